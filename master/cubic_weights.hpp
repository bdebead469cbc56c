// Cubic Hermite interpolation with slopes of the parabola through three points, as weights of the
// four values around the place. Of headings and of the frequencies of quadratic transfer functions.
#pragma once

#include <array>

namespace hawser::master {

/// Weights of the values at x0 < x1 < x2 < x3 for a place between x1 and x2: slopes at x1 and x2
/// are those of the parabolas through (x0, x1, x2) and (x1, x2, x3). Continuous in value and slope
/// from one interval to the next; exact for parabolas.
///
/// @param x       the four points, ascending
/// @param before  is there a value at x0? Without it the slope at x1 is that of the chord, weight 0
/// @param after   is there a value at x3?
inline std::array<double, 4> cubic_weights(const std::array<double, 4>& x, bool before, bool after,
                                           double at) {
    struct Slope {  // at the middle of three points, as a sum over their values
        double before, here, after;
    };
    const auto parabola = [](double h0, double h1) -> Slope {
        const double a = h1 / (h0 * (h0 + h1)), b = h0 / (h1 * (h0 + h1));
        return {-a, a - b, b};
    };
    const double h = x[2] - x[1], s = (at - x[1]) / h;
    const double slope1 = s * (1 - s) * (1 - s) * h, slope2 = -s * s * (1 - s) * h;
    const Slope m1 = before ? parabola(x[1] - x[0], h) : Slope{0.0, -1 / h, 1 / h};
    const Slope m2 = after ? parabola(h, x[3] - x[2]) : Slope{-1 / h, 1 / h, 0.0};
    return {slope1 * m1.before,
            (1 + 2 * s) * (1 - s) * (1 - s) + slope1 * m1.here + slope2 * m2.before,
            s * s * (3 - 2 * s) + slope1 * m1.after + slope2 * m2.here, slope2 * m2.after};
}

}  // namespace hawser::master
