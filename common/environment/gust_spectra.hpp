// Winds with a power-law profile. Sources: API RP 2A-WSD (20th edition, 2.3.2b); IEC 61400-1 annex
// B (Kaimal), profile of IEC 61400-3 for the open sea. Mean speeds over an hour, or over the ten
// minutes that IEC uses. Frequencies f in Hz, one-sided densities in m2/s.
#pragma once

namespace hawser {

/// Wind of API RP 2A.
struct ApiWind {
    double U0 = 0.0;  ///< mean speed at 10 m [m/s]

    /// U = U0 (z/10)^0.125 [m/s].
    [[nodiscard]] double mean(double z) const;
    /// Standard deviation of the gusts [m/s]: 0.15 U (z/20)^-0.125 up to 20 m, 0.15 U (z/20)^-0.275
    /// above.
    [[nodiscard]] double deviation(double z) const;
    /// S = sigma^2/fp (1 + 1.5 f/fp)^(-5/3), fp = 0.025 U/z: the middle of the range 0.01 to 0.1
    /// that is recommended. Carries sigma^2 from 0 to infinity.
    [[nodiscard]] double gust_density(double z, double f) const;
};

/// The wind whose mean at `height` [m] is `speed` [m/s].
ApiWind api_wind(double speed, double height);

/// Wind of IEC 61400.
struct KaimalWind {
    double speed = 0.0, height = 10.0;  ///< mean [m/s] at [m]
    double intensity = 0.0;  ///< of turbulence: standard deviation over mean, all heights

    /// U = speed (z/height)^0.14 [m/s].
    [[nodiscard]] double mean(double z) const;
    /// S = 4 sigma^2 L/U (1 + 6 f L/U)^(-5/3), sigma = intensity U, L = 8.1 times 0.7 z (42 m from
    /// z = 60 m on). Carries sigma^2 from 0 to infinity.
    [[nodiscard]] double gust_density(double z, double f) const;
};

/// Frequency range of these gusts [Hz].
inline constexpr double hour_lowest_frequency = 1.0 / 3600.0;
inline constexpr double hour_highest_frequency = 1.0;

}  // namespace hawser
