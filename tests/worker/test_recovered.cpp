// Recovered quantities of rods against closed forms and published figures (validation rows A4, A5,
// A22, A22a, A23).
#include <gtest/gtest.h>

#include <cmath>

#include "rod/recovered.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;
using Q = LineQuantity;

template <class V>
double value(const Recovered<V>& at, Q q, int lane = 0) {
    return LaneTraits<V>::get(at[index_of(q)], lane);
}

LineType pipe(double outer, double wall, double mass, double EI) {
    LineType type =
        plain_type(mass, 2.07e11 * M_PI / 4 * (outer * outer - std::pow(outer - 2 * wall, 2)), EI);
    type.category = "pipe";
    type.outer_diameter = outer;
    type.wall = PipeWall{.outer_diameter = outer, .inner_diameter = outer - 2 * wall};
    return type;
}

StressSection<Single> single(const StressSection<double>& s) {
    return {s.area,          s.inner_radius,  s.outer_radius,
            s.second_moment, s.concentration, s.contents_weight,
            s.yield,         s.breaking_load, s.no_wall};
}

StressSection<Single> section_of(const LineType& type) {
    const Case input = one_line(type, 10, 1, fixed_at({0, 0, 0}), LineEnd{});
    return single(stress_section(input, input.lines[0], 5.0, true));
}

TEST(PipeStress, AgreesWithTheReferenceWall) {  // validation row A23
    const StressSection<Single> s = section_of(pipe(0.324, 0.020, 200, 4.6e7));
    struct Row {
        double p_i, p_o, moment, wall, von_mises;
    };
    for (const Row row :
         {Row{0, 0, 50e3, 500e3, 62.728e6}, Row{20e6, 15.1e6, 50e3, 521.98e3, 68.783e6},
          Row{0, 15.1e6, 50e3, -744.96e3, 127.018e6}, Row{0, 0, 0, 500e3, 26.177e6}}) {
        const Single wall = wall_force<Single>(s, 500e3, row.p_i, row.p_o);
        EXPECT_NEAR(wall[0], row.wall, 1e-4 * std::abs(row.wall));
        const Stresses<Single> got = stresses<Single>(s, wall, row.moment, row.p_i, row.p_o);
        EXPECT_NEAR(got.von_mises[0], row.von_mises, 1e-4 * row.von_mises) << row.p_o;
    }
}

TEST(PipeStress, OfAThinTubeUnderPressureAloneIsTheBoilerFormula) {
    // sig_h = p r/t and half of it along the axis of a closed end: sqrt(3)/2 p r/t
    const double r = 0.5, t = 0.0005, p = 1e5;
    const StressSection<Single> s = section_of(pipe(2 * r + t, t, 100, 1e6));
    const double closed_end =
        p * M_PI * std::pow(r - t / 2, 2);  // wall force, no effective tension
    const double got = stresses<Single>(s, closed_end, 0.0, p, 0.0).von_mises[0];
    EXPECT_NEAR(got, std::sqrt(3.0) / 2 * p * r / t, 2e-3 * got);  // t/r = 1e-3
}

TEST(PipeStress, CorrosionTakesFromTheInsideAndConcentrationRaisesAxialAndBending) {
    LineType type = pipe(0.324, 0.020, 200, 4.6e7);
    type.wall->thickness_factor = 0.5;
    type.wall->concentration = 1.3;
    const StressSection<Single> s = section_of(type);
    EXPECT_DOUBLE_EQ(s.outer_radius[0], 0.162);
    EXPECT_NEAR(s.inner_radius[0], 0.152, 1e-12);
    const double A = M_PI * (0.162 * 0.162 - 0.152 * 0.152),
                 I = M_PI / 4 * (std::pow(0.162, 4) - std::pow(0.152, 4));
    const Stresses<Single> got = stresses<Single>(s, 500e3, 50e3, 0.0, 0.0);
    EXPECT_NEAR(got.axial[0], 1.3 * 500e3 / A, 1.0);
    EXPECT_NEAR(got.bending[0], 1.3 * 50e3 * 0.162 / I, 1.0);
    EXPECT_NEAR(got.von_mises[0], got.axial[0] + got.bending[0], 1.0);
}

TEST(PipeStress, SectionOfATaperRunsInBothDiametersAndInWhatGoesWithThem) {
    LineType foot = pipe(0.324, 0.020, 200, 4.6e7), top = pipe(0.5, 0.040, 200, 4.6e7);
    top.wall->thickness_factor = 0.8, foot.wall->thickness_factor = 0.9;
    top.wall->concentration = 1.1, foot.wall->concentration = 1.5;
    top.wall->contents_density = 800, foot.wall->contents_density = 1000;
    Case input = one_line(top, 40, 4, fixed_at({0, 0, 0}), LineEnd{});
    input.line_types.push_back(foot);
    input.lines[0].sections = {{.type = 0, .length = 10, .elements = 1},
                               {.type = 0, .length = 40, .elements = 4, .type_at_end = 1}};
    const StressSection<double> s = stress_section(input, input.lines[0], 20.0, true);
    // a quarter down the taper: 456 mm outside, 386 mm inside, of 35 mm the part 0.825 is left
    const double outer = 0.228, inner = outer - 0.825 * 0.035;
    EXPECT_NEAR(s.outer_radius, outer, 1e-12);
    EXPECT_NEAR(s.inner_radius, inner, 1e-12);
    EXPECT_NEAR(s.area, M_PI * (outer * outer - inner * inner), 1e-12);
    EXPECT_NEAR(s.second_moment, M_PI / 4 * (std::pow(outer, 4) - std::pow(inner, 4)), 1e-14);
    EXPECT_NEAR(s.concentration, 1.2, 1e-12);
    EXPECT_NEAR(s.contents_weight, 850 * input.environment.water.gravity, 1e-9);
}

TEST(Recovered, HangingPipeFullOfSeaCarriesItsSteelLessThePressureOnItsEnd) {
    // Open at both ends, top at the surface: the wall force at a height is the weight of the steel
    // below less what the water at the bottom pushes up on the ring: w l - p_bottom A_s.
    const double L = 200, D = 0.3, t = 0.02, g = 9.80665, rho = 1025;
    const double inner = D - 2 * t, area = M_PI / 4 * (D * D - inner * inner);
    const double steel = 7850 * area;
    LineType type = pipe(D, t, steel + rho * M_PI / 4 * inner * inner, 0.0);
    type.displaced_area = M_PI / 4 * D * D;
    type.wall->contents_density = rho;
    Case input = one_line(type, L, 10, fixed_at({0, 0, 0}), LineEnd{}, 1000);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const double bottom = rho * g * L * area;
    for (int n = 1; n <= 10; ++n) {  // the node at the surface feels the smeared waterline
        const double below = L * (10 - n) / 10;
        const double expected = steel * g * below - bottom;
        EXPECT_NEAR(value(recovery.node(n), Q::wall_tension), expected, 1e-3 * bottom) << n;
        EXPECT_NEAR(value(recovery.node(n), Q::axial_stress), expected / area,
                    1e-3 * bottom / area);
    }
}

TEST(Recovered, ChainAndRopeCarryTheirTensionOnTheirNominalArea) {
    for (const auto& [category, area] :
         {std::pair{"chain", 2 * M_PI / 4 * 0.01}, std::pair{"rope", M_PI / 4 * 0.01}}) {
        LineType type = plain_type(100, 1e9);
        type.category = category;
        type.section_area = area;
        type.breaking_load = 1e6;
        Case input = one_line(type, 100, 5, fixed_at({0, 0, -10}), LineEnd{}, 1000);
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        Recovery<Single> recovery(input, rod);
        recovery.recover(rod);
        const auto& top = recovery.node(0);
        const double T = 100 * 100 * 9.80665;
        EXPECT_NEAR(value(top, Q::von_mises_stress), T / area, 1e-6 * T / area);
        EXPECT_NEAR(value(top, Q::axial_stress), T / area, 1e-6 * T / area);
        EXPECT_EQ(value(top, Q::bending_stress), 0.0);
        EXPECT_NEAR(value(top, Q::load_utilisation), T / 1e6, 1e-6);
        EXPECT_TRUE(std::isnan(value(top, Q::wall_tension)));
        EXPECT_TRUE(std::isnan(value(top, Q::yield_utilisation)));
    }
}

TEST(Recovered, CantileverElasticaHasTheMomentAndShearOfItsDeadLoad) {  // validation row A4
    // M(s) = P (x_tip - x(s)), shear P cos(theta), T = P sin(theta)
    const double L = 10.0, EI = 1e6, P = 5 * EI / (L * L);
    LineEnd a = fixed_at({0, 0, 1000}, Joint::clamped);
    a.direction = Vec3(1, 0, 0);
    Case input = one_line(plain_type(1e-9, 1e11, EI), L, 16, a, LineEnd{});
    input.lines[0].attachments = {{.arc_length = L, .mass = P / 9.80665}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 16; n >= 0; --n)
        nodes.push_back({.position = {L * n / 16, 0, 1000}, .tangent = {-1, 0, 0}, .tension = 1.0});
    rod.set_guess(0, nodes);
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const double root = P * 0.61237 * L;                                      // of the table
    EXPECT_NEAR(value(recovery.node(0), Q::bend_moment), root, 0.01 * root);  // end: O(h^2), 1 %
    for (int n = 1; n < 16; ++n) {
        const auto& at = recovery.node(n);
        const double arm = value(recovery.node(16), Q::x) - value(at, Q::x);
        const double theta = M_PI / 180 * (90 - value(at, Q::declination));  // below the horizontal
        EXPECT_NEAR(value(at, Q::bend_moment), P * arm, 8e-4 * root) << n;
        EXPECT_NEAR(value(at, Q::curvature), P * arm / EI, 8e-4 * root / EI) << n;
        EXPECT_NEAR(value(at, Q::shear_force), P * std::cos(theta), 0.01 * P) << n;
        // F.t of R:47, with the B kappa^2 that lambda lacks: right as the tangent is, O(h^4)
        EXPECT_NEAR(value(at, Q::effective_tension), P * std::sin(theta), 1e-6 * P) << n;
    }
}

TEST(Recovered, HorizontalPipeClampedAtOneEndSagsAndShearsUnderItsWeight) {
    // w L^4/(8 EI) and w L; the sag of 0.44 m in 20 m is linear to 1e-3
    const double EI = 2.8288e7, w = 522.0, L = 20.0;
    LineEnd a = fixed_at({0, 0, 100}, Joint::clamped);
    a.direction = Vec3(1, 0, 0);
    for (const int elements : {5, 20}) {
        const Case input =
            one_line(plain_type(w / 9.80665, 2.8e9, EI), L, elements, a, LineEnd{}, 300);
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        EXPECT_NEAR(rod.node_position(0, elements).z() - 100.0, -w * L * L * L * L / (8 * EI),
                    5e-3 * w * L * L * L * L / (8 * EI));
        Recovery<Quad> recovery(input, rod);
        recovery.recover(rod);
        EXPECT_NEAR(value(recovery.node(0), Q::shear_force), w * L, 2e-3 * w * L);
        EXPECT_NEAR(value(recovery.node(elements), Q::shear_force), 0.0, 2e-3 * w * L);
        const Recovered<Single> near = recovery.at(rod, recovery.place(input, rod, 0, 0.1));
        EXPECT_NEAR(value(near, Q::shear_force), w * (L - 0.1), 2e-3 * w * L);
    }
}

TEST(Recovered, ChainAtAPointLoadHasTheForceOfBothLegs) {  // R:50
    // A chain with a clump that draws it down steeply: legs of one horizontal force
    LineType chain = plain_type(40.0, 2e8);
    Case input = one_line(chain, 60, 30, fixed_at({0, 0, 0}), fixed_at({50, 0, 0}));
    input.lines[0].attachments = {{.arc_length = 30, .mass = 3000}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const double H = std::abs(rod.force_on_support_a(0).x()), w = 40 * 9.80665;
    const double V = 0.5 * (60 * w + 3000 * 9.80665);  // at both ends
    for (int n = 1; n < 30; ++n) {
        const double s = 2.0 * n;
        const double vertical = n < 15 ? V - w * s : V - w * (60 - s);
        const double T = std::hypot(H, vertical);
        EXPECT_NEAR(value(recovery.node(n), Q::effective_tension), T, 2e-3 * T) << n;
        const double angle = 180 / M_PI * std::atan2(H, vertical);
        EXPECT_NEAR(value(recovery.node(n), Q::declination), n < 15 ? angle : 180 - angle, 1.0)
            << n;
        const Recovered<Single> at = recovery.at(rod, recovery.place(input, rod, 0, s));
        EXPECT_NEAR(value(at, Q::effective_tension), value(recovery.node(n), Q::effective_tension),
                    1e-9 * T);
    }
}

TEST(Recovered, RiserBendsAtTouchdownAsTheBoundaryValueSolution) {  // validation row A22a
    const double w = 1418.83, EI = 4.58729e7, suspended = 1658.198;
    LineType type = pipe(0.324, 0.020, w / 9.80665, EI);
    type.EA = 1e12, type.displaced_area = 0.0;
    Case input = one_line(type, suspended + 500, 1, fixed_at({0, 0, -165}),
                          anchored_at({799.142 + 500, 0, -1500}), 1500);
    input.environment.seabed.depth += 0.162;  // the bed of the reference is under the centre line
    input.lines[0].sections = {{.type = 0, .length = 1458.198, .elements = 40},
                               {.type = 0, .length = 300, .elements = 60},  // 5 m about touchdown
                               {.type = 0, .length = 400, .elements = 16}};
    input.environment.seabed.normal_stiffness = 1e8;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Single> recovery(input, rod);
    recovery.recover(rod);
    double largest = 0.0, stress = 0.0, at = 0.0;
    for (double s = 1500; s < 1750; s += 0.5) {
        const Recovered<Single> here = recovery.at(rod, recovery.place(input, rod, 0, s));
        if (value(here, Q::bend_moment) <= largest) continue;
        largest = value(here, Q::bend_moment), stress = value(here, Q::bending_stress), at = s;
    }
    EXPECT_NEAR(largest, 128.30e3, 0.005 * 128.30e3);  // row allows 2 %
    EXPECT_NEAR(stress, 93.79e6, 0.005 * 93.79e6);
    EXPECT_NEAR(at, suspended - 49.2, 5.0);
    const Grounding bed = recovery.grounding(rod, 0);
    // it sinks in by 0.8 mm, so that it meets the bed where a rigid one is still that far below
    EXPECT_NEAR(bed.touchdown, suspended, 4.0);
    EXPECT_NEAR(bed.grounded, 500.0, 4.0);
    EXPECT_NEAR(bed.position.x(), 799.142, 4.0);
    // far out on the bed: weight on soil, per length
    const auto& lying = recovery.node(110);
    EXPECT_NEAR(value(lying, Q::seabed_force), w, 1e-3 * w);
    EXPECT_NEAR(value(lying, Q::declination), 90.0, 0.01);
    EXPECT_EQ(value(recovery.node(10), Q::seabed_force), 0.0);
}

TEST(Recovered, PlacesAndNodesAreOneContinuousCurve) {
    LineType type = pipe(0.324, 0.020, 150, 4.58729e7);
    type.wall->contents_density = 800;
    Case input = one_line(type, 1800, 30, fixed_at({0, 0, -20}), anchored_at({1250, 0, -900}), 900);
    input.lines[0].internal_pressure = 5e6;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    const LineMesh mesh = mesh_of(input.lines[0]);
    for (int n = 0; n <= 30; ++n) {
        const double s = mesh.arc_length[static_cast<std::size_t>(n)];
        const Recovered<Single> at = recovery.at(rod, recovery.place(input, rod, 0, s));
        for (const Q q : {Q::effective_tension, Q::wall_tension, Q::curvature, Q::shear_force,
                          Q::von_mises_stress, Q::declination, Q::x, Q::z, Q::seabed_force}) {
            const double node = value(recovery.node(n), q);
            EXPECT_NEAR(value(at, q), node, 1e-9 * std::abs(node) + 1e-9) << n << words_of(q).name;
        }
        if (n == 0 || n == 30) continue;
        for (const double step : {-1e-4, 1e-4}) {
            const Recovered<Single> near =
                recovery.at(rod, recovery.place(input, rod, 0, s + step));
            const double node = value(recovery.node(n), Q::von_mises_stress);
            EXPECT_NEAR(value(near, Q::von_mises_stress), node, 1e-4 * node) << n;
        }
    }
}

TEST(Recovered, TouchdownMovesSteadilyWithTheTop) {
    // The top is drawn away in steps of 5 cm: the touchdown moves by dx_td/dX of each step, never
    // by the 12 m between Gauss points of elements of 40 m.
    double before = 0.0, least = 1e9, greatest = 0.0;
    for (int k = 0; k <= 60; ++k) {
        LineType type = plain_type(120, 1e10, 1e6);
        Case input = one_line(type, 1600, 40, fixed_at({-0.05 * k, 0, 0}),
                              anchored_at({1250, 0, -600}), 600);
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << k;
        const double s = Recovery<Single>(input, rod).grounding(rod, 0).touchdown;
        if (k > 0) least = std::min(least, s - before), greatest = std::max(greatest, s - before);
        before = s;
    }
    EXPECT_GT(least, 0.0);
    EXPECT_LT(greatest, 1.0);
}

TEST(Recovered, StressWhereSectionsMeetIsTheLargerOne) {
    LineType thick = pipe(0.4, 0.04, 200, 1e8), thin = pipe(0.4, 0.01, 200, 1e8);
    Case input = one_line(thick, 100, 1, fixed_at({0, 0, 100}), LineEnd{});
    input.line_types.push_back(thin);
    for (const bool thin_first : {false, true}) {
        input.lines[0].sections = {{.type = thin_first ? 1 : 0, .length = 50, .elements = 4},
                                   {.type = thin_first ? 0 : 1, .length = 50, .elements = 4}};
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        Recovery<Quad> recovery(input, rod);
        recovery.recover(rod);
        const double T = 200 * 50 * 9.80665, area = M_PI / 4 * (0.16 - 0.38 * 0.38);
        EXPECT_NEAR(value(recovery.node(4), Q::von_mises_stress), T / area, 1e-7 * T / area);
    }
}

}  // namespace
}  // namespace hawser::worker
