// What `hawser statics` and `hawser check --statics` find out, as plain values. SI and radians.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "resting_lines.hpp"

namespace hawser {

/// Does the platform stand upright, and what holds it?
struct Stability {
    double hull_GM_roll = 0.0, hull_GM_pitch = 0.0;  ///< weight and buoyancy alone, upright [m]
    double GM_roll = 0.0, GM_pitch = 0.0;  ///< stiffness with the lines over the buoyancy [m]
    std::vector<std::string> unstable;     ///< motions of the directions with negative stiffness
    std::vector<std::string> unheld;       ///< motions of the directions without stiffness
    [[nodiscard]] bool stable() const { return unstable.empty(); }
};

struct PlatformAtRest {
    std::string name;
    PlatformMotion position;  ///< equilibrium under the mean loads, on world axes
    double mass = 0.0;        ///< [kg]
    bool mass_is_auto = false;
    double acting_buoyancy = 0.0;     ///< at the design draft [N]
    double vertical_line_load = 0.0;  ///< at the design position in still water, downwards [N]
    Vec6 line_load = Vec6::Zero();    ///< at the equilibrium, about O [N, N.m]
    /// All; lines' part. Of several platforms each for its own motions, the others held.
    Mat6 stiffness = Mat6::Zero(), line_stiffness = Mat6::Zero();
    Stability stability;
    std::array<std::optional<double>, 6> periods;  ///< surge ... yaw [s]
    double added_mass_frequency = 0.0;             ///< [rad/s]; 0: constant matrices
    int iterations = 0;
};

/// What may move freely while the platform is held at an offset: the way across it, then heave,
/// roll, pitch and yaw.
struct FreeMotions {
    bool transverse = false, heave = true, roll = false, pitch = false, yaw = false;
    [[nodiscard]] bool any() const { return transverse || heave || roll || pitch || yaw; }
};

/// The platform at one offset; forces of the chosen lines on it.
struct OffsetPoint {
    double offset = 0.0;                 ///< [m]
    PlatformMotion pose;                 ///< from the design position, the free motions settled
    double across = 0.0;                 ///< to the left of the offset, where that is free [m]
    double restoring = 0.0;              ///< against the offset [N]
    double transverse = 0.0;             ///< to the left of the offset [N]
    double yaw_moment = 0.0;             ///< about the platform's reference point [N.m]
    double slope = 0.0;                  ///< d restoring/d offset, from the lines' tangent [N/m]
    double least = 0.0, greatest = 0.0;  ///< tension at end A, of lines that touch the platform [N]
    int least_line = -1, greatest_line = -1;  ///< index in Case::lines
};

struct OffsetCurve {
    int platform = 0;        ///< that is moved
    double heading = 0.0;    ///< [rad]
    std::vector<int> lines;  ///< that are summed
    FreeMotions free;
    std::vector<OffsetPoint> points;
    std::string ends;  ///< why there is no point at the next offset; empty: all were found
};

struct StaticsReport {
    std::vector<PlatformAtRest> platforms;  ///< in the order of the case
    std::vector<LineAtRest> lines;          ///< in line order
    Eigen::MatrixXd stiffness;  ///< of platforms and lines, 6 rows and columns per platform
    std::optional<OffsetCurve> curve;
    std::vector<std::string> warnings;
};

struct StaticsRequest {
    std::vector<double> offsets;  ///< [m]; empty: no curve
    double heading = 0.0;         ///< of the offsets [rad]
    std::string platform = {};    ///< that is moved, of several; empty: the first
    std::string lines = "*";      ///< glob: which lines the curve sums
    /// Along the curve; empty: heave for a curve of all lines, nothing for one of some lines
    std::optional<FreeMotions> free = {};
};

/// The case after the lines called like the glob are gone. A platform mass of `auto` is that of the
/// case with all of them, for the platform was built and ballasted with them. Throws RunError
/// (input) if no line is called so, or another line is tied to one of them; (no_equilibrium).
/// Defined by master/.
Case without_lines(const Case& input, const std::string& glob);

/// The equilibrium that starts a run. Throws RunError (no_equilibrium, input) with the reason.
/// Defined by master/.
StaticsReport find_statics(const Case& input, const StaticsRequest& request);

}  // namespace hawser
