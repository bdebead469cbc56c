// Natural periods of the moored platform, undamped, about its equilibrium: what an engineer looks
// at before the storm. Lines with their static stiffness and without mass.
#pragma once

#include <array>
#include <optional>

#include "vector.hpp"

namespace hawser::master {

/// Solves K x = w^2 M x and gives each mode to the motion that has most of its kinetic energy,
/// x_i (M x)_i: surge ... yaw [s]. Empty where nothing holds the platform.
///
/// @param K  stiffness about O [N/m, N, N.m], made symmetric here
/// @param M  mass with added mass about O [kg, kg.m, kg.m2], symmetric, positive definite
std::array<std::optional<double>, 6> natural_periods(const Mat6& K, const Mat6& M);

}  // namespace hawser::master
