#include "case/line_type_rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi;

double disc(double diameter) { return pi / 4.0 * diameter * diameter; }

double inner_diameter(const LineTypeKeys& type) {
    if (type.inner_diameter) return *type.inner_diameter;
    return type.outer_diameter.value_or(NAN) - 2.0 * type.wall_thickness.value_or(NAN);
}

/// Collects what a rule chose and what is missing for it.
class Rules {
 public:
    Rules(const LineTypeKeys& type, Problems& problems)
        : path_("line_types." + type.name), category_(type.category), problems_(problems) {}

    void missing(const std::string& key, const std::string& hint = {}) const {
        problems_.push_back({Severity::error,
                             path_,
                             fmt::format("category {} needs \"{}\"{}", category_, key, hint),
                             {}});
    }
    /// value = chosen if it is not given, with a note.
    void choose(std::optional<double>& value, const char* key, double chosen, const char* unit,
                const std::string& rule) const {
        if (value) return;
        value = chosen;
        if (std::isnan(chosen)) return;
        problems_.push_back({Severity::note,
                             path_ + "." + key,
                             fmt::format("auto: {:.6g} {} ({})", chosen, unit, rule),
                             {}});
    }

 private:
    std::string path_, category_;
    Problems& problems_;
};

void complete_pipe(LineTypeKeys& type, const Material* material, const Rules& rules) {
    if (!type.wall_thickness && !type.inner_diameter) rules.missing("wall_thickness");
    const bool stretches = type.EA || type.viscoelastic || !type.EA_curve.empty();
    const bool from_material = !type.mass || !stretches || !type.EI;
    if (!type.material && from_material) {
        rules.missing("material", " (or mass, EA and EI)");
    }
    const double outer = type.outer_diameter.value_or(NAN), inner = inner_diameter(type);
    const double steel = disc(outer) - disc(inner);
    const double layer = type.coating ? type.coating->thickness : 0.0;
    const double coated = outer + 2.0 * layer;
    const double coating =
        type.coating ? type.coating->density * (disc(coated) - disc(outer)) : 0.0;
    const double E = material != nullptr ? material->E : NAN;
    const double rho = material != nullptr ? material->density : NAN;
    if (!type.mass) type.mass = rho * steel + coating;
    if (!type.volume_diameter) type.volume_diameter = coated;
    if (!type.viscoelastic && !type.EA && type.EA_curve.empty()) type.EA = E * steel;
    if (!type.yield && material != nullptr) type.yield = material->yield;
    if (!type.EI) type.EI = E * pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4));
}

void complete_chain_or_rope(LineTypeKeys& type, const Rules& rules) {
    const bool chain = type.category == "chain", rope = type.category == "rope";
    if (!type.nominal_diameter) rules.missing("nominal_diameter");
    const double d = type.nominal_diameter.value_or(NAN), d2 = d * d;
    if (chain) {
        const bool studless = type.link == ChainLink::studless;
        rules.choose(type.mass, "mass", (studless ? 19.9e3 : 21.9e3) * d2, "kg/m",
                     studless ? "19.9 d2 t/m, studless" : "21.9 d2 t/m, studlink");
        if (!type.density && !type.volume_diameter) type.density = 7850.0;
        if (!type.viscoelastic && type.EA_curve.empty()) {
            rules.choose(type.EA, "EA", (studless ? 0.854e11 : 1.01e11) * d2, "N",
                         studless ? "0.854e8 d2 kN, studless" : "1.01e8 d2 kN, studlink");
        }
    } else if (rope) {
        rules.choose(type.mass, "mass", 678.75 * d2, "kg/m", "polyester rope, 0.679 d2 t/m");
        if (!type.density && !type.volume_diameter) type.density = 1380.0;
        if (!type.viscoelastic && type.EA_curve.empty()) {
            rules.choose(type.EA, "EA", 14.0 * 308.2e6 * d2, "N",
                         "polyester rope, 14 times its breaking load 0.308e6 d2 kN");
        }
    }
}

void require_given(LineTypeKeys& type, const Rules& rules) {
    if (!type.mass) rules.missing("mass");
    if (!type.density && !type.volume_diameter) {
        rules.missing("density", " (or volume_diameter): it gives the buoyancy");
    }
    if (!type.EA && !type.viscoelastic && type.EA_curve.empty())
        rules.missing("EA", " (or viscoelastic)");
}

}  // namespace

void check_curve(const Curve& curve, const std::string& path, Problems& problems) {
    const auto refuse = [&](const std::string& message) {
        problems.push_back({Severity::error, path, message, {}});
    };
    if (curve.empty()) return;
    if (curve.size() < 2) return refuse("expected at least two rows");
    if (curve.front()[0] != 0.0 || curve.front()[1] != 0.0) {
        if (!std::isnan(curve.front()[0]) && !std::isnan(curve.front()[1])) {
            refuse("the first row must be [0, 0]");
        }
    }
    for (std::size_t i = 1; i < curve.size(); ++i) {
        if (curve[i][0] <= curve[i - 1][0] || curve[i][1] <= curve[i - 1][1]) {
            return refuse(fmt::format("row {}: both columns must ascend from row to row", i + 1));
        }
    }
}

void complete_line_type(LineTypeKeys& type, const Material* material, Problems& problems) {
    const Rules rules(type, problems);
    check_curve(type.EA_curve, "line_types." + type.name + ".EA", problems);
    const bool pipe = type.category == "pipe";
    if (type.category.empty()) return;  // already reported
    if (pipe) {
        complete_pipe(type, material, rules);
    } else {
        if (type.category != "general") complete_chain_or_rope(type, rules);
        require_given(type, rules);
    }
    if (!type.volume_diameter) {
        type.volume_diameter =
            std::sqrt(4.0 * type.mass.value_or(NAN) / (pi * type.density.value_or(NAN)));
    }
    if (!type.EI) type.EI = 0.0;
    if (!type.damping_ratio && !type.axial_damping) type.damping_ratio = 0.01;
    if (!type.drag_reference) {
        type.drag_reference = pipe                         ? DragReference::outer
                              : type.category == "general" ? DragReference::volume
                                                           : DragReference::nominal;
    }
    const bool nominal = *type.drag_reference == DragReference::nominal;
    const bool outer = *type.drag_reference == DragReference::outer;
    if ((nominal && pipe) || (outer && !pipe)) {
        problems.push_back(
            {Severity::error,
             "line_types." + type.name + ".drag.reference",
             fmt::format("a {} has no {} diameter", type.category, nominal ? "nominal" : "outer"),
             {}});
    } else if (nominal && !type.nominal_diameter && type.category == "general") {
        rules.missing("nominal_diameter", ": drag refers to it");
    }
    if (pipe && inner_diameter(type) < 0.0) {
        problems.push_back({Severity::error,
                            "line_types." + type.name,
                            "the wall is thicker than the pipe's radius",
                            {}});
    }
    if (pipe && type.inner_diameter && type.outer_diameter &&
        *type.inner_diameter >= *type.outer_diameter) {
        problems.push_back({Severity::error,
                            "line_types." + type.name + ".inner_diameter",
                            "not smaller than outer_diameter",
                            {}});
    }
    if (type.viscoelastic && type.viscoelastic->EA_dynamic <= type.viscoelastic->EA_static) {
        problems.push_back({Severity::error,
                            "line_types." + type.name + ".viscoelastic.EA_dynamic",
                            "must be greater than EA_static",
                            {}});
    }
}

LineType line_type(const LineTypeKeys& type) {
    LineType value;
    value.name = type.name;
    value.category = type.category;
    const double volume_diameter = type.volume_diameter.value_or(NAN);
    const double growth = type.marine_growth ? type.marine_growth->thickness : 0.0;
    value.mass = type.mass.value_or(NAN);
    value.displaced_area = disc(volume_diameter);
    if (type.contents_density > 0.0)
        value.mass += type.contents_density * disc(inner_diameter(type));
    if (type.marine_growth) {
        value.displaced_area = disc(volume_diameter + 2.0 * growth);
        value.mass += type.marine_growth->density * (value.displaced_area - disc(volume_diameter));
    }
    const bool pipe = type.category == "pipe";
    const double coating = type.coating ? 2.0 * type.coating->thickness : 0.0;
    const double outer = pipe ? type.outer_diameter.value_or(NAN) + coating
                              : type.nominal_diameter.value_or(volume_diameter);
    const double reference = type.drag_reference == DragReference::volume ? volume_diameter : outer;
    value.outer_diameter = outer + 2.0 * growth;
    value.drag_diameter = reference + 2.0 * growth;
    value.viscoelastic = type.viscoelastic;
    value.EA_curve = type.EA_curve;
    // Where there is a curve, its first slope stands for EA.
    value.EA = type.viscoelastic           ? type.viscoelastic->EA_dynamic
               : value.EA_curve.size() > 1 ? value.EA_curve[1][1] / value.EA_curve[1][0]
                                           : type.EA.value_or(NAN);
    value.EI = type.EI.value_or(0.0);
    value.damping_ratio = type.damping_ratio;
    value.axial_damping = type.axial_damping;
    value.bending_damping = type.bending_damping;
    value.drag_normal = type.drag_normal;
    value.drag_axial = type.drag_axial;
    value.added_mass_normal = type.added_mass_normal;
    value.added_mass_axial = type.added_mass_axial;
    value.breaking_load = type.breaking_load;
    if (pipe) {
        value.wall = PipeWall{.outer_diameter = type.outer_diameter.value_or(NAN),
                              .inner_diameter = inner_diameter(type),
                              .contents_density = type.contents_density,
                              .concentration = type.concentration,
                              .thickness_factor = type.thickness_factor,
                              .yield = type.yield};
    }
    if (type.category == "chain") value.section_area = 2.0 * disc(outer);
    if (type.category == "rope" || type.category == "wire") value.section_area = disc(outer);
    return value;
}

}  // namespace hawser
