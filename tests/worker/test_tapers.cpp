// Tapered sections: properties that run linearly along the arc.
#include <gtest/gtest.h>

#include <cmath>

#include "rod/stress.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

constexpr double L = 100.0, g = 9.80665;

/// Hangs dry from a point; from (m0, EA0) at end A to (m1, EA1) at its free end.
Case hanging_taper(int elements) {
    LineType top = plain_type(300, 4e6), foot = plain_type(100, 1e6);
    foot.outer_diameter = 0.3;
    Case input = one_line(top, L, elements, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.density = 0.0;
    input.line_types.push_back(foot);
    input.lines[0].sections[0].type_at_end = 1;
    return input;
}

TEST(Taper, HangingBarCarriesAndStretchesByItsIntegrals) {
    double exact = 0.0;  // int_0^L T/EA ds, T = g int_s^L m
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double s = (i + 0.5) / n, below = 1 - s;
        const double T = g * L * (300 * below - 200 * (1 - s * s) / 2);
        exact += L / n * T / (4e6 - 3e6 * s);
    }
    std::vector<double> errors;
    for (const int elements : {4, 8, 16}) {
        const Case input = hanging_taper(elements);
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        EXPECT_NEAR(rod.tension_a(0), 200 * L * g, 1e-6 * 200 * L * g);  // linear: exact
        errors.push_back(-rod.node_position(0, elements).z() - L - exact);
    }
    EXPECT_LT(std::abs(errors[2]), 2e-3 * exact);
    for (int i = 0; i < 2; ++i) {  // the value at the middle: second order
        const double ratio =
            errors[static_cast<std::size_t>(i)] / errors[static_cast<std::size_t>(i) + 1];
        EXPECT_GT(ratio, 3.7) << i;
        EXPECT_LT(ratio, 4.3) << i;
    }
}

TEST(Taper, EveryPropertyRunsFromOneTypeToTheOther) {
    Case input = hanging_taper(4);
    LineType &a = input.line_types[0], &b = input.line_types[1];
    a.EI = 10, b.EI = 30, a.displaced_area = 1, b.displaced_area = 2;
    a.drag_normal = 1, b.drag_normal = 3, a.damping_ratio = 0.01, b.damping_ratio = 0.03;
    a.wall = PipeWall{.outer_diameter = 0.4, .inner_diameter = 0.3};
    b.wall = PipeWall{.outer_diameter = 0.6, .inner_diameter = 0.3};
    const Section &section = input.lines[0].sections[0];
    EXPECT_EQ(line_type_at(input, section, 0.0), a);
    const LineType at = line_type_at(input, section, 0.25);
    EXPECT_DOUBLE_EQ(at.EI, 15);
    EXPECT_DOUBLE_EQ(at.displaced_area, 1.25);
    EXPECT_DOUBLE_EQ(at.mass, 250);
    EXPECT_DOUBLE_EQ(at.outer_diameter, 0.15);
    EXPECT_DOUBLE_EQ(at.drag_normal, 1.5);
    EXPECT_DOUBLE_EQ(*at.damping_ratio, 0.015);
    EXPECT_DOUBLE_EQ(at.wall->outer_diameter, 0.45);
    LineType end = line_type_at(input, section, 1.0);
    end.name = b.name;
    EXPECT_EQ(end, b);
    // elements take the value at their middle, also in a second section of unlike elements
    input.lines[0].sections = {
        {.type = 0, .length = 30, .elements = 2},
        {.type = 0, .length = 70, .elements = 2, .growth = 2.5, .type_at_end = 1}};
    const LineMesh mesh = mesh_of(input.lines[0]);
    const auto mass = [&](int e) {
        return element_properties(input, input.lines[0], mesh, e, 1.0).m;
    };
    EXPECT_DOUBLE_EQ(mass(1), 300);
    EXPECT_NEAR(mass(2), 300 - 200 * 10.0 / 70, 1e-9);
    EXPECT_NEAR(mass(3), 300 - 200 * 45.0 / 70, 1e-9);
}

TEST(Taper, YieldAndBreakingLoadRunAsItsWallDoes) {
    Case input = hanging_taper(4);
    LineType &a = input.line_types[0], &b = input.line_types[1];
    a.wall = PipeWall{.outer_diameter = 0.4, .inner_diameter = 0.3};
    b.wall = PipeWall{.outer_diameter = 0.6, .inner_diameter = 0.3};
    a.wall->yield = 448e6, b.wall->yield = 358e6;
    a.breaking_load = 8e6, b.breaking_load = 4e6;
    const auto at = [&](double s) { return stress_section(input, input.lines[0], s, true); };
    EXPECT_DOUBLE_EQ(at(0).yield, 448e6);
    EXPECT_DOUBLE_EQ(at(0.25 * L).yield, 425.5e6);
    EXPECT_DOUBLE_EQ(at(L).yield, 358e6);
    EXPECT_DOUBLE_EQ(at(0.25 * L).breaking_load, 7e6);
    EXPECT_NEAR(at(0.25 * L).outer_radius, 0.225, 1e-12);
}

}  // namespace
}  // namespace hawser::worker
