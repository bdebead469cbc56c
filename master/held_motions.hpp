// Motions that do not follow from the loads: held (case key `fixed_modes`) or led
// (`prescribed_motion`). The equation of motion is solved for the others. K:20
#pragma once

#include <array>

#include "frames.hpp"

namespace hawser::master {

using Held = std::array<bool, 6>;  ///< surge ... yaw: x_O on world axes, then the Euler angles

[[nodiscard]] inline bool any(const Held& held) {
    for (const bool h : held)
        if (h) return true;
    return false;
}

/// (x_O'', w') = T y'' + (0, E' q') with y the six motions, K:3: T = diag(1, E).
Mat6 motion_matrix(const Vec3& angles);

/// What holds or leads the motions, and the acceleration it leaves.
struct HeldSolution {
    Vec6 acceleration = Vec6::Zero();  ///< (x_O'', w'), world axes
    Vec6 motions = Vec6::Zero();       ///< y'', those that are held as given
    Vec6 holding = Vec6::Zero();       ///< force and moment about O, world axes [N, N.m]
};

/// K:20: M (x_O'', w') = F + T^-T L, L zero in the free motions: the holding load does work in the
/// held ones alone. So
///
///     (T^T M T)_ff y''_f = (T^T (F - M b) - T^T M T y''_held)_f,    b = (0, E' q')
///
/// @param M      mass with added mass about O; nothing is asked of it where all is held
/// @param F      all loads, gyroscopic ones taken off [N, N.m]
/// @param given  y'' of the held motions [m/s2, rad/s2]; others are not looked at
HeldSolution solve_held(const Mat6& M, const Vec6& F, const PlatformMotion& motion,
                        const Held& held, const Vec6& given);

/// Orthogonal projection of (displacement, rotation vector) on what leaves the held motions alone.
Mat6 free_projection(const Vec3& angles, const Held& held);

/// `pose` with the held motions of `place`, and with their rates.
PlatformMotion with_held(PlatformMotion pose, const PlatformMotion& place, const Held& held);

}  // namespace hawser::master
