// Spectra of the sea surface. Source: JONSWAP and Pierson-Moskowitz in the form of DNV-RP-C205
// 3.5.5 (ISO 19901-1 has the same). One-sided, in circular frequency.
#pragma once

#include "case/environment.hpp"

namespace hawser {

/// Parameters of a JONSWAP spectrum; gamma = 1 is Pierson-Moskowitz.
struct Jonswap {
    double Hs = 0.0;     ///< significant wave height [m]
    double wp = 0.0;     ///< circular frequency of the peak [rad/s]
    double gamma = 1.0;  ///< peak enhancement [-]

    /// Density [m2.s] at circular frequency w [rad/s]:
    ///
    ///     S = A 5/16 Hs^2 wp^4 w^-5 exp(-5/4 (wp/w)^4) gamma^b
    ///     b = exp(-(w - wp)^2/(2 s^2 wp^2)),  s = 0.07 below the peak, 0.09 above
    ///     A = 1 - 0.287 ln gamma
    ///
    /// A makes 4 sqrt(m0) = Hs to about 0.2 % only; wave_components() scales the rest away.
    [[nodiscard]] double density(double w) const;
};

/// Peak enhancement where none is given, DNV-RP-C205 3.5.5.5, with p = Tp/sqrt(Hs) [s/m^0.5]:
///
///     gamma = 5 for p <= 3.6,   exp(5.75 - 1.15 p) between,   1 for p >= 5
double dnv_gamma(double Hs, double Tp);

/// Spectrum of a wave train of type jonswap or pierson_moskowitz.
Jonswap spectrum_of(const WaveTrain& train);

}  // namespace hawser
