// Wind speed in time at one height.
#include "environment/wind.hpp"

#include <cmath>
#include <numbers>

#include "environment/npd.hpp"
#include "environment/ramp.hpp"
#include "environment/random.hpp"

namespace hawser {

namespace {

constexpr int gust_components = 200;

/// Energy of the gusts between frequencies a and b: Simpson's rule in ln f, 8 cells.
double gust_energy(const NpdWind& npd, double z, double a, double b) {
    constexpr int cells = 8;
    const double width = std::log(b / a) / cells;
    const auto integrand = [&](double place) {
        const double f = a * std::exp(place * width);
        return f * npd.gust_density(z, f);
    };
    double total = 0.0;
    for (int i = 0; i < cells; ++i)
        total += width / 6.0 * (integrand(i) + 4.0 * integrand(i + 0.5) + integrand(i + 1));
    return total;
}

}  // namespace

WindField::WindField(const Wind& wind, double ramp, double height)
    : ramp_(ramp), mean_(wind.speed) {
    if (wind.spectrum == WindSpectrum::constant) return;
    const NpdWind npd = npd_wind(wind.speed, wind.averaging, wind.reference_height);
    mean_ = npd.mean(height);
    Random random(wind.seed);
    const double ratio =
        std::pow(npd_highest_frequency / npd_lowest_frequency, 1.0 / gust_components);
    for (int i = 0; i < gust_components; ++i) {
        const double low = npd_lowest_frequency * std::pow(ratio, i);
        const double f = low * std::pow(ratio, random.uniform());
        gusts_.push_back({.amplitude = std::sqrt(2.0 * gust_energy(npd, height, low, low * ratio)),
                          .omega = 2.0 * std::numbers::pi * f,
                          .phase = 2.0 * std::numbers::pi * random.uniform()});
    }
}

double WindField::speed(double t) const {
    double gust = 0.0;
    for (const GustComponent& g : gusts_) gust += g.amplitude * std::cos(g.omega * t + g.phase);
    return mean_ + ramp_factor(t, ramp_) * gust;
}

}  // namespace hawser
