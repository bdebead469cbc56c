#include <gtest/gtest.h>

#include <cmath>

#include "frames.hpp"
#include "spline.hpp"

namespace hawser {
namespace {

const Vec3 angles0(0.3, -0.5, 1.1);
const Vec3 rates0(0.2, 0.7, -0.4);

TEST(Rotation, IsYawThenPitchThenRoll) {  // K:1
    const Vec3 a = rotation({0, 0, M_PI / 2}) * Vec3::UnitX();
    EXPECT_NEAR((a - Vec3::UnitY()).norm(), 0, 1e-15);
    const Vec3 b = rotation({0, M_PI / 2, 0}) * Vec3::UnitX();  // bow down is positive pitch
    EXPECT_NEAR((b + Vec3::UnitZ()).norm(), 0, 1e-15);
    const Mat3 R = rotation(angles0);
    EXPECT_NEAR((R * R.transpose() - Mat3::Identity()).norm(), 0, 1e-14);
    EXPECT_NEAR((R - rotation({0, 0, 1.1}) * rotation({0, -0.5, 0}) * rotation({0.3, 0, 0})).norm(),
                0, 1e-15);
}

TEST(AngularVelocity, IsTheDerivativeOfTheRotation) {  // K:2, K:3
    const double e = 1e-6;  // central differences: error e^2, rounding 1e-16/e
    const Mat3 R_rate = (rotation(angles0 + e * rates0) - rotation(angles0 - e * rates0)) / (2 * e);
    const Vec3 w = angular_velocity_matrix(angles0) * rates0;
    EXPECT_NEAR((R_rate - skew(w) * rotation(angles0)).norm(), 0, 1e-9);
    const Mat3 E_rate = (angular_velocity_matrix(angles0 + e * rates0) -
                         angular_velocity_matrix(angles0 - e * rates0)) /
                        (2 * e);
    EXPECT_NEAR((E_rate - angular_velocity_matrix_rate(angles0, rates0)).norm(), 0, 1e-9);
}

TEST(MotionSpline, IsExactForCubicsAndMatchesBothEnds) {  // P:4, P:5
    const auto cubic = [](double t) {
        PlatformMotion m;
        m.position = Vec3(1 + 2 * t - t * t + 0.3 * t * t * t, t * t * t, -t);
        m.velocity = Vec3(2 - 2 * t + 0.9 * t * t, 3 * t * t, -1);
        m.angles = 0.01 * m.position;
        m.angle_rates = 0.01 * m.velocity;
        return m;
    };
    const MotionSpline spline(2.0, cubic(0), 2.5, cubic(0.5));
    for (const double dt : {0.0, 0.1, 0.25, 0.5}) {
        const auto s = spline.at(2.0 + dt);
        EXPECT_NEAR((s.motion.position - cubic(dt).position).norm(), 0, 1e-14);
        EXPECT_NEAR((s.motion.angle_rates - cubic(dt).angle_rates).norm(), 0, 1e-14);
        EXPECT_NEAR((s.acceleration.position - Vec3(-2 + 1.8 * dt, 6 * dt, 0)).norm(), 0, 1e-12);
    }
}

TEST(PointMotion, AccelerationIsTheDerivativeOfPosition) {  // K:5
    PlatformMotion from, to;
    from.angles = angles0;
    from.angle_rates = rates0;
    to.position = Vec3(1, -2, 0.5);
    to.angles = angles0 + 0.5 * rates0;
    to.angle_rates = -rates0;
    to.velocity = Vec3(0.1, 0.2, -3);
    const MotionSpline spline(0, from, 1, to);
    const Vec3 rho(10, -4, -60);
    const auto at = [&](double t) {
        const auto s = spline.at(t);
        return point_motion(s.motion, s.acceleration, rho);
    };
    const double e = 1e-4;  // second differences: error e^2 * 60 m, rounding 1e-14/e^2
    const PointMotion p = at(0.4);
    EXPECT_NEAR(((at(0.4 + e).position - at(0.4 - e).position) / (2 * e) - p.velocity).norm(), 0,
                1e-5);
    EXPECT_NEAR(((at(0.4 + e).velocity - at(0.4 - e).velocity) / (2 * e) - p.acceleration).norm(),
                0, 1e-4);
}

}  // namespace
}  // namespace hawser
