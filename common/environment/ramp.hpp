// The start-up ramp that brings in waves, gusts and slow drift (README.md of common/).
// Source: the ramp rule beside K:8. Continuous to the second derivative.
#pragma once

#include <algorithm>

namespace hawser {

/// Ramp r = 10 q^3 - 15 q^4 + 6 q^5 with q = t/ramp clamped to [0, 1]; 1 if there is no ramp.
///
/// @param t     simulated time [s]
/// @param ramp  length of the ramp [s], 0: none
inline double ramp_factor(double t, double ramp) {
    if (ramp <= 0.0) return 1.0;
    const double q = std::clamp(t / ramp, 0.0, 1.0);
    return q * q * q * (10.0 - q * (15.0 - 6.0 * q));
}

/// The ramp with its first two time derivatives [-, 1/s, 1/s2].
struct Ramp {
    double value = 1.0, rate = 0.0, second = 0.0;
};
inline Ramp ramp_with_rates(double t, double ramp) {
    if (ramp <= 0.0 || t >= ramp) return {};
    const double q = std::clamp(t / ramp, 0.0, 1.0);
    return {.value = ramp_factor(t, ramp),
            .rate = 30.0 * q * q * (1.0 - q) * (1.0 - q) / ramp,
            .second = 60.0 * q * (1.0 - q) * (1.0 - 2.0 * q) / (ramp * ramp)};
}

}  // namespace hawser
