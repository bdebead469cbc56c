#include "rod/properties.hpp"

#include <cmath>

namespace hawser::worker {

double axial_travel_time(const Case& input, const Line& line) {
    double sum = 0.0;
    for (const Section& section : line.sections) {
        const LineType& type = input.line_types[static_cast<std::size_t>(section.type)];
        sum += section.length * std::sqrt(type.mass / type.EA);
    }
    return sum;
}

ElementProperties<double> element_properties(const Case& input, const Line& line,
                                             const LineMesh& mesh, int e,
                                             double axial_frequency_integral) {
    const auto ue = static_cast<std::size_t>(e);
    const Section& section = line.sections[static_cast<std::size_t>(mesh.section[ue])];
    const LineType& type = input.line_types[static_cast<std::size_t>(section.type)];
    const double rho = input.environment.water.density, g = input.environment.water.gravity;

    ElementProperties<double> p;
    p.L = mesh.arc_length[ue + 1] - mesh.arc_length[ue];
    p.B = type.EI;
    p.Db = type.bending_damping;
    p.m = type.mass;
    p.weight = type.mass * g;
    p.rhoA = rho * type.displaced_area;
    p.buoyancy = p.rhoA * g;
    p.ma = p.rhoA * type.added_mass_normal;
    p.ma_less_mt = p.rhoA * (type.added_mass_normal - type.added_mass_axial);
    p.cn = 0.5 * rho * type.drag_normal * type.drag_diameter;
    p.ct = 0.5 * rho * type.drag_axial * type.drag_diameter;
    p.D = type.outer_diameter;

    p.K_damper = type.EA;
    if (type.axial_damping) {
        p.c_damper = *type.axial_damping;
    } else {  // R:5: c = 2 zeta EA / w1, w1 = pi / travel time
        p.c_damper =
            2.0 * type.damping_ratio.value_or(0.0) * type.EA * axial_frequency_integral / M_PI;
    }
    p.K_creep = 1e30;
    p.c_creep = 0.0;
    if (type.viscoelastic) {  // R:35, R:36
        const Viscoelastic& law = *type.viscoelastic;
        p.K_creep = law.EA_dynamic * law.EA_static / (law.EA_dynamic - law.EA_static);
        p.c_creep = p.K_creep * law.relaxation_time * law.EA_dynamic / law.EA_static;
    }
    return p;
}

}  // namespace hawser::worker
