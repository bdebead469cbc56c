// Held and led motions: the constrained equation of motion K:20, the path K:21, equilibrium and
// ledger with them.
#include <gtest/gtest.h>

#include <cmath>

#include "doubles.hpp"
#include "held_motions.hpp"
#include "paper_loop.hpp"
#include "platform_ledger.hpp"
#include "recorded_lines.hpp"
#include "spar_hull.hpp"
#include "static_start.hpp"

namespace hawser::master {
namespace {

constexpr double g = 9.80665;

Case pendulum_case() {
    Case c;
    c.environment.seabed.depth = 500;
    c.analysis.dynamics.ramp = 0;
    c.analysis.dynamics.platform_step = 0.1;
    Platform& p = c.platform.emplace();
    p.mass = 2e6;
    p.centre_of_gravity = {0, 0, -20};
    p.radii_of_gyration = {9, 12, 5};
    return c;
}

TEST(HeldMotions, LeaveTheOthersTheirEquationOfMotion) {  // K:20
    Mat6 M = Mat6::Zero();
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) M(i, j) = (i == j ? 9 : 0) + std::cos(1.0 + i * j + i + j);
    M = Mat6(0.5 * (M + M.transpose()));
    const Vec6 F = (Vec6() << 3, -2, 5, 1, 7, -4).finished();
    const PlatformMotion m{.angles = {0.4, -1.1, 2.0}, .angle_rates = {0.3, 0.2, -0.5}};
    const Held held{true, false, false, false, true, true};
    const Vec6 given = (Vec6() << 0.5, 99, 99, 99, -0.2, 0.1).finished();
    const HeldSolution out = solve_held(M, F, m, held, given);
    EXPECT_LT((M * out.acceleration - F - out.holding).norm(), 1e-12);
    const Mat6 T = motion_matrix(m.angles);
    const Vec6 work = T.transpose() * out.holding;
    for (int i = 0; i < 6; ++i) {
        if (held[static_cast<std::size_t>(i)])
            EXPECT_EQ(out.motions[i], given[i]) << i;
        else
            EXPECT_NEAR(work[i], 0, 1e-12) << i;  // no work in what is free
    }
    Vec6 b = Vec6::Zero();
    b.tail<3>() = angular_velocity_matrix_rate(m.angles, m.angle_rates) * m.angle_rates;
    EXPECT_LT((out.acceleration - T * out.motions - b).norm(), 1e-13);
    EXPECT_LT((solve_held(M, F, m, {}, given).acceleration - M.inverse() * F).norm(), 1e-12);
}

// Held at O, the body swings about it as a compound pendulum: T = 4 sqrt(I/(m g l)) K(sin(a/2)), at
// 60 deg 7.3 % above that of small swings.
TEST(HeldMotions, ABodyHeldAtItsReferencePointIsAPendulum) {
    Case c = pendulum_case();
    c.platform->fixed = {true, true, true, true, false, true};
    const Hull hull(c, nullptr);
    const double amplitude = M_PI / 3, I = 2e6 * (12 * 12 + 20 * 20), D = 0.02;
    const double T =
        4 * std::sqrt(I / (2e6 * g * 20)) * std::comp_ellint_1(std::sin(amplitude / 2));
    State start = State::Zero();
    start[4] = amplitude;
    double before = amplitude, crossing = 0, pull = 0, swing = 0;
    run(hull, start, D, static_cast<int>(T / D) + 2, [&](double t, const State& s, const auto&) {
        if (before > 0 && s[4] <= 0) {
            const double part = before / (before - s[4]);
            crossing = t - D + part * D;
            HullLoads loads = hull.loads(t, s);
            (void)hull.rate(t, s, loads, Vec6::Zero());
            pull = loads[Load::holding][2];
            swing = s[10];
        }
        before = s[4];
        EXPECT_EQ(s[0], 0.0);
        EXPECT_EQ(s[3], 0.0);
    });
    EXPECT_NEAR(crossing, T / 4, 1e-4);  // straight between steps at the crossing
    // At the lowest point the pivot carries weight and m w^2 l.
    EXPECT_NEAR(pull, 2e6 * (g + swing * swing * 20), 1e-3 * 2e6 * g);
    EXPECT_NEAR(swing * swing, 2 * 2e6 * g * 20 * (1 - std::cos(amplitude)) / I, 1e-3);
}

SixSeries sampled(double step, double until) {
    SixSeries rows;
    for (int i = 0; i * step <= until + 1e-9; ++i) {
        const double t = i * step;
        rows.push_back({t, 3 * std::sin(0.5 * t), std::cos(0.4 * t), t * t * t / 1e3, 0.1 * t / 50,
                        0.2 * std::sin(0.3 * t), 0});
    }
    return rows;
}

TEST(PrescribedPath, RunsThroughTheRowsWithContinuousAcceleration) {  // K:21
    PrescribedMotion motion;
    const auto errors = [&](double step) {
        motion.rows = sampled(step, 60);
        const PrescribedPath path(motion, 50);
        Vec3 worst = Vec3::Zero();
        for (double t = 0; t < 60; t += 0.37) {
            const LedMotion led = path.at(t);
            worst[0] =
                std::max(worst[0], std::abs(led.motion.position.x() - 3 * std::sin(0.5 * t)));
            worst[1] =
                std::max(worst[1], std::abs(led.motion.velocity.x() - 1.5 * std::cos(0.5 * t)));
            worst[2] = std::max(worst[2],
                                std::abs(led.acceleration.position.x() + 0.75 * std::sin(0.5 * t)));
            EXPECT_NEAR(led.motion.position.z(), t * t * t / 1e3, 1e-9);  // cubics exactly
            EXPECT_NEAR(led.acceleration.position.z(), 6 * t / 1e3, 1e-9);
        }
        for (std::size_t k = 1; k + 1 < motion.rows.size(); ++k) {
            const double t = motion.rows[k][0];
            EXPECT_NEAR(path.at(t - 1e-9).acceleration.position.x(),
                        path.at(t + 1e-9).acceleration.position.x(), 1e-7);
            EXPECT_NEAR(path.at(t).motion.angles.y(), 0.2 * std::sin(0.3 * t), 1e-14);
        }
        return worst;
    };
    const Vec3 coarse = errors(1.0), fine = errors(0.5);
    EXPECT_GT(coarse[0] / fine[0], 12);  // h^4
    EXPECT_GT(coarse[1] / fine[1], 6);   // h^3
    EXPECT_GT(coarse[2] / fine[2], 3);   // h^2
    // at its ends a cubic through four rows is off by 11/12 h^2 times the fourth derivative
    EXPECT_LT(fine[2], 11.0 / 12.0 * 0.25 * 0.25 * 0.75);
}

TEST(PrescribedPath, HarmonicsAreBroughtInSmoothly) {
    PrescribedMotion motion;
    motion.harmonic[2] = HarmonicMotion{.mean = 1, .amplitude = 4, .period = 9, .phase = 0.3};
    motion.harmonic[4] = HarmonicMotion{.amplitude = 0.1, .period = 7};
    const PrescribedPath path(motion, 20);
    EXPECT_EQ(path.at(0).motion.position.z(), 1);
    EXPECT_EQ(path.at(0).motion.velocity.z(), 0);
    EXPECT_EQ(path.at(0).acceleration.position.z(), 0);
    for (const double t : {1.0, 7.3, 19.0, 20.0, 41.0}) {
        const double h = 1e-4;
        const LedMotion at = path.at(t), after = path.at(t + h), before = path.at(t - h);
        EXPECT_NEAR(at.motion.velocity.z(),
                    (after.motion.position.z() - before.motion.position.z()) / (2 * h), 1e-6);
        EXPECT_NEAR(at.acceleration.angles.y(),
                    (after.motion.angle_rates.y() - before.motion.angle_rates.y()) / (2 * h), 1e-6);
    }
    EXPECT_NEAR(path.at(41).motion.position.z(), 1 + 4 * std::sin(2 * M_PI * 41 / 9 + 0.3), 1e-12);
}

LedgerTable ledger_of(const Case& c, std::vector<State>* states = nullptr) {
    const Hull hull(c, nullptr);
    Vec6 stiffness;
    stiffness << 5e5, 4e5, 1e6, 3e8, 3e8, 5e7;
    test::SpringLines lines({stiffness});
    PlatformMotion from = hull.held_at(0).motion;
    from = with_held({.position = {2, -1, 0.5}, .angles = {0.3, -0.2, 0.1}}, from, hull.held());
    Order to;
    to.to[0] = from;
    lines.send(to);
    PaperRate<Hull> rate(hull, lines, lines.receive());
    PlatformLedger ledger(c);
    rate.watch([&](int stage, double t, const State& s) {
        ledger.add(stage, t, rate.loads(), rate.reply(), hull.momentum(s), motion_of(s).velocity);
    });
    paper_loop(rate, hull.start(from, from), c.analysis.dynamics.platform_step,
               [&](int step, double, const State& y) {
                   if (states != nullptr) states->push_back(y);
                   return step < 300;
               });
    return ledger.table();
}

TEST(HeldMotions, TheLedgerClosesWithTheHoldingLoad) {
    Case c = pendulum_case();
    c.lines.resize(1);
    c.platform->fixed = {false, true, false, false, true, false};
    std::vector<State> states;
    const LedgerTable table = ledger_of(c, &states);
    for (int k = 0; k < 6; ++k) EXPECT_LT(table.residual_fraction(k), large_residual / 10) << k;
    const auto holding = static_cast<std::size_t>(Load::holding);
    EXPECT_GT(std::abs(table.mean[holding][1]) + std::abs(table.mean[holding][4]), 1e3);
    for (const State& s : states) {
        EXPECT_EQ(s[1], states[0][1]);
        EXPECT_EQ(s[4], states[0][4]);
    }
    EXPECT_GT(std::abs(states[100][0] - states[0][0]), 0.1);
}

TEST(PrescribedMotion, IsFollowedToTheBitAndTheForceNeededIsTold) {
    Case c = pendulum_case();
    c.lines.resize(1);
    c.platform->prescribed.emplace().rows = sampled(0.5, 40);
    std::vector<State> states;
    const LedgerTable table = ledger_of(c, &states);
    const PrescribedPath path(*c.platform->prescribed, 0);
    for (std::size_t i = 0; i < states.size(); i += 7) {
        const PlatformMotion led = path.at(static_cast<double>(i) * 0.1).motion;
        EXPECT_EQ(motion_of(states[i]), led) << i;
    }
    for (int k = 0; k < 6; ++k) EXPECT_LT(table.residual_fraction(k), large_residual / 10) << k;
    // No mass: what leads the platform carries the lines and nothing else.
    c.platform->mass = 0;
    const Hull hull(c, nullptr);
    const State s = hull.led(11, State::Zero());
    HullLoads loads = hull.loads(11, s);
    const Vec6 lines = (Vec6() << 1e5, 2e5, -3e5, 4e5, 5e5, 6e5).finished();
    Vec6 acceleration;
    const State rate = hull.rate(11, s, loads, lines, &acceleration);
    EXPECT_LT((loads[Load::holding] + lines).norm(), 1e-6);
    EXPECT_EQ(acceleration[0], path.at(11).acceleration.position.x());
    EXPECT_EQ(rate[0], path.at(11).motion.velocity.x());
}

TEST(HeldMotions, TheEquilibriumMovesOnlyWhatIsFree) {
    Case c = pendulum_case();
    Platform& p = *c.platform;
    p.hydrodynamics.matrix.emplace().stiffness(2, 2) = 4e6;
    p.hydrodynamics.matrix->added_mass.diagonal() << 1e6, 1e6, 1e6, 1e8, 1e8, 1e8;
    p.centre_of_gravity = {0.5, 0, -20};
    p.fixed = {true, true, false, false, true, true};
    p.initial.position = {4, 0, 0.7};
    p.initial.angles = {0, 0.25, 0};
    std::vector<Hull> hulls{Hull(c, nullptr)};
    NoLines lines;
    const StaticStart start = static_start(c, hulls, lines);
    EXPECT_EQ(start.equilibrium[0].position.x(), 4.0);
    EXPECT_EQ(start.equilibrium[0].angles.y(), 0.25);
    EXPECT_NEAR(start.equilibrium[0].position.z(), -2e6 * g / 4e6, 1e-5);  // floats on its spring
    EXPECT_NEAR(start.start[0].position.z() - start.equilibrium[0].position.z(), 0.7, 1e-12);
    EXPECT_EQ(start.start[0].angles.y(), 0.25);
    EXPECT_TRUE(start.modes[0].held);
    EXPECT_TRUE(start.modes[4].held);
    EXPECT_FALSE(start.modes[2].held);
    // Heave and roll alone, O and G on one axis: w^2 = C33/(m + a33).
    EXPECT_NEAR(*start.modes[2].period(), 2 * M_PI * std::sqrt(3e6 / 4e6), 1e-3);
}

}  // namespace
}  // namespace hawser::master
