// Current on the whole hull by coefficients (case key `platform.current_coefficients`): the flow is
// that of the current against the moving hull, at one depth. Waves do not count. K:23
#pragma once

#include <optional>

#include "environment/sea.hpp"
#include "heading_coefficients.hpp"

namespace hawser::master {

class CurrentLoad {
 public:
    CurrentLoad(const std::optional<CurrentCoefficients>& given, double water_density);

    /// K:23 with u = f U(z) - v, horizontal, v the velocity of the hull at `depth` below O; acts
    /// there. Half rho times draft x length, the moment times length once more. [N, N.m] about O
    /// @param factor  0 .. 1: part of the current that acts
    [[nodiscard]] Vec6 load(const Sea& sea, double factor, const PlatformMotion& motion,
                            const Mat3& R, const Vec3& w) const;

 private:
    HeadingCoefficients table_;
    Vec3 q_ = Vec3::Zero(), place_ = Vec3::Zero();
};

}  // namespace hawser::master
