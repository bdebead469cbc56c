// Constraints along a rod in statics: a tensioned riser in its guides, joints, a pull tube.
#include <gtest/gtest.h>

#include <cmath>

#include "rod_cases.hpp"

namespace hawser::worker {
namespace {

using namespace testing;
/// A top-tensioned riser of the truss spar: 406 x 25 mm, tensioner at z = 22 m, guides below the
/// hard tank.
Case riser(double length) {
    LineType pipe = plain_type(337.0, 6.2e9, 1.13e8);
    pipe.displaced_area = M_PI / 4 * 0.406 * 0.406;
    pipe.outer_diameter = pipe.drag_diameter = 0.406;
    pipe.drag_normal = 1.2;
    pipe.added_mass_normal = 1.0;
    LineEnd foot = fixed_at({4.5, 4.5, -1500}, Joint::clamped);
    foot.direction = Vec3(0, 0, -1);
    Case input = one_line(pipe, length, 40, LineEnd{}, foot, 1500);
    input.lines[0].sections = {{.type = 0, .length = 200, .elements = 20},
                               {.type = 0, .length = length - 200, .elements = 30}};
    LineConstraint tensioner{.type = ConstraintType::tensioner,
                             .name = "tensioner",
                             .position = {4.5, 4.5, 22},
                             .arc_length = 0.0,
                             .damping = 2e4,
                             .nominal_tension = 5.338e6,
                             .exponent = 1.1,
                             .gas_column = 40,
                             .stroke_min = -4.5,
                             .stroke_max = 4.5};
    input.lines[0].constraints = {tensioner};
    for (const double z : {-95.0, -115.0, -135.0, -165.0, -173.0})
        input.lines[0].constraints.push_back({.type = ConstraintType::guide,
                                              .name = "guide",
                                              .position = {4.5, 4.5, z},
                                              .arc_length = {},
                                              .stiffness = 2e7,
                                              .damping = 2e5,
                                              .gap = 0.025,
                                              .friction = 0.1});
    return input;
}

TEST(TensionedRiser, HangsInItsTensionerWithTheWeightBelow) {
    const Case input = riser(1521.1);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    // stroke x: the top stands x below its place; the gas law gives the pull there
    const double x = rod.constraint_opening(0, 0), F = 5.338e6 * std::pow(40 / (40 - x), 1.1);
    EXPECT_NEAR(rod.constraint_magnitude(0, 0), F, 1e-6 * F);
    EXPECT_NEAR(rod.node_position(0, 0).z(), 22 - x, 1e-9);
    // weight between top and foot: submerged below z = 0, in air above it, the node's own height
    // apart
    const double wet = 337.0 * 9.80665 - 1025 * 9.80665 * M_PI / 4 * 0.406 * 0.406;
    const double weight = wet * 1521.1 + (22 - x) / 1.0009 * (337.0 * 9.80665 - wet);
    EXPECT_NEAR(rod.tension_b(0), F - weight,
                2e-4 * F);  // cut-off at the surface: a fraction of an element
    EXPECT_NEAR(
        (rod.wrench(0, Vec3::Zero()) - (Vec6() << 0, 0, -F, -4.5 * F, 4.5 * F, 0).finished())
            .norm(),
        0, 1e-6 * F * 5);
}

TEST(TensionedRiser, StiffnessIsTheDerivativeOfItsLoadWithGuidesInContact) {  // R:22, R:24, R:25
    const Case input = riser(1521.1);
    const Sea sea = still_sea(input);
    PlatformMotion at;
    at.position = {25, 3, -0.2};
    at.angles = {0.003, 0.035, 0.01};
    const auto wrench = [&](const PlatformMotion& pose) {
        RodPack<Quad> rod(input, sea, {0});
        EXPECT_TRUE(rod.equilibrium(pose, false).ok());
        return rod.wrench(0, pose.position);
    };
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium(at, false).ok());
    double contact = 0.0;
    for (int c = 1; c < 6; ++c) contact = std::max(contact, rod.constraint_magnitude(0, c));
    EXPECT_GT(contact, 1e4);  // the hull leans on the riser
    const Mat6 S = rod.stiffness(0, at.position);
    const Vec3 w0 = at.angles;
    const Mat3 E = angular_velocity_matrix(w0);
    for (int j = 0; j < 6; ++j) {
        const double h = j < 3 ? 1e-3 : 1e-5;
        PlatformMotion up = at, down = at;
        if (j < 3) {
            up.position[j] += h, down.position[j] -= h;
        } else {
            const Vec3 dq = E.inverse() * (h * Vec3::Unit(j - 3));
            up.angles += dq, down.angles -= dq;
        }
        const Vec6 column = -(wrench(up) - wrench(down)) / (2 * h);
        // The tangent holds the contact points in the rod; heave makes them walk along its slope.
        EXPECT_NEAR((S.col(j) - column).norm() / column.norm(), 0, j == 2 ? 0.25 : 1e-2) << j;
    }
}

TEST(TensionedRiser, ContactWalksFromElementToElementWithoutAJump) {
    Case input = riser(1521.1);
    input.lines[0].sections[0].elements = 60;  // many nodes pass the guides
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    PlatformMotion at;
    at.position = {20, 0, 0};
    ASSERT_TRUE(rod.equilibrium(at, false).ok());
    double last = rod.constraint_magnitude(0, 5), largest_jump = 0.0, element = -1.0;
    int crossings = 0;
    for (int k = 0; k < 100; ++k) {  // heave by 4 m in 50 s, slowly
        const auto pose = [&](double t) {
            PlatformMotion m = at;
            m.position.z() = 2.0 * (1 - std::cos(2 * M_PI * t / 50));
            m.velocity.z() = 2.0 * 2 * M_PI / 50 * std::sin(2 * M_PI * t / 50);
            return m;
        };
        const double t = 0.5 * k;
        ASSERT_TRUE(rod.pass(t, t + 0.5, MotionSpline(t, pose(t), t + 0.5, pose(t + 0.5))).ok());
        rod.keep();
        const double N = rod.constraint_magnitude(0, 5);
        largest_jump = std::max(largest_jump, std::abs(N - last));
        last = N;
        const double e = LaneTraits<Quad>::get(rod.state().constraints()[5].element, 0);
        if (element >= 0.0 && e != element) ++crossings;
        element = e;
    }
    EXPECT_GT(crossings, 1);
    EXPECT_GT(last, 1e3);
    EXPECT_LT(largest_jump, 0.1 * last);
}

/// A beam along x on a pin at end A and a joint 20 m from it, 12 m hanging over: w = 98 N/m.
constexpr double span = 20, over = 12, EI = 1e9, w = 10 * 9.80665;
Case beam(LineConstraint joint) {
    Case input = one_line(plain_type(10, 1e10, EI), span + over, 16, fixed_at({0, 0, 1000}), {});
    joint.on_platform = false;
    joint.position = Vec3(span * (1 + 1e-6), 0, 1000);  // a little tension: 10 kN
    joint.arc_length = span;
    joint.direction = Vec3::UnitX();
    input.lines[0].constraints = {joint};
    return input;
}
/// Moment that the beam gives its joint, about y [N.m].
double moment_on_joint(const LineConstraint& joint) {
    const Case input = beam(joint);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 16; n >= 0; --n)
        nodes.push_back(
            {.position = Vec3(2.0 * n, 0, 1000), .tangent = -Vec3::UnitX(), .tension = 1e4});
    rod.set_guess(0, nodes);
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    // the joint carries the overhang and its part of the span, by moments about the pin
    const double M = -rod.constraint_moment(0, 0).y();
    const double load = (w * (span + over) * (span + over) / 2 - M) / span;
    EXPECT_NEAR(rod.constraint_force(0, 0).z(), load, 2e-3 * load);
    EXPECT_EQ(rod.wrench(0, Vec3::Zero()).norm(), 0.0);  // it stands on the earth
    return M;
}
constexpr double overhang = w * over * over / 2;

TEST(JointAlongTheRod, ClampCarriesTheMomentsOfBothSides) {
    // beam tables: overhang w l^2/2 against the propped span's w a^2/8
    const double M = overhang - w * span * span / 8;
    EXPECT_NEAR(moment_on_joint({.type = ConstraintType::clamp, .name = "clamp"}), M, 5e-3 * M);
}

TEST(JointAlongTheRod, BallJointCarriesNoMoment) {
    EXPECT_EQ(moment_on_joint({.type = ConstraintType::ball_joint, .name = "tie"}), 0.0);
}

TEST(JointAlongTheRod, FlexJointTurnsAgainstItsStiffnessOrTable) {
    // slope of the span at the joint: EI theta = (overhang - M) a/3 - w a^3/24
    const auto moment_at_angle = [](double kt, double M0) {  // M = M0 + kt theta
        const double free = (overhang - M0) * span / 3 - w * span * span * span / 24;
        return M0 + kt * free / (EI + kt * span / 3);
    };
    LineConstraint joint{.type = ConstraintType::flex_joint, .name = "flex"};
    joint.rotational_stiffness = 1e8;
    const double M = moment_at_angle(1e8, 0);
    EXPECT_NEAR(moment_on_joint(joint), M, 5e-3 * M);
    joint.rotational_curve = {{0, 0}, {4e-6, 400}, {1, 400 + 5e7 * (1 - 4e-6)}};
    const double bent = moment_at_angle(5e7, 400 - 5e7 * 4e-6);  // on its second piece
    EXPECT_GT(bent, 400);
    EXPECT_NEAR(moment_on_joint(joint), bent, 5e-3 * bent);
}

/// A chain from the platform, tied off 60 m along it, 40 m hanging free below.
Case tied_chain() {
    LineEnd top = fixed_at({0, 0, 0});
    top.kind = EndKind::platform;
    Case input = one_line(plain_type(100, 1e9), 100, 50, top, {});
    input.environment.water.density = 0.0;
    input.lines[0].constraints = {{.type = ConstraintType::ball_joint,
                                   .name = "tie_off",
                                   .position = {30, 0, -50},
                                   .arc_length = 60.0}};
    return input;
}

TEST(JointAlongTheRod, TieOffCarriesTwoCatenaries) {
    const Case input = tied_chain();
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());  // from a chain that hangs straight down
    const double weight = 100 * 9.80665;
    const std::vector<CatenaryElement> piece(
        60, {.length = 1, .EA = 1e9, .weight_wet = weight, .weight_dry = weight});
    const Catenary upper = solve_catenary(piece, {30, 0, -50}, {0, 0, 0}, false);
    ASSERT_TRUE(upper.found);
    const CatenaryNode& low = upper.nodes.front();
    const Vec3 load = low.tension * low.tangent.normalized() - Vec3(0, 0, 40 * weight);
    // 2 m elements of a chain without stiffness against 1 m pieces
    EXPECT_LT((rod.constraint_force(0, 0) + load).norm(), 5e-3 * load.norm());
    EXPECT_LT(rod.constraint_opening(0, 0), 1e-3);
    const Vec6 all = rod.wrench(0, Vec3::Zero());
    EXPECT_NEAR(all[2], -100 * weight, 1e-6 * 100 * weight);
    EXPECT_LT(std::abs(all[0]), 1e-6 * 100 * weight);
    const Vec3 lever = Vec3(30, 0, -50).cross(-rod.constraint_force(0, 0));
    EXPECT_NEAR(all[4], lever.y(), 1e-4 * std::abs(lever.y()));
}

TEST(JointAlongTheRod, StiffnessIsTheDerivativeOfItsLoad) {  // R:21, R:22 for point and slope
    Case input = tied_chain();
    input.line_types[0].EI = 1e6;
    for (const auto type :
         {ConstraintType::ball_joint, ConstraintType::flex_joint, ConstraintType::clamp}) {
        input.lines[0].end_b = fixed_at({70, 5, -20});
        input.lines[0].constraints[0].type = type;
        input.lines[0].constraints[0].position = {40, 0, -10};
        input.lines[0].constraints[0].rotational_stiffness = 1e5;
        const Sea sea = still_sea(input);
        PlatformMotion base;
        base.position = {0.5, 0.3, -0.2};
        const auto wrench = [&](const PlatformMotion& pose) {
            RodPack<Quad> rod(input, sea, {0});
            EXPECT_TRUE(rod.equilibrium(pose, false).ok());
            return rod.wrench(0, pose.position);
        };
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium(base, false).ok());
        const Mat6 S = rod.stiffness(0, base.position);
        for (int j = 0; j < 6; ++j) {
            const double h = j < 3 ? 1e-3 : 1e-5;
            PlatformMotion up = base, down = base;
            if (j < 3)
                up.position[j] += h, down.position[j] -= h;
            else
                up.angles[j - 3] += h, down.angles[j - 3] -= h;
            const Vec6 column = -(wrench(up) - wrench(down)) / (2 * h);
            // differences of solutions found to 1e-9 m over 1e-3 m
            EXPECT_NEAR((S.col(j) - column).norm() / column.norm(), 0, 1e-5)
                << static_cast<int>(type) << " " << j;
        }
    }
}

TEST(JointAlongTheRod, WithoutAnArcLengthIsAsStiffAsWithTheOneThatPassesThere) {
    // the upper half is stiff, the end B of the other half is not
    LineType stiff = plain_type(1, 1e7, 5e7), soft = plain_type(1, 1e7, 1e5);
    Case input = one_line(stiff, 50, 20, fixed_at({0, 0, 0}), fixed_at({0, 0, -100.1}));
    input.environment.water.density = 0.0, input.environment.water.gravity = 1e-9;
    input.line_types.push_back(soft);
    input.lines[0].sections.push_back({.type = 1, .length = 50, .elements = 20});
    LineConstraint joint{.type = ConstraintType::clamp, .name = "clamp", .on_platform = false};
    joint.position = {0.005, 0, -21.3213};
    joint.direction = Vec3(0, 0, -1);
    input.lines[0].constraints = {joint};
    Case told = input;
    told.lines[0].constraints[0].arc_length = 21.3;
    const Sea sea = still_sea(input);
    RodPack<Quad> found(input, sea, {0}), given(told, sea, {0});
    ASSERT_TRUE(found.equilibrium({}, false).ok());
    ASSERT_TRUE(given.equilibrium({}, false).ok());
    // drawn aside by 5 mm; a spring of the soft element would give way nine times as far
    EXPECT_NEAR(found.constraint_opening(0, 0), given.constraint_opening(0, 0),
                0.05 * given.constraint_opening(0, 0));
    EXPECT_NEAR(found.constraint_moment(0, 0).norm(), given.constraint_moment(0, 0).norm(),
                0.05 * given.constraint_moment(0, 0).norm() + 100.0);
}

TEST(JointAlongTheRod, GivenByItsHeightSettlesInAnyCurrent) {
    // 280 m of pipe between two ball joints, held a third of the way down: of the drag the middle
    // support takes half of what stands on the string, 140 m, and a little more as the pipe bends
    LineType pipe = plain_type(165.0, 2.78e9, 2.83e7);
    pipe.displaced_area = M_PI / 4 * 0.3 * 0.3;
    pipe.outer_diameter = pipe.drag_diameter = 0.3;
    pipe.drag_normal = 1.2;
    Case input = one_line(pipe, 279.95, 100, fixed_at({0, 0, -10}), fixed_at({0, 0, -290}), 300);
    LineConstraint joint{.name = "joint", .on_platform = false};
    joint.position = {0, 0, -100};
    joint.rotational_stiffness = 1e6;
    for (const auto type :
         {ConstraintType::ball_joint, ConstraintType::flex_joint, ConstraintType::clamp})
        for (const double speed : {0.1, 0.5, 1.0}) {
            joint.type = type;
            input.lines[0].constraints = {joint};
            input.environment.current.emplace();
            input.environment.current->profile = {{.depth = 0, .speed = speed},
                                                  {.depth = 300, .speed = speed}};
            const Sea sea = still_sea(input);
            RodPack<Quad> rod(input, sea, {0});
            ASSERT_TRUE(rod.equilibrium({}, true).ok()) << static_cast<int>(type) << " " << speed;
            const double share = 0.5 * 1025 * 1.2 * 0.3 * speed * speed * 140;
            EXPECT_NEAR(-rod.constraint_force(0, 0).x(), 1.07 * share, 0.05 * share);
            EXPECT_EQ(std::abs(rod.constraint_force(0, 0).z()), 0.0);  // put on where it stands
            EXPECT_NEAR(rod.constraint_point(0, 0).z(), -100.0, 1e-9);
        }
}

TEST(Guide, WithAGapCountsAsClosedForSmallMotion) {  // R:49
    Case open = riser(1521.1), closed = open;
    for (LineConstraint& c : closed.lines[0].constraints)
        if (c.type == ConstraintType::guide) c.type = ConstraintType::slider, c.gap = 0.0;
    const Sea sea = still_sea(open);
    RodPack<Quad> rod(open, sea, {0}), slid(closed, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    ASSERT_TRUE(slid.equilibrium({}, false).ok());
    const Vec3 origin = Vec3::Zero();
    const Mat6 at_rest = rod.stiffness(0, origin);  // that of Newton's iteration stays the true one
    for (const double omega : {0.0, 0.3}) {
        rod.swing(omega), slid.swing(omega);
        const Mat6 S = rod.stiffness(0, origin), K = slid.stiffness(0, origin);
        EXPECT_LT((S - K).norm(), 1e-6 * K.norm()) << omega;
        if (omega == 0.0) {  // without them the riser follows none of the hull's surge
            EXPECT_LT(std::abs(at_rest(0, 0)), 1.0);
            EXPECT_GT(S(0, 0), 1e3);
        }
    }
}

TEST(PullTube, TurnsTheTensionWithItsPath) {
    Case input = one_line(plain_type(1, 1e8), 40, 80, fixed_at({0, 0, 0}), fixed_at({40, 0, 0}));
    input.environment.water.density = input.environment.water.gravity = 0.0;
    LineConstraint tube{.type = ConstraintType::pull_tube, .name = "tube", .on_platform = false};
    tube.stiffness = 1e8;
    tube.path = {{19, 0, 2}, {20, 0, 2.05}, {21, 0, 2}};
    input.lines[0].constraints = {tube};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 80; n >= 0; --n)
        nodes.push_back(
            {.position = Vec3(0.5 * n, 0, 0), .tangent = -Vec3::UnitX(), .tension = 5e5});
    rod.set_guess(0, nodes);
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double pull = 2 * rod.tension_a(0) * std::sin(std::atan2(2.0, 19.0));
    EXPECT_GT(rod.tension_a(0), 4e5);
    EXPECT_NEAR(rod.constraint_force(0, 0).z(), pull, 0.01 * pull);
    EXPECT_LT(std::abs(rod.constraint_force(0, 0).x()), 0.01 * pull);  // no friction in statics
    EXPECT_LT(rod.constraint_magnitude(0, 0), 0.9 * pull);             // more than one point
}

TEST(Slider, WithAGapIsACentralizer) {
    Case input = riser(1521.1);
    LineConstraint& last = input.lines[0].constraints[5];
    last.friction = 0.0;
    PlatformMotion at;
    at.position = {20, 0, 0};
    const auto force = [&] {
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        EXPECT_TRUE(rod.equilibrium(at, false).ok());
        return rod.constraint_force(0, 5);
    };
    const Vec3 guide = force();
    last.type = ConstraintType::slider;
    EXPECT_GT(guide.norm(), 1e3);
    EXPECT_LT((force() - guide).norm(), 1e-6 * guide.norm());
    last.gap = 0.0;  // held in both senses and nowhere loose
    EXPECT_GT((force() - guide).norm(), 1e-3 * guide.norm());
}

TEST(Template, OnTheSeaFloorLoadsTheRodAndNotThePlatform) {
    Case input = riser(1521.1);
    LineConstraint conductor = input.lines[0].constraints[5];
    conductor.name = "conductor", conductor.on_platform = false;
    conductor.position = {4.9, 4.5, -1490};
    input.lines[0].constraints.push_back(conductor);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_GT(rod.constraint_force(0, 6).x(), 1e4);
    double on_platform = 0.0;
    for (int c = 0; c < 6; ++c) on_platform -= rod.constraint_force(0, c).x();
    EXPECT_NEAR(rod.wrench(0, Vec3::Zero())[0], on_platform, 1.0);
}

TEST(Constraints, OfOneLineDoNotFeelItsNeighbours) {
    Case input = riser(1521.1);
    input.lines.push_back(riser(1520.0).lines[0]);
    input.lines[1].constraints[0].friction_force = 1e5;
    const Sea sea = still_sea(input);
    RodPack<Quad> both(input, sea, {0, 1}), alone(input, sea, {1});
    PlatformMotion at;
    at.position = {15, 2, 0};
    ASSERT_TRUE(both.equilibrium(at, false).ok());
    ASSERT_TRUE(alone.equilibrium(at, false).ok());
    PlatformMotion moved = at;
    moved.position.x() += 0.4;
    moved.velocity.x() = 1.0;
    const MotionSpline spline(0.0, at, 0.5, moved);
    ASSERT_TRUE(both.pass(0.0, 0.5, spline).ok());
    ASSERT_TRUE(alone.pass(0.0, 0.5, spline).ok());
    const Vec6 a = both.wrench(1, Vec3::Zero()), b = alone.wrench(0, Vec3::Zero());
    for (int i = 0; i < 6; ++i) EXPECT_EQ(a[i], b[i]) << i;
    for (int c = 0; c < 6; ++c)
        EXPECT_EQ(both.constraint_dissipated(1, c), alone.constraint_dissipated(0, c));
}

}  // namespace
}  // namespace hawser::worker
