// Keys of line_types and materials.
#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;

const Table& layer_keys() {
    static const Table table = [] {
        Keys<Layer> k("layer");
        k.number("thickness", &Layer::thickness, length, "Thickness")
            .required()
            .at_least(0)
            .eg("50 mm");
        k.number("density", &Layer::density, dimension::density, "Density")
            .required()
            .above(0)
            .eg("1300 kg/m3");
        return k.done();
    }();
    return table;
}

const Table& viscoelastic_keys() {
    static const Table table = [] {
        Keys<Viscoelastic> k("viscoelastic");
        k.choice("model", &Viscoelastic::model,
                 std::vector<std::pair<std::string, RopeLaw>>{
                     {"standard_linear_solid", RopeLaw::standard_linear_solid},
                     {"dual_stiffness", RopeLaw::dual_stiffness}},
                 "Law of the rope: stiffness that relaxes in time, or the static stiffness up to "
                 "the tension of the run's start and the dynamic about it")
            .required()
            .later_words({"syrope"})
            .eg("standard_linear_solid");
        k.number("EA_dynamic", &Viscoelastic::EA_dynamic, force, "Stiffness against fast change")
            .required()
            .above(0)
            .eg("706320 kN");
        k.number("EA_static", &Viscoelastic::EA_static, force, "Stiffness in the long run")
            .required()
            .above(0)
            .eg("451260 kN");
        k.number("relaxation_time", &Viscoelastic::relaxation_time, dimension::time,
                 "Time constant of the tension under a held strain")
            .needed_with("model", {"standard_linear_solid"})
            .above(0)
            .eg("300 s");
        return k.done();
    }();
    return table;
}

const Table& drag_keys() {
    static const Table table = [] {
        Keys<LineTypeKeys> k("drag");
        k.number("normal", &LineTypeKeys::drag_normal, dimension::number,
                 "Normal drag coefficient on reference diameter x length")
            .required()
            .at_least(0)
            .eg("1.2");
        k.number("axial", &LineTypeKeys::drag_axial, dimension::number,
                 "Axial drag coefficient on reference diameter x length, without pi")
            .def("0")
            .at_least(0);
        k.choice(
             "reference", &LineTypeKeys::drag_reference,
             std::vector<std::pair<std::string, DragReference>>{{"nominal", DragReference::nominal},
                                                                {"outer", DragReference::outer},
                                                                {"volume", DragReference::volume}},
             "Diameter that both refer to")
            .follows("nominal for chain, wire, rope; outer for pipe; volume for general")
            .eg("nominal");
        return k.done();
    }();
    return table;
}

const Table& stress_keys() {
    static const Table table = [] {
        Keys<LineTypeKeys> k("stress");
        k.number("scf", &LineTypeKeys::concentration, dimension::number,
                 "Stress concentration factor on axial and bending stress")
            .def("1")
            .at_least(1)
            .at_most(20);
        k.number("thickness_factor", &LineTypeKeys::thickness_factor, dimension::number,
                 "Part of the wall that is left for stresses (corrosion)")
            .def("1")
            .above(0)
            .at_most(1);
        return k.done();
    }();
    return table;
}

const Table& taper_keys() {
    static const Table table = [] {
        Keys<TaperKeys> k("taper");
        k.text("from", &TaperKeys::from, "Line type at the end of the section towards end A")
            .required()
            .eg("pipe");
        k.text("to", &TaperKeys::to, "Line type at the end of the section towards end B")
            .required()
            .eg("pipe");
        return k.done();
    }();
    return table;
}

const Table& added_mass_keys() {
    static const Table table = [] {
        Keys<LineTypeKeys> k("added_mass");
        k.number("normal", &LineTypeKeys::added_mass_normal, dimension::number,
                 "Normal added mass coefficient on the displaced area")
            .def("1")
            .at_least(0);
        k.number("axial", &LineTypeKeys::added_mass_axial, dimension::number,
                 "Axial added mass coefficient on the displaced area")
            .def("0")
            .at_least(0);
        return k.done();
    }();
    return table;
}

}  // namespace

const Table& material_keys() {
    static const Table table = [] {
        Keys<Material> k("materials");
        k.number("E", &Material::E, stress, "Young's modulus").required().above(0).eg("207 GPa");
        k.number("density", &Material::density, dimension::density, "Density")
            .required()
            .above(0)
            .eg("7850 kg/m3");
        k.later("poisson", "Poisson's ratio");
        k.number("yield", &Material::yield, stress, "Yield stress, for utilisation")
            .above(0)
            .eg("448 MPa");
        return k.done();
    }();
    return table;
}

const Table& line_type_keys() {
    static const Table table = [] {
        using T = LineTypeKeys;
        Keys<T> k("line_types");
        k.plain("like", Form::text, "Start from this other line type");
        std::vector<std::pair<std::string, std::string>> categories;
        for (const char* word : {"chain", "wire", "rope", "pipe", "general"}) {
            categories.emplace_back(word, word);
        }
        k.choice("category", &T::category, categories,
                 "Kind of line: rules and defaults follow; compression is carried, by chain, wire "
                 "and rope too, and flagged in the summary")
            .required();
        k.number("nominal_diameter", &T::nominal_diameter, length,
                 "Diameter of the chain's bar, of the wire or rope")
            .only_with("category", {"chain", "wire", "rope", "general"})
            .above(0)
            .eg("172 mm");
        k.choice("link", &T::link,
                 std::vector<std::pair<std::string, ChainLink>>{{"studless", ChainLink::studless},
                                                                {"studlink", ChainLink::studlink}},
                 "Kind of chain")
            .only_with("category", {"chain"})
            .def("studless");
        k.number("outer_diameter", &T::outer_diameter, length, "Outer diameter of the pipe's steel")
            .needed_with("category", {"pipe"})
            .above(0)
            .eg("324 mm");
        k.number("wall_thickness", &T::wall_thickness, length, "Wall of the pipe")
            .only_with("category", {"pipe"})
            .above(0)
            .eg("20 mm");
        k.number("inner_diameter", &T::inner_diameter, length, "Instead of wall_thickness")
            .only_with("category", {"pipe"})
            .above(0)
            .eg("284 mm");
        k.text("material", &T::material, "Name under materials")
            .only_with("category", {"pipe"})
            .eg("steel");
        k.number("contents_density", &T::contents_density, dimension::density,
                 "Density of what fills the pipe")
            .only_with("category", {"pipe"})
            .def("0 kg/m3")
            .at_least(0);
        k.map("coating", &T::coating, layer_keys, "Layer outside the steel")
            .only_with("category", {"pipe"});
        k.map("marine_growth", &T::marine_growth, layer_keys, "Layer outside everything");
        k.number("mass", &T::mass, mass_per_length, "Mass per length in air, empty")
            .or_word("auto")
            .follows("rule of the category")
            .above(0)
            .eg("589 kg/m");
        k.number("density", &T::density, dimension::density,
                 "Density of the material: gives the volume with mass")
            .follows("7850 for chain, 1380 for rope")
            .above(0)
            .eg("7850 kg/m3");
        k.number("volume_diameter", &T::volume_diameter, length,
                 "Diameter of the cylinder of the same volume, without marine growth")
            .or_word("auto")
            .follows("from mass and density; outer diameter of a pipe")
            .above(0)
            .eg("309 mm");
        k.curve("EA", &T::EA, &T::EA_curve, {force, dimension::number, force},
                "Axial stiffness; or rows of strain and tension from [0, 0] upwards, straight "
                "between")
            .or_word("auto")
            .follows("rule of the category")
            .above(0)
            .eg("3071190 kN");
        k.number("EI", &T::EI, bending_stiffness, "Bending stiffness")
            .or_word("auto")
            .follows("E I for pipe, else 0")
            .at_least(0)
            .table_later()
            .eg("45.9 MN.m2");
        k.map("viscoelastic", &T::viscoelastic, viscoelastic_keys,
              "Rope whose stiffness depends on how long the load lasts, instead of EA");
        k.number("damping_ratio", &T::damping_ratio, dimension::number,
                 "Material damping as a fraction of critical in the line's first axial mode")
            .follows("0.01, without axial_damping")
            .at_least(0)
            .at_most(1)
            .eg("0.01");
        k.number("axial_damping", &T::axial_damping, dimension::axial_damping,
                 "Axial force per strain rate, instead of damping_ratio")
            .at_least(0)
            .eg("200 kN.s");
        k.number("bending_damping", &T::bending_damping, dimension::bending_damping,
                 "Moment per rate of curvature")
            .def("0 N.m2.s")
            .at_least(0);
        k.group("drag", drag_keys, "Drag coefficients").required();
        k.group("added_mass", added_mass_keys, "Added mass coefficients");
        k.number("breaking_load", &T::breaking_load, force,
                 "Breaking load, to check the stiffness against")
            .above(0)
            .eg("24.6 MN");
        k.number("yield", &T::yield, stress, "Yield stress, for utilisation")
            .only_with("category", {"pipe"})
            .follows("that of the material")
            .above(0)
            .eg("448 MPa");
        k.group("stress", stress_keys, "Stress concentration and corrosion")
            .only_with("category", {"pipe"});
        k.map("taper", &T::taper, taper_keys,
              "Properties vary linearly along the section that uses the type; all of them come "
              "from the two types named here");
        k.rule(KeyRule::Count::at_most_one, {"wall_thickness", "inner_diameter"});
        k.rule(KeyRule::Count::at_most_one, {"damping_ratio", "axial_damping"});
        k.rule(KeyRule::Count::at_most_one, {"EA", "viscoelastic"});
        return k.done();
    }();
    return table;
}

}  // namespace hawser
