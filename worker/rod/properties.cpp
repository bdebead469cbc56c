#include "rod/properties.hpp"

#include <cmath>

#include "rod/shape.hpp"

namespace hawser::worker {

namespace {

double mean_slope(const Curve& curve) {
    return (curve.back()[1] - curve.front()[1]) / (curve.back()[0] - curve.front()[0]);
}

}  // namespace

LineType line_type_at(const Case& input, const Section& section, double fraction) {
    LineType type = input.line_types[static_cast<std::size_t>(section.type)];
    if (!type.EA_curve.empty()) type.EA = mean_slope(type.EA_curve);
    if (section.type_at_end < 0) return type;
    const LineType& end = input.line_types[static_cast<std::size_t>(section.type_at_end)];
    const auto run = [&](double& a, double b) { a += fraction * (b - a); };
    for (double LineType::*const member :
         {&LineType::mass, &LineType::displaced_area, &LineType::outer_diameter, &LineType::EA,
          &LineType::EI, &LineType::bending_damping, &LineType::drag_diameter,
          &LineType::drag_normal, &LineType::drag_axial, &LineType::added_mass_normal,
          &LineType::added_mass_axial, &LineType::section_area})
        run(type.*member, end.*member);
    const auto run_optional = [&](std::optional<double>& a, const std::optional<double>& b) {
        if (a && b) run(*a, *b);
    };
    run_optional(type.damping_ratio, end.damping_ratio);
    run_optional(type.axial_damping, end.axial_damping);
    run_optional(type.breaking_load, end.breaking_load);
    if (type.viscoelastic && end.viscoelastic) {
        run(type.viscoelastic->EA_dynamic, end.viscoelastic->EA_dynamic);
        run(type.viscoelastic->EA_static, end.viscoelastic->EA_static);
        run(type.viscoelastic->relaxation_time, end.viscoelastic->relaxation_time);
    }
    if (type.wall && end.wall) {
        for (double PipeWall::*const member :
             {&PipeWall::outer_diameter, &PipeWall::inner_diameter, &PipeWall::contents_density,
              &PipeWall::concentration, &PipeWall::thickness_factor})
            run((*type.wall).*member, (*end.wall).*member);
        run_optional(type.wall->yield, end.wall->yield);
    }
    return type;
}

double axial_travel_time(const Case& input, const Line& line) {
    double sum = 0.0;
    for (const Section& section : line.sections) {
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const LineType type = line_type_at(input, section, gauss_xi[g]);
            sum += gauss_weight[g] * section.length * std::sqrt(type.mass / type.EA);
        }
    }
    return sum;
}

ElementProperties<double> element_properties(const Case& input, const Line& line,
                                             const LineMesh& mesh, int e,
                                             double axial_frequency_integral) {
    const auto ue = static_cast<std::size_t>(e);
    const auto in_section = static_cast<std::size_t>(mesh.section[ue]);
    const Section& section = line.sections[in_section];
    double start = 0.0;
    for (std::size_t i = 0; i < in_section; ++i) start += line.sections[i].length;
    const double middle = 0.5 * (mesh.arc_length[ue] + mesh.arc_length[ue + 1]);
    const LineType type = line_type_at(input, section, (middle - start) / section.length);
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
        // R:39: what creeps in statics stays as it is in motion
        if (law.model == RopeLaw::dual_stiffness) p.c_creep = no_creep * p.K_creep;
    }
    return p;
}

}  // namespace hawser::worker
