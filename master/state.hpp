// The platform's integrated state: the 12 numbers of P:1, then the slow-position filter K:8.
#pragma once

#include "frames.hpp"

namespace hawser::master {

/// x_O (3), q (3), x_O' (3), q' (3), then for each of surge, sway, yaw: x_a, x_a', x_s, x_s' (K:8).
using State = Eigen::Matrix<double, 24, 1>;

/// First filter number of surge (0), sway (1) or yaw (2) in the state.
constexpr int filter_index(int motion) { return 12 + 4 * motion; }

/// P:1  The platform's motion within the state.
inline PlatformMotion motion_of(const State& s) {
    return {s.segment<3>(0), s.segment<3>(3), s.segment<3>(6), s.segment<3>(9)};
}

/// Puts a motion into the first 12 numbers; the filter is left as it is.
inline void set_motion(State& s, const PlatformMotion& m) {
    s.segment<3>(0) = m.position;
    s.segment<3>(3) = m.angles;
    s.segment<3>(6) = m.velocity;
    s.segment<3>(9) = m.angle_rates;
}

}  // namespace hawser::master
