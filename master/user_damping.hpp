// The user's own linear and quadratic damping of the platform (case keys platform.damping).
#pragma once

#include "frames.hpp"

namespace hawser::master {

/// F_i = -sum_j B_ij v_j - sum_j Q_ij |v_j| v_j about O, with v = (x_O', w) on axes that turn with
/// yaw; returned on world axes [N, N.m].
Vec6 user_damping_load(const Mat6& linear, const Mat6& quadratic, const PlatformMotion& motion,
                       const Vec3& w);

}  // namespace hawser::master
