// The case: what is recorded (case key `output`).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hawser {

/// Results of the lines whose name matches `select` (glob: * and ?).
struct LineOutput {
    std::string select = "*";
    bool end_a = true, end_b = false;
    std::vector<double> at_arc;  ///< further places, arc length from end A [m]
    /// What is recorded there, of constraints (`guide.force`) and of touchdown: words of the key
    std::vector<std::string> results{"effective_tension"};
    std::vector<std::string> range;  ///< quantities of which the course along the line is kept

    bool operator==(const LineOutput&) const = default;
};

struct Output {
    double interval = 0.0;            ///< sampling [s], a multiple of the platform step (resolved)
    std::optional<double> snapshots;  ///< interval of node positions [s]
    bool platform_motions = true, platform_loads = false, environment = true;
    std::vector<LineOutput> lines;

    bool operator==(const Output&) const = default;
};

}  // namespace hawser
