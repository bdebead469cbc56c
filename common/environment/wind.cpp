// Wind speed in time at one height.
#include "environment/wind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/gust_spectra.hpp"
#include "environment/npd.hpp"
#include "environment/ramp.hpp"
#include "environment/random.hpp"

namespace hawser {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Energy of the gusts between frequencies a and b: Simpson's rule in ln f, 8 cells.
template <class Density>
double gust_energy(const Density& density, double a, double b) {
    constexpr int cells = 8;
    const double width = std::log(b / a) / cells;
    const auto integrand = [&](double place) {
        const double f = a * std::exp(place * width);
        return f * density(f);
    };
    double total = 0.0;
    for (int i = 0; i < cells; ++i)
        total += width / 6.0 * (integrand(i) + 4.0 * integrand(i + 0.5) + integrand(i + 1));
    return total;
}

/// One random frequency in each of n bins of equal width in ln f, with the energy of its bin.
template <class Density>
std::vector<GustComponent> gusts_of(const Density& density, double lowest, double highest, int n,
                                    std::uint64_t seed) {
    std::vector<GustComponent> gusts;
    Random random(seed);
    const double ratio = std::pow(highest / lowest, 1.0 / n);
    for (int i = 0; i < n; ++i) {
        const double low = lowest * std::pow(ratio, i);
        const double f = low * std::pow(ratio, random.uniform());
        gusts.push_back({.amplitude = std::sqrt(2.0 * gust_energy(density, low, low * ratio)),
                         .omega = two_pi * f,
                         .phase = two_pi * random.uniform()});
    }
    return gusts;
}

/// Mean over the time that the rows span.
double mean_of(const std::vector<std::array<double, 2>>& history) {
    double area = 0.0;
    for (std::size_t i = 1; i < history.size(); ++i)
        area += 0.5 * (history[i][0] - history[i - 1][0]) * (history[i][1] + history[i - 1][1]);
    return history.size() > 1 ? area / (history.back()[0] - history.front()[0])
                              : history.front()[1];
}

}  // namespace

WindField::WindField(const Wind& wind, double ramp, double height)
    : ramp_(ramp), mean_(wind.speed) {
    switch (wind.spectrum) {
        case WindSpectrum::constant:
            return;
        case WindSpectrum::npd: {
            const NpdWind npd = npd_wind(wind.speed, wind.averaging, wind.reference_height);
            mean_ = npd.mean(height);
            gusts_ = gusts_of([&](double f) { return npd.gust_density(height, f); },
                              npd_lowest_frequency, npd_highest_frequency, 200, wind.seed);
            return;
        }
        case WindSpectrum::api: {
            const ApiWind api = api_wind(wind.speed, wind.reference_height);
            mean_ = api.mean(height);
            gusts_ = gusts_of([&](double f) { return api.gust_density(height, f); },
                              hour_lowest_frequency, hour_highest_frequency, 290, wind.seed);
            return;
        }
        case WindSpectrum::kaimal: {
            const KaimalWind kaimal{.speed = wind.speed,
                                    .height = wind.reference_height,
                                    .intensity = wind.turbulence_intensity};
            mean_ = kaimal.mean(height);
            gusts_ = gusts_of([&](double f) { return kaimal.gust_density(height, f); },
                              hour_lowest_frequency, hour_highest_frequency, 290, wind.seed);
            return;
        }
        case WindSpectrum::time_history:
            history_ = wind.history;
            mean_ = mean_of(history_);
    }
}

double WindField::history_at(double t) const {
    if (t <= history_.front()[0]) return history_.front()[1];
    if (t >= history_.back()[0]) return history_.back()[1];
    const auto above = std::upper_bound(history_.begin(), history_.end(), t,
                                        [](double time, const auto& row) { return time < row[0]; });
    const auto& [t1, u1] = *above;
    const auto& [t0, u0] = *(above - 1);
    return std::lerp(u0, u1, (t - t0) / (t1 - t0));
}

double WindField::speed(double t) const {
    double gust = history_.empty() ? 0.0 : history_at(t) - mean_;
    for (const GustComponent& g : gusts_) gust += g.amplitude * std::cos(g.omega * t + g.phase);
    return mean_ + ramp_factor(t, ramp_) * gust;
}

}  // namespace hawser
