// The sea of a case: blocks of points, ramp, current with waves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "environment/sea.hpp"

namespace hawser {
namespace {

Environment storm() {
    Environment environment;
    environment.seabed.depth = 1500.0;
    environment.waves = {{.type = WaveType::jonswap,
                          .Hs = 15.2,
                          .Tp = 15.6,
                          .gamma = 2.4,
                          .heading = 0.3,
                          .seed = 5}};
    environment.current =
        Current{.heading = 0.5, .profile = {{0.0, 1.9, {}}, {40.0, 1.4, {}}, {75.0, 0.0, {}}}};
    return environment;
}

/// Seven numbers of n points.
struct Water {
    explicit Water(std::size_t n) : values(7, std::vector<double>(n)) {}
    WaterKinematics out() {
        return {values[0].data(), values[1].data(), values[2].data(), values[3].data(),
                values[4].data(), values[5].data(), values[6].data()};
    }
    std::vector<std::vector<double>> values;
};

struct Points {
    std::vector<double> x, y, z;
    [[nodiscard]] int size() const { return static_cast<int>(x.size()); }
};

Points points_down_to_the_seabed(int n) {
    Points points;
    for (int i = 0; i < n; ++i) {
        points.x.push_back(37.0 * i - 200.0);
        points.y.push_back(-11.0 * i);
        points.z.push_back(12.0 - 0.9 * i * i);
    }
    return points;
}

TEST(Sea, PointHasTheSameBitsAloneAndInAnyBlock) {
    const Sea sea(storm(), 100.0, 1.0);
    const Points points = points_down_to_the_seabed(37);
    Water together(37);
    sea.sample(250.0, 37, points.x.data(), points.y.data(), points.z.data(), together.out());
    for (const int block : {1, 2, 4, 5, 16}) {
        Water apart(37);
        for (int first = 0; first < 37; first += block) {
            const int n = std::min(block, 37 - first);
            const WaterKinematics all = apart.out();
            sea.sample(250.0, n, &points.x[static_cast<std::size_t>(first)],
                       &points.y[static_cast<std::size_t>(first)],
                       &points.z[static_cast<std::size_t>(first)],
                       {all.ux + first, all.uy + first, all.uz + first, all.ax + first,
                        all.ay + first, all.az + first, all.eta + first});
        }
        EXPECT_EQ(apart.values, together.values) << "blocks of " << block;
    }
}

TEST(Sea, CurrentIsAddedToTheWavesAndNotRamped) {
    Environment environment = storm();
    const Sea both(environment, 100.0, 0.0);
    environment.current.reset();
    const Sea waves(environment, 100.0, 0.0);
    const Points points = points_down_to_the_seabed(10);
    for (const double t : {0.0, 50.0, 500.0}) {
        Water a(10), b(10);
        both.sample(t, 10, points.x.data(), points.y.data(), points.z.data(), a.out());
        waves.sample(t, 10, points.x.data(), points.y.data(), points.z.data(), b.out());
        for (std::size_t i = 0; i < 10; ++i) {
            const Vec3 current = both.current(points.z[i]);
            EXPECT_NEAR(a.values[0][i], b.values[0][i] + current.x(), 1e-14);
            EXPECT_NEAR(a.values[1][i], b.values[1][i] + current.y(), 1e-14);
            for (std::size_t j = 2; j < 7; ++j) EXPECT_EQ(a.values[j][i], b.values[j][i]);
            EXPECT_EQ(b.values[0][i] == 0.0, t == 0.0);
        }
    }
}

TEST(Sea, StaticsSeesTheCurrentAlone) {
    const Sea sea(storm(), 100.0, 0.0);
    const Points points = points_down_to_the_seabed(10);
    Water water(10);
    sea.sample_current(10, points.x.data(), points.y.data(), points.z.data(), water.out());
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(water.values[0][i], sea.current(points.z[i]).x());
        EXPECT_EQ(water.values[1][i], sea.current(points.z[i]).y());
        for (std::size_t j = 2; j < 7; ++j) EXPECT_EQ(water.values[j][i], 0.0);
    }
}

// The variance of the elevation in time is that of the components, Hs^2/16. Two hours of samples
// (500 peak periods, energy spread over some 5 % of the peak frequency: 50 independent pieces)
// know it to about 10 %.
TEST(Sea, ElevationHasTheVarianceOfItsComponents) {
    const Sea sea(storm(), 0.0, 0.0);
    double mean = 0.0, square = 0.0;
    constexpr int n = 7200;
    for (int i = 0; i < n; ++i) {
        const double eta = sea.elevation(1.0 * i, 10.0, 20.0);
        mean += eta / n;
        square += eta * eta / n;
    }
    EXPECT_NEAR(4.0 * std::sqrt(square), 15.2, 1.0);
    EXPECT_NEAR(mean, 0.0, 0.1);
}

// Wave of 12 s, period and height of a regular wave as given.
TEST(Sea, PeakFrequencyIsThatOfTheLongestTrain) {
    Environment environment = storm();
    WaveTrain swell = environment.waves[0], regular{.type = WaveType::airy, .H = 1.0, .T = 9.0};
    swell.Tp = 18.0;
    EXPECT_EQ(Sea(Environment{}, 0.0, 1.0).peak_frequency(), 0.0);
    for (const auto& trains : {std::vector{environment.waves[0], swell, regular},
                               std::vector{swell, regular, environment.waves[0]}}) {
        environment.waves = trains;
        EXPECT_DOUBLE_EQ(Sea(environment, 0.0, 1.0).peak_frequency(), 2 * std::numbers::pi / 18.0);
    }
}

TEST(Sea, RegularWaveHasItsHeightAndItsCrestAtTheOriginAtPhaseZero) {
    Environment environment;
    environment.seabed.depth = 200.0;
    environment.waves = {{.type = WaveType::airy, .H = 6.0, .T = 12.0}};
    const Sea sea(environment, 0.0, 0.0);
    EXPECT_NEAR(sea.elevation(0.0, 0.0, 0.0), 3.0, 1e-14);
    EXPECT_NEAR(sea.elevation(6.0, 0.0, 50.0), -3.0, 1e-14);
    EXPECT_NEAR(sea.elevation(3.0, 0.0, 0.0), 0.0, 1e-14);
    // Towards +x: a little later the crest is a little further along.
    const double celerity = sea.components()[0].omega / sea.components()[0].k;
    EXPECT_NEAR(sea.elevation(1.0, celerity, 0.0), 3.0, 1e-13);
    EXPECT_DOUBLE_EQ(sea.peak_frequency(), 2.0 * std::numbers::pi / 12.0);
}

TEST(Sea, HeadingIsTheDirectionOfTravel) {
    Environment environment;
    environment.seabed.depth = 200.0;
    environment.waves = {
        {.type = WaveType::airy, .H = 6.0, .T = 12.0, .heading = std::numbers::pi / 2.0}};
    const Sea sea(environment, 0.0, 0.0);
    const double celerity = sea.components()[0].omega / sea.components()[0].k;
    EXPECT_NEAR(sea.elevation(1.0, 0.0, celerity), 3.0, 1e-13);
}

TEST(Sea, StillWaterIsStill) {
    Environment environment;
    environment.seabed.depth = 200.0;
    const Sea sea(environment, 100.0, 1.0);
    EXPECT_FALSE(sea.has_waves());
    EXPECT_FALSE(sea.has_current());
    EXPECT_EQ(sea.peak_frequency(), 0.0);
    EXPECT_EQ(sea.elevation(50.0, 1.0, 2.0), 0.0);
    const double x = 1.0, y = 2.0, z = -3.0;
    Water water(1);
    sea.sample(50.0, 1, &x, &y, &z, water.out());
    for (const auto& values : water.values) EXPECT_EQ(values[0], 0.0);
}

// Bernoulli, linear: rho du/dt = -grad p.
TEST(Sea, PressureGradientIsMinusDensityTimesAcceleration) {
    EXPECT_EQ(dynamic_pressure_gradient(1025.0, Vec3(1.0, -2.0, 0.5)),
              Vec3(-1025.0, 2050.0, -512.5));
}

// Value, slope and second derivative are 0 at the start and those of 1 at the end: what is left
// grows with the third power, coefficient 10.
TEST(Ramp, IsSmoothToTheSecondDerivative) {
    for (const double q : {1e-2, 1e-3, 1e-4}) {
        EXPECT_NEAR(ramp_factor(100.0 * q, 100.0) / (q * q * q), 10.0, 16.0 * q);
        EXPECT_NEAR((1.0 - ramp_factor(100.0 * (1.0 - q), 100.0)) / (q * q * q), 10.0,
                    16.0 * q + 1e-15 / (q * q * q));
    }
    EXPECT_EQ(ramp_factor(-1.0, 100.0), 0.0);
    EXPECT_EQ(ramp_factor(0.0, 100.0), 0.0);
    EXPECT_NEAR(ramp_factor(50.0, 100.0), 0.5, 1e-15);
    EXPECT_EQ(ramp_factor(100.0, 100.0), 1.0);
    EXPECT_EQ(ramp_factor(1e6, 100.0), 1.0);
    EXPECT_EQ(ramp_factor(0.0, 0.0), 1.0);
}

TEST(Sea, RampsTheCurrentThatTheStaticStartLeavesOut) {
    Environment environment;
    environment.seabed.depth = 100.0;
    environment.current = Current{.heading = 0.0, .profile = {{.depth = 0.0, .speed = 1.5}}};
    const Sea full(environment, 10.0, 0.0), ramped(environment, 10.0, 0.0, true);
    const double x = 0.0, z = -5.0;
    double u[7];
    const WaterKinematics out{&u[0], &u[1], &u[2], &u[3], &u[4], &u[5], &u[6]};
    full.sample(5.0, 1, &x, &x, &z, out);
    EXPECT_DOUBLE_EQ(u[0], 1.5);
    ramped.sample(5.0, 1, &x, &x, &z, out);
    EXPECT_DOUBLE_EQ(u[0], 0.75);  // half way through the ramp
    ramped.sample(10.0, 1, &x, &x, &z, out);
    EXPECT_DOUBLE_EQ(u[0], 1.5);
}

// Linear waves: elevations and, without stretching, kinematics of the trains add up.
TEST(Sea, TrainsAddUp) {
    Environment both = storm();
    WaveTrain swell = both.waves[0];
    swell.Hs = 3.0, swell.Tp = 19.0, swell.seed = 8, swell.heading = 1.1;
    both.waves.push_back(swell);
    for (WaveTrain& train : both.waves) train.stretching = Stretching::none;
    both.current.reset();
    Environment one = both, other = both;
    one.waves = {both.waves[0]};
    other.waves = {both.waves[1]};
    const Sea sea(both, 10.0, 0.0), first(one, 10.0, 0.0), second(other, 10.0, 0.0);
    ASSERT_EQ(sea.trains(), 2);
    for (const double t : {5.0, 50.0}) {
        EXPECT_EQ(sea.elevation_of_train(0, t, 3.0, 4.0), first.elevation(t, 3.0, 4.0));
        EXPECT_EQ(sea.elevation_of_train(1, t, 3.0, 4.0), second.elevation(t, 3.0, 4.0));
        EXPECT_NEAR(sea.elevation(t, 3.0, 4.0),
                    first.elevation(t, 3.0, 4.0) + second.elevation(t, 3.0, 4.0), 1e-12);
        const double x = 3.0, y = 4.0, z = -7.0;
        Water sum(1), a(1), b(1);
        sea.sample(t, 1, &x, &y, &z, sum.out());
        first.sample(t, 1, &x, &y, &z, a.out());
        second.sample(t, 1, &x, &y, &z, b.out());
        for (std::size_t j = 0; j < 7; ++j)
            EXPECT_NEAR(sum.values[j][0], a.values[j][0] + b.values[j][0], 1e-12);
    }
}

}  // namespace
}  // namespace hawser
