// Quasi-static lines: the same rods without inertia, drag of their own motion and waves.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "guided_riser.hpp"
#include "packing.hpp"
#include "rod/catenary.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

Case with_model(Case input, LineModel model) {
    input.analysis.dynamics.line_model = model;
    return input;
}

/// Sea, rod and passes of one line with a moving top; the tension at end A after each pass.
template <class V>
Record tension_of(const Case& input, double duration, double interval) {
    const Sea sea(input.environment, input.analysis.dynamics.ramp, 1.0);
    RodPack<V> rod(input, sea, {0});
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    Record out;
    EXPECT_TRUE(run(rod, duration, interval, [&](double t) { out.add(t, rod.tension_a(0)); }).ok());
    return out;
}

TEST(QuasiStatic, FollowsTheDynamicLineInSlowMotion) {
    // 5 m in 1000 s: drag moves the tension by 1 % of its deviation, in 200 s by 22 %
    Case input = standing_line(moving(fixed_at({0, 0, -100}), {-5, 0, 1}, 1000), 2065);
    input.analysis.dynamics.ramp = 500;
    const Record still = tension_of<Quad>(with_model(input, LineModel::quasi_static), 1000, 5);
    input.analysis.dynamics.line_step = 0.5;
    const Record dynamic = tension_of<Quad>(input, 1000, 5);
    EXPECT_GT(dynamic.deviation(), 1e5);
    EXPECT_LT(rms_difference(still, dynamic), 0.015 * dynamic.deviation());  // 1.1 %, v^2 of 22 %
}

TEST(QuasiStatic, IsTheStaticLineHoweverFastItsEndMoves) {
    // 3 m in 8 s, where the dynamic line has drag and inertia of its own size
    Case input = standing_line(moving(fixed_at({0, 0, -100}), {3, 0, 1}, 8), 2040);
    input.analysis.dynamics.ramp = 1;
    const Sea sea(input.environment, 1.0, 1.0);
    RodPack<Quad> rod(with_model(input, LineModel::quasi_static), sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    double worst = 0.0;
    ASSERT_TRUE(run(rod, 12, 0.5, [&](double t) {
                    if (t < 1) return;  // the ramp
                    const double s = std::sin(2 * M_PI * t / 8);
                    const Case there = standing_line(fixed_at({3 * s, 0, -100 + s}), 2040);
                    RodPack<Quad> at_rest(there, sea, {0});
                    ASSERT_TRUE(at_rest.equilibrium({}, false).ok());
                    worst = std::max(worst, std::abs(rod.tension_a(0) / at_rest.tension_a(0) - 1));
                }).ok());
    EXPECT_LT(worst, 1e-9);  // the same equations; still_tolerance leaves 1e-6 m of 2500 m
    const Record dynamic = tension_of<Quad>(input, 12, 0.5);
    const Record still = tension_of<Quad>(with_model(input, LineModel::quasi_static), 12, 0.5);
    EXPECT_GT(rms_difference(still, dynamic), 0.1 * still.deviation());  // ... which it is not
}

TEST(QuasiStatic, HangsOnTheElasticCatenary) {
    const double w = 200, L = 2286, EA = 7.06e8;
    Case input = one_line(plain_type(w / 9.80665, EA), L, 16,
                          moving(fixed_at({0, 0, 0}), {20, 0, 10}, 20), fixed_at({1900, 0, -1300}));
    input.environment.water.density = 0.0;
    input.analysis.dynamics.ramp = 1;
    const Sea sea(input.environment, 1.0, 1.0);
    RodPack<Quad> rod(with_model(input, LineModel::quasi_static), sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const std::vector<CatenaryElement> element(
        1, {.length = L, .EA = EA, .weight_wet = w, .weight_dry = w});
    ASSERT_TRUE(run(rod, 10, 0.5, [&](double t) {
                    if (t < 1) return;
                    const double s = std::sin(2 * M_PI * t / 20);
                    const Catenary c =
                        solve_catenary(element, {1900, 0, -1300}, {20 * s, 0, 10 * s}, false);
                    const double T = std::hypot(c.horizontal, c.vertical_a);
                    EXPECT_NEAR(rod.tension_a(0), T, 2e-7 * T) << t;  // mesh of 16
                }).ok());
}

TEST(QuasiStatic, ViscoelasticRopeStillRelaxesWithItsTime) {  // R:4, R:36, one step per pass
    const double EA_d = 706.32e6, EA_s = 451.26e6, tau_r = 20, length = 100;
    const double e0 = 0.002, step = 0.003, quick = 1e-3;
    LineType rope = plain_type(1e-3, EA_d);
    rope.viscoelastic = Viscoelastic{EA_d, EA_s, tau_r};
    rope.damping_ratio = 0.5;  // structural damping acts on rates that are none
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = {length * (1 + e0), 0, 0};
    Case input = one_line(rope, length, 2, a, fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 1e-9;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(with_model(input, LineModel::quasi_static), sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const PlatformMotion before;
    PlatformMotion after;
    after.position.x() = step * length;
    ASSERT_TRUE(rod.pass(0, quick, MotionSpline(0, before, quick, after)).ok());
    rod.keep();
    for (int k = 0; k < 160; ++k) {
        const double t0 = quick + 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, after, t1, after)).ok());
        rod.keep();
        const double modulus = (rod.tension_a(0) - EA_s * e0) / step;
        const double exact = EA_s + (EA_d - EA_s) * std::exp(-(t1 - quick / 2) / tau_r);
        // steps of tau_r/40 by the trapezoidal rule, (h/tau)^2/12 of the decay, and the instant
        EXPECT_NEAR(modulus, exact, 1e-3 * exact) << t1;
    }
}

/// The moored chain of the quasi-static tests of state: partly on the bed.
Case lying_chain(LineModel model) {
    Case input =
        one_line(plain_type(200, 1e9), 500, 40, moving(fixed_at({0, 0, 0}), {10, 4, 3}, 12),
                 anchored_at({400, 0, -200}), 200);
    input.environment.water.density = 0.0;
    input.analysis.dynamics.ramp = 2;
    return with_model(input, model);
}

TEST(QuasiStatic, PassesStartFromTheKeptStateAndLeaveNoTrace) {
    const Case input = lying_chain(LineModel::quasi_static);
    const Sea sea = still_sea(input);
    const PlatformMotion still;
    const auto run_with = [&](bool trial_passes) {
        RodPack<Quad> rod(input, sea, {0});
        EXPECT_TRUE(rod.equilibrium({}, false).ok());
        for (int k = 0; k < 10; ++k) {
            const double t = 0.5 * k;
            const MotionSpline spline(t, still, t + 0.5, still);
            if (trial_passes) {
                EXPECT_TRUE(rod.pass(t, t + 0.25, spline).ok());
                EXPECT_TRUE(rod.pass(t, t + 0.5, spline).ok());
            }
            EXPECT_TRUE(rod.pass(t, t + 0.5, spline).ok());
            rod.keep();
        }
        return rod.kept().block();
    };
    const auto a = run_with(false), b = run_with(true);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
}

TEST(QuasiStatic, NeighboursDoNotChangeABit) {
    Case input = lying_chain(LineModel::quasi_static);
    for (int i = 1; i < 4; ++i) {
        Line other = input.lines[0];
        other.end_a.motion->amplitude *= 1.5 * i;  // some of them in parts of the way
        input.lines.push_back(other);
    }
    const Sea sea = still_sea(input);
    RodPack<Quad> together(input, sea, {0, 1, 2, 3}), alone(input, sea, {0});
    ASSERT_TRUE(together.equilibrium({}, false).ok());
    ASSERT_TRUE(alone.equilibrium({}, false).ok());
    ASSERT_TRUE(run(together, 6, 0.5).ok());
    ASSERT_TRUE(run(alone, 6, 0.5).ok());
    for (std::size_t n = 0; n <= 40; ++n)
        EXPECT_EQ(LaneTraits<Quad>::get(together.kept().nodes()[n].r.x, 0),
                  LaneTraits<Quad>::get(alone.kept().nodes()[n].r.x, 0));
    EXPECT_EQ(together.tension_a(0), alone.tension_a(0));
}

TEST(QuasiStatic, GoesInPartsWhereOneStrideFails) {
    // the top leaps by 60 m in one pass: Newton's iteration does not find it from where it was
    Case input = lying_chain(LineModel::quasi_static);
    input.lines[0].end_a.kind = EndKind::platform;
    input.lines[0].end_a.motion.reset();
    input.environment.seabed.friction_axial = input.environment.seabed.friction_lateral = 0.0;
    const Sea sea = still_sea(input);
    PlatformMotion from, to;
    to.position = {-40, 30, 5};
    RodPack<Quad> rod(input, sea, {0}), there(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium(from, false).ok());
    ASSERT_TRUE(rod.pass(0.0, 0.5, MotionSpline(0.0, from, 0.5, to)).ok());
    ASSERT_TRUE(there.equilibrium(to, false).ok());
    EXPECT_NEAR(rod.tension_a(0), there.tension_a(0), 1e-6 * there.tension_a(0));
}

TEST(QuasiStatic, SaysWhereAndWhenThereIsNoSolution) {
    Case input = lying_chain(LineModel::quasi_static);
    input.lines[0].end_a.kind = EndKind::platform;
    input.lines[0].end_a.motion.reset();
    const Sea sea = still_sea(input);
    PlatformMotion from, to;
    to.position = {-3000, 0, 0};  // six times its length
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium(from, false).ok());
    const Status status = rod.pass(0.0, 0.5, MotionSpline(0.0, from, 0.5, to));
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.line, 0);
    EXPECT_GT(status.t, 0.0);
    EXPECT_LE(status.t, 0.5);
}

TEST(QuasiStatic, RiserInItsGuidesStandsAtRestInEveryPassOfAStormyHull) {
    // surge of 5 m and 2 deg of pitch in 12 s about an offset of 25 m, heave of 2 m: guides come
    // and go, the contact walks along the riser
    Case input = guided_riser(1521.1);
    for (LineConstraint& c : input.lines[0].constraints) c.friction = 0.0;
    const Sea sea = still_sea(input);
    const auto pose = [](double t) {
        const double w = 2 * M_PI / 12;
        PlatformMotion m;
        m.position = {25 + 5 * std::sin(w * t), 2 * std::sin(0.7 * w * t), 2 * std::cos(w * t) - 2};
        m.velocity = {5 * w * std::cos(w * t), 1.4 * w * std::cos(0.7 * w * t),
                      -2 * w * std::sin(w * t)};
        m.angles.y() = 0.035 * std::sin(w * t);
        m.angle_rates.y() = 0.035 * w * std::cos(w * t);
        return m;
    };
    RodPack<Quad> rod(with_model(input, LineModel::quasi_static), sea, {0}), there(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium(pose(0), false).ok());
    double strongest = 0.0;
    for (int k = 0; k < 48; ++k) {
        const double t = 0.5 * k;
        ASSERT_TRUE(rod.pass(t, t + 0.5, MotionSpline(t, pose(t), t + 0.5, pose(t + 0.5))).ok())
            << t;
        rod.keep();
        ASSERT_TRUE(there.equilibrium(pose(t + 0.5), false).ok());
        for (int c = 0; c < 6; ++c) {
            const double N = there.constraint_magnitude(0, c);
            // 1e-6 m of a guide of 20 MN/m
            EXPECT_NEAR(rod.constraint_magnitude(0, c), N, 1e-6 * N + 40) << t << " " << c;
            if (c > 0) strongest = std::max(strongest, N);
        }
    }
    EXPECT_GT(strongest, 5e4);
    // about four corrections a pass; from the kept shape where it stood it was ten and more
    EXPECT_LT(static_cast<double>(rod.work().solves), 7.0 * 48 + 100);
}

TEST(QuasiStatic, PacksDoNotMixModels) {
    Case input = lying_chain(LineModel::dynamic);
    Line other = input.lines[0];
    other.model = LineModel::quasi_static;
    input.lines.push_back(other);
    input.lines.push_back(input.lines[0]);
    const std::vector<Pack> packs = packs_of(input);
    ASSERT_EQ(packs.size(), 2u);
    EXPECT_EQ(packs[0].lines, (std::vector<int>{0, 2}));
    EXPECT_EQ(packs[1].lines, (std::vector<int>{1}));
}

}  // namespace
}  // namespace hawser::worker
