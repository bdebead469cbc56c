// Dispersion of linear gravity waves over a flat bottom. Source: Airy theory; DNV-RP-C205 3.2.
#pragma once

namespace hawser {

/// Wave number k > 0 that solves the dispersion relation, to rounding:
///
///     omega^2 = g k tanh(k h)
///
/// @param omega    circular frequency [rad/s], positive
/// @param depth    water depth h [m], positive
/// @param gravity  g [m/s2]
/// @return         k [1/m]
double wave_number(double omega, double depth, double gravity);

}  // namespace hawser
