// Statistics against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "statistics.hpp"

namespace {

using hawser::Statistics;
using hawser::statistics_of;

struct Series {
    std::vector<double> t, x;
};

// n samples over whole periods, the last point of a period left out: sums of sines over equidistant
// points are then exact.
Series sine(double mean, double amplitude, double period, int periods, int per_period) {
    Series s;
    for (int i = 0; i < periods * per_period; ++i) {
        s.t.push_back(i * period / per_period);
        s.x.push_back(mean + amplitude * std::sin(2 * std::numbers::pi * i / per_period));
    }
    return s;
}

TEST(Statistics, OfASineAreItsAmplitudeOverRootTwoAndItsPeriod) {
    const Series s = sine(3.0, 2.0, 12.0, 20, 48);
    const Statistics r = statistics_of(s.t, s.x, 0.0);
    EXPECT_EQ(r.n, 960);
    EXPECT_NEAR(r.mean, 3.0, 1e-13);            // rounding only
    EXPECT_NEAR(r.std, std::sqrt(2.0), 1e-13);  // A/sqrt 2
    EXPECT_NEAR(r.skewness, 0.0, 1e-12);        // odd moments vanish
    EXPECT_NEAR(r.kurtosis, 1.5, 1e-12);        // <sin^4>/<sin^2>^2 = (3/8)/(1/4)
    EXPECT_DOUBLE_EQ(r.max, 5.0);               // sampled at the crest
    EXPECT_NEAR(r.t_max, 3.0, 1e-12);           // a quarter period
    EXPECT_DOUBLE_EQ(r.min, 1.0);
    EXPECT_NEAR(r.t_min, 9.0, 1e-12);
    EXPECT_NEAR(r.tz, 12.0, 1e-9);  // crossings lie on samples
}

TEST(Statistics, OfOneSpikeHaveTheSkewnessOfABernoulliVariable) {
    std::vector<double> t(100), x(100, 0.0);
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = static_cast<double>(i);
    x[40] = 1.0;
    const Statistics r = statistics_of(t, x, 0.0);
    const double p = 0.01, q = 1.0 - p;
    EXPECT_NEAR(r.mean, p, 1e-15);
    EXPECT_NEAR(r.std, std::sqrt(p * q), 1e-15);
    EXPECT_NEAR(r.skewness, (q - p) / std::sqrt(p * q), 1e-11);
    EXPECT_NEAR(r.kurtosis, (1.0 - 3.0 * p * q) / (p * q), 1e-10);
    EXPECT_TRUE(std::isnan(r.tz));  // one crossing makes no period
}

TEST(Statistics, CountOnlyTheTimeAskedFor) {
    const std::vector<double> t{0, 1, 2, 3}, x{100, 1, 2, 3};
    const Statistics r = statistics_of(t, x, 1.0);
    EXPECT_EQ(r.n, 3);
    EXPECT_DOUBLE_EQ(r.mean, 2.0);
    EXPECT_DOUBLE_EQ(r.max, 3.0);
}

TEST(Statistics, LeaveOutWhatIsNotANumber) {
    const std::vector<double> t{0, 1, 2}, x{1.0, std::numeric_limits<double>::quiet_NaN(), 3.0};
    const Statistics r = statistics_of(t, x, 0.0);
    EXPECT_EQ(r.n, 2);
    EXPECT_DOUBLE_EQ(r.mean, 2.0);
}

TEST(Statistics, OfNothingAreNotNumbers) {
    const std::vector<double> t{0, 1}, x{1, 2};
    const Statistics r = statistics_of(t, x, 5.0);
    EXPECT_EQ(r.n, 0);
    EXPECT_TRUE(std::isnan(r.mean) && std::isnan(r.std) && std::isnan(r.max) && std::isnan(r.tz));
}

// A millimetre about 1e9: the mean of squares less the square of the mean would have lost it all.
TEST(Statistics, KeepASmallMotionAboutALargeMean) {
    const Series s = sine(1e9, 1e-3, 10.0, 10, 20);
    const Statistics r = statistics_of(s.t, s.x, 0.0);
    EXPECT_NEAR(r.std, 1e-3 / std::sqrt(2.0), 1e-6);  // 1e9 has 1.2e-7 between neighbours
}

}  // namespace
