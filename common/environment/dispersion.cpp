// Dispersion relation of linear gravity waves, solved by Newton's method.
#include "environment/dispersion.hpp"

#include <cassert>
#include <cmath>

namespace hawser {

double wave_number(double omega, double depth, double gravity) {
    assert(omega > 0.0 && depth > 0.0 && gravity > 0.0);
    // y tanh y = a with y = kh. The start has the right limits in shallow (y^2 = a) and deep water
    // (y = a) and is within 1 % between them, so three or four corrections reach rounding.
    const double a = omega * omega * depth / gravity;
    double y = a * std::pow(-std::expm1(-std::pow(a, 1.25)), -0.4);
    double correction = y;
    for (int i = 0; i < 20 && std::abs(correction) > 1e-13 * y; ++i) {
        const double tanh_y = std::tanh(y);
        correction = (y * tanh_y - a) / (tanh_y + y * (1.0 - tanh_y * tanh_y));
        y -= correction;
    }
    assert(std::abs(y * std::tanh(y) - a) <= 1e-12 * a);
    return y / depth;
}

}  // namespace hawser
