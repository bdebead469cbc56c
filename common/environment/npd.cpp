// The NPD wind model of ISO 19901-1.
#include "environment/npd.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hawser {

double NpdWind::mean(double z) const {
    return U0 * (1.0 + 0.0573 * std::sqrt(1.0 + 0.15 * U0) * std::log(z / 10.0));
}

double NpdWind::turbulence_intensity(double z) const {
    return 0.06 * (1.0 + 0.043 * U0) * std::pow(z / 10.0, -0.22);
}

double NpdWind::mean(double z, double averaging) const {
    const double hours = std::min(averaging / 3600.0, 1.0);
    return mean(z) * (1.0 - 0.41 * turbulence_intensity(z) * std::log(hours));
}

double NpdWind::gust_density(double z, double f) const {
    if (U0 <= 0.0) return 0.0;
    constexpr double n = 0.468;
    const double x = 172.0 * f * std::pow(z / 10.0, 2.0 / 3.0) * std::pow(U0 / 10.0, -0.75);
    return 320.0 * (U0 / 10.0) * (U0 / 10.0) * std::pow(z / 10.0, 0.45) *
           std::pow(1.0 + std::pow(x, n), -5.0 / (3.0 * n));
}

NpdWind npd_wind(double speed, double averaging, double height) {
    assert(speed >= 0.0 && averaging > 0.0 && height > 0.0);
    // The mean at the given height rises with U0 for heights above half a metre: halve the bracket
    // until its ends meet.
    double low = 0.0, high = 4.0 * speed + 1.0;
    while (true) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return {.U0 = middle};
        (NpdWind{.U0 = middle}.mean(height, averaging) < speed ? low : high) = middle;
    }
}

}  // namespace hawser
