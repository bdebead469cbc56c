// Rods under loads that break weak solvers: slack and snap, compression, lift-off and landing,
// stops, impacts, a neighbour that fails. Every run must end sound, and its largest figure must not
// depend on the step.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Least and greatest of a tension, and of the tension anywhere in the rod.
struct Extremes {
    double top_least = 1e30, top_greatest = -1e30, least = 1e30, greatest = -1e30;
    void add(const RodPack<Single>& rod) {
        top_least = std::min(top_least, rod.tension_a(0));
        top_greatest = std::max(top_greatest, rod.tension_a(0));
        for (int i = 0; i <= 2 * rod.elements(); ++i) {
            const double T = rod.kept().lambda()[i].now[0];
            least = std::min(least, T), greatest = std::max(greatest, T);
        }
    }
};

/// Runs a case of one line with steps h and gathers the extremes after `from`.
Extremes extremes(Case input, double h, double duration, double from, Status& status) {
    input.analysis.dynamics.line_step = h;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    status = rod.equilibrium({}, false);
    EXPECT_TRUE(status.ok());
    Extremes out;
    status = run(rod, duration, 0.1, [&](double t) {
        if (t >= from) out.add(rod);
    });
    return out;
}

TEST(SlackLine, SnapsWithAPeakThatDoesNotDependOnTheStep) {
    // A chain whose top falls faster than it can follow: slack at the anchor, then a snap
    LineType chain = plain_type(77.7066, 384.243e6);
    chain.displaced_area = M_PI / 4 * 0.09 * 0.09;
    chain.drag_diameter = 0.09, chain.drag_normal = 1.6, chain.drag_axial = 0.3;
    chain.added_mass_normal = 1.0, chain.damping_ratio = 0.01;
    LineEnd top = moving(fixed_at({5.2, 0, -70}), {-7, 0, 4}, 9);
    Case input = one_line(chain, 902.2, 60, top, anchored_at({853.87, 0, -320}), 320);
    input.analysis.dynamics.ramp = 9;
    Status status;
    const Extremes coarse = extremes(input, 0.02, 27, 9, status);
    ASSERT_TRUE(status.ok()) << status.t;
    const Extremes fine = extremes(input, 0.005, 27, 9, status);
    ASSERT_TRUE(status.ok()) << status.t;
    EXPECT_LT(fine.top_least, 0.1 * 911e3);  // of the tension at rest
    EXPECT_GT(fine.top_greatest, 3 * 911e3);
    // short spikes of a slack line: 3 % at 0.1 s, falling with the square of the step
    EXPECT_NEAR(coarse.top_greatest, fine.top_greatest, 0.03 * fine.top_greatest);
}

TEST(Riser, CompressedNearTouchdownComesThrough) {
    // 324 x 20 mm, top heaved by 8 m in 8 s: compression of some MN runs down to touchdown
    LineType pipe = plain_type(229.2, 3.954e9, 4.587e7);
    pipe.displaced_area = M_PI / 4 * 0.324 * 0.324;
    pipe.outer_diameter = pipe.drag_diameter = 0.324;
    pipe.drag_normal = 1.2, pipe.added_mass_normal = 1.0, pipe.damping_ratio = 0.01;
    LineEnd top = moving(fixed_at({0, 0, -165}), {0, 0, 8}, 8);
    Case input = one_line(pipe, 2200, 1, top, anchored_at({1300, 0, -1500}), 1500);
    input.lines[0].sections = {{.type = 0, .length = 1300, .elements = 20},
                               {.type = 0, .length = 500, .elements = 50},
                               {.type = 0, .length = 400, .elements = 10}};
    input.analysis.dynamics.ramp = 16;
    Status status;
    const Extremes coarse = extremes(input, 0.02, 40, 24, status);
    ASSERT_TRUE(status.ok()) << status.t;
    const Extremes fine = extremes(input, 0.01, 40, 24, status);
    ASSERT_TRUE(status.ok()) << status.t;
    EXPECT_LT(fine.least, -1e5);
    EXPECT_GT(fine.top_greatest, 4e6);
    EXPECT_NEAR(coarse.top_greatest, fine.top_greatest, 0.02 * fine.top_greatest);
}

TEST(LineOnTheBed, LiftsOffLandsAndLiesAsBefore) {
    LineType chain = plain_type(390, 1.674e9);
    chain.displaced_area = M_PI / 4 * 0.252 * 0.252;
    chain.drag_diameter = 0.252, chain.drag_normal = 1.4, chain.drag_axial = 0.6;
    chain.added_mass_normal = 1.0, chain.damping_ratio = 0.02;
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = {0, 0, -2};
    Case input = one_line(chain, 420, 60, a, anchored_at({380, 0, -100}), 100);
    input.environment.seabed.friction_axial = input.environment.seabed.friction_lateral = 0.0;
    input.analysis.dynamics.line_step = 0.02;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double T0 = rod.tension_a(0);
    const auto on_bed = [&] {
        int n = 0;
        for (int i = 0; i <= rod.elements(); ++i) n += rod.node_position(0, i).z() < -99.8;
        return n;
    };
    const int lying = on_bed();
    int fewest = lying;
    // the top goes 24 m away from the anchor and back, 10 s each way, then stands
    const auto pose = [](double t) {
        PlatformMotion m;
        if (t < 20) {
            const double w = 2 * M_PI / 20;
            m.position.x() = -12 * (1 - std::cos(w * t));
            m.velocity.x() = -12 * w * std::sin(w * t);
        }
        return m;
    };
    for (int k = 0; k < 480; ++k) {
        const double t0 = 0.25 * k, t1 = t0 + 0.25;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, pose(t0), t1, pose(t1))).ok()) << t0;
        rod.keep();
        fewest = std::min(fewest, on_bed());
    }
    EXPECT_GT(lying, 10);
    EXPECT_LT(fewest, lying / 2);
    EXPECT_EQ(on_bed(), lying);
    EXPECT_NEAR(rod.tension_a(0), T0, 2e-3 * T0);  // what swings on after 100 s of quadratic drag
}

/// A top-tensioned riser, 406 x 25 mm in 1500 m, on a gas tensioner of +-4.5 m; guides if asked
/// for.
Case tensioned_riser(bool guides, double step) {
    LineType pipe = plain_type(337.0, 6.2e9, 1.13e8);
    pipe.displaced_area = M_PI / 4 * 0.406 * 0.406;
    pipe.outer_diameter = pipe.drag_diameter = 0.406;
    pipe.drag_normal = 1.2, pipe.added_mass_normal = 1.0, pipe.damping_ratio = 0.01;
    LineEnd foot = fixed_at({4.5, 4.5, -1500}, Joint::clamped);
    foot.direction = Vec3(0, 0, -1);
    Case input = one_line(pipe, 1521.1, 40, LineEnd{}, foot, 1500);
    input.lines[0].sections = {{.type = 0, .length = 200, .elements = 20},
                               {.type = 0, .length = 1321.1, .elements = 30}};
    input.lines[0].constraints = {{.type = ConstraintType::tensioner,
                                   .name = "tensioner",
                                   .position = {4.5, 4.5, 22},
                                   .arc_length = 0.0,
                                   .damping = 2e4,
                                   .nominal_tension = 5.338e6,
                                   .exponent = 1.1,
                                   .gas_column = 40,
                                   .stroke_min = -4.5,
                                   .stroke_max = 4.5}};
    if (guides)
        for (const double z : {-95.0, -135.0, -173.0})
            input.lines[0].constraints.push_back({.type = ConstraintType::guide,
                                                  .name = "guide",
                                                  .position = {4.5, 4.5, z},
                                                  .stiffness = 2e7,
                                                  .damping = 2e5,
                                                  .gap = 0.025,
                                                  .friction = 0.1});
    input.analysis.dynamics.line_step = step;
    return input;
}

TEST(TensionedRiser, StrokesOutOnBothSidesAndComesBack) {
    const Case input = tensioned_riser(false, 0.01);
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double start = rod.constraint_magnitude(0, 0), w = 2 * M_PI / 60;
    const auto pose = [&](double t) {  // one heave of +-6 m in a minute: beyond both stops
        PlatformMotion m;
        m.position.z() = 6.0 * (std::sin(w * t) - std::sin(2 * w * t) / 2);
        m.velocity.z() = 6.0 * w * (std::cos(w * t) - std::cos(2 * w * t));
        return m;
    };
    double longest = 0.0, shortest = 0.0, greatest = 0.0, least = 1e12;
    for (int k = 0; k < 240; ++k) {
        const double t0 = 0.25 * k, t1 = t0 + 0.25;
        const Status status = rod.pass(t0, t1, MotionSpline(t0, pose(t0), t1, pose(t1)));
        ASSERT_TRUE(status.ok()) << t0;
        rod.keep();
        longest = std::max(longest, rod.constraint_opening(0, 0));
        shortest = std::min(shortest, rod.constraint_opening(0, 0));
        greatest = std::max(greatest, rod.constraint_magnitude(0, 0));
        least = std::min(least, rod.constraint_magnitude(0, 0));
    }
    // the stops are hard beside the riser (EA/L = 4 MN/m), and what the ram cannot give it must
    const double beyond = 6.0 * 1.299 - 4.5;  // greatest heave less the stop
    EXPECT_GT(longest, 4.5);
    EXPECT_LT(longest, 4.5 + 0.25);
    EXPECT_LT(shortest, -4.5);
    EXPECT_GT(shortest, -4.5 - 0.25);
    const double pull = 5.338e6 * std::pow(40 / (40 - 4.5), 1.1);
    EXPECT_NEAR(greatest, pull + 6.2e9 / 1521.1 * beyond, 0.15 * greatest);
    EXPECT_LT(least, 5.338e6 * std::pow(40 / (40 + 4.5), 1.1));
    EXPECT_NEAR(rod.constraint_magnitude(0, 0), start, 0.01 * start);
}

/// A hull that leaves its place with the speed of 2 m/s until it has moved by 1 m.
struct Impact {
    double peak = 0.0, deepest = 0.0;
    bool complementary = true;
};
Impact strike(double step) {
    const Case input = tensioned_riser(true, step);
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    const auto pose = [](double t) {
        PlatformMotion m;  // 2 m/s is reached after 5 mm, well inside the gap of 25 mm
        m.position.x() = t < 0.005 ? 200 * t * t : std::min(1.0, 2 * (t - 0.0025));
        m.velocity.x() = t < 0.005 ? 400 * t : t < 0.5025 ? 2.0 : 0.0;
        return m;
    };
    Impact out;
    const double dt = 0.0025;
    for (int k = 0; k < 320; ++k) {
        const double t0 = dt * k, t1 = t0 + dt;
        const Status status = rod.pass(t0, t1, MotionSpline(t0, pose(t0), t1, pose(t1)));
        EXPECT_TRUE(status.ok()) << t0;
        if (!status.ok()) return out;
        rod.keep();
        for (int c = 1; c <= 3; ++c) {
            const double N = rod.constraint_magnitude(0, c), gap = rod.constraint_opening(0, c);
            out.peak = std::max(out.peak, N), out.deepest = std::min(out.deepest, gap);
            const Vec3 place = pose(t1).position +
                               input.lines[0].constraints[static_cast<std::size_t>(c)].position;
            Vec3 across = rod.constraint_point(0, c) - place;  // of the rod beside the axis
            across.z() = 0.0;
            const bool pushes_back = rod.constraint_force(0, c).dot(across) <= 0;
            out.complementary = out.complementary && pushes_back && (N == 0 || gap < 1e-9);
        }
    }
    return out;
}

TEST(Guide, StruckAtTwoMetresASecondPushesAndNeverPulls) {
    const Impact coarse = strike(0.0025), fine = strike(0.000625);
    EXPECT_TRUE(coarse.complementary);
    EXPECT_TRUE(fine.complementary);
    // no more than the damper at first touch and what a rod as heavy as a guide's spacing can do to
    // the spring: v (c + sqrt(k m))
    const double bound = 2.0 * (2e5 + std::sqrt(2e7 * 40 * (337 + 1025 * 0.1295)));
    EXPECT_GT(fine.peak, 2.0 * 2e5);
    EXPECT_LT(fine.peak, bound);
    EXPECT_NEAR(coarse.peak, fine.peak, 0.15 * fine.peak);  // an impact lasts some ten coarse steps
    EXPECT_GT(coarse.deepest, -0.1);
}

TEST(RodPack, ARiserThatFailsLeavesItsNeighboursBitsAlone) {
    Case input = tensioned_riser(true, 0.02);
    for (int i = 1; i < 4; ++i) input.lines.push_back(input.lines[0]);
    for (std::size_t i = 0; i < 4; ++i) {
        input.lines[i].name = "ttr" + std::to_string(i);
        input.lines[i].constraints[0].nominal_tension += 1e5 * static_cast<double>(i);
    }
    // the wellhead of the third, which is purely elastic, runs away: its stretch law ends at twice
    // the length (R:6)
    input.line_types.push_back(input.line_types[0]);
    input.line_types[1].damping_ratio.reset();
    for (Section& section : input.lines[2].sections) section.type = 1;
    input.lines[2].end_b.motion =
        EndMotion{.amplitude = {4e3, 0, 0}, .period = {40, 1, 1}, .phase = Vec3::Zero()};
    input.analysis.dynamics.ramp = 1.0;
    const Sea sea = still_sea(input);
    const auto pose = [](double t) {
        PlatformMotion m;
        m.position.x() = 1.0 - std::cos(0.5 * t), m.velocity.x() = 0.5 * std::sin(0.5 * t);
        return m;
    };
    RodPack<Quad> all(input, sea, {0, 1, 2, 3}), rest(input, sea, {0, 1, 3});
    ASSERT_TRUE(all.equilibrium({}, false).ok());
    ASSERT_TRUE(rest.equilibrium({}, false).ok());
    Status status;
    double t = 0.0;
    for (; t < 15 && status.ok(); t += 0.5) {
        const MotionSpline platform(t, pose(t), t + 0.5, pose(t + 0.5));
        ASSERT_TRUE(rest.pass(t, t + 0.5, platform).ok());
        status = all.pass(t, t + 0.5, platform);
        if (!status.ok()) break;
        all.keep(), rest.keep();
    }
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.line, 2);
    EXPECT_GT(status.t, t);
    EXPECT_LE(status.t, t + 0.5);
    EXPECT_GE(status.arc_length, 0.0);
    EXPECT_LE(status.arc_length, 1521.1);
    const auto& a = all.state().block();
    const auto& b = rest.state().block();
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [i, k] : {std::pair{0, 0}, std::pair{1, 1}, std::pair{3, 2}}) {
        std::size_t different = 0;
        for (std::size_t n = 0; n < a.size(); ++n) {
            const double x = a[n][i], y = b[n][k];
            different += std::memcmp(&x, &y, sizeof x) != 0;
        }
        EXPECT_EQ(different, 0U) << "line " << i;
    }
}

}  // namespace
}  // namespace hawser::worker
