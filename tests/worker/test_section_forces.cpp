// Force inside rods by balance, R:47, against closed forms: tension beside jumps of weight, stretch
// and bending stiffness, at point masses and constraints, on the bed, in motion and where a line
// has parted.
#include <gtest/gtest.h>

#include <cmath>

#include "rod/recovered.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;
using Q = LineQuantity;

constexpr double g = 9.80665;

template <class V>
double tension_at(const Recovery<V>& recovery, const RodPack<V>& rod, const Case& input, double s) {
    return recovery.at(rod, recovery.place(input, rod, 0, s))[index_of(Q::effective_tension)][0];
}

TEST(SectionForces, SharesOfTheLoadsGrowFromNoneToAll) {
    for (const double share : shares_above(1.0)) EXPECT_NEAR(share, 0.0, 1e-15);
    for (const double share : shares_above(0.0)) EXPECT_NEAR(share, 1.0, 1e-14);
    for (const double x : {0.1, 0.5, 0.83}) {  // of q = x^3: (1 - x^4)/4
        const auto share = shares_above(x);
        double sum = 0.0;
        for (std::size_t i = 0; i < gauss_points; ++i)
            sum += gauss_weight[i] * share[i] * std::pow(gauss_xi[i], 3);
        EXPECT_NEAR(sum, (1 - std::pow(x, 4)) / 4, 1e-14);
    }
}

TEST(SectionForces, HangingSteppedPipeCarriesTheWeightBelow) {
    // Heavy and stiff beside light and soft, elements of 1.5 m beside one of 50 m: lambda, which
    // is continuous, misses the tension by percents there. Exact to the tolerance of statics.
    LineType light = plain_type(100, 2e8), heavy = plain_type(800, 1e10, 1e7);
    Case input = one_line(light, 1, 1, fixed_at({0, 0, 500}), LineEnd{});
    input.line_types.push_back(heavy);
    input.lines[0].sections = {{.type = 0, .length = 100, .elements = 2},
                               {.type = 1, .length = 6, .elements = 4},
                               {.type = 0, .length = 150, .elements = 3}};
    input.lines[0].attachments = {{.arc_length = 50, .mass = 3000},
                                  {.arc_length = 256, .mass = 5000}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const auto below = [](double s, bool lower) {  // weight under arc length s
        double w = 5000 * g;
        w += 100 * g * std::min(150.0, 256 - s);
        if (s < 106) w += 800 * g * std::min(6.0, 106 - s);
        if (s < 100) w += 100 * g * (100 - s);
        if (s < 50 || (s == 50 && !lower)) w += 3000 * g;
        return w;
    };
    for (double s = 0.5; s < 256; s += 0.5)
        EXPECT_NEAR(tension_at(recovery, rod, input, s), below(s, true), 1e-8 * below(0, false))
            << s;
    const LineMesh mesh = mesh_of(input.lines[0]);
    for (int n = 1; n < mesh.elements(); ++n) {
        const double s = mesh.arc_length[static_cast<std::size_t>(n)];
        EXPECT_NEAR(recovery.tensions(n)[0][0], below(s, true), 1e-8 * below(0, false)) << n;
        EXPECT_NEAR(recovery.tensions(n)[1][0], below(s, false), 1e-8 * below(0, false)) << n;
    }
    EXPECT_NEAR(recovery.node(mesh.elements())[index_of(Q::effective_tension)][0], 5000 * g, 1e-3);
}

TEST(SectionForces, CatenaryOfTwoRopesHasItsHorizontalAndVerticalForce) {
    // T = hypot(H, V(s)): H and V at end A from the reaction, V less the weight passed.
    LineType chain = plain_type(500, 3e9), rope = plain_type(30, 4e8);
    Case input = one_line(chain, 1, 1, fixed_at({0, 0, 0}), fixed_at({900, 0, -300}));
    input.line_types.push_back(rope);
    input.lines[0].sections = {{.type = 0, .length = 100, .elements = 20},
                               {.type = 1, .length = 800, .elements = 16},
                               {.type = 0, .length = 200, .elements = 10}};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Single> recovery(input, rod);
    recovery.recover(rod);
    const Vec3 top = rod.force_on_support_a(0);
    for (double s = 1; s < 1100; s += 7.3) {
        double V = -top.z() - 500 * g * std::min(s, 100.0);
        if (s > 100) V -= 30 * g * std::min(s - 100, 800.0);
        if (s > 900) V -= 500 * g * (s - 900);
        const double T = std::hypot(top.x(), V);
        // the directions of the cubics: a kink of curvature inside 50 m of rope, O(h^4)
        EXPECT_NEAR(tension_at(recovery, rod, input, s), T, 2e-5 * T) << s;
    }
}

TEST(SectionForces, TensionJumpsAtATensionerBetweenNodes) {
    // A riser that sticks out of its tensioner by 3 m: above it its own weight pushes down.
    const double pull = 2e6, w = 300 * g;
    Case input = one_line(plain_type(300, 5e9, 1e7), 303, 1, LineEnd{}, fixed_at({0, 0, -300}));
    input.lines[0].sections = {{.type = 0, .length = 303, .elements = 10}};
    LineConstraint tensioner;
    tensioner.type = ConstraintType::tensioner;
    tensioner.name = "tensioner";
    tensioner.position = {0, 0, 0.1};
    tensioner.on_platform = false;
    tensioner.arc_length = 3.0;
    tensioner.nominal_tension = pull;
    input.lines[0].constraints = {tensioner};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const double force = rod.constraint_magnitude(0, 0);
    for (const double s : {0.0, 1.0, 2.9, 3.1, 10.0, 30.3, 150.0, 303.0}) {
        const double T = (s < 3 ? 0.0 : force) - w * s;
        EXPECT_NEAR(tension_at(recovery, rod, input, s), T, 1e-6 * pull) << s;
    }
}

TEST(SectionForces, AlongTheBedTheWeightIsCarriedAndTheTensionStays) {
    // T on a level bed without friction is H all along; the bed's own load is across the line.
    Case input = one_line(plain_type(150, 1e9), 1500, 30, fixed_at({0, 0, 0}),
                          anchored_at({1350, 0, -300}), 300);
    input.environment.seabed.normal_stiffness = 1e5;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Single> recovery(input, rod);
    recovery.recover(rod);
    const double H = std::abs(rod.force_on_support_a(0).x());
    const double touchdown = recovery.grounding(rod, 0).touchdown;
    ASSERT_LT(touchdown, 1200);
    for (double s = touchdown + 120; s < 1500; s += 11)
        EXPECT_NEAR(tension_at(recovery, rod, input, s), H, 1e-3 * H) << s;
    const double V = -rod.force_on_support_a(0).z();
    for (double s = 0; s < touchdown - 60; s += 17)
        EXPECT_NEAR(tension_at(recovery, rod, input, s), std::hypot(H, V - 150 * g * s), 1e-3 * H)
            << s;
}

TEST(SectionForces, OfAShakenLineAreTheInertiaBelow) {
    // Hung from a top that heaves slowly beside the line's own periods: every part follows, and
    // T(s) = m(s) (g + a) but for the stretch, (w/w1)^2 of the dynamic part.
    LineType light = plain_type(50, 2e9), heavy = plain_type(900, 2e10);
    light.damping_ratio = heavy.damping_ratio = 0.3;  // the start's kink rings away
    const double amplitude = 2.0, period = 8.0, omega = 2 * M_PI / period;
    Case input =
        one_line(light, 1, 1, moving(fixed_at({0, 0, 500}), {0, 0, amplitude}, period), LineEnd{});
    input.line_types.push_back(heavy);
    input.lines[0].sections = {{.type = 0, .length = 120, .elements = 3},
                               {.type = 1, .length = 4, .elements = 4},
                               {.type = 0, .length = 120, .elements = 3}};
    input.lines[0].attachments = {{.arc_length = 244, .mass = 2000}};
    input.analysis.dynamics.line_step = 0.02;
    input.analysis.dynamics.ramp = 8.0;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    const auto mass_below = [](double s) {
        return 2000 + 50 * std::min(120.0, 244 - s) + (s < 124 ? 900 * std::min(4.0, 124 - s) : 0) +
               (s < 120 ? 50 * (120 - s) : 0);
    };
    double worst = 0.0;
    ASSERT_TRUE(run(rod, 40, 0.5, [&](double t) {
                    if (t < 24) return;
                    recovery.recover(rod);
                    const double a = -amplitude * omega * omega * std::sin(omega * t);
                    for (const double s : {1.0, 39.0, 100.0, 119.0, 121.0, 125.0, 140.0, 240.0}) {
                        const double T = mass_below(s) * (g + a);
                        worst =
                            std::max(worst, std::abs(tension_at(recovery, rod, input, s) / T - 1));
                    }
                }).ok());
    EXPECT_LT(worst, 0.01);
}

TEST(SectionForces, BalanceClosesAtTheOtherEndInWavesAndCurrent) {
    // What the loads of the state miss of the two reactions is what one Newton iteration leaves.
    Case input = standing_line(moving(fixed_at({0, 0, -100}), {4, 0, 2}, 12), 1500);
    input.environment.current = Current{};
    input.environment.current->profile = {{.depth = 0.0, .speed = 1.0},
                                          {.depth = 1500, .speed = 0.2}};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, true).ok());
    SectionForces<Single> forces(rod.elements());
    rod.section_forces(forces);
    const double T = rod.tension_a(0);
    EXPECT_LT(vec(forces.gap).norm(), 1e-7 * T);
    ASSERT_TRUE(run(rod, 30, 0.5, [&](double) {
                    rod.section_forces(forces);
                    EXPECT_LT(vec(forces.gap).norm(), 2e-3 * T);
                }).ok());
}

TEST(SectionForces, ALineThatHasPartedCarriesNothingThereAndItsTailsOnEitherSide) {
    Case input = one_line(plain_type(100, 1e9), 200, 20, fixed_at({0, 0, 500}), LineEnd{});
    input.lines[0].fail = LineFailure{.time = 0.01, .arc_length = 100.0};
    input.analysis.dynamics.line_step = 0.02;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Single> recovery(input, rod);
    ASSERT_TRUE(run(rod, 0.5, 0.5).ok());
    recovery.recover(rod);
    // the element above the node at 100 m is gone, the lower part falls: no tension but ringing
    EXPECT_EQ(tension_at(recovery, rod, input, 95.0), 0.0);
    EXPECT_LT(std::abs(tension_at(recovery, rod, input, 150.0)), 0.5 * 50 * 100 * g);
    EXPECT_GT(tension_at(recovery, rod, input, 1.0), 0.0);
}

TEST(SectionForces, NeighboursInThePackDoNotChangeABit) {
    Case input = standing_line(moving(fixed_at({0, 0, -100}), {4, 0, 2}, 12), 1500);
    for (int k = 1; k < 4; ++k) {
        input.lines.push_back(input.lines[0]);
        input.lines.back().end_a.motion->amplitude.x() += 3.0 * k;  // others need more iterations
    }
    const Sea sea = still_sea(input);
    RodPack<Quad> together(input, sea, {0, 1, 2, 3}), alone(input, sea, {0});
    ASSERT_TRUE(together.equilibrium({}, false).ok());
    ASSERT_TRUE(alone.equilibrium({}, false).ok());
    Recovery<Quad> in_pack(input, together), single(input, alone);
    for (int k = 0; k < 10; ++k) {
        ASSERT_TRUE(run(together, 0.5, 0.5).ok());
        ASSERT_TRUE(run(alone, 0.5, 0.5).ok());
    }
    in_pack.recover(together), single.recover(alone);
    for (int n = 0; n <= together.elements(); ++n)
        for (const Q q : {Q::effective_tension, Q::axial_strain, Q::z})
            EXPECT_EQ(in_pack.node(n)[index_of(q)][0], single.node(n)[index_of(q)][0]) << n;
}

}  // namespace
}  // namespace hawser::worker
