// The sea floor: friction by spring and slider (R:34), beds that slope (R:33).
#include <gtest/gtest.h>

#include <cmath>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

constexpr double mass = 200.0, weight = mass * 9.80665, diameter = 0.2, length = 4.0;

/// Depth of a rod of this weight per length in the bed, R:33.
double sinkage(const Seabed& bed, double w) {
    return w / bed.normal_stiffness + 0.5 * bed_smoothing;
}

/// A stiff short rod that lies on the bed, dry, both ends free, pointing along `u`.
Case plank(double angle = 0.0, double direction = 0.0) {
    LineType type = plain_type(mass, 1e9, 1e7);
    type.outer_diameter = diameter;
    Case input = one_line(type, length, 2, LineEnd{}, LineEnd{}, 100);
    input.environment.seabed.slope_angle = angle;
    input.environment.seabed.slope_direction = direction;
    input.analysis.dynamics.line_step = 0.05;
    return input;
}
void lay(RodPack<Single>& rod, const Case& input, const Vec3& u) {
    const Seabed& bed = input.environment.seabed;
    const Bed plane = bed_of(bed);
    const double pen = sinkage(bed, weight * plane.normal.z());
    const Vec3 middle = Vec3(0, 0, plane.z) + (0.5 * diameter - pen) * plane.normal;
    std::vector<CatenaryNode> nodes;
    for (int n = 0; n <= 2; ++n)
        nodes.push_back({.position = middle + length * (0.5 * n - 0.5) * u, .tangent = u});
    rod.set_guess(0, nodes);
    for (int i = 0; i < 5; ++i) rod.kept().lambda()[i] = {};
}
Vec3 middle_of(const RodPack<Single>& rod) { return vec(rod.kept().nodes()[1].r); }

TEST(BedFriction, HoldsASteadyLoadForAnHour) {  // R:34, acceptance 16
    Case input = plank();
    const Seabed& bed = input.environment.seabed;
    LineType& type = input.line_types[0];
    type.drag_diameter = 0.2, type.drag_normal = 1.2, type.drag_axial = 1.2;
    for (const bool across : {true, false}) {
        const double mu = across ? bed.friction_lateral : bed.friction_axial;
        const double speed = std::sqrt(0.6 * mu * weight / (0.5 * 1025 * 1.2 * 0.2));
        input.environment.current =
            Current{.heading = 0.3, .profile = {{.depth = 0, .speed = speed}}};
        const Vec3 flow(std::cos(0.3), std::sin(0.3), 0), normal(-std::sin(0.3), std::cos(0.3), 0);
        const Sea sea(input.environment, 60.0, 1.0, true);
        RodPack<Single> rod(input, sea, {0});
        lay(rod, input, across ? normal : flow);
        const Vec3 start = middle_of(rod);
        double furthest = 0.0;
        ASSERT_TRUE(run(rod, 3600, 0.5, [&](double) {
                        furthest = std::max(furthest, (middle_of(rod) - start).dot(flow));
                    }).ok());
        EXPECT_LT(furthest, bed.friction_mobilisation);
        // the spring's own deflection, 0.6 um: the ramp of 60 s is slow against 0.3 s
        EXPECT_NEAR((middle_of(rod) - start).dot(flow), 0.6 * bed.friction_mobilisation,
                    0.01 * bed.friction_mobilisation);
        EXPECT_LT(std::abs((middle_of(rod) - start).dot(normal)), 1e-3 * bed.friction_mobilisation);
    }
}

TEST(BedFriction, SlowCycleDissipatesItsLoop) {  // R:34, acceptance 16: 4 mu N (X - um), 0.5 %
    for (const bool across : {false, true}) {
        Case input = plank();
        const Seabed& bed = input.environment.seabed;
        const double X = 0.8, period = 400.0, um = bed.friction_mobilisation;
        const Vec3 u = across ? Vec3::UnitY() : Vec3::UnitX();
        const double z = -100 + 0.5 * diameter - sinkage(bed, weight);
        for (LineEnd* end : {&input.lines[0].end_a, &input.lines[0].end_b})
            *end = moving(fixed_at({0, 0, z}), {X, 0, 0}, period);
        input.lines[0].end_a.position += 0.5 * length * u;
        input.lines[0].end_b.position -= 0.5 * length * u;
        input.analysis.dynamics.ramp = 0.0;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        lay(rod, input, u);
        double work = 0.0, x_before = 0.0, f_before = 0.0;
        ASSERT_TRUE(run(rod, 1.5 * period, 0.5, [&](double t) {
                        const double x = X * std::sin(2 * M_PI * t / period);
                        const double f =
                            -(rod.force_on_support_a(0) + rod.force_on_support_b(0)).x();
                        if (t > 0.5 * period) work += 0.5 * (f + f_before) * (x - x_before);
                        x_before = x, f_before = f;
                    }).ok());
        const double mu = across ? bed.friction_lateral : bed.friction_axial;
        const double loop = 4 * mu * weight * length * (X - um);
        EXPECT_NEAR(work, loop, 0.005 * loop) << across;
    }
}

TEST(BedFriction, DoesNotActInStatics) {
    // a taut rod across a current that friction could hold: its ends carry all of the drag
    Case input = plank();
    const double z = -100 + 0.5 * diameter - sinkage(input.environment.seabed, weight);
    input.lines[0].end_a = fixed_at({2.001, 0, z}), input.lines[0].end_b = fixed_at({-2.001, 0, z});
    input.line_types[0].drag_diameter = 0.2, input.line_types[0].drag_normal = 1.2;
    input.environment.current = Current{.heading = M_PI / 2, .profile = {{.depth = 0, .speed = 1}}};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    lay(rod, input, Vec3::UnitX());
    for (int i = 0; i < 5; ++i) rod.kept().lambda()[i].now = Single(5e5);
    ASSERT_TRUE(rod.equilibrium({}, true).ok());
    const double drag = 0.5 * 1025 * 1.2 * 0.2 * length;
    EXPECT_NEAR((rod.force_on_support_a(0) + rod.force_on_support_b(0)).y(), drag, 0.001 * drag);
    for (std::size_t g = 0; g < rod.kept().points(); ++g)
        EXPECT_EQ(rod.kept().grips()[g].uphill[0], 0.0);
}

TEST(SlopingBed, HoldsAPlankUpToTheFrictionAngle) {  // R:33, R:34
    for (const double part : {0.45, 1.5}) {          // of the coefficient
        for (const bool across : {false, true}) {
            Case input = plank(0.0, 0.7);
            input.analysis.dynamics.line_step = 0.01;  // a tenth of the time on the spring
            Seabed& bed = input.environment.seabed;
            const double mu = across ? bed.friction_lateral : bed.friction_axial;
            bed.slope_angle = std::atan(part * mu);
            const Bed plane = bed_of(bed);
            const Sea sea = still_sea(input);
            RodPack<Single> rod(input, sea, {0});
            lay(rod, input, across ? plane.level : plane.uphill);
            const Vec3 start = middle_of(rod);
            const double T = 20.0;
            ASSERT_TRUE(run(rod, T, 0.5).ok());
            const Vec3 moved = middle_of(rod) - start;
            if (part < 0.5) {  // the weight comes on at once: twice its static deflection
                EXPECT_LT(moved.norm(), bed.friction_mobilisation);
                EXPECT_GT(-moved.dot(plane.uphill), 0.0);
            } else {
                // on the spring up to um, then under mu N
                const double down = 9.80665 * std::sin(bed.slope_angle),
                             um = bed.friction_mobilisation;
                const double held = mu * 9.80665 * std::cos(bed.slope_angle);
                const double w = std::sqrt(held / um), t1 = std::acos(1 - held / down) / w;
                const double v = std::sqrt((2 * down - held) * um), rest = T - t1;
                const double x = um + v * rest + 0.5 * (down - held) * rest * rest;
                EXPECT_NEAR(-moved.dot(plane.uphill), x, 1e-3 * x);
                EXPECT_NEAR(moved.dot(plane.normal), 0.0, 1e-3);
            }
            EXPECT_NEAR(moved.dot(plane.level), 0.0, 1e-6);
        }
    }
}

TEST(SlopingBed, ChainLyingOnItWithoutFrictionCarriesItsWeightDownhill) {  // R:33
    // T varies by w sin(angle) L
    const double angle = 0.12, direction = 2.1, L = 200.0;
    LineType type = plain_type(mass, 1e9, 1e3);
    type.outer_diameter = diameter;
    Case input = one_line(type, L, 20, LineEnd{}, LineEnd{}, 500);
    Seabed& bed = input.environment.seabed;
    bed.slope_angle = angle, bed.slope_direction = direction;
    const Bed plane = bed_of(bed);
    const double pen = sinkage(bed, weight * std::cos(angle)), stretch = 1 + 3e5 / 1e9;
    const Vec3 u = (plane.uphill + 0.4 * plane.level).normalized();
    const Vec3 b = Vec3(0, 0, plane.z) + (0.5 * diameter - pen) * plane.normal - 80 * u;
    input.lines[0].end_a = fixed_at(b + stretch * L * u), input.lines[0].end_b = fixed_at(b);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 0; n <= 20; ++n)
        nodes.push_back({.position = b + stretch * L * n / 20.0 * u, .tangent = u, .tension = 3e5});
    rod.set_guess(0, nodes);
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double along_line = weight * L * std::sin(angle) * u.dot(plane.uphill);
    EXPECT_GT(rod.tension_b(0), 1e5);
    const Vec3 ends = -rod.force_on_support_a(0) - rod.force_on_support_b(0);
    EXPECT_NEAR(ends.dot(plane.uphill), weight * L * std::sin(angle), 1e-6 * weight * L);
    EXPECT_NEAR(ends.dot(plane.level), 0.0, 1e-6 * weight * L);
    // the line sags sideways, down the slope, by 1.7 m: the tangents at its ends turn by 0.03
    EXPECT_NEAR(-(rod.force_on_support_a(0) + rod.force_on_support_b(0)).dot(u), along_line,
                1e-6 * weight * L);
    EXPECT_NEAR(rod.tension_a(0) - rod.tension_b(0), along_line, 0.002 * along_line);
    for (int n = 1; n < 20; ++n) {
        const Vec3 r = rod.node_position(0, n) - Vec3(0, 0, plane.z);
        EXPECT_NEAR(r.dot(plane.normal), 0.5 * diameter - pen, 0.1 * pen) << n;
    }
}

TEST(SlopingBed, AFlatOneIsASlopeOfNothing) {
    // the general plane and the flat one: same contact
    Case input = plank();
    Bed flat = bed_of(input.environment.seabed), tilted = flat;
    tilted.slopes = true;
    const Vector<Single> r = lanes_of({3, -2, -99.95}), v = lanes_of({0.1, 0.2, -0.3});
    EXPECT_NEAR(height_on_bed(flat, r)[0], height_on_bed(tilted, r)[0], 1e-12);
    EXPECT_EQ(speed_off_bed(flat, v)[0], speed_off_bed(tilted, v)[0]);
}

TEST(BedFriction, ItsTangentIsTheDerivativeOfItsForce) {  // R:34, sticking and slipping
    Case input = plank(0.2, 0.4);
    input.environment.seabed.friction_axial = input.environment.seabed.friction_lateral = 0.4;
    const Bed bed = bed_of(input.environment.seabed);
    const Vector<Single> p = lanes_of({0.8, 0.5, 0.1});
    for (const double reach : {0.3, 2.0}) {
        const Vec3 moved = reach * bed.mobilisation * (0.8 * bed.uphill - 0.6 * bed.level);
        const auto force = [&](const Vec3& x) {
            return vec(
                bed_friction(bed, Single(700.0), p, slide_of(bed, lanes_of(x), Grip<Single>{}))
                    .force);
        };
        const auto S =
            bed_friction(bed, Single(700.0), p, slide_of(bed, lanes_of(moved), Grip<Single>{}))
                .stiffness;
        for (int k = 0; k < 3; ++k) {
            Vec3 dx = Vec3::Zero();
            dx[k] = 1e-6;
            const Vec3 slope = (force(moved + dx) - force(moved - dx)) / 2e-6;
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(-slope[i], S(i, k)[0], 1e-5 * 700 / bed.mobilisation) << reach;
        }
        EXPECT_NEAR(force(moved).norm(), std::min(1.0, reach) * 0.4 * 700, 1e-6);
    }
}

}  // namespace
}  // namespace hawser::worker
