// JONSWAP and Pierson-Moskowitz spectra.
#include "environment/spectra.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace hawser {

double Jonswap::density(double w) const {
    if (w <= 0.0) return 0.0;
    const double A = 1.0 - 0.287 * std::log(gamma);
    const double s = w <= wp ? 0.07 : 0.09;
    const double from_peak = (w - wp) / (s * wp);
    const double b = std::exp(-0.5 * from_peak * from_peak);
    const double ratio4 = std::pow(wp / w, 4);
    return A * 5.0 / 16.0 * Hs * Hs * ratio4 / w * std::exp(-1.25 * ratio4) * std::pow(gamma, b);
}

double dnv_gamma(double Hs, double Tp) {
    const double p = Tp / std::sqrt(Hs);
    if (p <= 3.6) return 5.0;
    if (p >= 5.0) return 1.0;
    return std::exp(5.75 - 1.15 * p);
}

Jonswap spectrum_of(const WaveTrain& train) {
    assert(train.type != WaveType::airy);
    const bool enhanced = train.type == WaveType::jonswap;
    return {.Hs = train.Hs,
            .wp = 2.0 * std::numbers::pi / train.Tp,
            .gamma = enhanced ? train.gamma.value_or(dnv_gamma(train.Hs, train.Tp)) : 1.0};
}

}  // namespace hawser
