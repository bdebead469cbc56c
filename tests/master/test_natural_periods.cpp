#include <gtest/gtest.h>

#include <cmath>

#include "natural_periods.hpp"
#include "rigid_body.hpp"

namespace hawser::master {
namespace {

TEST(NaturalPeriods, AreTwoPiRootMassOverStiffnessWithoutCoupling) {
    Vec6 k, m;
    k << 4e5, 3e5, 1e7, 5e9, 6e9, 4e8;
    m << 2e8, 2e8, 1.5e8, 4e11, 4e11, 2e10;
    const auto periods = natural_periods(k.asDiagonal(), m.asDiagonal());
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(periods[std::size_t(i)].value(), 2 * M_PI * std::sqrt(m[i] / k[i]), 1e-9);
}

TEST(NaturalPeriods, DoNotDependOnTheReferencePoint) {
    // A body on springs at its centre of gravity, seen from a point 60 m above.
    RigidBody body{.mass = 1e8, .centre_of_gravity = {0, 0, -60}, .inertia = Mat3::Zero()};
    body.inertia.diagonal() << 7e11, 7e11, 2e10;
    Vec6 k;
    k << 4e5, 3e5, 1e7, 9e9, 8e9, 4e8;
    Mat6 to_G = Mat6::Identity();  // displacement of G from that of O
    to_G.block<3, 3>(0, 3) = -skew(body.centre_of_gravity);
    const Mat6 K = to_G.transpose() * k.asDiagonal() * to_G;
    const auto periods = natural_periods(K, mass_matrix(turned(body, Mat3::Identity())));
    const double m[] = {1e8, 1e8, 1e8, 7e11, 7e11, 2e10};
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(periods[std::size_t(i)].value(), 2 * M_PI * std::sqrt(m[i] / k[i]), 1e-6);
}

TEST(NaturalPeriods, AreEmptyWhereNothingHolds) {
    Vec6 k;
    k << 0, 0, 1e7, 5e9, 6e9, 0;
    const auto periods = natural_periods(k.asDiagonal(), Mat6::Identity() * 1e8);
    EXPECT_FALSE(periods[0] || periods[1] || periods[5]);
    EXPECT_TRUE(periods[2] && periods[3] && periods[4]);
}

}  // namespace
}  // namespace hawser::master
