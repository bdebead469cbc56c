// Spectra of the sea surface, one-sided, in circular frequency. Sources: JONSWAP and
// Pierson-Moskowitz in the form of DNV-RP-C205 3.5.5 (ISO 19901-1 has the same); Ochi and Hubble
// 1976; Torsethaugen 1996 as DNV-RP-C205 appendix A has it.
#pragma once

#include <array>
#include <utility>
#include <variant>
#include <vector>

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

/// Two humps of Ochi and Hubble, each (L = lambda):
///
///     S = 1/4 ((L + 1/4) wp^4)^L / Gamma(L) Hs^2 w^-(4 L + 1) exp(-(L + 1/4) (wp/w)^4)
///
/// Each carries exactly Hs^2/16; L = 1 is Pierson-Moskowitz.
struct OchiHubble {
    std::array<SpectrumHump, 2> humps;

    [[nodiscard]] double density(double w) const;
};

/// The most probable of the eleven members of the family for a significant height [m], from 800
/// spectra of the North Atlantic:
///
///     Hs1 = 0.84 Hs   wp1 = 0.70 exp(-0.046 Hs)   L1 = 3.00
///     Hs2 = 0.54 Hs   wp2 = 1.15 exp(-0.039 Hs)   L2 = 1.54 exp(-0.062 Hs)
///
/// The heights are rounded there: together they make 0.9986 Hs, which is scaled to Hs here.
OchiHubble most_probable_ochi_hubble(double Hs);

/// Torsethaugen's two-peaked spectrum of the Norwegian shelf (fetch 370 km): a primary hump at Tp
/// and a secondary one, each E G0 A_g x^-N exp(-N/M x^-M) g^b with x = f Tp_j, E = Hs_j^2 Tp_j/16,
/// b as in Jonswap (only the primary hump is enhanced), N = 0.5 sqrt(Hs) + 3.2. Wind sea dominates
/// below Tf = 6.6 Hs^(1/3), swell above.
struct Torsethaugen {
    struct Hump {
        double Hs = 0.0, Tp = 0.0, gamma = 1.0, M = 4.0;
        double factor = 0.0;  ///< E G0 A_g/(2 pi)
    };
    double N = 0.0;
    std::array<Hump, 2> humps;

    [[nodiscard]] double density(double w) const;
};
Torsethaugen torsethaugen(double Hs, double Tp, double gravity);

/// Hs^2/16/(to - from) between two frequencies, 0 outside.
struct WhiteNoise {
    double Hs = 0.0, from = 0.0, to = 0.0;

    [[nodiscard]] double density(double w) const;
};

/// Linear between rows of frequency and density, 0 outside.
struct TabulatedSpectrum {
    std::vector<std::array<double, 2>> rows;

    [[nodiscard]] double density(double w) const;
    [[nodiscard]] double energy() const;  ///< m0, exact for the straight pieces [m2]
};

/// Peak enhancement where none is given, DNV-RP-C205 3.5.5.5, with p = Tp/sqrt(Hs) [s/m^0.5]:
///
///     gamma = 5 for p <= 3.6,   exp(5.75 - 1.15 p) between,   1 for p >= 5
double dnv_gamma(double Hs, double Tp);

using Spectrum = std::variant<Jonswap, OchiHubble, Torsethaugen, WhiteNoise, TabulatedSpectrum>;

/// Spectrum of a train of a type that has one.
Spectrum spectrum_of(const WaveTrain& train, double gravity = 9.80665);
double density(const Spectrum& spectrum, double w);

}  // namespace hawser
