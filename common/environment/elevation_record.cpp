// Fourier transform of a record, for the frequencies of a band.
#include "environment/elevation_record.hpp"

#include <cmath>
#include <numbers>

namespace hawser {

namespace {

constexpr double rounding = 1e-9;  // of the ends of the band

double mean_of(const WaveTrain& train) {
    double sum = 0.0;
    for (const auto& [t, eta] : train.record) sum += eta;
    return sum / static_cast<double>(train.record.size());
}

}  // namespace

std::vector<Harmonic> record_harmonics(const WaveTrain& train) {
    std::vector<Harmonic> harmonics;
    const std::size_t N = train.record.size();
    if (N < 2) return harmonics;
    const double t0 = train.record.front()[0];
    const double dt = (train.record.back()[0] - t0) / static_cast<double>(N - 1);
    const double mean = mean_of(train);
    const double step = 2.0 * std::numbers::pi / (static_cast<double>(N) * dt);
    std::vector<double> cosine(N), sine(N);  // of 2 pi n/N: all that the transform needs
    for (std::size_t n = 0; n < N; ++n) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(N);
        cosine[n] = std::cos(angle);
        sine[n] = std::sin(angle);
    }
    for (std::size_t m = 1; 2 * m <= N; ++m) {
        const double omega = step * static_cast<double>(m);
        if (omega < train.band_min * (1.0 - rounding)) continue;
        if (omega > train.band_max * (1.0 + rounding)) break;
        double re = 0.0, im = 0.0;
        std::size_t turn = 0;  // m n modulo N
        for (std::size_t n = 0; n < N; ++n) {
            const double eta = train.record[n][1] - mean;
            re += eta * cosine[turn];
            im -= eta * sine[turn];
            turn += m;
            if (turn >= N) turn -= N;
        }
        const double both = 2 * m == N ? 1.0 : 2.0;
        harmonics.push_back({.omega = omega,
                             .amplitude = both * std::hypot(re, im) / static_cast<double>(N),
                             .phase = std::atan2(im, re) - omega * t0});
    }
    return harmonics;
}

double kept_by_band(const WaveTrain& train) {
    const double mean = mean_of(train);
    double all = 0.0, kept = 0.0;
    for (const auto& [t, eta] : train.record)
        all += (eta - mean) * (eta - mean) / static_cast<double>(train.record.size());
    for (const Harmonic& h : record_harmonics(train)) kept += 0.5 * h.amplitude * h.amplitude;
    return all > 0.0 ? kept / all : 0.0;
}

}  // namespace hawser
