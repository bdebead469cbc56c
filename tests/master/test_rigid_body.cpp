// The equation of motion K:4 with K:3, free of any load.
#include <gtest/gtest.h>

#include <algorithm>

#include "spar_hull.hpp"

namespace hawser::master {
namespace {

// A body with three different moments of inertia and G off O, in water without gravity.
Case top_case() {
    Case c;
    c.environment.water.gravity = 0.0;
    c.environment.seabed.depth = 100.0;
    Platform& p = c.platform.emplace();
    p.mass = 1200.0;
    p.centre_of_gravity = {0.3, -0.2, -1.5};
    p.radii_of_gyration = {1.0, 1.4, 0.7};
    return c;
}

double energy(const Hull& hull, const State& s) {
    Vec6 v;
    v << motion_of(s).velocity, angular_velocity(motion_of(s));
    return 0.5 * v.dot(hull.momentum(s));
}

Vec3 angular_momentum_about_origin(const Hull& hull, const State& s) {
    const Vec6 p = hull.momentum(s);
    return p.tail<3>() + motion_of(s).position.cross(Vec3(p.head<3>()));
}

TEST(TorqueFreeTop, KeepsEnergyMomentumAndAngularMomentum) {  // K:4, P:1
    const Hull hull(top_case(), nullptr);
    State s = State::Zero();
    set_motion(s, {.position = {1, 2, -3},
                   .angles = {0.1, 0.3, 0.3},
                   .velocity = {0.5, -0.2, 0.1},
                   .angle_rates = {0.1, 0.08, -0.15}});
    const double e0 = energy(hull, s);
    const Vec6 p0 = hull.momentum(s);
    const Vec3 l0 = angular_momentum_about_origin(hull, s);
    double energy_error = 0, momentum_error = 0, angular_error = 0, steepest = 0;
    run(hull, s, 0.01, 1001, [&](double, const State& y, const HullLoads&) {
        energy_error = std::max(energy_error, std::abs(energy(hull, y) / e0 - 1));
        momentum_error = std::max(momentum_error,
                                  (hull.momentum(y) - p0).head<3>().norm() / p0.head<3>().norm());
        angular_error = std::max(angular_error,
                                 (angular_momentum_about_origin(hull, y) - l0).norm() / l0.norm());
        steepest = std::max(steepest, std::abs(motion_of(y).angles.y()));
    });
    EXPECT_GT(steepest, 50 * M_PI / 180);  // the rotation is far from small
    // Error of the fourth-order scheme at 0.01 s over 10 s, as the equations page states it.
    EXPECT_LT(energy_error, 2e-11);
    EXPECT_LT(momentum_error, 2e-11);
    EXPECT_LT(angular_error, 2e-11);
}

TEST(TorqueFreeTop, LedgerClosesAboutTheMovingPoint) {  // dL_O/dt = M_O - v x p
    const Hull hull(top_case(), nullptr);
    State s = State::Zero();
    set_motion(s, {.velocity = {0.5, -0.2, 0.1}, .angle_rates = {0.3, 0.5, -0.6}});
    Vec6 push;
    push << 300, -200, 100, 50, 80, -40;
    HullLoads loads = hull.loads(0, s);
    const State rate = hull.rate(0, s, loads, push);
    const double h = 1e-5;  // central differences: h^2 and 1e-16/h
    const Vec6 change =
        (hull.momentum(State(s + h * rate)) - hull.momentum(State(s - h * rate))) / (2 * h);
    EXPECT_LT((change - (loads.total() - hull.momentum_transport(s))).norm(), 1e-6 * push.norm());
}

TEST(EquationOfMotion, RefusesAPitchWhereEulerAnglesFail) {  // K:2
    const Hull hull(top_case(), nullptr);
    State s = State::Zero();
    set_motion(s, {.angles = {0, 81 * M_PI / 180, 0}});
    HullLoads loads = hull.loads(12.5, s);
    try {
        (void)hull.rate(12.5, s, loads, Vec6::Zero());
        FAIL() << "81 deg of pitch went through";
    } catch (const RunError& e) {
        EXPECT_EQ(e.code(), ExitCode::diverged);
        EXPECT_NE(std::string(e.what()).find("t = 12.500 s: pitch is 81.0 deg"), std::string::npos)
            << e.what();
    }
}

TEST(EquationOfMotion, EndsTheRunOfAPlatformThatCapsizesInRoll) {
    const Hull hull(top_case(), nullptr);
    const auto rate_at = [&](double roll) {
        State s = State::Zero();
        set_motion(s, {.angles = {roll * M_PI / 180, 0, 0}});
        HullLoads loads = hull.loads(12.5, s);
        (void)hull.rate(12.5, s, loads, Vec6::Zero());
    };
    EXPECT_NO_THROW(rate_at(79));
    try {
        rate_at(81);
        FAIL() << "81 deg of roll went through";
    } catch (const RunError& e) {
        EXPECT_EQ(e.code(), ExitCode::diverged);
        EXPECT_NE(std::string(e.what()).find("capsized: its axis leans by 81.0 deg"),
                  std::string::npos)
            << e.what();
    }
}

TEST(Pose, DisplacedByARotationVectorTurnsAboutTheWorldAxes) {
    const PlatformMotion pose{.position = {1, 2, 3}, .angles = {0.2, -0.3, 2 * M_PI + 0.4}};
    Vec6 step;
    step << 0.1, 0.2, 0.3, 0.01, -0.02, 0.03;
    const PlatformMotion moved = displaced(pose, step);
    const Vec3 v = step.tail<3>();
    const Mat3 expected =
        Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * rotation(pose.angles);
    EXPECT_LT((rotation(moved.angles) - expected).norm(), 1e-14);
    EXPECT_LT((moved.position - Vec3(1.1, 2.2, 3.3)).norm(), 1e-15);
    EXPECT_NEAR(moved.angles.z(), pose.angles.z(), 0.05);  // same turn of yaw
}

}  // namespace
}  // namespace hawser::master
