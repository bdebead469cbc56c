// Wave spectra: check values of validation row C, JONSWAP of Hs 15.2 m, Tp 15.6 s, gamma 2.4.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "environment/spectra.hpp"

namespace hawser {
namespace {

const Jonswap paper_sea{.Hs = 15.2, .wp = 2.0 * std::numbers::pi / 15.6, .gamma = 2.4};

/// Integral of w^n S(w) over 0.05 to 50 times the peak, trapezoidal rule in ln w.
double moment(const Jonswap& spectrum, int n) {
    constexpr int cells = 20000;
    const double step = std::log(1000.0) / cells;
    double total = 0.0;
    for (int i = 0; i <= cells; ++i) {
        const double w = 0.05 * spectrum.wp * std::exp(i * step);
        total += std::pow(w, n + 1) * spectrum.density(w) * step;
    }
    return total;
}

// Given to four digits after the point.
TEST(Jonswap, DensityAgreesWithCheckValues) {
    EXPECT_NEAR(paper_sea.density(0.3), 10.0985, 6e-5);
    EXPECT_NEAR(paper_sea.density(paper_sea.wp), 92.2904, 6e-5);
    EXPECT_NEAR(paper_sea.density(0.5), 27.5472, 6e-5);
    EXPECT_NEAR(paper_sea.density(0.8), 4.0065, 6e-5);
    EXPECT_EQ(paper_sea.density(0.0), 0.0);
}

TEST(Jonswap, MomentsAgreeWithCheckValues) {
    const double m0 = moment(paper_sea, 0);
    EXPECT_NEAR(4.0 * std::sqrt(m0), 15.196, 5e-4);
    EXPECT_NEAR(2.0 * std::numbers::pi * m0 / moment(paper_sea, 1), 12.73, 5e-3);
    EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(m0 / moment(paper_sea, 2)), 11.82, 5e-3);
    // The factor that would make Hs exact; what lies above 10 rad/s is 3e-6 of the energy.
    const double A = (1.0 - 0.287 * std::log(2.4)) * 15.2 * 15.2 / 16.0 / m0;
    EXPECT_NEAR(A, 0.749141, 4e-6);
}

TEST(Jonswap, PiersonMoskowitzIsItsUnenhancedMember) {
    const WaveTrain train{.type = WaveType::pierson_moskowitz, .Hs = 6.0, .Tp = 11.0};
    const auto spectrum = std::get<Jonswap>(spectrum_of(train));
    EXPECT_EQ(spectrum.gamma, 1.0);
    // The Bretschneider form integrates in closed form: m0 = Hs^2/16.
    EXPECT_NEAR(4.0 * std::sqrt(moment(spectrum, 0)), 6.0, 1e-5);
}

// DNV-RP-C205 3.5.5.5.
TEST(Jonswap, MissingGammaFollowsTheDnvRule) {
    EXPECT_EQ(dnv_gamma(16.0, 4.0 * 3.5), 5.0);
    EXPECT_EQ(dnv_gamma(16.0, 4.0 * 5.1), 1.0);
    EXPECT_NEAR(dnv_gamma(15.2, 15.6), std::exp(5.75 - 1.15 * 15.6 / std::sqrt(15.2)), 1e-12);
    EXPECT_NEAR(dnv_gamma(16.0, 4.0 * 4.9999), 1.0, 2e-4);  // continuous at 5: exp(0)

    WaveTrain train{.type = WaveType::jonswap, .Hs = 15.2, .Tp = 15.6};
    EXPECT_EQ(std::get<Jonswap>(spectrum_of(train)).gamma, dnv_gamma(15.2, 15.6));
    train.gamma = 2.4;
    EXPECT_EQ(std::get<Jonswap>(spectrum_of(train)).gamma, 2.4);
}

/// n-th moment of any spectrum up to 40 rad/s: Simpson's rule, steps of 0.5 mrad/s.
double moment_of(const Spectrum& spectrum, int n) {
    constexpr double step = 5e-4;
    constexpr int cells = 80000;
    double sum = 0.0;
    for (int i = 0; i <= cells; ++i) {
        const double w = i * step, weight = i == 0 || i == cells ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * step / 3.0 * std::pow(w, n) * density(spectrum, w);
    }
    return sum;
}

TEST(OchiHubble, HumpOfShapeOneIsPiersonMoskowitz) {
    const OchiHubble two{{SpectrumHump{3.0, 12.0, 1.0}, SpectrumHump{4.0, 12.0, 1.0}}};
    const Jonswap one{.Hs = 5.0, .wp = 2.0 * std::numbers::pi / 12.0};
    for (const double w : {0.3, 0.5, 0.6, 1.0, 2.0})
        EXPECT_NEAR(two.density(w) / one.density(w), 1.0, 1e-12);
    EXPECT_EQ(two.density(0.0), 0.0);
}

// With c = (L + 1/4) wp^4 a hump's moments are Hs^2/16 c^(n/4) Gamma(L - n/4)/Gamma(L).
TEST(OchiHubble, MomentsAreGammaFunctions) {
    for (const double L : {1.5, 3.0, 6.0}) {
        const double wp = 0.6, Hs = 4.0, c = (L + 0.25) * std::pow(wp, 4);
        const OchiHubble hump{
            {SpectrumHump{Hs, 2.0 * std::numbers::pi / wp, L}, SpectrumHump{0.0, 8.0, 1.0}}};
        for (const int n : {0, 1, 2}) {
            const double exact =
                Hs * Hs / 16 * std::pow(c, n / 4.0) * std::tgamma(L - n / 4.0) / std::tgamma(L);
            EXPECT_NEAR(moment_of(hump, n) / exact, 1.0, 1e-5);  // the tail beyond 40 rad/s
        }
        EXPECT_GT(hump.density(wp), hump.density(1.001 * wp));
        EXPECT_GT(hump.density(wp), hump.density(0.999 * wp));
    }
}

TEST(OchiHubble, MostProbableOfTheFamilyHasItsHeight) {  // Ochi and Hubble 1976, Hs 10 m
    const OchiHubble s = most_probable_ochi_hubble(10.0);
    EXPECT_NEAR(4.0 * std::sqrt(moment_of(s, 0)), 10.0, 2e-3);
    EXPECT_NEAR(s.humps[0].Hs, 8.4, 0.02);
    EXPECT_NEAR(s.humps[1].Hs, 5.4, 0.02);
    EXPECT_NEAR(2 * std::numbers::pi / s.humps[0].Tp, 0.4419, 1e-4);  // 0.70 exp(-0.46)
    EXPECT_NEAR(2 * std::numbers::pi / s.humps[1].Tp, 0.7786, 1e-4);  // 1.15 exp(-0.39)
    EXPECT_EQ(s.humps[0].lambda, 3.0);
    EXPECT_NEAR(s.humps[1].lambda, 0.8284, 1e-4);  // 1.54 exp(-0.62)
}

// Values of the formulas of the 1996 report as the toolbox MSS (torsetSpectrum.m, g = 9.81) has
// them: wind sea, swell, swell just past the border.
TEST(Torsethaugen, DensityAgreesWithAnotherProgram) {
    const struct {
        double Hs, Tp;
        std::array<double, 6> density;  // at 0.35, 0.4, 0.5, 0.63, 0.8, 1.2 rad/s
    } rows[] = {
        {8, 10, {2.683786, 3.777106, 5.365822, 12.906477, 3.797296, 0.797412}},
        {4, 16, {1.239533, 4.224264, 1.343518, 1.290927, 0.797720, 0.204392}},
        {12, 15.5, {21.246829, 56.450044, 17.893885, 7.661153, 2.695572, 0.533883}},
    };
    const double w[] = {0.35, 0.4, 0.5, 0.63, 0.8, 1.2};
    for (const auto& row : rows) {
        const Torsethaugen s = torsethaugen(row.Hs, row.Tp, 9.81);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(s.density(w[i]), row.density[i], 1e-6);
        EXPECT_NEAR(4.0 * std::sqrt(moment_of(s, 0)), row.Hs, 0.02 * row.Hs);  // A_g is a fit
        EXPECT_NEAR(std::hypot(s.humps[0].Hs, s.humps[1].Hs), row.Hs, 1e-12);
    }
}

// At Tp = Tf = 6.6 Hs^(1/3) there is one hump, and the two branches meet in the other's height.
TEST(Torsethaugen, BranchesMeetInOneHump) {
    const double Hs = 6.0, Tf = 6.6 * std::cbrt(Hs);
    for (const double Tp : {Tf * (1 - 1e-6), Tf * (1 + 1e-6)})
        EXPECT_NEAR(torsethaugen(Hs, Tp, 9.81).humps[0].Hs, Hs, 1e-9);
}

TEST(WhiteNoise, IsConstantInItsBand) {
    const WhiteNoise s{.Hs = 2.0, .from = 0.3, .to = 1.5};
    EXPECT_DOUBLE_EQ(s.density(0.4), 4.0 / 16 / 1.2);
    EXPECT_EQ(s.density(0.4), s.density(1.4));
    EXPECT_EQ(s.density(0.29), 0.0);
    EXPECT_EQ(s.density(1.51), 0.0);
}

TEST(TabulatedSpectrum, IsLinearBetweenItsRows) {
    const TabulatedSpectrum s{{{0.2, 0.0}, {0.6, 8.0}, {1.6, 2.0}}};
    EXPECT_DOUBLE_EQ(s.density(0.3), 2.0);
    EXPECT_DOUBLE_EQ(s.density(0.6), 8.0);
    EXPECT_DOUBLE_EQ(s.density(1.6), 2.0);
    EXPECT_DOUBLE_EQ(s.density(1.1), 5.0);
    EXPECT_EQ(s.density(0.1), 0.0);
    EXPECT_EQ(s.density(1.7), 0.0);
    EXPECT_DOUBLE_EQ(s.energy(), 1.6 + 5.0);
}

}  // namespace
}  // namespace hawser
