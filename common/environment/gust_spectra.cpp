// Winds with a power-law profile.
#include "environment/gust_spectra.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

double ApiWind::mean(double z) const { return U0 * std::pow(z / 10.0, 0.125); }

double ApiWind::deviation(double z) const {
    return 0.15 * mean(z) * std::pow(z / 20.0, z <= 20.0 ? -0.125 : -0.275);
}

double ApiWind::gust_density(double z, double f) const {
    if (U0 <= 0.0) return 0.0;
    const double sigma = deviation(z), fp = 0.025 * mean(z) / z;
    return sigma * sigma / fp * std::pow(1.0 + 1.5 * f / fp, -5.0 / 3.0);
}

ApiWind api_wind(double speed, double height) {
    return {.U0 = speed * std::pow(height / 10.0, -0.125)};
}

double KaimalWind::mean(double z) const { return speed * std::pow(z / height, 0.14); }

double KaimalWind::gust_density(double z, double f) const {
    if (speed <= 0.0) return 0.0;
    const double U = mean(z), sigma = intensity * U;
    const double time = 8.1 * 0.7 * std::min(z, 60.0) / U;
    return 4.0 * sigma * sigma * time * std::pow(1.0 + 6.0 * f * time, -5.0 / 3.0);
}

}  // namespace hawser
