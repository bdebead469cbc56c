// The current profile: interpolation and ends. Values of validation row C.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "environment/current.hpp"

namespace hawser {
namespace {

const Current paper_current{
    .heading = 0.0,
    .profile = {{0.0, 1.9, {}}, {40.0, 1.4, {}}, {75.0, 0.0, {}}, {1500.0, 0.0, {}}}};

TEST(CurrentProfile, IsLinearBetweenItsPoints) {
    const CurrentProfile current(paper_current);
    EXPECT_EQ(current.velocity(0.0).x(), 1.9);
    EXPECT_NEAR(current.velocity(-20.0).x(), 1.65, 1e-15);
    EXPECT_NEAR(current.velocity(-40.0).x(), 1.4, 1e-15);
    EXPECT_NEAR(current.velocity(-57.5).x(), 0.7, 1e-15);
    EXPECT_EQ(current.velocity(-75.0).x(), 0.0);
    EXPECT_EQ(current.velocity(-900.0).norm(), 0.0);
}

TEST(CurrentProfile, IsConstantAboveAndBelow) {
    const CurrentProfile current(
        Current{.heading = 0.0, .profile = {{10.0, 1.2, {}}, {50.0, 0.4, {}}}});
    EXPECT_EQ(current.velocity(15.0).x(), 1.2);  // up to the crest
    EXPECT_EQ(current.velocity(-5.0).x(), 1.2);
    EXPECT_EQ(current.velocity(-51.0).x(), 0.4);
}

TEST(CurrentProfile, PointsMayHaveTheirOwnHeading) {
    using std::numbers::pi;
    const CurrentProfile current(
        Current{.heading = pi / 2.0, .profile = {{0.0, 1.0, {}}, {100.0, 1.0, -pi / 2.0}}});
    EXPECT_NEAR(current.velocity(0.0).y(), 1.0, 1e-15);
    EXPECT_NEAR(current.velocity(-25.0).y(), 0.5, 1e-15);
    EXPECT_NEAR(current.velocity(-100.0).y(), -1.0, 1e-15);
    EXPECT_NEAR(current.velocity(-50.0).norm(), 0.0, 1e-15);  // opposite currents cancel
    EXPECT_EQ(current.velocity(-10.0).z(), 0.0);
}

TEST(CurrentProfile, EmptyMeansNoCurrent) {
    EXPECT_TRUE(CurrentProfile().empty());
    EXPECT_EQ(CurrentProfile().velocity(-10.0).norm(), 0.0);
    EXPECT_FALSE(CurrentProfile(paper_current).empty());
}

}  // namespace
}  // namespace hawser
