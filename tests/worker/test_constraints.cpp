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

}  // namespace
}  // namespace hawser::worker
