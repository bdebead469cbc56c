// Height, peaks and range of a wave train.
#include "environment/wave_trains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/elevation_record.hpp"
#include "environment/spectra.hpp"

namespace hawser {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double below_the_lowest = 0.05;  // share of the energy
constexpr double neighbourhood = 0.1;      // of a frequency, to either side

/// Energies at frequencies, ascending.
using Lines = std::vector<std::pair<double, double>>;

double total(const Lines& lines) {
    double sum = 0.0;
    for (const auto& [w, energy] : lines) sum += energy;
    return sum;
}

/// Energies of a list, of a record's band, or of the pieces of a table.
Lines lines_of(const WaveTrain& train) {
    Lines lines;
    if (train.type == WaveType::components) {
        for (const ListedWave& w : train.list)
            lines.emplace_back(w.frequency, 0.5 * w.amplitude * w.amplitude);
    } else if (train.type == WaveType::elevation_file) {
        for (const Harmonic& h : record_harmonics(train))
            lines.emplace_back(h.omega, 0.5 * h.amplitude * h.amplitude);
    } else {
        for (std::size_t i = 1; i < train.spectrum.size(); ++i) {
            const auto& [w0, S0] = train.spectrum[i - 1];
            const auto& [w1, S1] = train.spectrum[i];
            lines.emplace_back(0.5 * (w0 + w1), 0.5 * (w1 - w0) * (S0 + S1));
        }
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

/// Frequency with the most energy within 10 % of it: its neighbourhood's centroid.
double most_energetic(const Lines& lines) {
    double best = -1.0, at = 0.0;
    std::size_t low = 0, high = 0;
    double m0 = 0.0, m1 = 0.0;
    for (const auto& [w, own] : lines) {
        for (; high < lines.size() && lines[high].first <= w * (1.0 + neighbourhood); ++high) {
            m0 += lines[high].second;
            m1 += lines[high].second * lines[high].first;
        }
        for (; lines[low].first < w * (1.0 - neighbourhood); ++low) {
            m0 -= lines[low].second;
            m1 -= lines[low].second * lines[low].first;
        }
        if (m0 > best) best = m0, at = m1 / m0;
    }
    return at;
}

double lowest_of(const Lines& lines) {
    const double all = total(lines);
    double below = 0.0;
    for (const auto& [w, energy] : lines) {
        below += energy;
        if (below > below_the_lowest * all) return w;
    }
    return lines.empty() ? 0.0 : lines.back().first;
}

}  // namespace

bool is_random(const WaveTrain& train) {
    return train.type != WaveType::airy && train.type != WaveType::elevation_file &&
           train.type != WaveType::components;
}

double significant_height(const WaveTrain& train) {
    switch (train.type) {
        case WaveType::airy:
            return std::sqrt(2.0) * train.H;
        case WaveType::spectrum_file:
            return 4.0 * std::sqrt(TabulatedSpectrum{train.spectrum}.energy());
        case WaveType::elevation_file:
        case WaveType::components:
            return 4.0 * std::sqrt(total(lines_of(train)));
        default:
            return train.Hs;
    }
}

FrequencyRange frequency_range(const WaveTrain& train) {
    const auto between = [](double from, double to) -> FrequencyRange {
        return {from, to, to - from};
    };
    if (train.type == WaveType::white_noise) return between(train.band_min, train.band_max);
    if (train.type == WaveType::spectrum_file)
        return between(train.spectrum.front()[0], train.spectrum.back()[0]);
    double low = two_pi / train.Tp, high = low;
    if (train.type == WaveType::ochi_hubble) {
        const OchiHubble s = std::get<OchiHubble>(spectrum_of(train));
        low = two_pi / std::max(s.humps[0].Tp, s.humps[1].Tp);
        high = two_pi / std::min(s.humps[0].Tp, s.humps[1].Tp);
    } else if (train.type == WaveType::torsethaugen) {
        const Torsethaugen s = std::get<Torsethaugen>(spectrum_of(train));
        low = two_pi / std::max(s.humps[0].Tp, s.humps[1].Tp);
        high = two_pi / std::min(s.humps[0].Tp, s.humps[1].Tp);
    }
    const double from = train.range_min * low;
    return {from, train.range_max * high, std::fma(train.range_max, high, -from)};  // rounded once
}

Peaks peaks_of(const WaveTrain& train) {
    switch (train.type) {
        case WaveType::airy:
            return {two_pi / train.T, two_pi / train.T};
        case WaveType::jonswap:
        case WaveType::pierson_moskowitz:
            return {two_pi / train.Tp, two_pi / train.Tp};
        case WaveType::torsethaugen: {
            const auto humps = std::get<Torsethaugen>(spectrum_of(train)).humps;
            const bool swell = humps[1].Hs > 0.0 && humps[1].Tp > humps[0].Tp;
            return {two_pi / train.Tp, two_pi / (swell ? humps[1].Tp : train.Tp)};
        }
        case WaveType::ochi_hubble: {
            const OchiHubble s = std::get<OchiHubble>(spectrum_of(train));
            const double a = two_pi / s.humps[0].Tp, b = two_pi / s.humps[1].Tp;
            return {s.density(a) >= s.density(b) ? a : b, std::min(a, b)};
        }
        case WaveType::white_noise:
            return {0.5 * (train.band_min + train.band_max), train.band_min};
        default:
            break;
    }
    const Lines lines = lines_of(train);
    return {most_energetic(lines), lowest_of(lines)};
}

std::optional<double> main_peak(const std::vector<WaveTrain>& trains) {
    std::optional<double> peak;
    double greatest = -1.0;
    for (const WaveTrain& train : trains)
        if (const double height = significant_height(train); height > greatest || !peak) {
            greatest = height;
            peak = peaks_of(train).highest;
        }
    return peak;
}

std::optional<double> lowest_peak(const std::vector<WaveTrain>& trains) {
    std::optional<double> peak;
    for (const WaveTrain& train : trains) {
        const double own = peaks_of(train).lowest;
        peak = peak ? std::min(*peak, own) : own;
    }
    return peak;
}

}  // namespace hawser
