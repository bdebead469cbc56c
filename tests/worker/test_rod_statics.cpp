// Statics of rods against closed forms and published tables (validation rows A1, A2, A4, A5).
#include <gtest/gtest.h>

#include <cmath>

#include "rod/catenary.hpp"
#include "rod_cases.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

TEST(Catenary, AgreesWithThePublishedAnchorLine) {  // validation row A1: x, z, L, EA, w = 400, 200,
                                                    // 500, 7.51e12, 800
    std::vector<CatenaryElement> elements(
        40, {.length = 12.5, .EA = 7.51e12, .weight_wet = 800, .weight_dry = 800});
    const Catenary c = solve_catenary(elements, {400, 0, -200}, {0, 0, 0}, true);
    ASSERT_TRUE(c.found);
    EXPECT_NEAR(c.horizontal, 96643.428, 96643.428 * 1e-4);
    EXPECT_NEAR(c.vertical_a, 237751.755, 237751.755 * 1e-4);
    EXPECT_NEAR(c.grounded, 202.8103, 0.02);
}

TEST(Catenary, AgreesWithThePublishedLineClearOfTheBed) {  // validation row A1c, w = 200
    std::vector<CatenaryElement> elements(
        40, {.length = 12.5, .EA = 7.51e12, .weight_wet = 200, .weight_dry = 200});
    const Catenary c = solve_catenary(elements, {400, 0, -200}, {0, 0, 0}, false);
    ASSERT_TRUE(c.found);
    EXPECT_NEAR(c.horizontal, 43694.58, 43694.58 * 1e-4);
    EXPECT_NEAR(c.vertical_a, 77634.40, 77634.40 * 1e-4);
}

TEST(Catenary, FrictionOfTheBedStretchesTheLineLess) {
    // x = L_B + (H/w) asinh(V/H) + H L/EA + C w/(2 EA) [-L_B^2 + (L_B - H/(C w)) max(L_B - H/(C w),
    // 0)]
    const double w = 800, L = 500, EA = 2e7;
    for (const double C : {0.2, 3.0}) {
        std::vector<CatenaryElement> elements(
            40, {.length = 12.5, .EA = EA, .weight_wet = w, .weight_dry = w});
        const Catenary c = solve_catenary(elements, {400, 0, -200}, {0, 0, 0}, true, C);
        ASSERT_TRUE(c.found);
        const double H = c.horizontal, V = c.vertical_a, LB = L - V / w, free = LB - H / (C * w);
        EXPECT_NEAR(LB, c.grounded, 1e-6 * L);
        const double x = LB + H / w * std::asinh(V / H) + H * L / EA +
                         C * w / (2 * EA) * (-LB * LB + free * std::max(free, 0.0));
        EXPECT_NEAR(x, 400, 1e-8 * 400) << C;
        EXPECT_NEAR(c.nodes.front().tension, std::max(H - C * w * LB, 0.0), 1e-6 * H) << C;
    }
}

TEST(RodStatics, SettlesOnTheAnchorLineOfThePublishedCatenary) {  // validation row A1, bar 0.1 %
                                                                  // with 40 elements
    LineType type = plain_type(800 / 9.80665, 7.51e12);
    type.outer_diameter = 0.0;
    Case input = one_line(type, 500, 40, fixed_at({0, 0, 0}), anchored_at({400, 0, -200}), 200);
    input.environment.seabed.normal_stiffness = 1e6;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const Vec3 f = rod.force_on_support_a(0);
    EXPECT_NEAR(f.x(), 96643.428, 96643.428 * 1e-3);
    EXPECT_NEAR(-f.z(), 237751.755, 237751.755 * 1e-3);
}

/// Reference line of validation row A2: chain 122 m, polyester 2286 m, chain 91 m, no bed contact.
Case reference_line(double span) {
    LineType chain = plain_type(588.7, 3.07119e9), rope = plain_type(66.0, 7.0632e8);
    chain.displaced_area = M_PI / 4 * 0.3096 * 0.3096;
    rope.displaced_area = M_PI / 4 * 0.2474 * 0.2474;
    Case input = one_line(chain, 91, 4, fixed_at({0, 0, -50}), fixed_at({span, 0, -1500}), 3000);
    input.line_types.push_back(rope);
    input.lines[0].sections = {{.type = 0, .length = 91, .elements = 4},
                               {.type = 1, .length = 2286, .elements = 32},
                               {.type = 0, .length = 122, .elements = 6}};
    return input;
}

TEST(RodStatics, ThreePartLineAgreesWithTheClosedForm) {  // validation row A2, tolerance 0.05 %
    struct Row {
        double X, H, V_top, T_top, T_anchor;
    };
    const std::vector<Row> rows = {{2025, 1188.4693, 1515.3168, 1925.7841, 1190.6384},
                                   {2040, 2026.9211, 2100.6325, 2919.0865, 2130.7883},
                                   {2060, 5144.7188, 4276.9648, 6690.3333, 5873.3949},
                                   {2080, 9113.4862, 7007.5611, 11496.1535, 10677.7634}};
    for (const Row& row : rows) {
        const Case input = reference_line(row.X);
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << row.X;
        const Vec3 f = rod.force_on_support_a(0);
        EXPECT_NEAR(f.x(), row.H * 1e3, row.H * 0.5) << row.X;
        EXPECT_NEAR(-f.z(), row.V_top * 1e3, row.V_top * 0.5) << row.X;
        EXPECT_NEAR(rod.tension_a(0), row.T_top * 1e3, row.T_top * 0.5) << row.X;
        EXPECT_NEAR(rod.tension_b(0), row.T_anchor * 1e3, row.T_anchor * 0.5) << row.X;
    }
}

TEST(RodStatics, ElasticCatenaryConvergesAndKeepsTheExactStretchLaw) {
    // R:6 at about 1 % and 5 % strain against Irvine's closed form; 16 elements leave less than
    // 1e-7
    for (const double EA : {7.06e8, 1.5e8}) {
        Case input = one_line(plain_type(200 / 9.80665, EA), 2286, 16, fixed_at({0, 0, 0}),
                              fixed_at({1900, 0, -1300}));
        input.environment.water.density = 0.0;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        std::vector<CatenaryElement> elements(
            1, {.length = 2286, .EA = EA, .weight_wet = 200, .weight_dry = 200});
        const Catenary c = solve_catenary(elements, {1900, 0, -1300}, {0, 0, 0}, false);
        const double T = std::hypot(c.horizontal, c.vertical_a);
        EXPECT_NEAR(rod.tension_a(0), T, 1e-7 * T) << EA;
    }
}

/// Straight start from the root at A: direction u, all slopes along it.
std::vector<CatenaryNode> straight(const Vec3& root, const Vec3& u, double length, int elements,
                                   double tension) {
    std::vector<CatenaryNode> nodes;
    for (int n = elements; n >= 0; --n)
        nodes.push_back(
            {.position = root + u * length * n / elements, .tangent = -u, .tension = tension});
    return nodes;
}

TEST(RodStatics, CantileverElasticaReachesTheTabulatedTip) {  // validation row A4
    struct Row {
        double load, x, w;
    };
    for (const Row row : {Row{1, .94357, .30172}, Row{2, .83936, .49346}, Row{5, .61237, .71379},
                          Row{10, .44500, .81061}}) {
        // Root clamped at end A, a point mass at the free end B; the rod's own weight is negligible
        const double L = 10.0, EI = 1e6;
        LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped);
        a.direction = Vec3(1, 0, 0);
        Case input = one_line(plain_type(1e-9, 1e11, EI), L, 16, a, LineEnd{});
        input.lines[0].attachments = {{.arc_length = L, .mass = row.load * EI / (L * L) / 9.80665}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        rod.set_guess(0, straight({0, 0, 1000}, {1, 0, 0}, L, 16, 1.0));
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << row.load;
        const Vec3 tip = rod.node_position(0, 16) - Vec3(0, 0, 1000);
        EXPECT_NEAR(tip.x() / L, row.x, 2e-5) << row.load;  // mesh 1e-5, table five digits
        EXPECT_NEAR(-tip.z() / L, row.w, 2e-5) << row.load;
    }
}

TEST(RodStatics, EndMomentClosesTheRodToACircle) {  // validation row A5, 16 elements
    const double L = 10.0, EI = 1e6, radius = L / (2 * M_PI);
    LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped), b = a;
    a.direction = b.direction = Vec3(1, 0, 0);
    Case input = one_line(plain_type(1e-9, 1e11, EI), L, 16, a, b);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 16; n >= 0; --n) {  // an oval to start from
        const double p = 2 * M_PI * n / 16;
        nodes.push_back({.position = Vec3(0.8 * radius * std::sin(p), 0,
                                          1000 - 1.2 * radius * (1 - std::cos(p))),
                         .tangent = -Vec3(0.8 * std::cos(p), 0, -1.2 * std::sin(p)).normalized(),
                         .tension = -EI / radius / radius});
    }
    rod.set_guess(0, nodes);
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_NEAR((rod.node_position(0, 8) - Vec3(0, 0, 1000 - 2 * radius)).norm() / L, 0, 1e-3);
    EXPECT_NEAR(rod.moment_on_support_a(0).norm(), EI / radius, 0.01 * EI / radius);
    EXPECT_NEAR(rod.force_on_support_a(0).norm(), 0, 0.01 * EI / radius / radius);
}

TEST(RodStatics, LeavesTheCompressedStraightRodForTheHangingOne) {
    // Newton converges to the straight rod squeezed by 15 %: an equilibrium nobody wants. The
    // catenary of 100 m over 85 m is 23.17 m deep: c (cosh x - 1), x = 42.5/c, sinh(x)/x = 100/85.
    Case input =
        one_line(plain_type(10, 1e8), 100, 10, fixed_at({0, 0, -50}), fixed_at({85, 0, -50}));
    input.environment.water.gravity = 1e-9;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    rod.set_guess(0, straight({0, 0, -50}, {1, 0, 0}, 85, 10, -1.5e7));
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_NEAR(rod.node_position(0, 5).z(), -50 - 23.17, 0.05);  // mesh of 10
    EXPECT_GT(rod.tension_a(0), 0.0);
}

TEST(RodStatics, StandsCompressionUpToItsEulerLoad) {
    // pinned at both ends, weightless: straight below pi^2 EI/L^2, bent beyond it
    const double L = 100, EI = 1e7, EA = 1e8, euler = M_PI * M_PI * EI / L / L;
    for (const double part : {0.5, 0.9, 1.5}) {
        Case input = one_line(plain_type(10, EA, EI), L, 10, fixed_at({0, 0, -50}),
                              fixed_at({L * (1 - part * euler / EA), 0, -50}));
        input.environment.water.gravity = 1e-9;
        input.environment.water.density = 0.0;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        rod.set_guess(
            0, straight({0, 0, -50}, {1, 0, 0}, L * (1 - part * euler / EA), 10, -part * euler));
        const Status status = rod.equilibrium({}, false);
        const double bow = std::abs(rod.node_position(0, 5).z() + 50);
        if (part < 1.0) {
            ASSERT_TRUE(status.ok()) << part;
            EXPECT_NEAR(rod.tension_a(0), -part * euler, 1e-3 * euler) << part;
            EXPECT_LT(bow, 1e-6) << part;
        } else if (status.ok()) {  // whatever is given out, the straight rod is not
            EXPECT_GT(bow, 0.1);
        } else {
            EXPECT_EQ(status.code, Status::Code::false_equilibrium);
        }
    }
}

}  // namespace
}  // namespace hawser::worker
