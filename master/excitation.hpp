// First-order wave forces from the database, with phase and heading at a given (slow) position:
// K:8.
#pragma once

#include "component_table.hpp"
#include "slow_motion.hpp"

namespace hawser::master {

/// First-order excitation about O on world axes [N, N.m], without the ramp:
///
///     F(t) = Q_z Re sum_i a_i X_i(b_i - yaw) e^{i (w_i t - k_i (x cos b_i + y sin b_i) + eps_i)}
///
/// Q_z turns by yaw alone. @param phases  WavePhases at the same position
Vec6 excitation_load(const ComponentTable<CVec6>& table,
                     const std::vector<WaveComponent>& components,
                     const std::vector<Complex>& phases, double yaw);

}  // namespace hawser::master
