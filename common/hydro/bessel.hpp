// Bessel functions as the matched eigenfunctions need them: scaled so that nothing overflows, many
// orders at once by recurrence. Starting values from Boost.Math; DLMF chapter 10.
#pragma once

#include <span>

namespace hawser::hydro {

/// Exponent of the velocity at an edge with fluid all around three quarters of it: u ~ d^(-1/3) is
/// the weight (1 - x^2)^(nu - 1/2) of Gegenbauer's polynomials with this nu, H:4.
constexpr double edge_order = 1.0 / 6.0;

/// J_(nu+n)(x) / x^nu for n = 0 .. size - 1, nu = edge_order, x >= 0.
void edge_bessel_j(double x, std::span<double> out);

/// e^-x I_(nu+n)(x) / x^nu for n = 0 .. size - 1, nu = edge_order, x >= 0.
void edge_bessel_i(double x, std::span<double> out);

/// e^-x I_m(x) for m = 0 .. size - 1, size >= 2, x > 0.
void scaled_bessel_i(double x, std::span<double> out);

/// e^x K_m(x) for m = 0 .. size - 1, size >= 2, x > 0.
void scaled_bessel_k(double x, std::span<double> out);

/// J_m(x) and Y_m(x) for m = 0 .. size - 1, x > 0. Y is cut at 1e280.
void bessel_jy(double x, std::span<double> j, std::span<double> y);

}  // namespace hawser::hydro
