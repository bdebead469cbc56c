// Directions of a short-crested sea: D(b) = cos^2s((b - b0)/2)/integral (Longuet-Higgins,
// Cartwright and Smith 1963), one direction per component, so that no two components share a
// frequency.
#pragma once

#include <cstdint>
#include <vector>

#include "environment/wave_components.hpp"

namespace hawser {

/// Density of directions [1/rad] at an angle [rad] from the mean:
///
///     D = Gamma(s + 1)/(2 sqrt(pi) Gamma(s + 1/2)) cos^2s(angle/2),   |angle| <= pi
///
/// Its moments are <cos angle> = s/(s + 1) and <cos 2 angle> = s (s - 1)/((s + 1)(s + 2)).
double cos2s_density(double s, double angle);

/// Angles from the mean [rad], ascending: the circle cut into sectors of equal energy, each
/// represented by the direction of its mean vector. First and second moment converge faster than
/// 1/n; the two end sectors with their long tails are what is left.
std::vector<double> spread_directions(const Spreading& spreading);

/// Turns the components of one train, by rising frequency, out of its heading. Each run of
/// `directions` components has every direction once, in an order drawn from the seed: so every part
/// of the spectrum has the whole spreading, and the sea stays ergodic (components of one frequency
/// and different headings would stand still as an interference pattern in space).
void spread_components(const Spreading& spreading, std::uint64_t seed,
                       std::vector<WaveComponent>& components);

}  // namespace hawser
