// Small fixed-size vectors and matrices of mechanics. World axes: x, y horizontal, z up, z = 0 at
// mean sea level. Order of the six motions: surge, sway, heave, roll, pitch, yaw.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hawser {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

/// Cross-product matrix: skew(a) b = a x b.
inline Mat3 skew(const Vec3& a) {
    Mat3 S;
    S << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return S;
}

}  // namespace hawser
