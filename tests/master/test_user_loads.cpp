// Loads by hand and coefficients by heading against closed forms: user stiffness K:22, forces in
// time, wind and current tables K:23.
#include <gtest/gtest.h>

#include "heading_coefficients.hpp"
#include "spar_hull.hpp"

namespace hawser::master {
namespace {

constexpr double degree = M_PI / 180, g = 9.80665;

Case light_case() {
    Case c;
    c.environment.seabed.depth = 500;
    c.analysis.dynamics.ramp = 0;
    Platform& p = c.platform.emplace();
    p.mass = 1e6;
    p.centre_of_gravity = {0, 0, 0};
    p.radii_of_gyration = {8, 11, 14};
    return c;
}

State at(const PlatformMotion& m) {
    State s = State::Zero();
    set_motion(s, m);
    return s;
}

// Kinetic energy by hull.momentum, potential 1/2 y^T K y: kept at 40 deg of roll and pitch while
// the body spins. RK4 at w D = 0.1 loses (w D)^5/144 per radian: halving D takes off 2^4 and more.
TEST(UserStiffness, OnEarthAxesHasAPotentialAtAnyAttitude) {  // K:22
    Case c = light_case();
    c.environment.water.gravity = 1e-12;
    Mat6 A = Mat6::Zero();
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) A(i, j) = std::sin(1.7 * i + 0.9 * j * j + i * j);
    const Vec6 scale = (Vec6() << 1e3, 1e3, 1e3, 1e4, 1e4, 1e4).finished();
    c.platform->stiffness = scale.asDiagonal() * (A * A.transpose()) * scale.asDiagonal();
    const Mat6 K = c.platform->stiffness;
    const Hull hull(c, nullptr);
    const State start = at({.position = {1, -2, 0.5},
                            .angles = {0.7, -0.7, 2.0},
                            .velocity = {0.3, 0.2, -0.1},
                            .angle_rates = {0.2, -0.1, 0.3}});
    const auto energy = [&](const State& s) {
        const PlatformMotion m = motion_of(s);
        Vec6 v;
        v << m.velocity, angular_velocity(m);
        return 0.5 * hull.momentum(s).dot(v) + 0.5 * s.head<6>().dot(K * s.head<6>());
    };
    const auto lost = [&](double D) {
        const State end = run(hull, start, D, static_cast<int>(std::lround(4.0 / D)));
        return std::abs(energy(end) / energy(start) - 1);
    };
    const double coarse = lost(0.04), fine = lost(0.02);
    EXPECT_LT(fine, 1e-6);
    EXPECT_GT(coarse / fine, 14);
}

TEST(UserStiffness, YawSpringOfOc3) {  // validation row B1: 98.34 MN.m/rad
    Case c = light_case();
    c.platform->stiffness(5, 5) = 98.34e6;
    const Hull hull(c, nullptr);
    EXPECT_NEAR(hull.static_load({.angles = {0, 0, 0.1}}, Statics{})[5], -9.834e6, 1e-6);
    EXPECT_NEAR(hull.loads(3, at({.angles = {0, 0, 0.1}}))[Load::stiffness][5], -9.834e6, 1e-6);
    EXPECT_NEAR(hull.static_stiffness({}, Statics{})(5, 5), 98.34e6, 1);
}

TEST(UserStiffness, TurnsWithYawWhereTheCaseSaysSo) {
    Case c = light_case();
    c.platform->stiffness(0, 0) = 2e5;
    const PlatformMotion ahead_is_port{.position = {3, 4, 0}, .angles = {0, 0, M_PI / 2}};
    const auto push = [&](bool turns) {
        c.platform->stiffness_turns = turns;
        return Vec6(Hull(c, nullptr).loads(0, at(ahead_is_port))[Load::stiffness]);
    };
    EXPECT_NEAR(push(false)[0], -6e5, 1e-6);
    EXPECT_NEAR(push(true)[0], 0, 1e-6);
    EXPECT_NEAR(push(true)[1], -8e5, 1e-6);
}

TEST(AppliedForces, ActAtTheirPointOnTheirAxes) {
    Case c = light_case();
    c.platform->forces = {{.name = "thruster",
                           .force = Vec3(1e5, 0, 0),
                           .moment = Vec3(0, 2e5, 0),
                           .position = {0, -20, -15}}};
    const PlatformMotion turned{.position = {100, 50, 0}, .angles = {0, 0, M_PI / 2}};
    const auto load = [&](bool on_platform) {
        c.platform->forces[0].on_platform_axes = on_platform;
        const Hull hull(c, nullptr);
        const Vec6 now = hull.loads(7, at(turned))[Load::forces];
        const Vec6 rest = hull.static_load(turned, Statics{});
        EXPECT_LT((rest.head<2>() - now.head<2>()).norm(), 1e-6);  // constant: in the statics
        return now;
    };
    // The point stands at (20, 0, -15) beside O now.
    const Vec6 earth = load(false), body = load(true);
    EXPECT_LT((earth - (Vec6() << 1e5, 0, 0, 0, -15e5 + 2e5, 0).finished()).norm(), 1e-6);
    EXPECT_LT((body - (Vec6() << 0, 1e5, 0, 15e5 - 2e5, 0, 20e5).finished()).norm(), 1e-6);
}

TEST(AppliedForces, FollowTheirHistory) {
    Case c = light_case();
    c.analysis.dynamics.ramp = 100;
    AppliedForce ramp{.name = "ramp", .force = Vec3(1e5, 0, 0)};
    ramp.factor = {{{10, 0.5}}, {{30, 1.5}}};
    AppliedForce harmonic{.name = "harmonic", .force = Vec3(0, 1e5, 0)};
    harmonic.period = 8;
    harmonic.phase = M_PI / 3;
    AppliedForce file{.name = "file"};
    file.rows = {{{0, 0, 0, 1e3, 0, 0, 5e3}}, {{20, 0, 0, 3e3, 0, 0, 5e3}}};
    c.platform->forces = {ramp, harmonic, file};
    const Hull hull(c, nullptr);
    const auto load = [&](double t) { return Vec6(hull.loads(t, at({}))[Load::forces]); };
    EXPECT_NEAR(load(0)[0], 0.5e5, 1e-9);  // constant outside of the rows
    EXPECT_NEAR(load(15)[0], 0.75e5, 1e-9);
    EXPECT_NEAR(load(99)[0], 1.5e5, 1e-9);
    EXPECT_NEAR(load(120)[1], 1e5 * std::cos(2 * M_PI * 15 + M_PI / 3), 1e-6);
    EXPECT_NEAR(load(50)[1], 0.5e5 * std::cos(2 * M_PI * 50 / 8 + M_PI / 3), 1e-6);  // half way
    EXPECT_NEAR(load(5)[2], 1.5e3, 1e-9);
    EXPECT_NEAR(load(500)[5], 5e3, 1e-9);
    const Vec6 rest = hull.static_load({}, Statics{});
    EXPECT_NEAR(rest[0], 0.5e5, 1e-9);
    EXPECT_NEAR(rest[1], 0, 1e-9);
    EXPECT_NEAR(rest[2] + 1e6 * g, 1e3, 1e-6);
}

/// Cx, Cy, Cyaw of cosines and sines, exact at the rows.
HeadingTable round_table(int rows, double last) {
    HeadingTable table;
    for (int i = 0; i <= rows; ++i) {
        const double b = last * i / rows;
        table.push_back({b, std::cos(b), i == 0 || i == rows ? 0 : std::sin(b),
                         i == 0 || i == rows ? 0 : 0.1 * std::sin(2 * b)});
    }
    return table;
}

TEST(HeadingCoefficients, AreMirroredAndSmooth) {
    const HeadingCoefficients half(round_table(12, M_PI)), full(round_table(24, 2 * M_PI));
    double slope_before = 0;
    for (int i = -72; i <= 144; ++i) {
        const double b = i * 5 * degree;  // rows every 15 deg
        const Vec3 C = half.at(b);
        // cubic with slopes of parabolas: (h^2/6) f''' h 4/27 of a sine, twice that in 2 b with 0.1
        EXPECT_NEAR(C[0], std::cos(b), 1e-3) << i;
        EXPECT_NEAR(C[1], std::sin(b), 1e-3) << i;
        EXPECT_NEAR(C[2], 0.1 * std::sin(2 * b), 1e-3) << i;
        EXPECT_LT((C - full.at(b)).norm(), 1e-12) << i;
        const double e = 1e-6, before = (half.at(b)[1] - half.at(b - e)[1]) / e,
                     after = (half.at(b + e)[1] - half.at(b)[1]) / e;
        EXPECT_NEAR(before, after, 1e-5) << i;
        slope_before = after;
    }
    EXPECT_NEAR(slope_before, std::cos(144 * 5 * degree), 0.02);
    EXPECT_NEAR(half.at(45 * degree)[1], std::sin(45 * degree), 1e-15);  // a row
}

TEST(Wind, TableGivesOcimfsForcesAndMoment) {  // K:23
    Case c = light_case();
    c.environment.wind = Wind{.spectrum = WindSpectrum::constant, .speed = 30, .heading = 0.5};
    WindArea area{.area = 900, .centre_height = 30};
    area.side_area = 2400;
    area.length = 120;
    area.coefficients = {
        {{0, 0.8, 0, 0}}, {{90 * degree, 0.1, 0.95, 0.04}}, {{180 * degree, -0.7, 0, 0}}};
    c.platform->wind = area;
    const double q = 0.5 * 1.226 * 900;
    const auto load = [&](double relative) {
        return Hull(c, nullptr)
            .loads(0, at({.angles = {0, 0, 0.5 - relative * degree}}))[Load::wind];
    };
    // On platform axes, turned back.
    const auto on_platform = [&](double relative) {
        const Vec6 l = load(relative);
        const double yaw = 0.5 - relative * degree;
        return Vec3(std::cos(yaw) * l[0] + std::sin(yaw) * l[1],
                    -std::sin(yaw) * l[0] + std::cos(yaw) * l[1], l[5]);
    };
    EXPECT_LT((on_platform(0) - Vec3(0.8 * q * 900, 0, 0)).norm(), 1e-6);
    EXPECT_LT((on_platform(180) - Vec3(-0.7 * q * 900, 0, 0)).norm(), 1e-6);
    const Vec3 from_starboard(0.1 * q * 900, 0.95 * q * 2400, 0.04 * q * 2400 * 120);
    EXPECT_LT((on_platform(90) - from_starboard).norm(), 1e-6 * from_starboard.norm());
    const Vec3 from_port(from_starboard[0], -from_starboard[1], -from_starboard[2]);
    EXPECT_LT((on_platform(-90) - from_port).norm(), 1e-6 * from_port.norm());
    const Vec6 heeling = load(90);  // moment arm: r x F with r = 30 m up
    EXPECT_NEAR(heeling[3], -30 * heeling[1], 1e-6);
    EXPECT_NEAR(heeling[4], 30 * heeling[0], 1e-6);
}

TEST(Current, CoefficientsActOnTheFlowAgainstTheHull) {  // K:23
    Case c = light_case();
    c.environment.current = Current{.profile = {{0, 2.0, {}}, {20, 1.0, {}}}};
    CurrentCoefficients k{.draft = 20, .length = 150};
    k.coefficients = {
        {{0, 0.05, 0, 0}}, {{90 * degree, 0, 0.6, 0.02}}, {{180 * degree, -0.06, 0, 0}}};
    c.platform->current_coefficients = k;
    const Hull hull(c, nullptr);
    const double q = 0.5 * 1025 * 20 * 150;
    const Vec6 rest = hull.static_load({}, Statics{});  // 1.5 m/s at half the draft
    EXPECT_NEAR(rest[0], 0.05 * q * 2.25, 1e-6);
    EXPECT_NEAR(rest[4], -10 * rest[0], 1e-5);
    EXPECT_LT(
        (hull.loads(0, at({}))[Load::current] - (Vec6() << rest[0], 0, 0, 0, rest[4], 0).finished())
            .norm(),
        1e-5);
    // Overtakes the water by one metre a second: its flow comes from ahead.
    EXPECT_NEAR(hull.loads(0, at({.velocity = {2.5, 0, 0}}))[Load::current][0], -0.06 * q, 1e-6);
    // Still in the water, and swayed to starboard: the flow goes to port.
    const Vec6 swayed = hull.loads(0, at({.velocity = {1.5, -1.2, 0}}))[Load::current];
    EXPECT_NEAR(swayed[1], 0.6 * q * 1.44, 1e-5);
    EXPECT_NEAR(swayed[5], 0.02 * q * 150 * 1.44, 1e-4);
    // Pitching moves the depth at which it is felt.
    EXPECT_NEAR(hull.loads(0, at({.angle_rates = {0, 0.05, 0}}))[Load::current][0],
                0.05 * q * 2.0 * 2.0, 1e-5);
    Case left_out = c;
    left_out.analysis.statics.current = false;
    EXPECT_NEAR(hull.static_load({}, left_out.analysis.statics)[0], 0, 1e-12);
}

}  // namespace
}  // namespace hawser::master
