// The dispersion relation: check values, limits, residual.
#include <gtest/gtest.h>

#include <cmath>

#include "environment/dispersion.hpp"

namespace hawser {
namespace {

constexpr double g = 9.80665;

// Validation row C, given to seven digits.
TEST(Dispersion, AgreesWithCheckValues) {
    EXPECT_NEAR(wave_number(0.4, 50.0, g), 0.02091387, 5e-9);
    EXPECT_NEAR(wave_number(0.4, 1500.0, g), 0.01631546, 5e-9);
    EXPECT_NEAR(wave_number(0.1, 1500.0, g), 0.00109825, 5e-9);
    EXPECT_NEAR(wave_number(0.6, 20.0, g), 0.04883818, 5e-9);
}

TEST(Dispersion, HoldsToRoundingFromShallowToDeep) {
    for (double omega = 0.01; omega < 10.0; omega *= 1.3)
        for (double depth = 1.0; depth < 10000.0; depth *= 2.1) {
            const double k = wave_number(omega, depth, g);
            EXPECT_NEAR(g * k * std::tanh(k * depth) / (omega * omega), 1.0, 1e-13)
                << omega << " rad/s in " << depth << " m";
        }
}

TEST(Dispersion, HasTheDeepAndShallowWaterLimits) {
    EXPECT_NEAR(wave_number(2.0, 1000.0, g) / (2.0 * 2.0 / g), 1.0, 1e-14);
    // Shallow: w^2 = g h k^2 (1 - (kh)^2/3 + ...), here kh = 0.002.
    EXPECT_NEAR(
        wave_number(0.01 / std::sqrt(5.0), 0.4, g) / (0.01 / std::sqrt(5.0) / std::sqrt(g * 0.4)),
        1.0, 1e-6);
}

}  // namespace
}  // namespace hawser
