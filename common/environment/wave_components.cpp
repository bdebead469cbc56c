// Discretisation of a wave spectrum into Airy components.
#include "environment/wave_components.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "environment/dispersion.hpp"
#include "environment/elevation_record.hpp"
#include "environment/random.hpp"
#include "environment/spectra.hpp"
#include "environment/spreading.hpp"
#include "environment/wave_trains.hpp"

namespace hawser {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Running integrals of S(w) and w S(w) over the range, by Simpson's rule in narrow cells (the
/// peak is some 1000 cells wide).
class CumulativeSpectrum {
 public:
    CumulativeSpectrum(const Spectrum& spectrum, const FrequencyRange& range)
        : from_(range.from), width_(range.width / cells), m0_(cells + 1, 0.0), m1_(cells + 1, 0.0) {
        for (int i = 0; i < cells; ++i) {
            const double a = from_ + i * width_;
            const double Sa = density(spectrum, a), Sm = density(spectrum, a + 0.5 * width_),
                         Sb = density(spectrum, a + width_);
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

/// Band of equal energy, or one random frequency in each of equal bands.
std::vector<WaveComponent> drawn_from_spectrum(const WaveTrain& train, double depth,
                                               double gravity) {
    const FrequencyRange range = frequency_range(train);
    assert(train.components > 0 && range.width > 0.0);
    const CumulativeSpectrum cumulative(spectrum_of(train, gravity), range);
    const double m0 = cumulative.energy();
    const double height = significant_height(train);
    const double scale = height * height / 16.0 / m0;
    Random random(train.seed);

    std::vector<WaveComponent> components;
    const int n = train.components;
    for (int i = 0; i < n; ++i) {
        double energy = m0 / n, omega = 0.0;
        if (train.discretisation == Discretisation::equal_energy) {
            omega = cumulative.centroid(cumulative.place_of(i * energy),
                                        cumulative.place_of((i + 1) * energy));
        } else {
            const double width = range.width / n, low = range.from + i * width;
            energy = cumulative.energy_below(low + width) - cumulative.energy_below(low);
            omega = low + width * random.uniform();
        }
        components.push_back({.amplitude = std::sqrt(2.0 * scale * energy),
                              .omega = omega,
                              .k = wave_number(omega, depth, gravity),
                              .phase = two_pi * random.uniform(),
                              .heading = train.heading});
    }
    if (train.spreading) spread_components(*train.spreading, train.seed, components);
    return components;
}

}  // namespace

std::vector<WaveComponent> wave_components(const WaveTrain& train, double depth, double gravity) {
    if (is_random(train)) return drawn_from_spectrum(train, depth, gravity);
    std::vector<WaveComponent> components;
    const auto add = [&](double amplitude, double omega, double phase, double heading) {
        const double k = wave_number(omega, depth, gravity);
        components.push_back({amplitude, omega, k, phase, heading});
    };
    if (train.type == WaveType::elevation_file) {
        const double along =
            train.record_x * std::cos(train.heading) + train.record_y * std::sin(train.heading);
        for (const Harmonic& h : record_harmonics(train)) {
            add(h.amplitude, h.omega, h.phase, train.heading);
            components.back().phase += components.back().k * along;
        }
    } else if (train.type == WaveType::components) {
        for (const ListedWave& w : train.list)
            add(w.amplitude, w.frequency, w.phase, w.heading.value_or(train.heading));
    } else {
        add(0.5 * train.H, two_pi / train.T, train.phase, train.heading);
    }
    return components;
}

}  // namespace hawser
