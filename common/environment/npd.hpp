// The NPD wind model: mean profile, averaging, gust spectrum. Source: ISO 19901-1 section 7.3 (API
// RP 2MET gives the same). For strong wind over open sea; t in [3 s, 1 h], z above 0.
#pragma once

namespace hawser {

/// Wind described by one number.
struct NpdWind {
    double U0 = 0.0;  ///< 1 h mean speed at 10 m [m/s]

    /// 1 h mean speed [m/s] at height z [m]: U = U0 [1 + C ln(z/10)], C = 0.0573 sqrt(1 + 0.15 U0).
    [[nodiscard]] double mean(double z) const;
    /// Turbulence intensity at height z [m]: Iu = 0.06 (1 + 0.043 U0) (z/10)^-0.22.
    [[nodiscard]] double turbulence_intensity(double z) const;
    /// Speed averaged over `averaging` [s], the highest such mean of the hour [m/s]:
    /// u = U [1 - 0.41 Iu ln(averaging/3600)]. Averages over more than an hour equal the hour's.
    [[nodiscard]] double mean(double z, double averaging) const;
    /// Spectral density of the gusts [m2/s] at height z [m] and frequency f [Hz], one-sided:
    ///
    ///     S = 320 (U0/10)^2 (z/10)^0.45 (1 + x^n)^(-5/(3n)),   n = 0.468
    ///     x = 172 f (z/10)^(2/3) (U0/10)^(-3/4)
    [[nodiscard]] double gust_density(double z, double f) const;
};

/// The wind whose mean over `averaging` [s] at `height` [m] is `speed` [m/s].
NpdWind npd_wind(double speed, double averaging, double height);

/// Frequency range of the gust spectrum [Hz].
inline constexpr double npd_lowest_frequency = 1.0 / 600.0;
inline constexpr double npd_highest_frequency = 0.5;

}  // namespace hawser
