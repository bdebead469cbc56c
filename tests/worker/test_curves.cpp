// Tabulated tension against strain (R:41), bending damping, buoyant sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rod/catenary.hpp"
#include "rod/curves.hpp"
#include "rod/modes.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

const Curve table = {{0, 0}, {0.01, 1e5}, {0.03, 6e5}, {0.05, 8e5}};
double table_at(double e) {
    return e < 0.01 ? 1e7 * e : e < 0.03 ? 1e5 + 2.5e7 * (e - 0.01) : 6e5 + 1e7 * (e - 0.03);
}

Case tabulated(LineEnd a) {
    LineType type = plain_type(1e-3, 0.0);
    type.EA = std::nan("");
    type.EA_curve = table;
    Case input = one_line(type, 100, 2, a, fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0, input.environment.water.gravity = 1e-9;
    input.analysis.dynamics.ramp = 0.0;
    return input;
}

TEST(TensionTable, IsFollowedInStaticsAcrossItsKinks) {  // R:41
    for (const double e : {0.004, 0.02, 0.045, 0.06}) {
        const Case input = tabulated(fixed_at({100 * (1 + e), 0, 0}));
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << e;
        EXPECT_NEAR(rod.tension_a(0), table_at(e), 1e-6 * table_at(e)) << e;
    }
}

TEST(TensionTable, IsFollowedInMotionAcrossItsKinks) {  // R:41, with a damper beside it, R:4
    for (const double damping : {0.0, 2e6}) {
        // strain 0.025 + 0.02 sin(0.5 t)
        Case input = tabulated(moving(fixed_at({102.5, 0, 0}), {2, 0, 0}, 4 * M_PI));
        if (damping > 0.0) input.line_types[0].axial_damping = damping;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        ASSERT_TRUE(run(rod, 25, 0.1, [&](double t) {
                        if (t < 1) return;
                        const double e = 0.025 + 0.02 * std::sin(0.5 * t);
                        const double T = table_at(e) + damping * 0.01 * std::cos(0.5 * t);
                        // (g - 1/2) h w of the damper's share; end force is of the last solve
                        EXPECT_NEAR(rod.tension_a(0), T, 2e-3 * T + 5e-3 * 0.01 * damping) << t;
                    }).ok());
    }
}

TEST(TensionTable, GivesModesTheStiffnessOfItsOwnSlope) {  // R:43: w = n pi/L sqrt(F'/m)
    for (const auto& [e, slope] : {std::pair(0.009, 1e7), {0.02, 2.5e7}, {0.045, 1e7}}) {
        Case input = tabulated(fixed_at({100 * (1 + e), 0, 0}));
        input.line_types[0].mass = 1.0;
        input.lines[0].sections[0].elements = 20;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << e;
        const std::vector<RodMode> modes = rod_modes(rod, 0, input, 40);
        const auto axial = std::find_if(modes.begin(), modes.end(), [](const RodMode& m) {
            return m.kind == RodMode::Kind::axial;
        });
        ASSERT_NE(axial, modes.end()) << e;
        const double w = M_PI / 100 * std::sqrt(slope);
        EXPECT_NEAR(std::sqrt(axial->omega_squared), w, 1e-4 * w) << e;  // mesh of 20, fourth order
    }
}

TEST(TensionTable, WithoutADamperGivesBackWhatItStored) {  // R:41, over whole cycles across a kink
    Case input = tabulated(moving(fixed_at({102.5, 0, 0}), {2, 0, 0}, 4 * M_PI));
    input.line_types[0].damping_ratio = 0.0;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    double work = 0.0, flow = 0.0, T_before = rod.tension_a(0), x_before = 102.5;
    const double period = 4 * M_PI;
    ASSERT_TRUE(run(rod, 3 * period, period / 200, [&](double t) {
                    const double x = rod.node_position(0, 0).x(), T = rod.tension_a(0);
                    if (t > period * (1 + 1e-9)) {
                        work += 0.5 * (T + T_before) * (x - x_before);
                        flow += 0.5 * (T + T_before) * std::abs(x - x_before);
                    }
                    T_before = T, x_before = x;
                }).ok());
    EXPECT_GT(flow, 1e6);
    EXPECT_NEAR(work, 0.0, 1e-3 * flow);  // trapezoids across the kinks
}

TEST(TensionTable, ItsStrainSolvesTheSpringAndDamper) {
    for (const double c : {0.0, 3e6})
        for (const double e : {-0.002, 0.005, 0.0299, 0.0301, 0.2}) {
            const CurvePoint p = strain_under(table, c, table_at(e) + c * e);
            EXPECT_NEAR(p.strain, e, 1e-12) << e;
        }
}

TEST(TensionTable, LeavesNeighboursAlone) {
    Case input = tabulated(moving(fixed_at({102.5, 0, 0}), {2, 0, 0}, 4 * M_PI));
    input.line_types.push_back(input.line_types[0]);
    input.line_types[1].EA_curve.clear(), input.line_types[1].EA = 1.3e7;
    input.lines.push_back(input.lines[0]);
    input.lines[1].sections[0].type = 1;
    const Sea sea = still_sea(input);
    RodPack<Quad> together(input, sea, {0, 1});
    ASSERT_TRUE(together.equilibrium({}, false).ok());
    ASSERT_TRUE(run(together, 5, 0.5).ok());
    for (int line = 0; line < 2; ++line) {
        RodPack<Quad> alone(input, sea, {line});
        ASSERT_TRUE(alone.equilibrium({}, false).ok());
        ASSERT_TRUE(run(alone, 5, 0.5).ok());
        for (std::size_t n = 0; n < alone.kept().block().size(); ++n)
            ASSERT_EQ(alone.kept().block()[n][0], together.kept().block()[n][line]) << line;
    }
}

TEST(BendingDamping, DecaysAFreeVibrationAsItsClosedForm) {  // R:1: zeta = Db k^4/(2 m w)
    // a beam under a little tension: m w^2 = B k^4 + T k^2
    const double L = 20, B = 1e7, m = 100, T = 1e4, EA = 1e8, k = M_PI / L;
    const double w = std::sqrt((B * std::pow(k, 4) + T * k * k) / m), zeta = 0.02;
    LineType type = plain_type(m, EA, B);
    type.bending_damping = 2 * zeta * m * w / std::pow(k, 4);
    Case input = one_line(type, L, 8, fixed_at({L * (1 + T / EA), 0, 0}), fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0, input.environment.water.gravity = 1e-9;
    const double period = 2 * M_PI / w;
    input.analysis.dynamics.line_step = period / 200;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double a = 1e-3;  // small: no tension from the stretch
    displace(
        rod, L, -w * w, [&](double s) { return Vec3(0, 0, a * std::sin(k * s)); },
        [&](double s) { return Vec3(0, 0, a * k * std::cos(k * s)); });
    Record z;
    ASSERT_TRUE(run(rod, 12 * period, period / 50, [&](double t) {
                    z.add(t, rod.node_position(0, 4).z());
                }).ok());
    // the largest of two periods ten apart
    const auto peak = [&](double from) {
        double best = 0.0;
        for (std::size_t i = 0; i < z.t.size(); ++i)
            if (z.t[i] > from && z.t[i] < from + period) best = std::max(best, z.y[i]);
        return best;
    };
    const double decay = std::log(peak(0.5 * period) / peak(10.5 * period)) / (20 * M_PI);
    // the scheme's own damping at w h = 0.03 is 1e-6 of critical; sampling of peaks 1e-3
    EXPECT_NEAR(decay, zeta, 0.02 * zeta);
}

TEST(LazyWave, HangsOnThePiecewiseCatenary) {  // buoyant section, volume_diameter larger
    LineType pipe = plain_type(150, 3e9), floats = plain_type(300, 3e9);
    pipe.displaced_area = M_PI / 4 * 0.3 * 0.3, pipe.outer_diameter = 0.3;
    floats.displaced_area = M_PI / 4 * 0.8 * 0.8, floats.outer_diameter = 0.3;
    LineEnd top = fixed_at({0, 0, -20});
    Case input = one_line(pipe, 900, 45, top, fixed_at({700, 0, -600}), 5000);
    input.line_types.push_back(floats);
    input.lines[0].sections = {{.type = 0, .length = 600, .elements = 60},
                               {.type = 1, .length = 150, .elements = 30},
                               {.type = 0, .length = 350, .elements = 35}};
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    // the catenary's own equations, started from what the rod found at its end A
    const Vec3 pull = rod.force_on_support_a(0);  // of the line on its support
    Vec3 r(0, 0, -20), F = pull;
    std::vector<Vec3> nodes = {r};
    for (const Section& s : input.lines[0].sections) {
        const LineType& type = input.line_types[static_cast<std::size_t>(s.type)];
        const double w = (type.mass - 1025 * type.displaced_area) * 9.80665;
        const double ds = s.length / s.elements;
        for (int e = 0; e < s.elements; ++e) {  // Simpson along each tenth of an element
            for (int i = 0; i < 10; ++i) {
                const auto slope = [&](double at) {
                    const Vec3 T = F + Vec3(0, 0, w * at);
                    return Vec3(T / T.norm() * (1 + T.norm() / type.EA));
                };
                const double h = ds / 10;
                r += h / 6 * (slope(0) + 4 * slope(h / 2) + slope(h));
                F.z() += w * h;
            }
            nodes.push_back(r);
        }
    }
    double lowest = 0, arch = -1e9;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        EXPECT_LT((rod.node_position(0, static_cast<int>(n)) - nodes[n]).norm(), 0.3) << n;
        if (n < 60) lowest = std::min(lowest, nodes[n].z());
        if (n >= 60 && n <= 90) arch = std::max(arch, nodes[n].z());
    }
    EXPECT_LT((nodes.back() - Vec3(700, 0, -600)).norm(), 0.3);
    EXPECT_GT(arch, lowest + 10.0);  // sag and arch: a wave
}

}  // namespace
}  // namespace hawser::worker
