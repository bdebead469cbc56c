// The slow position that gives phase and heading of the first-order wave forces: K:8, a Butterworth
// low-pass of order 4 on surge, sway and yaw, integrated with the platform.
#pragma once

#include "state.hpp"

namespace hawser::master {

/// Where the waves are met: surge, sway [m] and yaw [rad].
struct WavePosition {
    double x = 0.0, y = 0.0, yaw = 0.0;
};

/// Slow position x_s of the state's filter.
WavePosition slow_position(const State& state);

/// Position of the moment.
WavePosition instantaneous_position(const State& state);

/// K:8  Adds the filter's rates to the rate of the state; x is surge, sway, yaw:
///
///     x_a'' = -0.7654 wc x_a' - wc^2 (x_a - x),   x_s'' = -1.8478 wc x_s' - wc^2 (x_s - x_a)
///
/// @param cutoff  wc [rad/s]; 0 holds the filter where it is (still water)
void add_slow_motion_to(State& rate, const State& state, double cutoff);

/// Sets the filter at rest at a position.
void rest_slow_motion_at(State& state, const PlatformMotion& position);

}  // namespace hawser::master
