// The user's own stiffness of the platform about its design position (case keys
// platform.stiffness). K:22
#pragma once

#include "frames.hpp"

namespace hawser::master {

/// K:22, load about O on world axes [N, N.m], with y = (x_O, roll, pitch, yaw):
///
///     T^T (F, M) = -K y,   T = diag(1, E)      earth axes: the power is d(1/2 y^T K y)/dt, exactly
///     (F, M) = -Q K Q^T y, Q = diag(Rz, Rz)    axes that turn with yaw, small roll and pitch
Vec6 user_stiffness_load(const Mat6& K, bool turns_with_yaw, const PlatformMotion& pose);

}  // namespace hawser::master
