// Lines that can be looked at while they rest, and how they swing about that rest: what the
// commands `statics`, `modes` and `check --statics` want beside the loads of the seam. In one
// process only: a static solution takes seconds.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "lines.hpp"

namespace hawser {

/// The greatest of a quantity along a line; NaN where the line does not have it.
struct Extreme {
    double value = NAN;
    double at = NAN;  ///< arc length from end A [m]
};

/// A constraint along a line in the static solution.
struct ConstraintAtRest {
    Vec3 force = Vec3::Zero();  ///< on the line, world axes [N]
    double magnitude = 0.0;     ///< normal force, or tension of a tensioner [N]
    double opening = 0.0;       ///< gap left, stroke of a tensioner, of a joint the distance from
                                ///< its place [m]
};

/// A line in the static solution. Angles are those of the direction of growing arc length.
struct LineAtRest {
    double tension_a = 0.0, tension_b = 0.0;  ///< effective tension at the ends; at end A of a
                                              ///< riser in a tensioner that one's pull [N]
    double declination_a = 0.0, declination_b = 0.0;  ///< from vertical down [rad]
    double azimuth_a = 0.0, azimuth_b = 0.0;          ///< in the horizontal plane, from +x [rad]
    double lowest_tension = 0.0;                      ///< effective tension along the line [N]
    double lowest_at = 0.0;                           ///< arc length of that place [m]
    Extreme tension;                                  ///< effective [N]
    Extreme von_mises, bending;                       ///< stress [Pa]
    Extreme curvature;                                ///< [1/m]
    Extreme yield, breaking_load;                     ///< part of it that is used [-]
    double grounded = 0.0;                            ///< length in contact with the seabed [m]
    double touchdown = NAN;                     ///< least arc length in contact [m]; NaN: none
    std::vector<ConstraintAtRest> constraints;  ///< in the order of Line::constraints
    std::vector<double> arc_length;             ///< of the nodes, from end A [m]
    std::vector<Vec3> position;                 ///< of the nodes [m]
};

/// A natural mode of a rod about its static solution, ends held, undamped.
struct RodMode {
    enum class Kind { axial, in_plane, out_of_plane };
    double omega_squared = 0.0;  ///< [rad2/s2]; about zero: nothing holds the rod that way;
                                 ///< below: it buckles
    Kind kind = Kind::in_plane;  ///< the greatest of the shares
    double axial = 0.0, in_plane = 0.0, out_of_plane = 0.0;  ///< shares of the energy, sum 1
    std::vector<Vec3> shape;                  ///< displacement of the nodes from end A, largest 1
    static constexpr double nothing = 1e-10;  ///< what rounding leaves of omega_squared
    [[nodiscard]] std::optional<double> period() const {  ///< [s]
        if (omega_squared > nothing) return 2.0 * M_PI / std::sqrt(omega_squared);
        return std::nullopt;
    }
};

/// Horizontal unit vector of the vertical plane through a line's ends, from end A to end B; of a
/// line straight down that of its azimuth. Modes are in or out of this plane.
[[nodiscard]] inline Vec3 plane_of(const Line& line, const Vec3& end_a, const Vec3& end_b) {
    const Vec3 across(end_b.x() - end_a.x(), end_b.y() - end_a.y(), 0.0);
    if (across.norm() < 1e-6 * line.length())
        return {std::cos(line.azimuth), std::sin(line.azimuth), 0.0};
    return across.normalized();
}

/// All lines of a case in this process. at_rest() tells of the last order `equilibrium`.
class RestingLines : public Lines {
 public:
    /// One per line, in line order.
    [[nodiscard]] virtual std::vector<LineAtRest> at_rest() const = 0;
    /// The lowest modes of a line about the last order `equilibrium`, ascending in frequency.
    virtual std::vector<RodMode> modes(int line, int count) = 0;
};

/// Defined by worker/.
std::unique_ptr<RestingLines> make_resting_lines(const Case& input);

}  // namespace hawser
