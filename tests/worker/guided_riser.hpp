// A top-tensioned riser like those of the truss spar, for tests.
#pragma once

#include "rod_cases.hpp"

namespace hawser::worker::testing {

/// The truss spar's top-tensioned riser, uniform: clamped foot, gas tensioner at z = 22 m, guides.
inline Case guided_riser(double length, double gas_exponent = 1.1) {
    LineType pipe = plain_type(337.0, 6.2e9, 1.13e8);
    pipe.displaced_area = M_PI / 4 * 0.406 * 0.406;
    pipe.outer_diameter = pipe.drag_diameter = 0.406;
    pipe.drag_normal = 1.2;
    pipe.added_mass_normal = 1.0;
    LineEnd foot = fixed_at({4.5, 4.5, -1500}, Joint::clamped);
    foot.direction = Vec3(0, 0, -1);
    Case input = one_line(pipe, length, 40, LineEnd{}, foot, 1500);
    input.lines[0].sections = {{.type = 0, .length = 200, .elements = 20},
                               {.type = 0, .length = length - 212, .elements = 30},
                               {.type = 0, .length = 12, .elements = 6}};
    LineConstraint tensioner{.type = ConstraintType::tensioner,
                             .name = "tensioner",
                             .position = {4.5, 4.5, 22},
                             .arc_length = 0.0,
                             .damping = 2e4,
                             .nominal_tension = 5.338e6,
                             .exponent = gas_exponent,
                             .gas_column = 40,
                             .stroke_min = -4.5,
                             .stroke_max = 4.5};
    if (gas_exponent == 0.0) tensioner.stiffness = 147e3;
    input.lines[0].constraints = {tensioner};
    for (const double z : {-95.0, -115.0, -135.0, -165.0, -173.0})
        input.lines[0].constraints.push_back({.type = ConstraintType::guide,
                                              .name = "guide",
                                              .position = {4.5, 4.5, z},
                                              .arc_length = {},
                                              .stiffness = 2e7,
                                              .damping = 2e5,
                                              .gap = 0.025,
                                              .friction = 0.1});
    return input;
}

}  // namespace hawser::worker::testing
