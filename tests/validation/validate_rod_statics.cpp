// Validation rows A1b, A1c, A3, A3b, A4, A5, A7, A22a: rods and catenaries at rest, through the
// kernel, where a case file cannot set the problem up (moments and free ends without weight) or
// does not print the number (stiffness of a mooring, curvature).
#include <gtest/gtest.h>

#include <cmath>

#include "line_mesh.hpp"
#include "rod/catenary.hpp"
#include "validation/row.hpp"
#include "worker/rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Straight start from the root at A along u, for rods that no catenary describes.
std::vector<CatenaryNode> straight(const Vec3& root, const Vec3& u, double length, int elements,
                                   double tension) {
    std::vector<CatenaryNode> nodes;
    for (int n = elements; n >= 0; --n)
        nodes.push_back(
            {.position = root + u * length * n / elements, .tangent = -u, .tension = tension});
    return nodes;
}

TEST(ValidationA1, ElasticCatenaryOfTheCatenarySolver) {  // MoorPy test_catenary
    const auto line = [](double w) {
        return std::vector<CatenaryElement>(
            40, {.length = 12.5, .EA = 7.51e12, .weight_wet = w, .weight_dry = w});
    };
    const Catenary lying = solve_catenary(line(800), {400, 0, -200}, {0, 0, 0}, true);
    validate({"A1", "catenary solver: H [N]", 96643.428, lying.horizontal, 1e-4});
    validate({"A1", "catenary solver: V at the top [N]", 237751.755, lying.vertical_a, 1e-4});
    validate({"A1", "catenary solver: length on the bed [m]", 202.8103, lying.grounded, 1e-4});
    const Catenary rubbing = solve_catenary(line(800), {400, 0, -200}, {0, 0, 0}, true, 0.1);
    validate({"A1b", "catenary solver, friction 0.1: tension at the anchor [N]", 80418.60,
              rubbing.nodes.front().tension, 1e-4});
    validate({"A1b", "catenary solver, friction 0.1: H at the top [N]", 96643.428,
              rubbing.horizontal, 1e-4});
    const Catenary held = solve_catenary(line(800), {400, 0, -200}, {0, 0, 0}, true, 5.0);
    validate({"A1b", "catenary solver, friction 5: tension at the anchor [N]", 0.0,
              held.nodes.front().tension, 1e-9, false});
    const Catenary clear = solve_catenary(line(200), {400, 0, -200}, {0, 0, 0}, false);
    validate({"A1c", "catenary solver: H [N]", 43694.58, clear.horizontal, 1e-4});
    validate({"A1c", "catenary solver: V at the top [N]", 77634.40, clear.vertical_a, 1e-4});
    const CatenaryNode& anchor = clear.nodes.front();
    validate({"A1c", "catenary solver: V at the anchor, down [N]", 22365.60,
              -anchor.tension * anchor.tangent.z(), 1e-4});
}

/// Sum of the lines' static stiffness about the origin and of their loads, platform at rest.
struct MooringStiffness {
    Mat6 K = Mat6::Zero();
    Vec6 load = Vec6::Zero();
    double top = 0.0, anchor = 0.0;
};

/// Three chains of one kind: from a fairlead radius and height to anchors on the bed.
struct ThreeLines {
    double depth, anchor_radius, fairlead_radius, fairlead_z, length, diameter, mass, EA;
    double weight;  ///< submerged [N/m]
    double first_heading;
    double touchdown;  ///< arc length about which the mesh is fine [m]
};

MooringStiffness mooring(const ThreeLines& of) {
    LineType type = plain_type(of.mass, of.EA);
    type.displaced_area = (of.mass - of.weight / 9.80665) / 1025;
    type.outer_diameter = 0.0;  // the sources let the chain's axis lie on the bed
    MooringStiffness sum;
    for (int i = 0; i < 3; ++i) {
        const double heading = of.first_heading + 2 * M_PI * i / 3;
        const Vec3 u(std::cos(heading), std::sin(heading), 0);
        LineEnd a;
        a.kind = EndKind::platform;
        a.position = of.fairlead_radius * u + Vec3(0, 0, of.fairlead_z);
        Case input = one_line(type, of.length, 1, a,
                              anchored_at(of.anchor_radius * u - Vec3(0, 0, of.depth)), of.depth);
        // The bed takes up the line element by element: for the stiffness of a catenary the
        // elements about touchdown must be short.
        input.lines[0].sections = {
            {.type = 0, .length = of.touchdown - 75, .elements = 20},
            {.type = 0, .length = 150, .elements = 50},
            {.type = 0, .length = of.length - of.touchdown - 75, .elements = 20}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        EXPECT_TRUE(rod.equilibrium({}, false).ok());
        sum.K += rod.stiffness(0, Vec3::Zero());
        sum.load += rod.wrench(0, Vec3::Zero());
        sum.top = rod.tension_a(0), sum.anchor = rod.tension_b(0);
    }
    return sum;
}

TEST(ValidationA3, MooringOfOC3) {  // NREL/TP-500-47535; stiffness worked out by MoorPy
    const MooringStiffness m = mooring({.depth = 320,
                                        .anchor_radius = 853.87,
                                        .fairlead_radius = 5.2,
                                        .fairlead_z = -70,
                                        .length = 902.2,
                                        .diameter = 0.09,
                                        .mass = 77.7066,
                                        .EA = 384.243e6,
                                        .weight = 698.094,
                                        .first_heading = 0,
                                        .touchdown = 767});
    validate({"A3", "fairlead tension [N]", 911.09e3, m.top, 5e-3});
    validate({"A3", "anchor tension [N]", 736.94e3, m.anchor, 5e-3});
    validate({"A3", "Fz [N]", -1.6072e6, m.load[2], 5e-3});
    validate({"A3", "K11 [N/m]", 41181, m.K(0, 0), 5e-3});
    validate({"A3", "K33 [N/m]", 11941, m.K(2, 2), 5e-3});
    validate({"A3", "K15 [N]", -2.8154e6, m.K(0, 4), 5e-3});
    validate({"A3", "K55 [N.m]", 3.108e8, m.K(4, 4), 5e-3});
    validate({"A3", "K66 [N.m]", 1.1567e7, m.K(5, 5), 5e-3});
}

TEST(ValidationA3b, MooringOfVolturnUS) {  // NREL/TP-5000-76773; MoorPy
    const MooringStiffness m = mooring({.depth = 200,
                                        .anchor_radius = 837.6,
                                        .fairlead_radius = 58,
                                        .fairlead_z = -14,
                                        .length = 850,
                                        .diameter = 0.333,
                                        .mass = 685,
                                        .EA = 3.27e9,
                                        .weight = 5842.1223,
                                        .first_heading = M_PI,
                                        .touchdown = 347});
    validate({"A3b", "fairlead tension [N]", 2435.6e3, m.top, 5e-3});
    validate({"A3b", "anchor tension [N]", 1349.6e3, m.anchor, 5e-3});
    validate({"A3b", "K11 [N/m]", 71892, m.K(0, 0), 5e-3});
    validate({"A3b", "K33 [N/m]", 60743, m.K(2, 2), 5e-3});
    validate({"A3b", "K15 [N]", 1.1447e6, m.K(0, 4), 5e-3});
    validate({"A3b", "K55 [N.m]", 2.5859e8, m.K(4, 4), 5e-3});
    validate({"A3b", "K66 [N.m]", 2.5229e8, m.K(5, 5), 5e-3});
}

TEST(ValidationA4, CantileverElastica) {  // Bisshopp & Drucker 1945; Mattiasson 1981
    struct Row {
        double load, x, w, angle;
        const char *x_is, *w_is, *angle_is;
    };
    constexpr int elements = 8;
    const double L = 10.0, EI = 1e6;
    for (const Row row : {Row{1, .94357, .30172, .46135, "x_tip/L, PL2/EI 1", "w/L, PL2/EI 1",
                              "tip angle, PL2/EI 1 [rad]"},
                          Row{2, .83936, .49346, .78175, "x_tip/L, PL2/EI 2", "w/L, PL2/EI 2",
                              "tip angle, PL2/EI 2 [rad]"},
                          Row{5, .61237, .71379, 1.21537, "x_tip/L, PL2/EI 5", "w/L, PL2/EI 5",
                              "tip angle, PL2/EI 5 [rad]"},
                          Row{10, .44500, .81061, 1.43029, "x_tip/L, PL2/EI 10", "w/L, PL2/EI 10",
                              "tip angle, PL2/EI 10 [rad]"}}) {
        LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped);
        a.direction = Vec3(1, 0, 0);
        Case input = one_line(plain_type(1e-9, 1e11, EI), L, elements, a, LineEnd{});
        input.lines[0].attachments = {{.arc_length = L, .mass = row.load * EI / (L * L) / 9.80665}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        rod.set_guess(0, straight({0, 0, 1000}, {1, 0, 0}, L, elements, 1.0));
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << row.load;
        const Vec3 tip = rod.node_position(0, elements) - Vec3(0, 0, 1000);
        const Vec3 u = rod.direction_b(0);
        validate({"A4", row.x_is, row.x, tip.x() / L, 1e-3});
        validate({"A4", row.w_is, row.w, -tip.z() / L, 1e-3});
        validate({"A4", row.angle_is, row.angle, std::atan2(-u.z(), u.x()), 1e-3});
    }
}

/// Largest curvature of a single rod |r''| [1/m] and its arc length from end A [m], at the two
/// Gauss points of each element where a cubic's second derivative is best.
struct Bend {
    double curvature = 0.0, at = 0.0;
};
Bend largest_bend(const RodPack<Single>& rod, const Line& line) {
    const LineMesh mesh = mesh_of(line);
    const NodeState<Single>* node = rod.kept().nodes();
    Bend out;
    double s = line.length();
    for (int e = 0; e < rod.elements(); ++e) {  // from end B
        const auto far = static_cast<std::size_t>(rod.elements() - e);
        const double L = mesh.arc_length[far] - mesh.arc_length[far - 1];
        for (const double x : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
            const auto c = reduced_curvature(x);
            const Vec3 q0 = vec(node[e + 1].r) - vec(node[e].r);
            const Vec3 bend =
                (c[0] * q0 + c[1] * L * vec(node[e].d) + c[2] * L * vec(node[e + 1].d)) / (L * L);
            if (bend.norm() > out.curvature) out = {bend.norm(), s - x * L};
        }
        s -= L;
    }
    return out;
}

TEST(ValidationA5, EndMomentClosesTheRodToACircle) {
    // Both ends clamped along x at one point: the rod that closes carries M = 2 pi EI/L and no
    // force
    const double L = 10.0, EI = 1e6, radius = L / (2 * M_PI);
    LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped), b;
    a.direction = Vec3(1, 0, 0);
    b = a;
    Case input = one_line(plain_type(1e-9, 1e11, EI), L, 16, a, b);
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
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
    double out_of_round = 0.0;
    for (int n = 0; n <= 16; ++n)
        out_of_round = std::max(
            out_of_round,
            std::abs((rod.node_position(0, n) - Vec3(0, 0, 1000 - radius)).norm() - radius) / L);
    validate({"A5", "largest distance from the circle, over L", 0, out_of_round, 1e-3, false});
    validate(
        {"A5", "end moment over EI/L", 2 * M_PI, rod.moment_on_support_a(0).norm() * L / EI, 1e-2});
    validate({"A5", "largest curvature times L", 2 * M_PI,
              largest_bend(rod, input.lines[0]).curvature * L, 1e-2});
}

TEST(ValidationA7, BeamsOfSmallDeflection) {  // 10 m, EI 1e7 N m2, 100 kg/m
    const double L = 10, EI = 1e7, m = 100, w = m * 9.80665;
    {
        // pinned at both ends: EA so low that the stretch of 4e-6 pulls with less than 1e-4 of pi2
        // EI/L2
        Case input =
            one_line(plain_type(m, 1e7, EI), L, 16, fixed_at({0, 0, 1000}), fixed_at({L, 0, 1000}));
        input.environment.water.density = 1e-9;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        rod.set_guess(0, straight({0, 0, 1000}, {1, 0, 0}, L, 16, 1.0));
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        validate({"A7", "simply supported beam, middle [mm]", 5e3 * w * std::pow(L, 4) / (384 * EI),
                  1e3 * (1000 - rod.node_position(0, 8).z()), 1e-3});
    }
    LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped);
    a.direction = Vec3(1, 0, 0);
    Case input = one_line(plain_type(m, 1e10, EI), L, 16, a, LineEnd{});
    input.environment.water.density = 1e-9;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    rod.set_guess(0, straight({0, 0, 1000}, {1, 0, 0}, L, 16, 1.0));
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    validate({"A7", "cantilever, tip [mm]", 1e3 * w * std::pow(L, 4) / (8 * EI),
              1e3 * (1000 - rod.node_position(0, 16).z()), 1e-3});
}

TEST(ValidationA22a, RiserBendsAtTouchdown) {
    // Boundary-value solution of the inextensible bar on a rigid flat bed, pinned at the top
    const double w = 1418.83, EI = 4.58729e7, suspended = 1658.198;
    LineType type = plain_type(w / 9.80665, 1e12, EI);
    type.outer_diameter = 0.0;
    Case input = one_line(type, suspended + 500, 1, fixed_at({0, 0, -165}),
                          anchored_at({799.142 + 500, 0, -1500}), 1500);
    input.lines[0].sections = {{.type = 0, .length = 1458.198, .elements = 40},
                               {.type = 0, .length = 300, .elements = 60},
                               {.type = 0, .length = 400, .elements = 16}};
    input.environment.seabed.normal_stiffness = 1e6;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const Bend bend = largest_bend(rod, input.lines[0]);
    const Vec3 u = rod.direction_a(0);
    validate({"A22a", "tension at the top [N]", 2391.33e3, rod.tension_a(0), 1e-3});
    validate({"A22a", "top angle from vertical [deg]", 12.0315,
              std::atan2(u.x(), -u.z()) * 180 / M_PI, 0.05, false});
    validate({"A22a", "largest moment [N.m]", 128.30e3, bend.curvature * EI, 2e-2});
    validate({"A22a", "largest bending stress at the outer wall [Pa]", 93.79e6,
              2.07e11 * 0.162 * bend.curvature, 2e-2});
    validate({"A22a", "its distance from touchdown [m]", 49.2, suspended - bend.at, 8.0, false});
}

}  // namespace
}  // namespace hawser::worker
