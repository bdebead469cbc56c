// Wave spectra: check values of validation row C, JONSWAP of Hs 15.2 m, Tp 15.6 s, gamma 2.4.
#include <gtest/gtest.h>

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
    const Jonswap spectrum = spectrum_of(train);
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
    EXPECT_EQ(spectrum_of(train).gamma, dnv_gamma(15.2, 15.6));
    train.gamma = 2.4;
    EXPECT_EQ(spectrum_of(train).gamma, 2.4);
}

}  // namespace
}  // namespace hawser
