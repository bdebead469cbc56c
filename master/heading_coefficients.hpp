// Force and yaw moment coefficients over the heading of a flow relative to the platform, in OCIMF's
// form (case keys `platform.wind.coefficients`, `platform.current_coefficients`). K:23
#pragma once

#include "case/platform.hpp"
#include "vector.hpp"

namespace hawser::master {

/// Smooth over the whole circle: cubics between the rows with continuous slope. Rows of 0 to 180
/// deg are mirrored, Cx even, Cy and Cyaw odd.
class HeadingCoefficients {
 public:
    HeadingCoefficients() = default;
    explicit HeadingCoefficients(const HeadingTable& table);

    [[nodiscard]] bool empty() const { return rows_.empty(); }
    /// Cx, Cy, Cyaw. @param heading [rad], any turn
    [[nodiscard]] Vec3 at(double heading) const;

    /// K:23, on world axes about the point where it acts: with b the heading of the horizontal flow
    /// u against the platform's yaw
    ///
    ///     F_x = q_x Cx(b) |u|^2, F_y = q_y Cy(b) |u|^2, M_z = q_yaw Cyaw(b) |u|^2
    ///
    /// turned by yaw. @param q  1/2 rho times area, area, area x length
    [[nodiscard]] Vec6 load(const Vec3& u, double yaw, const Vec3& q) const;

 private:
    std::vector<std::array<double, 4>> rows_;  ///< 0 to 360 deg
    std::vector<std::array<double, 3>> slopes_;
};

}  // namespace hawser::master
