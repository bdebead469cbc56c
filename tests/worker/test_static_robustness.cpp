// Statics where it is hard: failures, risers far off their place, much line on the bed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "guided_riser.hpp"
#include "rod/catenary.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

bool same_bits(const RodState<Quad>& a, const RodState<Quad>& b) {
    return std::memcmp(a.block().data(), b.block().data(), a.block().size() * sizeof(Quad)) == 0;
}

/// The oil riser of the truss spar: 324 x 20 mm, 2400 m, hung off at 172 m of depth.
Case catenary_riser() {
    LineType pipe = plain_type(232.0, 3.95e9, 4.43e7);
    pipe.displaced_area = M_PI / 4 * 0.324 * 0.324;
    pipe.outer_diameter = pipe.drag_diameter = 0.324;
    pipe.drag_normal = 1.2;
    pipe.added_mass_normal = 1.0;
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = {20, 0, -172};
    a.joint = Joint::flex;
    a.rotational_stiffness = 15e3 * 180 / M_PI;
    Case input = one_line(pipe, 2400, 56, a, anchored_at({1517, 0, -1500}), 1500);
    input.lines[0].sections = {{.type = 0, .length = 1250, .elements = 20},
                               {.type = 0, .length = 750, .elements = 30},
                               {.type = 0, .length = 400, .elements = 6}};
    return input;
}

PlatformMotion at(double x, double y = 0.0, double z = 0.0) {
    PlatformMotion pose;
    pose.position = {x, y, z};
    return pose;
}

TEST(StaticFailure, LeavesNoTraceInTheStateNorInWhatIsFoundNext) {
    const Case input = catenary_riser();
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0}), other(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium(at(5), false).ok());
    ASSERT_TRUE(other.equilibrium(at(5), false).ok());
    ASSERT_FALSE(rod.equilibrium(at(-3000), false).ok());  // further than the riser is long
    EXPECT_TRUE(same_bits(rod.kept(), other.kept()));
    EXPECT_EQ(rod.tension_a(0), other.tension_a(0));
    ASSERT_TRUE(rod.equilibrium(at(12, 3), false).ok());
    ASSERT_TRUE(other.equilibrium(at(12, 3), false).ok());
    EXPECT_TRUE(same_bits(rod.kept(), other.kept()));
}

TEST(StaticFailure, OfOneLaneIsNamedAndTheOthersKeepWhatTheyHad) {
    Case input = catenary_riser();
    Line short_one = input.lines[0];
    short_one.end_b.position.x() = 2000;  // 2385 m off: it can follow 60 m, not 200
    input.lines.push_back(short_one);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0, 1});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const RodState<Quad> before = rod.kept();
    const Status status = rod.equilibrium(at(-800), false);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.line, 1);
    EXPECT_TRUE(same_bits(rod.kept(), before));
}

/// Chain of the VolturnUS-S floater, its axis lying on the bed, one of three headings.
Case volturn_chain(double element, int line) {
    LineType type = plain_type(685, 3.27e9);
    type.displaced_area = (685 - 5842.1223 / 9.80665) / 1025;
    type.outer_diameter = 0.0;
    const double heading = M_PI + 2 * M_PI * line / 3;
    const Vec3 u(std::cos(heading), std::sin(heading), 0);
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = 58 * u + Vec3(0, 0, -14);
    return one_line(type, 850, static_cast<int>(std::ceil(850 / element)), a,
                    anchored_at(837.6 * u - Vec3(0, 0, 200)), 200);
}

TEST(MooringChain, IsFoundOnAnyMeshAndAnyBed) {  // validation row A3b
    for (const double bed : {1e5, 1e6, 1e7})
        for (const double element : {3.5, 7.5})
            for (int line = 0; line < 3; ++line) {
                Case input = volturn_chain(element, line);
                input.environment.seabed.normal_stiffness = bed;
                const Sea sea = still_sea(input);
                RodPack<Quad> rod(input, sea, {0});
                ASSERT_TRUE(rod.equilibrium({}, false).ok())
                    << bed << " " << element << " " << line;
                EXPECT_NEAR(rod.tension_a(0), 2435.6e3, 5e-3 * 2435.6e3) << bed << " " << element;
            }
}

TEST(LightLine, LiesDownInTheStream) {
    // 1.6 N/m in water, 17 to 630 N/m of drag across it
    for (const double speed : {0.5, 1.0, 2.0, 3.0}) {
        LineType type = plain_type(10.5, 5e7);
        type.displaced_area = 10.34 / 1025;
        type.outer_diameter = type.drag_diameter = 0.1133;
        type.drag_normal = 1.2;
        Case input = one_line(type, 320, 40, fixed_at({0, 0, -5}), fixed_at({0, 200, -195}), 400);
        input.environment.current.emplace();
        input.environment.current->profile = {{.depth = 0, .speed = speed},
                                              {.depth = 400, .speed = speed}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, true).ok()) << speed;
        // the drag on the whole line is carried by its ends
        const Vec3 pull = rod.force_on_support_a(0) + rod.force_on_support_b(0);
        EXPECT_GT(pull.x(), 0.3 * 0.5 * 1025 * 1.2 * 0.1133 * speed * speed * 320) << speed;
    }
}

/// A pipe held at its top and at a point of the hull, with some length to spare between the two;
/// below it hangs to the bed.
Case tied_off(const Vec3& top, const Vec3& tie, double spare) {
    LineType pipe = plain_type(200, 3.9e9, 2e7);
    pipe.displaced_area = 0.07, pipe.outer_diameter = 0.3;
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = top;
    const double above = (tie - top).norm() + spare;
    Case input = one_line(pipe, above + 550, 160, a, anchored_at({400, 0, -300}), 300);
    LineConstraint joint;
    joint.type = ConstraintType::ball_joint;
    joint.name = "tie";
    joint.position = tie;
    joint.arc_length = above;
    input.lines[0].constraints = {joint};
    return input;
}

TEST(TieOff, HoldsALineThatHasLengthToSpareAboveIt) {
    for (const Vec3& tie : {Vec3(12, 0, -55), Vec3(32, 0, -5)})  // below the top, beside it
        for (const double spare : {0.0, 0.01, 0.1, 0.3, 1.0, 2.0}) {
            const Case input = tied_off({12, 0, -5}, tie, spare);
            const Sea sea = still_sea(input);
            RodPack<Quad> rod(input, sea, {0});
            ASSERT_TRUE(rod.equilibrium({}, false).ok()) << tie.transpose() << " " << spare;
            EXPECT_LT(rod.constraint_opening(0, 0), 0.01) << spare;
            // no longer does the top alone carry the line below: 255 m of its weight
            if (spare >= 0.3) {
                EXPECT_GT(rod.constraint_magnitude(0, 0), 0.5 * 255 * 1258) << spare;
            }
        }
}

/// One leg of elastic catenary by quadrature, from its upper end down: V falls by w per metre, the
/// bed takes what would hang below it.
struct Leg {
    double x = 0.0, z = 0.0, V = 0.0;
};
Leg leg(double H, double V, double w, double EA, double length, bool down_to_the_bed) {
    Leg at{.V = V};
    const int n = 1000;
    const double h = length / n;
    for (int i = 0; i < n; ++i) {
        const double v = std::max(at.V - 0.5 * w * h, down_to_the_bed ? 0.0 : -1e30);
        const double T = std::hypot(H, v);
        at.x += h * (H / T + H / EA), at.z -= h * (v / T + v / EA);
        at.V = std::max(at.V - w * h, down_to_the_bed ? 0.0 : -1e30);
    }
    return at;
}

TEST(Buoy, OfAnyVolumeLiftsItsChainAsTwoCatenariesThatMeet) {
    // 60 m and 120 m of chain from 2 m below the surface to an anchor 150 m off in 50 m of water;
    // the buoy of 1 t at the joint rises with its volume until it floats
    const double w = 369.7, EA = 2.1e8, depth = 50.0, mass = 1000.0;
    LineType chain = plain_type(w / 9.80665, EA);
    chain.outer_diameter = 0.0;
    Case input =
        one_line(chain, 180, 60, fixed_at({0, 0, -2}), anchored_at({150, 0, -depth}), depth);
    input.environment.seabed.normal_stiffness = 1e6;
    for (double volume = 1.0; volume <= 9.0; volume += 0.5) {
        input.lines[0].attachments = {{.arc_length = 60, .mass = mass, .volume = volume}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << volume;
        // H and V at the top so that the anchor is met, by Newton's iteration with differences
        const double height = std::cbrt(6 * volume / M_PI);
        const auto miss = [&](double H, double V) {
            const Leg upper = leg(H, V, w, EA, 60, false);
            const double z = -2 + upper.z;
            const double wet = std::clamp(0.5 - z / height, 0.0, 1.0);
            const double after = upper.V - 9.80665 * (mass - wet * 1025 * volume);
            const Leg lower = leg(H, after, w, EA, 120, true);
            return Eigen::Vector2d(upper.x + lower.x - 150, z + lower.z + depth);
        };
        const Vec3 top = rod.force_on_support_a(0);
        double H = top.x(), V = -top.z();
        for (int i = 0; i < 100; ++i) {
            const Eigen::Vector2d m = miss(H, V);
            Eigen::Matrix2d J;
            J << (miss(H + 1, V) - m), (miss(H, V + 1) - m);
            const Eigen::Vector2d d = J.inverse() * m;
            double part = std::min(1.0, 0.1 * std::hypot(H, V) / d.norm());
            while (part > 1e-4 && miss(H - part * d[0], V - part * d[1]).norm() > m.norm())
                part *= 0.5;
            H -= part * d[0], V -= part * d[1];
        }
        ASSERT_LT(miss(H, V).norm(), 1e-3) << volume;
        // to the penetration of the bed and the kink smeared over an element of 3 m, a tenth of it
        // in place
        EXPECT_NEAR(top.x(), H, 0.015 * std::hypot(H, V)) << volume;
        EXPECT_NEAR(-top.z(), V, 0.015 * std::hypot(H, V)) << volume;
        EXPECT_NEAR(rod.node_position(0, 20).z(), -2 + leg(H, V, w, EA, 60, false).z, 0.3)
            << volume;
    }
}

TEST(CatenaryRiser, WithEightHundredMetresOnTheBedFollowsItsPlatform) {
    const Case input = catenary_riser();
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    const double w = 232.0 * 9.80665 - 1025 * 9.80665 * M_PI / 4 * 0.324 * 0.324;
    const std::vector<CatenaryElement> pipe(
        60, {.length = 40, .EA = 3.95e9, .weight_wet = w, .weight_dry = w});
    for (const double x : {0.0, 60.0, 30.0, -30.0, -60.0}) {  // towards the anchor and away
        ASSERT_TRUE(rod.equilibrium(at(x), false).ok()) << x;
        const Catenary c = solve_catenary(pipe, {1517, 0, -1500 + 0.162}, {20 + x, 0, -172}, true);
        EXPECT_GT(c.grounded, 650.0);
        const double T = std::hypot(c.horizontal, c.vertical_a);
        // bending holds up the sag bend: EI/(T R^2) of the horizontal tension, 1 % of it
        EXPECT_NEAR(rod.tension_a(0), T, 5e-3 * T) << x;
    }
}

TEST(TensionedRiser, StandsAtAnyStrokeAtTheStart) {
    for (const double length : {1518.0, 1519.0, 1520.0, 1521.0, 1522.0, 1523.0, 1524.0}) {
        const Case input = guided_riser(length);  // 1521.1 m is stroke 0
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << length;
        // a longer riser stands higher: a metre less of stroke per metre, less what it stretches
        EXPECT_NEAR(rod.constraint_opening(0, 0), 1521.1 - length, 0.15) << length;
    }
}

TEST(TensionedRiser, FollowsItsPlatformToSixtyMetres) {
    const Case input = guided_riser(1521.1);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    const double dry = 337.0 * 9.80665, wet = dry - 1025 * 9.80665 * M_PI / 4 * 0.406 * 0.406;
    double before = 0.0;
    for (double x = 0.0; x <= 60.0; x += 5.0) {
        ASSERT_TRUE(rod.equilibrium(at(x), false).ok()) << x;
        const double pulls_back = -rod.wrench(0, at(x).position)[0];
        const double F = rod.constraint_magnitude(0, 0);
        if (x > 0.0) {
            EXPECT_GT(pulls_back, before) << x;
            // a string from the keel guide to the foot, h = 1327 m below, its tension growing by
            // the weight w h: x w / ln(T_keel/T_foot); set-down, bending and the gap are 3 %
            const double keel = F - 22 * dry - 173 * wet, foot = keel - 1327 * wet;
            EXPECT_NEAR(pulls_back, x * wet / std::log(keel / foot), 0.03 * pulls_back) << x;
        }
        before = pulls_back;
    }
    RodPack<Quad> at_once(input, sea, {0});  // and at once
    ASSERT_TRUE(at_once.equilibrium(at(60), false).ok());
    EXPECT_NEAR(-at_once.wrench(0, at(60).position)[0], before, 1e-6 * before);
}

}  // namespace
}  // namespace hawser::worker
