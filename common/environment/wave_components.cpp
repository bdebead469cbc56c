// Discretisation of a wave spectrum into Airy components.
#include "environment/wave_components.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "environment/dispersion.hpp"
#include "environment/random.hpp"
#include "environment/spectra.hpp"

namespace hawser {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Running integrals of S(w) and w S(w) over the range, by Simpson's rule in narrow cells (the
/// peak is some 1000 cells wide).
class CumulativeSpectrum {
 public:
    CumulativeSpectrum(const Jonswap& spectrum, double from, double to)
        : from_(from), width_((to - from) / cells), m0_(cells + 1, 0.0), m1_(cells + 1, 0.0) {
        for (int i = 0; i < cells; ++i) {
            const double a = from_ + i * width_;
            const double Sa = spectrum.density(a), Sm = spectrum.density(a + 0.5 * width_),
                         Sb = spectrum.density(a + width_);
            const double energy = width_ / 6.0 * (Sa + 4.0 * Sm + Sb);
            const double first = width_ * width_ / 6.0 * (2.0 * Sm + Sb);  // about a
            const auto j = static_cast<std::size_t>(i);
            m0_[j + 1] = m0_[j] + energy;
            m1_[j + 1] = m1_[j] + a * energy + first;
        }
    }

    [[nodiscard]] double energy() const { return m0_.back(); }
    /// Energy below frequency w.
    [[nodiscard]] double energy_below(double w) const { return at(m0_, (w - from_) / width_); }
    /// Place (in cells from the start of the range) below which energy m0 lies.
    [[nodiscard]] double place_of(double m0) const {
        const auto above = std::upper_bound(m0_.begin() + 1, m0_.end() - 1, m0);
        const double low = *(above - 1), high = *above;
        return static_cast<double>(above - 1 - m0_.begin()) + (m0 - low) / (high - low);
    }
    /// Mean frequency of the energy between two places.
    [[nodiscard]] double centroid(double a, double b) const {
        return (at(m1_, b) - at(m1_, a)) / (at(m0_, b) - at(m0_, a));
    }

 private:
    static constexpr int cells = 20000;
    static double at(const std::vector<double>& integral, double place) {
        const double p = std::clamp(place, 0.0, static_cast<double>(cells));
        const auto i = std::min(static_cast<std::size_t>(p), std::size_t{cells - 1});
        return integral[i] + (p - static_cast<double>(i)) * (integral[i + 1] - integral[i]);
    }
    double from_, width_;
    std::vector<double> m0_, m1_;
};

}  // namespace

std::vector<WaveComponent> wave_components(const WaveTrain& train, double depth, double gravity) {
    std::vector<WaveComponent> components;
    if (train.type == WaveType::airy) {
        const double omega = two_pi / train.T;
        components.push_back({.amplitude = 0.5 * train.H,
                              .omega = omega,
                              .k = wave_number(omega, depth, gravity),
                              .phase = train.phase,
                              .heading = train.heading});
        return components;
    }

    assert(train.components > 0 && train.range_max > train.range_min);
    const Jonswap spectrum = spectrum_of(train);
    const double from = train.range_min * spectrum.wp, to = train.range_max * spectrum.wp;
    const CumulativeSpectrum cumulative(spectrum, from, to);
    const double m0 = cumulative.energy();
    const double scale = train.Hs * train.Hs / 16.0 / m0;
    Random random(train.seed);

    const int n = train.components;
    for (int i = 0; i < n; ++i) {
        double energy = m0 / n, omega = 0.0;
        if (train.discretisation == Discretisation::equal_energy) {
            omega = cumulative.centroid(cumulative.place_of(i * energy),
                                        cumulative.place_of((i + 1) * energy));
        } else {
            const double width = (to - from) / n, low = from + i * width;
            energy = cumulative.energy_below(low + width) - cumulative.energy_below(low);
            omega = low + width * random.uniform();
        }
        components.push_back({.amplitude = std::sqrt(2.0 * scale * energy),
                              .omega = omega,
                              .k = wave_number(omega, depth, gravity),
                              .phase = two_pi * random.uniform(),
                              .heading = train.heading});
    }
    return components;
}

}  // namespace hawser
