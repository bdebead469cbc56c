// Euler angles near their limit: a free body between 70 and 78 deg of pitch against an integration
// by quaternions, and the stop beyond 80 deg. K:2, K:3
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "spar_hull.hpp"

namespace hawser::master {
namespace {

const Vec3 radii(8, 11, 14);
constexpr double mass = 1e6;

/// World moment in time that swings the pitch up towards its limit and back.
Vec3 moment(double t) { return {2e5 * std::sin(0.9 * t), -6e5 * std::sin(0.5 * t), 1e5}; }

Case free_body() {
    Case c;
    c.environment.seabed.depth = 500;
    c.environment.water.gravity = 1e-12;
    c.analysis.dynamics.ramp = 0;
    Platform& p = c.platform.emplace();
    p.mass = mass;
    p.centre_of_gravity = {0, 0, 0};
    p.radii_of_gyration = radii;
    return c;
}

const PlatformMotion begin{.angles = {0.05, 70 * M_PI / 180, 0.4},
                           .angle_rates = {0.005, 0.03, -0.01}};

/// Euler's equations on body axes with the attitude as a quaternion: no angle, no limit.
Mat3 by_quaternion(double until) {
    const Vec3 I = mass * radii.cwiseAbs2();
    Eigen::Quaterniond q(rotation(begin.angles));
    Vec3 w = rotation(begin.angles).transpose() * angular_velocity(begin);
    using Both = Eigen::Matrix<double, 7, 1>;
    const auto rate = [&](double t, const Both& y) {
        const Eigen::Quaterniond a(y[0], y[1], y[2], y[3]);
        const Vec3 v = y.tail<3>();
        const Eigen::Quaterniond spin = a * Eigen::Quaterniond(0, v.x(), v.y(), v.z());
        Both out;
        out << 0.5 * spin.w(), 0.5 * spin.x(), 0.5 * spin.y(), 0.5 * spin.z(),
            (a.normalized().conjugate() * moment(t) - v.cross(I.cwiseProduct(v))).cwiseQuotient(I);
        return out;
    };
    Both y;
    y << q.w(), q.x(), q.y(), q.z(), w;
    const int n = 4000;
    const double h = until / n;
    for (int i = 0; i < n; ++i) {
        const double t = i * h;
        const Both k1 = rate(t, y), k2 = rate(t + h / 2, y + h / 2 * k1),
                   k3 = rate(t + h / 2, y + h / 2 * k2), k4 = rate(t + h, y + h * k3);
        y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        y.head<4>().normalize();
    }
    return Eigen::Quaterniond(y[0], y[1], y[2], y[3]).toRotationMatrix();
}

TEST(SteepPitch, AFreeBodyTurnsAsByQuaternions) {  // K:2, K:3
    const Case c = free_body();
    const Hull hull(c, nullptr);
    State start = State::Zero();
    set_motion(start, begin);
    constexpr double until = 8.0;
    const Mat3 exact = by_quaternion(until);
    double steepest = 0;
    const auto error = [&](double D) {
        const State end = run(
            hull, start, D, static_cast<int>(std::lround(until / D)),
            [&](double, const State& s, const auto&) { steepest = std::max(steepest, s[4]); },
            [](double t, const State&) {
                Vec6 load = Vec6::Zero();
                load.tail<3>() = moment(t);
                return load;
            });
        return (rotation(motion_of(end).angles) - exact).norm();
    };
    const double coarse = error(0.2), fine = error(0.1);
    EXPECT_GT(steepest, 76 * M_PI / 180);
    EXPECT_LT(steepest, 80 * M_PI / 180);
    // 1/cos(pitch) is 5 here: its fourth derivative by D^4/100 of some 0.2 rad/s
    EXPECT_LT(fine, 1e-5);
    EXPECT_GT(coarse / fine, 12);
}

TEST(SteepPitch, EndsWithAClearMessageBeyondItsLimit) {
    const Case c = free_body();
    const Hull hull(c, nullptr);
    for (const double pitch : {79.9, 80.1, -80.1}) {
        State s = State::Zero();
        set_motion(s, {.angles = {0, pitch * M_PI / 180, 0}});
        HullLoads loads = hull.loads(3, s);
        try {
            (void)hull.rate(3, s, loads, Vec6::Zero());
            EXPECT_LT(std::abs(pitch), 80);
        } catch (const RunError& error) {
            EXPECT_GT(std::abs(pitch), 80);
            EXPECT_EQ(error.code(), ExitCode::diverged);
            EXPECT_NE(std::string(error.what()).find("the limit is 80 deg"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace hawser::master
