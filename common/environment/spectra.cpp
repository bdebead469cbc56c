// Densities of the spectra.
#include "environment/spectra.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace hawser {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// E G0 A_g/(2 pi) of a hump of Torsethaugen's spectrum; A_g = (1 + a (ln gamma)^b)/gamma.
double torsethaugen_factor(const Torsethaugen::Hump& h, double N) {
    const double M = h.M, q = (N - 1.0) / M;
    const double G0 = M * std::pow(N / M, q) / std::tgamma(q);
    const double a =
        4.1 * std::pow(N - 2.0 * std::pow(M, 0.28) + 5.3, 0.96 - 1.45 * std::pow(M, 0.1));
    const double b =
        (2.2 * std::pow(M, -3.3) + 0.57) * std::pow(N, 0.53 - 0.58 * std::pow(M, 0.37)) + 0.94 -
        1.04 * std::pow(M, -1.9);
    const double A = (1.0 + a * std::pow(std::log(h.gamma), b)) / h.gamma;
    return h.Hs * h.Hs / 16.0 * h.Tp * G0 * A / two_pi;
}

}  // namespace

double Jonswap::density(double w) const {
    if (w <= 0.0) return 0.0;
    const double A = 1.0 - 0.287 * std::log(gamma);
    const double s = w <= wp ? 0.07 : 0.09;
    const double from_peak = (w - wp) / (s * wp);
    const double b = std::exp(-0.5 * from_peak * from_peak);
    const double ratio4 = std::pow(wp / w, 4);
    return A * 5.0 / 16.0 * Hs * Hs * ratio4 / w * std::exp(-1.25 * ratio4) * std::pow(gamma, b);
}

double OchiHubble::density(double w) const {
    if (w <= 0.0) return 0.0;
    double S = 0.0;
    for (const SpectrumHump& h : humps) {
        const double c = (h.lambda + 0.25) * std::pow(two_pi / (h.Tp * w), 4);
        S += 0.25 * h.Hs * h.Hs / w * std::exp(h.lambda * std::log(c) - c - std::lgamma(h.lambda));
    }
    return S;
}

OchiHubble most_probable_ochi_hubble(double Hs) {
    const double scale = Hs / std::hypot(0.84, 0.54);
    return {{SpectrumHump{0.84 * scale, two_pi / (0.70 * std::exp(-0.046 * Hs)), 3.0},
             SpectrumHump{0.54 * scale, two_pi / (1.15 * std::exp(-0.039 * Hs)),
                          1.54 * std::exp(-0.062 * Hs)}}};
}

double Torsethaugen::density(double w) const {
    if (w <= 0.0) return 0.0;
    double S = 0.0;
    for (const Hump& h : humps) {
        const double x = w * h.Tp / two_pi, s = x < 1.0 ? 0.07 : 0.09;
        const double b = std::exp(-0.5 * (x - 1.0) * (x - 1.0) / (s * s));
        S += h.factor * std::pow(x, -N) * std::exp(-N / h.M * std::pow(x, -h.M)) *
             std::pow(h.gamma, b);
    }
    return S;
}

Torsethaugen torsethaugen(double Hs, double Tp, double gravity) {
    Torsethaugen t;
    t.N = 0.5 * std::sqrt(Hs) + 3.2;
    const double Tf = 6.6 * std::cbrt(Hs), highest = 25.0;
    const double steep = 35.0 * (1.0 + 3.5 * std::exp(-Hs));
    const auto square = [](double x) { return x * x; };
    Torsethaugen::Hump &first = t.humps[0], &second = t.humps[1];
    first.Tp = Tp;
    if (Tp <= Tf) {  // wind sea dominates, swell adds
        const double r =
            0.7 + 0.3 * std::exp(-square(2.0 * (Tf - Tp) / (Tf - 2.0 * std::sqrt(Hs))));
        first.Hs = r * Hs;
        first.gamma = steep * std::pow(two_pi / gravity * first.Hs / (Tp * Tp), 0.857);
        second = {.Hs = std::sqrt(1.0 - r * r) * Hs, .Tp = Tf + 2.0};
    } else {  // swell dominates, wind sea adds
        const double past = std::min((Tp - Tf) / (highest - Tf), 1.0);
        const double r = 0.6 + 0.4 * std::exp(-square(past / 0.3));
        first.Hs = r * Hs;
        first.gamma =
            steep * std::pow(two_pi / gravity * Hs / (Tf * Tf), 0.857) * (1.0 + 6.0 * past);
        second = {.Hs = std::sqrt(1.0 - r * r) * Hs, .M = 4.0 * (1.0 - 0.7 * std::exp(-Hs / 3.0))};
        const double q = (t.N - 1.0) / second.M;
        const double G0 = second.M * std::pow(t.N / second.M, q) / std::tgamma(q);
        const double level = std::max(0.01, 0.08 * (1.0 - std::exp(-Hs / 3.0)));
        second.Tp =
            std::max(2.5, std::pow(G0 * second.Hs * second.Hs / (16.0 * level * std::pow(0.4, t.N)),
                                   1.0 / (t.N - 1.0)));
    }
    first.gamma = std::max(first.gamma, 1.0);
    for (Torsethaugen::Hump& h : t.humps) h.factor = torsethaugen_factor(h, t.N);
    return t;
}

double WhiteNoise::density(double w) const {
    return w >= from && w <= to ? Hs * Hs / 16.0 / (to - from) : 0.0;
}

double TabulatedSpectrum::density(double w) const {
    if (rows.empty() || w < rows.front()[0] || w > rows.back()[0]) return 0.0;
    const auto above = std::upper_bound(rows.begin() + 1, rows.end() - 1, w,
                                        [](double x, const auto& row) { return x < row[0]; });
    const auto& [w1, S1] = *above;
    const auto& [w0, S0] = *(above - 1);
    return std::lerp(S0, S1, (w - w0) / (w1 - w0));
}

double TabulatedSpectrum::energy() const {
    double m0 = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        m0 += 0.5 * (rows[i][0] - rows[i - 1][0]) * (rows[i][1] + rows[i - 1][1]);
    return m0;
}

double dnv_gamma(double Hs, double Tp) {
    const double p = Tp / std::sqrt(Hs);
    if (p <= 3.6) return 5.0;
    if (p >= 5.0) return 1.0;
    return std::exp(5.75 - 1.15 * p);
}

Spectrum spectrum_of(const WaveTrain& train, double gravity) {
    switch (train.type) {
        case WaveType::ochi_hubble:
            if (train.humps.size() == 2) return OchiHubble{{train.humps[0], train.humps[1]}};
            return most_probable_ochi_hubble(train.Hs);
        case WaveType::torsethaugen:
            return torsethaugen(train.Hs, train.Tp, gravity);
        case WaveType::white_noise:
            return WhiteNoise{.Hs = train.Hs, .from = train.band_min, .to = train.band_max};
        case WaveType::spectrum_file:
            return TabulatedSpectrum{train.spectrum};
        default:
            break;
    }
    assert(train.type == WaveType::jonswap || train.type == WaveType::pierson_moskowitz);
    const bool enhanced = train.type == WaveType::jonswap;
    return Jonswap{.Hs = train.Hs,
                   .wp = two_pi / train.Tp,
                   .gamma = enhanced ? train.gamma.value_or(dnv_gamma(train.Hs, train.Tp)) : 1.0};
}

double density(const Spectrum& spectrum, double w) {
    return std::visit([w](const auto& s) { return s.density(w); }, spectrum);
}

}  // namespace hawser
