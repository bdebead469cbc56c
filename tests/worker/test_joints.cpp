// Rods held by joints and lying on the bed, at rest: flex joint R:31, spring, seabed R:33, steel
// catenary riser (validation rows A22, A22a), point masses.
#include <gtest/gtest.h>

#include <cmath>

#include "constraint/point_laws.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

TEST(FlexJoint, TurnsUntilItsMomentCarriesTheTipLoad) {  // R:31: kt theta = W L cos(theta)
    const double L = 10, EI = 1e10, kt = 2e6, g = 9.80665;
    for (const double W : {1e4, 1e5, 5e5}) {
        LineEnd a = fixed_at({0, 0, 1000}, Joint::flex);
        a.rotational_stiffness = kt;
        a.direction = Vec3(1, 0, 0);
        Case input = one_line(plain_type(1e-6, 1e12, EI), L, 8, a, LineEnd{});
        input.lines[0].attachments = {{.arc_length = L, .mass = W / g}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        std::vector<CatenaryNode> nodes;
        for (int n = 8; n >= 0; --n)
            nodes.push_back(
                {.position = Vec3(L * n / 8, 0, 1000), .tangent = -Vec3::UnitX(), .tension = 1.0});
        rod.set_guess(0, nodes);
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << W;
        double theta = 0.0;
        for (int i = 0; i < 100; ++i)
            theta -= (kt * theta - W * L * std::cos(theta)) / (kt + W * L * std::sin(theta));
        const Vec3 u = rod.direction_a(0);
        // bending of the rod itself: W L^2/(2 EI) is below 3e-3 of the angle's work
        EXPECT_NEAR(std::atan2(-u.z(), u.x()), theta, 3e-3 * theta) << W;
        EXPECT_NEAR(rod.moment_on_support_a(0).y(), kt * std::atan2(-u.z(), u.x()), 1e-6 * W * L);
        const Vec3 tip = rod.node_position(0, 8);
        EXPECT_NEAR(rod.moment_on_support_a(0).y(), W * tip.x(), 1e-6 * W * L) << W;
        EXPECT_NEAR(rod.force_on_support_a(0).z(), -W, 1e-4 * W) << W;
    }
}

TEST(FlexJoint, StandsAlongTheStaticTangentUnlessToldOtherwise) {
    LineEnd a = fixed_at({10, 0, -20}, Joint::flex);
    a.kind = EndKind::platform;
    a.rotational_stiffness = 5e5;
    Case input = one_line(plain_type(100, 1e9, 1e7), 1000, 40, a, anchored_at({600, 0, -700}), 700);
    input.lines[0].sections = {{.type = 0, .length = 1000, .elements = 40, .growth = 1.05}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_LT(rod.moment_on_support_a(0).norm(), 1e-3);
    const Vec3 u = rod.direction_a(0);
    PlatformMotion offset;
    offset.position.x() = -8.0;
    offset.angles.y() = 0.02;
    ASSERT_TRUE(rod.equilibrium(offset, false).ok());
    const Vec3 axis = rotation(offset.angles) * u;
    const double theta = std::acos(std::min(1.0, axis.dot(rod.direction_a(0))));
    EXPECT_GT(theta, 0.01);
    EXPECT_NEAR(rod.moment_on_support_a(0).norm(), 5e5 * theta, 1e-4 * 5e5 * theta);
}

TEST(Clamp, HoldsTheDirectionOfTheRod) {
    LineEnd a = fixed_at({0, 0, -20}, Joint::clamped);
    a.direction = Vec3(0.3, 0, -1).normalized();
    Case input = one_line(plain_type(100, 1e9, 1e7), 1000, 80, a, anchored_at({600, 0, -700}), 700);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    // 1000 times stiffer than the element it holds
    EXPECT_LT((rod.direction_a(0) - *a.direction).norm(), 2e-3);
    EXPECT_GT(rod.moment_on_support_a(0).norm(), 1e3);
}

TEST(Clamp, CarriesTheMomentOfARodThatIsShaken) {  // m L^2/2 a
    // A stiff rod hangs clamped under a hull that surges: its first bending mode is 1 s, the hull's
    // period 20 s. Force m L a, moment m L^2/2 a about its end, and the lever of the end about O.
    const double L = 10, m = 100, w = 2 * M_PI / 20, A = 3;
    LineEnd a;
    a.kind = EndKind::platform, a.joint = Joint::clamped;
    a.position = {0, 0, -5}, a.direction = Vec3(0, 0, -1);
    Case input = one_line(plain_type(m, 1e9, 1e9), L, 4, a, LineEnd{});
    input.environment.water.density = 0.0;
    input.analysis.dynamics.line_step = 0.02;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const auto hull = [&](double t) {
        PlatformMotion at;  // starts at rest, its acceleration without a jump
        at.position.x() = A * (w * t - std::sin(w * t));
        at.velocity.x() = A * w * (1 - std::cos(w * t));
        return at;
    };
    for (int k = 0; k < 80; ++k) {
        const double t0 = 0.25 * k, t1 = t0 + 0.25;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, hull(t0), t1, hull(t1))).ok());
        rod.keep();
        const double force = -m * L * A * w * w * std::sin(w * t1);
        const double tip = A * w * w * m * L * L / 2;
        // spline of 0.25 s steps: 1e-3 of the acceleration; the rod's own swing 1e-2
        EXPECT_NEAR(rod.force_on_support_a(0).x(), force, 0.02 * A * w * w * m * L) << t1;
        EXPECT_NEAR(rod.moment_on_support_a(0).y(), -force * L / 2, 0.02 * tip) << t1;
        const Vec6 about_O = rod.wrench(0, hull(t1).position);
        EXPECT_NEAR(about_O[4], -force * (5 + L / 2), 0.02 * 3 * tip) << t1;
    }
}

TEST(Spring, ForceIsMinusTheGradientOfEnergy) {
    const Spring<Single> spring{.stiffness = 3e4, .damping = 0.0, .length = 2.0};
    for (const Vec3& g : {Vec3(1, 2, -1.5), Vec3(0.5, -0.3, 0.4)}) {
        const auto energy = [&](const Vec3& x) {
            return load(spring, lanes_of(x), lanes_of({0, 0, 0}), Single(0.0)).energy[0];
        };
        const Vec3 f = vec(load(spring, lanes_of(g), lanes_of({0, 0, 0}), Single(0.0)).force);
        for (int c = 0; c < 3; ++c) {
            const Vec3 e = 1e-3 * Vec3::Unit(c);
            const double slope =
                (8 * (energy(g + e) - energy(g - e)) - (energy(g + 2 * e) - energy(g - 2 * e))) /
                12e-3;
            EXPECT_NEAR(f[c], -slope, 1e-8 * 3e4) << c;
        }
    }
}

TEST(Spring, ItsDamperTakesEnergyOutAlongTheSpring) {
    const Spring<Single> spring{.stiffness = 0.0, .damping = 50.0, .length = 2.0};
    const Vec3 g(3, 0, 4), rate(0.2, 0.7, 0.1), e(0.6, 0, 0.8);
    const Vec3 f = vec(load(spring, lanes_of(g), lanes_of(rate), Single(0.0)).force);
    EXPECT_LT((f + 50.0 * rate.dot(e) * e).norm(), 1e-10);
    EXPECT_LT(f.dot(rate), 0.0);
}

TEST(Seabed, CarriesALyingLineWithItsSpring) {  // R:33: penetration w/k + d0/2
    const double w = 1000, k = 2e4, D = 0.1, pen = w / k + bed_smoothing / 2, z_bed = -100;
    const double z = z_bed + D / 2 - pen, L = 100, strain = 2e-3;
    LineType type = plain_type(w / 9.80665, 1e8);
    Case input = one_line(type, L, 20, fixed_at({0, 0, z + 0.02}),
                          fixed_at({L * (1 + strain), 0, z - 0.01}), -z_bed);
    input.environment.seabed.normal_stiffness = k;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 20; n >= 0; --n)
        nodes.push_back({.position = Vec3(L * (1 + strain) * n / 20, 0, z + 0.02 - 0.03 * n / 20),
                         .tangent = -Vec3::UnitX(),
                         .tension = 1e8 * strain});
    rod.set_guess(0, nodes);
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    // away from the ends by several sqrt(T/k) = 3 m, where the ends' offset has died out
    for (int n = 9; n <= 11; ++n) EXPECT_NEAR(rod.node_position(0, n).z(), z, 1e-6) << n;
}

TEST(PointMass, HangsAndBobsOnItsLine) {  // period 2 pi sqrt((M + m L/3) L/EA)
    const double L = 50, EA = 1e7, M = 5000, m = 2;
    Case input = one_line(plain_type(m, EA), L, 4, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.density = 0.0;
    input.lines[0].attachments = {{.arc_length = L, .mass = M}};
    const double period = 2 * M_PI * std::sqrt((M + m * L / 3) * L / EA);
    input.analysis.dynamics.line_step = period / 100;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double T = (M + m * L) * 9.80665;
    EXPECT_NEAR(rod.tension_a(0), T, 1e-6 * T);
    for (int n = 0; n <= 4; ++n) {  // set off with 0.1 m/s
        rod.kept().nodes()[n].v = lanes_of({0, 0, -0.1 * (4 - n) / 4.0});
        rod.kept().nodes()[n].vd = lanes_of({0, 0, 0.1 / L});
    }
    Record bob;
    ASSERT_TRUE(run(rod, 5.5 * period, period / 100, [&](double t) {
                    bob.add(t, rod.tension_a(0) - T);
                }).ok());
    EXPECT_NEAR(bob.period(), period,
                2e-3 * period);  // (w h)^2/12 and higher modes of a light line
    EXPECT_NEAR(bob.largest(), 0.1 * std::sqrt(M * EA / L), 0.02 * bob.largest());
}

TEST(PointMass,
     AfloatBobsOnItsWaterplane) {  // a sphere's buoyancy fades over its height d: rho V g/d
    const double L = 8.9, EA = 5e4, M = 800, V = 1, m = 0.01;
    const double d = std::cbrt(6 * V / M_PI), lift = 1025 * 9.80665 * V, k = lift / d + EA / L;
    Case input = one_line(plain_type(m, EA), L, 4, fixed_at({0, 0, 9}), LineEnd{});
    input.line_types[0].outer_diameter = 0.001;
    input.lines[0].attachments = {{.arc_length = L, .mass = M, .volume = V}};
    const double period = 2 * M_PI * std::sqrt(M / k);
    input.analysis.dynamics.line_step = period / 100;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    // half of it is under at z = 0: M g - lift (1/2 - z/d) = (EA/L) (9 - L - z)
    const double z = ((9 - L) * EA / L - M * 9.80665 + 0.5 * lift) / k;
    EXPECT_NEAR(rod.node_position(0, 4).z(), z, 1e-4);
    const double T = rod.tension_a(0);
    for (int n = 0; n <= 4; ++n) {  // set off with 0.1 m/s
        rod.kept().nodes()[n].v = lanes_of({0, 0, -0.1 * (4 - n) / 4.0});
        rod.kept().nodes()[n].vd = lanes_of({0, 0, 0.1 / L});
    }
    Record bob;
    ASSERT_TRUE(run(rod, 5.5 * period, period / 100, [&](double t) {
                    bob.add(t, rod.tension_a(0) - T);
                }).ok());
    EXPECT_NEAR(bob.period(), period, 2e-3 * period);
    // the energy of the start, whole, after five periods
    const double swing = 0.1 * std::sqrt(M / k) * EA / L;
    EXPECT_NEAR(*std::max_element(bob.y.end() - 100, bob.y.end()), swing, 0.02 * swing);
}

TEST(SteelCatenaryRiser, SettlesOnTheCatenary) {  // validation row A22: 0.2 %
    struct Row {
        double H, T, suspended, x;
    };
    const double w = 1418.83;
    for (const Row row : {Row{398.0, 2292.2, 1591.0, 683.5}, Row{497.2, 2391.3, 1648.6, 789.4},
                          Row{661.4, 2555.6, 1739.8, 945.2}}) {
        LineType type = plain_type(w / 9.80665, 1e12);
        type.outer_diameter = 0.0;
        Case input = one_line(type, row.suspended + 500, 100, fixed_at({0, 0, -165}),
                              anchored_at({row.x + 500, 0, -1500}), 1500);
        input.environment.seabed.normal_stiffness = 1e6;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << row.H;
        EXPECT_NEAR(rod.force_on_support_a(0).x(), row.H * 1e3, 2e-3 * row.H * 1e3);
        EXPECT_NEAR(rod.tension_a(0), row.T * 1e3, 2e-3 * row.T * 1e3) << row.H;
    }
}

TEST(SteelCatenaryRiser, BendsAtTouchdownAsTheBoundaryValueSolution) {  // validation row A22a
    const double w = 1418.83, EI = 4.58729e7, suspended = 1658.198;
    LineType type = plain_type(w / 9.80665, 1e12, EI);
    type.outer_diameter = 0.0;
    Case input = one_line(type, suspended + 500, 1, fixed_at({0, 0, -165}),
                          anchored_at({799.142 + 500, 0, -1500}), 1500);
    // 5 m elements about touchdown
    input.lines[0].sections = {{.type = 0, .length = 1458.198, .elements = 40},
                               {.type = 0, .length = 300, .elements = 60},
                               {.type = 0, .length = 400, .elements = 16}};
    input.environment.seabed.normal_stiffness = 1e6;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_NEAR(rod.tension_a(0), 2391.33e3, 1e-3 * 2391.33e3);
    double largest = 0.0, at = 0.0, s = suspended + 500;
    const NodeState<Single>* node = rod.kept().nodes();
    const LineMesh mesh = mesh_of(input.lines[0]);
    for (int e = 0; e < rod.elements(); ++e) {  // from end B
        const auto far = static_cast<std::size_t>(rod.elements() - e);
        const double L = mesh.arc_length[far] - mesh.arc_length[far - 1];
        for (const double x : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
            const auto c = reduced_curvature(x);
            const Vec3 q0 = vec(node[e + 1].r) - vec(node[e].r);
            const Vec3 bend =
                (c[0] * q0 + c[1] * L * vec(node[e].d) + c[2] * L * vec(node[e + 1].d)) / (L * L);
            if (bend.norm() > largest) largest = bend.norm(), at = s - x * L;
        }
        s -= L;
    }
    EXPECT_NEAR(largest * EI, 128.30e3, 0.02 * 128.30e3);
    EXPECT_NEAR(largest, 0.0027970, 0.02 * 0.0027970);
    EXPECT_NEAR(at, suspended - 49.2, 8.0);  // flat maximum, 5 m elements, a bed that gives way
}

}  // namespace
}  // namespace hawser::worker
