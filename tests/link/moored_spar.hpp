// A small spar buoy on six chains in waves and current, built by hand: everything a coupled run
// has, quick to compute.
#pragma once

#include <cmath>

#include "case/case.hpp"

namespace hawser::test {

inline Case moored_spar() {
    Case c;
    c.name = "moored_spar";
    c.environment.seabed.depth = 300.0;
    c.environment.waves = {
        {.type = WaveType::jonswap, .Hs = 6.0, .Tp = 10.0, .seed = 7, .components = 20}};
    c.environment.current = Current{
        .heading = 0.3, .profile = {{.depth = 0.0, .speed = 0.8}, {.depth = 300.0, .speed = 0.2}}};

    Platform& p = c.platform.emplace();
    p.name = "spar";
    p.centre_of_gravity = {0, 0, -65};
    p.radii_of_gyration = {40, 40, 4};
    p.hydrodynamics.matrix.emplace().damping(5, 5) = 1e7;
    p.members = {{.name = "column",
                  .from = {0, 0, -100},
                  .to = {0, 0, 15},
                  .diameter = 10.0,
                  .Cd = 1.0,
                  .displaced_area = 25 * M_PI}};

    LineType chain;
    chain.name = "chain";
    chain.category = "chain";
    chain.mass = 200.0;
    chain.displaced_area = 200.0 / 7850;
    chain.outer_diameter = 0.1;
    chain.EA = 8e8;
    chain.drag_diameter = 0.1;
    chain.drag_normal = 2.4;
    chain.drag_axial = 1.15;
    c.line_types = {chain};
    for (int i = 0; i < 6; ++i) {  // two layouts, so two packs at least
        const double a = i * M_PI / 3;
        Line line;
        line.name = "ml" + std::to_string(i + 1);
        line.family = i < 4 ? "bow" : "stern";
        line.end_a.kind = EndKind::platform;
        line.end_a.position = {5 * std::cos(a), 5 * std::sin(a), -50};
        line.end_b.kind = EndKind::anchor;
        line.end_b.position = {600 * std::cos(a), 600 * std::sin(a), -300};
        line.sections = {{.type = 0, .length = 665.0, .elements = i % 2 == 0 ? 12 : 15}};
        line.azimuth = a;
        c.lines.push_back(line);
    }
    c.analysis.dynamics.duration = 3.0;
    c.analysis.dynamics.ramp = 1.0;
    c.analysis.dynamics.statistics_from = 1.0;
    c.analysis.dynamics.line_step = 0.05;
    c.output.interval = 0.5;
    c.output.snapshots = 1.0;
    c.output.platform_loads = true;
    c.output.lines = {{.select = "*", .end_b = true, .results = {"effective_tension", "force"}},
                      {.select = "ml*",
                       .end_b = true,
                       .at_arc = {200.0, 480.0},
                       .results = {"effective_tension", "seabed_force", "curvature", "touchdown"},
                       .range = {"effective_tension", "seabed_force"}}};
    return c;
}

}  // namespace hawser::test
