// Steady current as a profile over depth. Source: case key `environment.current`; validation row C.
// Not stretched with the waves: above mean sea level the surface value holds.
#pragma once

#include <vector>

#include "case/environment.hpp"
#include "vector.hpp"

namespace hawser {

/// Horizontal current, linear between the points of the profile (in its two components, so that
/// headings of 350 and 10 degrees meet at 0), constant above the first and below the last.
class CurrentProfile {
 public:
    CurrentProfile() = default;  ///< no current
    explicit CurrentProfile(const Current& current);

    /// Velocity at height z above mean sea level [m], world axes [m/s].
    [[nodiscard]] Vec3 velocity(double z) const;
    [[nodiscard]] bool empty() const { return points_.empty(); }

 private:
    struct Point {
        double depth;  ///< below mean sea level [m]
        double x, y;   ///< velocity [m/s]
    };
    std::vector<Point> points_;  ///< ascending depth
};

}  // namespace hawser
