// How far a run has come, for the person waiting: on stderr, rank 0 only.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "roles.hpp"

namespace hawser::master {

struct ProgressState {
    double t = 0.0, duration = 0.0;  ///< simulated [s]
    double wall = 0.0;               ///< since the loop began [s]
    std::optional<double> surge;     ///< [m]; of several platforms the greatest
    double tension = 0.0;            ///< greatest effective tension at an end A [N]
    std::string line;                ///< whose; empty: no lines
    std::string platform = {};       ///< of several: whose surge it is
};

/// "t 1250.0/3600.0 s  34.7 %  2.31x real time  ETA 00:16:57  surge 31.2 m  max T 5012 kN (ml6)"
std::string progress_line(const ProgressState& state);

class Progress {
 public:
    /// `automatic`: a bar if the run is alone on a terminal, else a line per 5 % or 30 s. Ranks
    /// under MPI are never asked whether they are on a terminal: Open MPI gives them false answers.
    Progress(ProgressStyle style, bool alone);

    /// Prints if it is time to. Called once a step.
    /// @param platforms  of the case, on world axes; empty: none
    void show(double t, double duration, std::span<const PlatformMotion> platforms,
              const Reply& lines, const Case& input);
    /// Ends the bar's line.
    void finish();

 private:
    ProgressStyle style_;
    double start_, last_wall_;
    double last_fraction_ = 0.0;
    bool bar_shown_ = false;
};

}  // namespace hawser::master
