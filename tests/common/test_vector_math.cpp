// Sine, cosine and exponential of lanes against the standard library.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "vector_math.hpp"

namespace hawser {
namespace {

using Batch = Lanes<8>;

Batch ramp(double first, double step) {
    Batch x;
    for (int i = 0; i < Batch::size; ++i) x.set(i, first + i * step);
    return x;
}

// The series end at r^17/17! and r^16/16! with r = pi/4: below 1e-15. What remains is rounding.
TEST(VectorMath, SineAndCosineAreRightToRounding) {
    double worst = 0.0;
    for (double x = -2000.0; x < 2000.0; x += 8 * 0.0137) {
        const Batch angles = ramp(x, 0.0137);
        const auto [s, c] = sincos(angles);
        for (int i = 0; i < Batch::size; ++i) {
            worst = std::max(worst, std::abs(s[i] - std::sin(angles[i])));
            worst = std::max(worst, std::abs(c[i] - std::cos(angles[i])));
        }
    }
    EXPECT_LT(worst, 2e-15);
}

// A three-hour storm seen 10 km away has phases of some 1e5 rad. The three parts of pi/2 carry
// more than 100 bits, so the reduction itself loses nothing.
TEST(VectorMath, LargePhasesKeepTheirAccuracy) {
    double worst = 0.0;
    for (double x = -9.9e5; x < 9.9e5; x += 1234.567) {
        const Batch angles = ramp(x, 0.7);
        const auto [s, c] = sincos(angles);
        for (int i = 0; i < Batch::size; ++i) {
            worst = std::max(worst, std::abs(s[i] - std::sin(angles[i])));
            worst = std::max(worst, std::abs(c[i] - std::cos(angles[i])));
        }
    }
    EXPECT_LT(worst, 1e-14);
}

// Next to multiples of pi/2 the result is a small difference of large numbers.
TEST(VectorMath, ZerosOfTheSineAreRelativelyRight) {
    for (int n = 1; n < 100000; n = 3 * n + 1) {
        const double x = n * std::numbers::pi;
        EXPECT_NEAR(sincos(Batch(x)).sin[0] / std::sin(x), 1.0, 1e-4) << n;  // sin is about n 1e-16
    }
}

TEST(VectorMath, ExponentialIsRightToRounding) {
    double worst = 0.0;
    for (double x = -699.0; x < 699.0; x += 8 * 0.0173) {
        const Batch exponents = ramp(x, 0.0173);
        const Batch e = exp(exponents);
        for (int i = 0; i < Batch::size; ++i)
            worst = std::max(worst, std::abs(e[i] / std::exp(exponents[i]) - 1.0));
    }
    EXPECT_LT(worst, 2e-15);
    EXPECT_EQ(exp(Batch(0.0))[3], 1.0);
}

TEST(VectorMath, ExponentialIsClampedAndLetsNanThrough) {
    EXPECT_GT(exp(Batch(-1e9))[0], 0.0);
    EXPECT_LT(exp(Batch(-1e9))[0], 1e-300);
    EXPECT_TRUE(std::isfinite(exp(Batch(1e9))[0]));
    EXPECT_TRUE(std::isnan(exp(Batch(std::numeric_limits<double>::quiet_NaN()))[0]));
}

/// Not inlined: an argument known to the compiler would be worked out without the processor's fused
/// multiply-add.
[[gnu::noinline]] std::array<Batch, 3> functions_of(Batch x) {
    return {sincos(x).sin, sincos(x).cos, exp(x)};
}

TEST(VectorMath, ALaneDoesNotFeelItsNeighbours) {
    const Batch mixed = ramp(-3.0, 1.37);
    const std::array<Batch, 3> together = functions_of(mixed);
    for (int i = 0; i < Batch::size; ++i) {
        const std::array<Batch, 3> alone = functions_of(Batch(mixed[i]));
        for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(together[f][i], alone[f][0]);
    }
}

}  // namespace
}  // namespace hawser
