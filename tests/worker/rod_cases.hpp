// Small cases for the tests of rods, built by hand.
#pragma once

#include "case/case.hpp"
#include "environment/sea.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker::testing {

/// A line type with no water about it unless told: mass [kg/m], EA [N], EI [N.m2].
inline LineType plain_type(double mass, double EA, double EI = 0.0) {
    LineType type;
    type.name = "plain";
    type.category = "general";
    type.mass = mass;
    type.EA = EA;
    type.EI = EI;
    type.displaced_area = 0.0;
    type.outer_diameter = 0.1;
    type.drag_diameter = 0.1;
    type.added_mass_normal = 0.0;
    return type;
}

/// One line with one section between two points.
inline Case one_line(const LineType& type, double length, int elements, const LineEnd& a,
                     const LineEnd& b, double depth = 1e5) {
    Case input;
    input.environment.seabed.depth = depth;
    input.line_types = {type};
    Line line;
    line.name = "line";
    line.end_a = a;
    line.end_b = b;
    line.sections = {{.type = 0, .length = length, .elements = elements}};
    input.lines = {line};
    input.analysis.dynamics.duration = 10.0;
    return input;
}

inline LineEnd fixed_at(const Vec3& position, Joint joint = Joint::ball) {
    LineEnd end;
    end.kind = EndKind::fixed;
    end.position = position;
    end.joint = joint;
    return end;
}
inline LineEnd anchored_at(const Vec3& position) {
    LineEnd end = fixed_at(position);
    end.kind = EndKind::anchor;
    return end;
}

inline Sea still_sea(const Case& input) { return Sea(input.environment, 0.0, 1.0); }

}  // namespace hawser::worker::testing
