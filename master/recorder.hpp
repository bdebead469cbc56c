// The platforms' part of the results: what rank 0 puts into the series file at a sample.
#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "environment/sea.hpp"
#include "environment/wind.hpp"
#include "hull.hpp"
#include "io/series_file.hpp"

namespace hawser::master {

class Recorder {
 public:
    /// Declares the columns that rank 0 provides. @param sea of the case, for the elevation
    Recorder(const Case& input, const Sea& sea, io::SeriesWriter& results);

    /// Is a sample (a snapshot) due at the start of this step?
    [[nodiscard]] bool sample_due(int step) const { return step % sample_every_ == 0; }
    [[nodiscard]] bool snapshot_due(int step) const {
        return snapshot_every_ > 0 && step % snapshot_every_ == 0;
    }

    /// Opens a sample and puts what belongs to the environment.
    void sample(double t);
    /// Puts the state of platform k, its acceleration (second derivatives of the six motions) and
    /// its loads into the sample that is open. Surge and sway count from its design position.
    void platform(std::size_t k, const State& y, const Vec6& acceleration, const HullLoads& loads);
    /// Opens a snapshot; the lines put their nodes.
    void snapshot(double t) { results_.add_time(io::Clock::snapshot, t); }

 private:
    /// Fields of one platform; -1: not recorded.
    struct Columns {
        Vec3 design;
        int position, velocity, acceleration, elevation;
        std::vector<int> loads;
    };
    int declare(const std::string& path, int columns);
    void put(int field, const Vec6& values);

    const Sea& sea_;
    io::SeriesWriter& results_;
    std::optional<WindField> wind_;
    int sample_every_, snapshot_every_;
    std::vector<Columns> platforms_;
    int elevation_, elevation_of_trains_, wind_speed_;
    std::vector<double> trains_;  ///< elevation of each
};

}  // namespace hawser::master
