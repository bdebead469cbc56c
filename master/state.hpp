// The platform's integrated state: the 12 numbers of P:1, then the slow-position filter K:8, then
// the memory of radiation K:10.
#pragma once

#include "frames.hpp"
#include "lines.hpp"

namespace hawser::master {

constexpr int most_oscillators = 12;  ///< of the fitted memory, K:10
constexpr int memory_index = 24;      ///< of its first number
constexpr int most_memory_states = 2 * 6 * most_oscillators;

/// x_O (3), q (3), x_O' (3), q' (3), then for each of surge, sway, yaw: x_a, x_a', x_s, x_s' (K:8),
/// then x1 (6), x2 (6) of each oscillator (K:10); without memory these stay 0.
using State = Eigen::Matrix<double, memory_index + most_memory_states, 1>;

/// First filter number of surge (0), sway (1) or yaw (2) in the state.
constexpr int filter_index(int motion) { return 12 + 4 * motion; }

/// P:1  The platform's motion within the state.
inline PlatformMotion motion_of(const State& s) {
    return {s.segment<3>(0), s.segment<3>(3), s.segment<3>(6), s.segment<3>(9)};
}

/// The states of several platforms, one after the other, integrated as one; no step allocates.
constexpr int state_numbers = State::RowsAtCompileTime;
using JointState = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_platforms * state_numbers, 1>;

/// State of platform k.
inline const State& state_of(const State& s, int) { return s; }
inline State state_of(const JointState& s, int k) {
    return s.segment<state_numbers>(static_cast<Eigen::Index>(k) * state_numbers);
}

/// P:1  The motions of all platforms.
inline PerPlatform<PlatformMotion> poses_of(const JointState& s) {
    PerPlatform<PlatformMotion> out;
    for (int k = 0; k * state_numbers < s.size(); ++k)
        out[static_cast<std::size_t>(k)] = motion_of(state_of(s, k));
    return out;
}

/// Puts a motion into the first 12 numbers; the filter is left as it is.
inline void set_motion(State& s, const PlatformMotion& m) {
    s.segment<3>(0) = m.position;
    s.segment<3>(3) = m.angles;
    s.segment<3>(6) = m.velocity;
    s.segment<3>(9) = m.angle_rates;
}

}  // namespace hawser::master
