// NPD wind: check values of validation row C (87.5 knots = 45.0138 m/s), gusts in time.
#include <gtest/gtest.h>

#include <cmath>

#include "environment/gust_spectra.hpp"
#include "environment/npd.hpp"
#include "environment/wind.hpp"

namespace hawser {
namespace {

constexpr NpdWind hurricane{.U0 = 45.0138};
const Wind paper_wind{.spectrum = WindSpectrum::npd, .speed = 45.0138, .heading = 0.0, .seed = 11};

double standard_deviation(const std::vector<GustComponent>& gusts) {
    double variance = 0.0;
    for (const GustComponent& g : gusts) variance += 0.5 * g.amplitude * g.amplitude;
    return std::sqrt(variance);
}

// Given to the digits shown.
TEST(Npd, ProfileAndSpectrumAgreeWithCheckValues) {
    EXPECT_NEAR(hurricane.mean(20.0), 49.992, 5e-4);
    EXPECT_NEAR(hurricane.mean(30.0), 52.903, 5e-4);
    EXPECT_NEAR(hurricane.mean(50.0), 56.572, 5e-4);
    EXPECT_NEAR(hurricane.mean(100.0), 61.550, 5e-4);
    EXPECT_NEAR(hurricane.turbulence_intensity(10.0), 0.17614, 5e-6);
    EXPECT_NEAR(hurricane.gust_density(10.0, 0.01), 865.71, 5e-3);
    EXPECT_NEAR(hurricane.gust_density(10.0, 0.1), 99.305, 5e-4);
    EXPECT_NEAR(hurricane.gust_density(30.0, 0.01), 795.42, 5e-3);
    EXPECT_NEAR(hurricane.gust_density(30.0, 0.1), 67.142, 5e-4);
}

// ISO 19901-1: u = U [1 - 0.41 Iu ln(t/3600)]; at 10 m and one minute 45.0138 (1 + 0.41 x 0.17614 x
// ln 60) = 58.324 m/s.
TEST(Npd, ShorterAveragesAreHigher) {
    EXPECT_NEAR(hurricane.mean(10.0, 60.0), 58.324, 2e-3);
    EXPECT_EQ(hurricane.mean(30.0, 3600.0), hurricane.mean(30.0));
    EXPECT_EQ(hurricane.mean(30.0, 10800.0), hurricane.mean(30.0));
}

TEST(Npd, SpeedOfAnyAveragingAndHeightGivesBackTheHourlyMean) {
    for (const double averaging : {3.0, 60.0, 600.0, 3600.0})
        for (const double height : {2.0, 10.0, 30.0, 90.0})
            EXPECT_NEAR(npd_wind(hurricane.mean(height, averaging), averaging, height).U0, 45.0138,
                        1e-12)
                << averaging << " s, " << height << " m";
    EXPECT_NEAR(npd_wind(0.0, 3600.0, 10.0).U0, 0.0, 1e-12);
}

// The standard deviation over 1/600 to 0.5 Hz, given to four digits.
TEST(WindField, GustsHaveTheStandardDeviationOfTheBand) {
    EXPECT_NEAR(standard_deviation(WindField(paper_wind, 0.0, 10.0).components()), 6.915, 1e-3);
    EXPECT_NEAR(standard_deviation(WindField(paper_wind, 0.0, 30.0).components()), 6.173, 1e-3);
}

TEST(WindField, MeanIsThatOfTheHeight) {
    EXPECT_NEAR(WindField(paper_wind, 100.0, 30.0).mean_speed(), 52.903, 5e-4);
    Wind minute = paper_wind;
    minute.speed = hurricane.mean(20.0, 60.0);
    minute.averaging = 60.0;
    minute.reference_height = 20.0;
    EXPECT_NEAR(WindField(minute, 100.0, 30.0).mean_speed(), 52.903, 5e-4);
}

// Frequencies inside the band; lines 2.9 % apart on average, so 0.045 rad/s (surge) is resolved.
TEST(WindField, ComponentsFillTheBand) {
    const auto gusts = WindField(paper_wind, 0.0, 30.0).components();
    ASSERT_EQ(gusts.size(), 200u);
    double last = 2.0 * M_PI / 600.0;
    for (const GustComponent& g : gusts) {
        EXPECT_GE(g.omega, last);
        EXPECT_LE(g.omega / last, 1.06);  // neighbouring bins of 2.9 %: at most two of them apart
        last = g.omega;
    }
    EXPECT_LE(last, M_PI);
}

// One in each of 200 bins of equal width in ln f, its place in the bin uniform: mean 1/2, variance
// 1/12 (five standard errors of 200 numbers), and both halves of the bins are used.
TEST(WindField, FrequenciesAreRandomInsideTheirBins) {
    const auto gusts = WindField(paper_wind, 0.0, 30.0).components();
    const double bin = std::log(300.0) / 200;  // 1/600 to 0.5 Hz
    double mean = 0.0, square = 0.0;
    for (std::size_t i = 0; i < gusts.size(); ++i) {
        const double place =
            std::log(gusts[i].omega / (2.0 * M_PI / 600.0)) / bin - static_cast<double>(i);
        EXPECT_GE(place, -1e-9) << i;
        EXPECT_LE(place, 1.0 + 1e-9) << i;
        mean += place / 200.0, square += place * place / 200.0;
    }
    EXPECT_NEAR(mean, 0.5, 5.0 * std::sqrt(1.0 / 12 / 200));
    EXPECT_NEAR(square - mean * mean, 1.0 / 12, 5.0 * std::sqrt(1.0 / 180 / 200));
}

// Most of the energy lies below 0.02 Hz on some 80 lines of unequal strength: correlations of the
// order of 0.2 remain, a repetition would be 1.
TEST(WindField, GustsDoNotRepeatWithinThreeHours) {
    const auto gusts = WindField(paper_wind, 0.0, 30.0).components();
    double largest = 0.0, total = 0.0;
    for (const GustComponent& g : gusts) total += g.amplitude * g.amplitude;
    for (double lag = 600.0; lag < 10800.0; lag += 5.0) {
        double correlation = 0.0;
        for (const GustComponent& g : gusts)
            correlation += g.amplitude * g.amplitude * std::cos(g.omega * lag);
        largest = std::max(largest, std::abs(correlation) / total);
    }
    EXPECT_LT(largest, 0.5);
}

TEST(WindField, GustsAreRampedAndTheMeanIsNot) {
    const WindField ramped(paper_wind, 100.0, 30.0), full(paper_wind, 0.0, 30.0);
    EXPECT_EQ(ramped.speed(0.0), ramped.mean_speed());
    EXPECT_NEAR(ramped.speed(50.0) - ramped.mean_speed(),
                0.5 * (full.speed(50.0) - full.mean_speed()), 1e-13);
    EXPECT_EQ(ramped.speed(200.0), full.speed(200.0));
    EXPECT_NE(full.speed(200.0), full.mean_speed());
}

// The mean of 200 unit vectors of random direction is 1/sqrt(200) = 0.07 long; three times that is
// exceeded once in 8000 seeds.
TEST(WindField, PhasesAreRandom) {
    double x = 0.0, y = 0.0;
    const WindField wind(paper_wind, 0.0, 30.0);
    for (const GustComponent& g : wind.components()) {
        x += std::cos(g.phase) / 200.0;
        y += std::sin(g.phase) / 200.0;
    }
    EXPECT_LT(std::hypot(x, y), 0.21);
}

TEST(WindField, FollowsFromItsSeed) {
    Wind other = paper_wind;
    EXPECT_EQ(WindField(paper_wind, 0.0, 30.0).speed(77.0),
              WindField(other, 0.0, 30.0).speed(77.0));
    other.seed = 12;
    EXPECT_NE(WindField(paper_wind, 0.0, 30.0).speed(77.0),
              WindField(other, 0.0, 30.0).speed(77.0));
}

TEST(WindField, ConstantWindIsTheGivenSpeedEverywhere) {
    const Wind steady{.spectrum = WindSpectrum::constant, .speed = 20.0};
    EXPECT_EQ(WindField(steady, 100.0, 70.0).speed(123.0), 20.0);
    EXPECT_EQ(WindField(steady, 100.0, 70.0).mean_speed(), 20.0);
}

// --- other winds -------------------------------------------------------------------------------

/// Energy between two frequencies [Hz]: Simpson's rule in ln f.
template <class Density>
double energy_between(const Density& density, double a, double b) {
    constexpr int cells = 20000;
    const double width = std::log(b / a) / cells;
    double sum = 0.0;
    for (int i = 0; i <= cells; ++i) {
        const double f = a * std::exp(i * width);
        sum += (i == 0 || i == cells ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * width / 3.0 * f * density(f);
    }
    return sum;
}

// The closed integral of (1 + c f)^(-5/3): energy above f is sigma^2 (1 + c f)^(-2/3).
TEST(ApiWind, SpectrumHasTheClosedEnergyAndProfile) {
    const ApiWind wind{.U0 = 30.0};
    for (const double z : {10.0, 40.0}) {
        const double sigma = wind.deviation(z), fp = 0.025 * wind.mean(z) / z;
        const auto above = [&](double f) {
            return sigma * sigma * std::pow(1 + 1.5 * f / fp, -2.0 / 3);
        };
        EXPECT_NEAR(energy_between([&](double f) { return wind.gust_density(z, f); }, 1e-3, 2.0),
                    above(1e-3) - above(2.0), 1e-8);
    }
    EXPECT_DOUBLE_EQ(wind.mean(10.0), 30.0);
    EXPECT_NEAR(wind.mean(80.0), 30.0 * std::pow(8.0, 0.125), 1e-12);
    EXPECT_NEAR(wind.deviation(20.0), 0.15 * wind.mean(20.0), 1e-12);
    EXPECT_NEAR(wind.deviation(10.0), 0.15 * 30.0 * 1.0905, 1e-3);             // 2^0.125
    EXPECT_NEAR(wind.deviation(40.0), 0.15 * wind.mean(40.0) * 0.8265, 1e-3);  // 2^-0.275
    EXPECT_NEAR(wind.gust_density(10.0, 0.0), std::pow(wind.deviation(10), 2) / 0.075, 1e-9);
    EXPECT_NEAR(api_wind(wind.mean(35.0), 35.0).U0, 30.0, 1e-12);
}

TEST(KaimalWind, SpectrumHasTheClosedEnergyAndProfile) {
    const KaimalWind wind{.speed = 18.0, .height = 90.0, .intensity = 0.14};
    for (const double z : {20.0, 90.0}) {
        const double sigma = 0.14 * wind.mean(z);
        const double time = 8.1 * (z > 60.0 ? 42.0 : 0.7 * z) / wind.mean(z);
        const auto above = [&](double f) {
            return sigma * sigma * std::pow(1 + 6 * f * time, -2.0 / 3);
        };
        EXPECT_NEAR(energy_between([&](double f) { return wind.gust_density(z, f); }, 1e-3, 2.0),
                    above(1e-3) - above(2.0), 1e-8);
    }
    EXPECT_DOUBLE_EQ(wind.mean(90.0), 18.0);
    EXPECT_NEAR(wind.mean(45.0), 18.0 * std::pow(0.5, 0.14), 1e-12);
}

// The gusts carry the closed energy of their band.
TEST(WindField, ApiAndKaimalGustsHaveTheStandardDeviationOfTheBand) {
    const Wind api{.spectrum = WindSpectrum::api, .speed = 25.0, .seed = 2};
    Wind kaimal = api;
    kaimal.spectrum = WindSpectrum::kaimal;
    kaimal.turbulence_intensity = 0.1;
    const double z = 30.0, low = 1.0 / 3600, high = 1.0;
    const ApiWind a{.U0 = 25.0};
    const KaimalWind k{.speed = 25.0, .height = 10.0, .intensity = 0.1};
    const auto share = [&](double c) {
        return std::pow(1 + c * low, -2.0 / 3) - std::pow(1 + c * high, -2.0 / 3);
    };
    const WindField api_field(api, 0.0, z), kaimal_field(kaimal, 0.0, z);
    EXPECT_NEAR(standard_deviation(api_field.components()),
                a.deviation(z) * std::sqrt(share(1.5 * z / (0.025 * a.mean(z)))), 1e-6);
    EXPECT_NEAR(standard_deviation(kaimal_field.components()),
                0.1 * k.mean(z) * std::sqrt(share(6 * 8.1 * 0.7 * z / k.mean(z))), 1e-6);
    EXPECT_EQ(api_field.mean_speed(), a.mean(z));
    EXPECT_EQ(kaimal_field.mean_speed(), k.mean(z));
}

TEST(WindField, TimeHistoryIsLinearBetweenItsRows) {
    const Wind measured{.spectrum = WindSpectrum::time_history,
                        .history = {{10.0, 8.0}, {20.0, 14.0}, {50.0, 11.0}}};
    const WindField full(measured, 0.0, 30.0), ramped(measured, 100.0, 30.0);
    EXPECT_DOUBLE_EQ(full.mean_speed(), (110.0 + 375.0) / 40.0);
    EXPECT_DOUBLE_EQ(full.speed(15.0), 11.0);
    EXPECT_DOUBLE_EQ(full.speed(20.0), 14.0);
    EXPECT_DOUBLE_EQ(full.speed(35.0), 12.5);
    EXPECT_DOUBLE_EQ(full.speed(0.0), 8.0);
    EXPECT_DOUBLE_EQ(full.speed(90.0), 11.0);
    EXPECT_DOUBLE_EQ(ramped.speed(50.0), 0.5 * (full.mean_speed() + 11.0));
}

}  // namespace
}  // namespace hawser
