// Lines that change with time: parting (LineFailure), paying out (Winch), sheltered water.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "guided_riser.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Chain hanging in the water between a platform and the bed.
Case slack_chain() {
    LineType type = plain_type(150, 5e8);
    type.displaced_area = 0.02, type.outer_diameter = 0.1;
    type.drag_diameter = 0.1, type.drag_normal = 2.4, type.drag_axial = 1.15;
    type.added_mass_normal = 1.0, type.added_mass_axial = 0.5, type.damping_ratio = 0.02;
    LineEnd top;
    top.kind = EndKind::platform;
    top.position = {0, 0, -10};
    Case input = one_line(type, 320, 32, top, anchored_at({250, 0, -150}), 150);
    input.analysis.dynamics.line_step = 0.02;
    return input;
}

double kinetic_and_potential(const RodPack<Single>& rod, const Case& input) {
    // lumped: enough to see that energy leaves
    const LineType& type = input.line_types[0];
    const double wet = (type.mass - 1025 * type.displaced_area) * 9.80665;
    const int N = rod.elements();
    double sum = 0.0;
    for (int n = 0; n <= N; ++n) {
        const double L = rod.properties()[0].L[0] * (n == 0 || n == N ? 0.5 : 1.0);
        const NodeState<Single>& x = rod.kept().nodes()[n];
        sum += L * (0.5 * type.mass * vec(x.v).squaredNorm() + wet * x.r.z[0]);
    }
    return sum;
}

TEST(Failure, AtEndALetsThePlatformGo) {
    Case input = slack_chain();
    input.lines[0].fail = LineFailure{.time = 2.01, .arc_length = 0.0};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double before = rod.tension_a(0), high = rod.node_position(0, 0).z();
    ASSERT_TRUE(run(rod, 2.0, 0.5).ok());
    EXPECT_NEAR(rod.tension_a(0), before, 1e-3 * before);
    const PlatformMotion still;
    double energy = kinetic_and_potential(rod, input);
    for (int k = 4; k < 240; ++k) {
        const double t0 = 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, still, t1, still)).ok()) << t1;
        rod.keep();
        ASSERT_EQ(rod.pass_wrench(0).norm(), 0.0);
        ASSERT_TRUE(std::isfinite(rod.node_position(0, 0).z()));
        const double now = kinetic_and_potential(rod, input);
        // a slack chain's stretch of 0.2 mm/m is all that could come back
        if (k % 10 == 0) {
            EXPECT_LT(now, energy + 1e-4 * std::abs(energy)) << t1;
            energy = now;
        }
    }
    EXPECT_LT(rod.node_position(0, 0).z(), high - 100.0);
    // all lies, in folds that elements of 10 m arch over
    for (int n = 0; n <= 32; ++n) EXPECT_LT(rod.node_position(0, n).z(), -145.0) << n;
}

TEST(Failure, HappensInTheStepThatPassesItsTime) {
    Case input = slack_chain();
    input.lines[0].fail = LineFailure{.time = 0.41, .arc_length = 0.0};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double before = rod.tension_a(0);
    ASSERT_TRUE(run(rod, 0.44, 0.02, [&](double t) {
                    EXPECT_NEAR(rod.tension_a(0), t < 0.41 ? before : 0.0, 1e-3 * before) << t;
                }).ok());
}

TEST(Failure, AtTheAnchorLeavesItNothing) {
    Case input = slack_chain();
    input.lines[0].fail = LineFailure{.time = 0.5, .arc_length = 320.0};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_GT(rod.tension_b(0), 1e4);
    ASSERT_TRUE(run(rod, 5, 0.5).ok());
    // half an element lies at the anchor and joins it to nothing
    EXPECT_LT(std::abs(rod.tension_b(0)), 0.05 * 5 * (150 - 1025 * 0.02) * 9.80665);
    for (int i = 0; i < 2; ++i) EXPECT_LT(std::abs(rod.kept().lambda()[i].now[0]), 1.0) << i;
    EXPECT_LT((rod.node_position(0, 32) - Vec3(250, 0, -150)).norm(), 1e-9);
}

TEST(Failure, AtANodeBothPartsGoOn) {
    Case input = slack_chain();
    input.lines[0].fail = LineFailure{.time = 1.0, .arc_length = 81.0};  // node at 80 m
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    ASSERT_TRUE(run(rod, 200, 0.5).ok());
    // what hangs from the platform: 70 m and half of the element that parted
    const double wet = (150 - 1025 * 0.02) * 9.80665;
    EXPECT_NEAR(rod.tension_a(0), 75 * wet, 0.01 * 75 * wet);
    EXPECT_NEAR(rod.node_position(0, 7).z(), -10 - 70, 0.5);
    for (int n = 8; n <= 32; ++n) EXPECT_LT(rod.node_position(0, n).z(), -145.0) << n;
    EXPECT_LT(std::abs(rod.tension_b(0)), 0.3 * 32 * wet);  // what friction holds, ten times less
    // far apart: nothing joins them
    EXPECT_GT((rod.node_position(0, 7) - rod.node_position(0, 8)).norm(), 60.0);
}

/// A riser of 210 m in its tensioner, drawn taut, that fails at an arc length after one second.
Case failing_riser(double arc_length) {
    Case input = guided_riser(212.0, 0.0);
    input.environment.seabed.depth = 200;
    input.lines[0].end_b.position.z() = -190;
    input.lines[0].sections = {{.type = 0, .length = 211, .elements = 40}};
    input.lines[0].constraints.resize(2);
    input.lines[0].constraints[1].position.z() = -20;
    input.lines[0].fail = LineFailure{.time = 1.0, .arc_length = arc_length};
    input.analysis.dynamics.line_step = 0.01;
    return input;
}

TEST(Failure, AtTheTopOfATensionedRiserFreesItOfItsTensioner) {
    const Case input = failing_riser(0.0);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double before = rod.tension_a(0);
    EXPECT_GT(before, 4e6);
    ASSERT_TRUE(run(rod, 3.0, 0.5, [&](double t) {
                    if (t < 0.99) {
                        EXPECT_NEAR(rod.tension_a(0), before, 1e-3 * before) << t;
                        EXPECT_NEAR(rod.constraint_magnitude(0, 0), before, 1e-3 * before) << t;
                    } else if (t > 1.01) {
                        EXPECT_EQ(rod.constraint_magnitude(0, 0), 0.0) << t;
                        EXPECT_EQ(rod.constraint_force(0, 0).norm(), 0.0) << t;
                        // what the guide may still hold
                        const Vec3 guide = rod.constraint_force(0, 1);
                        EXPECT_LT((rod.pass_wrench(0).head<3>() + guide).norm(), 1.0) << t;
                        EXPECT_LT(std::abs(rod.tension_a(0)), 1e-3 * before) << t;
                    }
                }).ok());
}

TEST(Failure, AtARingBelowTheTopLetsItsTensionerGoToo) {
    Case input = failing_riser(10.55);  // two elements down
    input.lines[0].constraints[0].arc_length = 10.55;
    input.lines[0].constraints[0].position.z() = 11.45;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_GT(rod.constraint_magnitude(0, 0), 4e6);
    ASSERT_TRUE(run(rod, 1.5, 0.5).ok());
    EXPECT_EQ(rod.constraint_magnitude(0, 0), 0.0);
}

TEST(Guide, ExertsNothingBeyondTheEndOfTheRod) {
    // a rod that hangs 5 m above a guide and one that hangs through it
    Case input = slack_chain();
    input.line_types[0].EI = 1e6;
    input.lines[0].end_b = LineEnd{};
    input.lines[0].end_a.position = {0, 0, -10};
    input.lines[0].sections = {{.type = 0, .length = 60, .elements = 12}};
    input.lines[0].constraints = {{.type = ConstraintType::guide,
                                   .name = "guide",
                                   .position = {0.5, 0, -75},
                                   .stiffness = 1e5,
                                   .damping = 1e3,
                                   .gap = 0.025}};
    const Sea sea = still_sea(input);
    RodPack<Quad> above(input, sea, {0});
    ASSERT_TRUE(above.equilibrium({}, false).ok());
    EXPECT_EQ(above.constraint_force(0, 0).norm(), 0.0);
    EXPECT_EQ(above.constraint_magnitude(0, 0), 0.0);
    EXPECT_LT(std::abs(above.node_position(0, 12).x()), 1e-9);
    input.lines[0].constraints[0].position.z() = -65;
    RodPack<Quad> through(input, sea, {0});
    ASSERT_TRUE(through.equilibrium({}, false).ok());
    // a stiff pendulum of 76 kN drawn aside by 0.475 m would push with 0.36 kN
    EXPECT_GT(through.constraint_force(0, 0).x(), 200.0);
    EXPECT_LT(through.constraint_force(0, 0).x(), 360.0);
}

TEST(Failure, IsTheSameInEveryPassAndLeavesNeighboursAlone) {
    Case input = slack_chain();
    for (int i = 1; i < 4; ++i) input.lines.push_back(input.lines[0]);
    // Matching the impulse would hand over what the other passes have returned.
    input.analysis.dynamics.force = ForceFit::instantaneous;
    input.lines[1].fail = LineFailure{.time = 1.13, .arc_length = 0.0};
    input.lines[2].fail = LineFailure{.time = 0.61, .arc_length = 160.0};
    const Sea sea = still_sea(input);
    RodPack<Quad> together(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(together.equilibrium({}, false).ok());
    const PlatformMotion still;
    const auto step = [&](RodPack<Quad>& pack, int k, bool often) {
        const double t = 0.5 * k;
        if (often) {
            for (const double H : {0.25, 0.25, 0.5})
                ASSERT_TRUE(pack.pass(t, t + H, MotionSpline(t, still, t + H, still)).ok());
        }
        ASSERT_TRUE(pack.pass(t, t + 0.5, MotionSpline(t, still, t + 0.5, still)).ok());
        pack.keep();
    };
    for (int k = 0; k < 12; ++k) step(together, k, true);
    for (int line = 0; line < 4; ++line) {
        RodPack<Quad> alone(input, sea, {line});
        ASSERT_TRUE(alone.equilibrium({}, false).ok());
        for (int k = 0; k < 12; ++k) step(alone, k, false);
        for (std::size_t n = 0; n < alone.kept().block().size(); ++n)
            ASSERT_EQ(alone.kept().block()[n][0], together.kept().block()[n][line]) << line;
    }
}

TEST(Winch, PayingOutEndsInTheLongerLinesStatics) {
    Case input = slack_chain();
    input.lines[0].sections = {{.type = 0, .length = 60, .elements = 6},
                               {.type = 0, .length = 260, .elements = 26}};
    Case longer = input;
    longer.lines[0].sections[0].length = 66;
    input.lines[0].winch = Winch{.paid_out = {{5, 0}, {35, 6}}};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0}), goal(longer, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    ASSERT_TRUE(goal.equilibrium({}, false).ok());
    const double before = rod.tension_a(0);
    ASSERT_TRUE(run(rod, 5, 0.5).ok());
    EXPECT_NEAR(rod.tension_a(0), before, 1e-3 * before);
    for (int k = 10; k < 600; ++k) {
        const PlatformMotion still;
        const double t0 = 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, still, t1, still)).ok());
        rod.keep();
    }
    // bed friction holds back what was laid down: up to mu w of the length that moved
    EXPECT_NEAR(rod.tension_a(0), goal.tension_a(0), 2e-3 * goal.tension_a(0));
    EXPECT_LT(goal.tension_a(0), 0.95 * before);
    for (int n = 0; n <= 20; ++n)
        EXPECT_LT((rod.node_position(0, n) - goal.node_position(0, n)).norm(), 0.1) << n;
}

TEST(Winch, TensionOfATautLineFollowsItsLength) {  // T = EA (l - L)/L
    LineType type = plain_type(1.0, 1e7);
    const double L = 100, l = 101;
    Case input = one_line(type, L, 4, fixed_at({l, 0, -50}), fixed_at({0, 0, -50}));
    input.environment.water.density = 0.0, input.environment.water.gravity = 1e-9;
    input.lines[0].winch = Winch{.paid_out = {{0, 0}, {10, -0.5}, {20, 0.4}}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    ASSERT_TRUE(run(rod, 20, 0.5, [&](double t) {
                    const double paid = t < 10 ? -0.05 * t : -0.5 + 0.09 * (t - 10);
                    const double T = 1e7 * (l - L - paid) / (L + paid);
                    EXPECT_NEAR(rod.tension_a(0), T, 1e-3 * T) << t;  // axial waves: 2 kN
                }).ok());
}

constexpr double excess = 50.0;  // of the mass over that of the water [kg/m]

/// Vertical rod under a platform, in waves and current.
Case riser_in_hull(std::optional<double> above) {
    LineType type = plain_type(1025 * 0.05 + excess, 1e9, 1e10);
    type.displaced_area = 0.05, type.outer_diameter = 0.25, type.added_mass_normal = 1.0;
    type.drag_diameter = 0.25, type.drag_normal = 1.2, type.drag_axial = 0.1;
    LineEnd top;
    top.kind = EndKind::platform, top.joint = Joint::clamped;
    top.position = {3, 2, -10}, top.direction = Vec3(0, 0, -1);
    Case input = one_line(type, 40, 8, top, LineEnd{}, 1000);
    input.environment.waves = {WaveTrain{.type = WaveType::airy, .H = 6, .T = 9}};
    input.environment.current = Current{.heading = 1.0, .profile = {{.depth = 0, .speed = 1.0}}};
    input.analysis.dynamics.ramp = 0.0;
    input.lines[0].sheltered_above = above;
    return input;
}

TEST(Shelter, WaterMovesWithTheHull) {
    // wholly sheltered: the accelerated water carries the mass that it displaces, the support the
    // rest
    Case input = riser_in_hull(-60.0);
    const Sea sea(input.environment, 0.0, 0.0);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, true).ok());
    EXPECT_NEAR(rod.node_position(0, 8).x(), 3.0, 1e-6);
    const auto hull = [](double t) {
        PlatformMotion m;
        m.position = {2 * std::sin(0.6 * t), 0, std::sin(0.5 * t)};
        m.velocity = {1.2 * std::cos(0.6 * t), 0, 0.5 * std::cos(0.5 * t)};
        return m;
    };
    NodeState<Quad>* node = rod.kept().nodes();
    for (int n = 0; n <= 8; ++n) node[n].v = Vector<Quad>{1.2, 0, 0.5};
    for (int k = 0; k < 40; ++k) {
        const double t0 = 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, hull(t0), t1, hull(t1))).ok());
        rod.keep();
        const Vec3 a(-0.72 * std::sin(0.6 * t1), 0, -0.25 * std::sin(0.5 * t1));
        const Vec3 exact = -excess * 40 * (a + Vec3(0, 0, 9.80665));
        // 1.4 kN of 2 t; of 6 t with the water's part it would be 4.3 kN. The spline's acceleration
        // is right to 1 %, the tip swings by millimetres.
        EXPECT_LT((rod.force_on_support_a(0) - exact).norm(), 60.0) << t1;
        EXPECT_NEAR(rod.node_position(0, 8).x() - rod.node_position(0, 0).x(), 0.0, 0.02);
    }
    EXPECT_EQ(rod.work().water_samples, 0);  // no wave is looked at there
}

TEST(Shelter, BelowItTheSeaIsFelt) {
    const Case open = riser_in_hull({}), half = riser_in_hull(-30.0);
    const Sea sea(open.environment, 0.0, 0.0);
    RodPack<Quad> in_the_open(open, sea, {0}), sheltered(half, sea, {0});
    ASSERT_TRUE(in_the_open.equilibrium({}, true).ok());
    ASSERT_TRUE(sheltered.equilibrium({}, true).ok());
    // drag of the current on 40 and on 20 m
    const double full = in_the_open.force_on_support_a(0).head<2>().norm();
    EXPECT_NEAR(full, 0.5 * 1025 * 1.2 * 0.25 * 40, 0.03 * full);  // the tip leans by 1 deg
    EXPECT_NEAR(sheltered.force_on_support_a(0).head<2>().norm(), 0.5 * full, 0.03 * full);
    ASSERT_TRUE(run(in_the_open, 1.0, 0.5).ok());
    ASSERT_TRUE(run(sheltered, 1.0, 0.5).ok());
    // nothing is sampled more than 5 m and a point's piece above the border
    const auto samples = [](const RodPack<Quad>& rod) {
        return static_cast<double>(rod.work().water_samples);
    };
    EXPECT_LT(samples(sheltered), 0.75 * samples(in_the_open));
    EXPECT_GT(samples(sheltered), 0.5 * samples(in_the_open));
}

}  // namespace
}  // namespace hawser::worker
