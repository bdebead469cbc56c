// Wind on the topsides: one area at one height with one shape coefficient, or coefficients by
// heading. The speed is that of the air against the moving platform. K:23
#pragma once

#include <optional>

#include "case/environment.hpp"
#include "case/platform.hpp"
#include "environment/wind.hpp"
#include "frames.hpp"
#include "heading_coefficients.hpp"

namespace hawser::master {

class WindLoad {
 public:
    WindLoad(const std::optional<Wind>& wind, const std::optional<WindArea>& area, double ramp);

    /// F = 1/2 rho_air Cs A |u| u,  u = U(t) d - v_h, at the centre of the area: [N, N.m] about O;
    /// or K:23 with area, side area and length.
    /// v_h: horizontal velocity of that centre; the gust within U is ramped, the mean is not.
    [[nodiscard]] Vec6 load(double t, const PlatformMotion& motion, const Mat3& R,
                            const Vec3& w) const;

    /// The same at the mean speed with the platform at rest: what the static start holds.
    [[nodiscard]] Vec6 mean_load(const PlatformMotion& pose, const Mat3& R) const;

 private:
    [[nodiscard]] Vec6 load_of(const Vec3& relative, const Vec3& arm, double yaw) const;

    std::optional<WindField> field_;
    double factor_ = 0.0;  ///< 1/2 rho_air Cs A [kg/m]
    HeadingCoefficients table_;
    Vec3 q_ = Vec3::Zero();  ///< 1/2 rho_air times area, side area, side area x length
    Vec3 direction_ = Vec3::UnitX(), centre_ = Vec3::Zero();
};

}  // namespace hawser::master
