// Small displacements of a platform, for Newton's method on its equilibrium.
#pragma once

#include "frames.hpp"

namespace hawser::master {

/// Roll, pitch, yaw [rad] of a rotation matrix: the inverse of K:1, |pitch| < 90 deg.
Vec3 angles_of(const Mat3& R);

/// The pose moved by (dx, rotation vector), both on world axes: x_O + dx, R' = exp([v]) R.
/// Velocities are kept. Yaw stays on the branch of the pose it came from.
PlatformMotion displaced(const PlatformMotion& pose, const Vec6& step);

}  // namespace hawser::master
