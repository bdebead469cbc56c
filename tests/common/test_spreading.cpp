// Directional spreading: moments of the distribution, of its sectors and of the sea made of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "environment/spreading.hpp"
#include "environment/wave_components.hpp"

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi, depth = 300.0, gravity = 9.80665;

/// Mean of e^(i n angle) over the distribution: trapezoidal rule of a periodic function.
double moment(double s, int n) {
    constexpr int cells = 20000;
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) {
        const double angle = -pi + 2 * pi * i / cells;
        sum += cos2s_density(s, angle) * std::cos(n * angle) * 2 * pi / cells;
    }
    return sum;
}

WaveTrain spread_sea(double s, int directions, int components,
                     Discretisation discretisation = Discretisation::equal_energy) {
    return {.type = WaveType::jonswap,
            .Hs = 6,
            .Tp = 11,
            .gamma = 2,
            .heading = 2.9,
            .seed = 5,
            .components = components,
            .discretisation = discretisation,
            .spreading = Spreading{.s = s, .directions = directions}};
}

/// Energy-weighted mean of e^(i n (b - b0)).
std::complex<double> moment(const std::vector<WaveComponent>& components, double heading, int n) {
    std::complex<double> sum = 0.0;
    double energy = 0.0;
    for (const WaveComponent& c : components) {
        const double a2 = c.amplitude * c.amplitude;
        energy += a2;
        sum += a2 * std::polar(1.0, n * (c.heading - heading));
    }
    return sum / energy;
}

// Beta functions: <cos> = s/(s + 1), <cos 2> = s (s - 1)/((s + 1)(s + 2)).
TEST(Cos2s, DensityHasTheClosedMoments) {
    for (const double s : {1.0, 2.5, 8.0, 50.0}) {
        EXPECT_NEAR(moment(s, 0), 1.0, 1e-9);
        EXPECT_NEAR(moment(s, 1), s / (s + 1), 1e-9);
        EXPECT_NEAR(moment(s, 2), s * (s - 1) / ((s + 1) * (s + 2)), 1e-9);
        EXPECT_EQ(cos2s_density(s, 3.2), 0.0);
    }
    EXPECT_NEAR(cos2s_density(1.0, 0.0), 1 / pi, 1e-15);  // s = 1: (1 + cos)/(2 pi)
}

// Unit vectors stand for sectors: within an inner sector the variance of the angle, 1/n^2, is
// missed; the two end sectors, of energy 1/n each, are wide whatever n is. So the error falls like
// 1/n or faster, with a factor that is the tails' own.
TEST(Cos2s, MomentsOfTheSectorsConverge) {
    for (const double s : {1.0, 4.0, 20.0})
        for (const int n : {5, 10, 20, 40, 80}) {
            double first = 0.0, second = 0.0;
            for (const double b : spread_directions({.s = s, .directions = n})) {
                first += std::cos(b) / n;
                second += std::cos(2 * b) / n;
            }
            EXPECT_NEAR(first, s / (s + 1), 0.07 / n);
            EXPECT_NEAR(second, s * (s - 1) / ((s + 1) * (s + 2)), 0.5 / n);
        }
}

TEST(Cos2s, DirectionsAreSymmetricAndOneIsTheMean) {
    const auto five = spread_directions({.s = 3, .directions = 5});
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(five[i], -five[4 - i]);
    EXPECT_EQ(spread_directions({.s = 3, .directions = 1}), std::vector<double>{0.0});
}

// Equal energy: a hundred components of ten directions have the moments of the ten directions.
TEST(SpreadSea, HasTheMomentsOfItsDirections) {
    const auto components = wave_components(spread_sea(6, 10, 100), depth, gravity);
    double first = 0.0, second = 0.0;
    for (const double b : spread_directions({.s = 6, .directions = 10})) {
        first += std::cos(b) / 10;
        second += std::cos(2 * b) / 10;
    }
    EXPECT_NEAR(std::abs(moment(components, 2.9, 1) - first), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(moment(components, 2.9, 2) - second), 0.0, 1e-12);
    EXPECT_NEAR(first, 6.0 / 7.0, 0.006);
    EXPECT_NEAR(second, 6.0 * 5 / (7 * 8), 0.02);
}

// Bins of unequal energy: the mean holds as well as the directions share the bins of the peak. The
// peak is a tenth of the range, so 1000 components put ten or so sets of directions there.
TEST(SpreadSea, MomentsConvergeWithUnequalEnergiesToo) {
    const auto components = wave_components(
        spread_sea(6, 10, 2000, Discretisation::equal_frequency_random), depth, gravity);
    EXPECT_NEAR(std::abs(moment(components, 2.9, 1) - 6.0 / 7.0), 0.0, 0.01);
    EXPECT_NEAR(std::abs(moment(components, 2.9, 2) - 30.0 / 56.0), 0.0, 0.03);
}

TEST(SpreadSea, EveryRunOfComponentsHasEveryDirectionOnceAndNoFrequencyTwice) {
    const auto components = wave_components(spread_sea(6, 8, 80), depth, gravity);
    std::set<double> frequencies;
    for (const WaveComponent& c : components) frequencies.insert(c.omega);
    EXPECT_EQ(frequencies.size(), 80u);
    std::set<std::vector<double>> orders;
    for (std::size_t run = 0; run < 80; run += 8) {
        std::vector<double> headings;
        for (std::size_t i = 0; i < 8; ++i) headings.push_back(components[run + i].heading);
        orders.insert(headings);
        std::sort(headings.begin(), headings.end());
        const auto expected = spread_directions({.s = 6, .directions = 8});
        for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(headings[i], 2.9 + expected[i]);
    }
    EXPECT_GE(orders.size(), 9u);  // shuffled, and not always alike
}

TEST(SpreadSea, OnlyHeadingsDifferFromTheLongCrestedSea) {
    WaveTrain train = spread_sea(6, 8, 80);
    const auto spread = wave_components(train, depth, gravity);
    train.seed = 6;
    const auto other = wave_components(train, depth, gravity);
    train.seed = 5;
    const auto again = wave_components(train, depth, gravity);
    train.spreading.reset();
    const auto plain = wave_components(train, depth, gravity);
    bool differs = false;
    for (std::size_t i = 0; i < 80; ++i) {
        EXPECT_EQ(spread[i].omega, plain[i].omega);
        EXPECT_EQ(spread[i].phase, plain[i].phase);
        EXPECT_EQ(spread[i].heading, again[i].heading);
        differs = differs || spread[i].heading != other[i].heading;
    }
    EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace hawser
