#include "case/platform.hpp"

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;

/// Dimensions of a 6x6 matrix from those of its four 3x3 blocks: force by translation, force by
/// rotation, moment by translation, moment by rotation.
std::vector<Dimension> blocks(const Dimension& tt, const Dimension& tr, const Dimension& rt,
                              const Dimension& rr) {
    std::vector<Dimension> all;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) all.push_back(i < 3 ? (j < 3 ? tt : tr) : (j < 3 ? rt : rr));
    }
    return all;
}

const Table& database_keys() {
    static const Table table = [] {
        Keys<HydroDatabase> k("database");
        k.choice(
             "format", &HydroDatabase::format,
             std::vector<std::pair<std::string, HydroFormat>>{{"wamit", HydroFormat::wamit},
                                                              {"hams", HydroFormat::hams},
                                                              {"capytaine", HydroFormat::capytaine},
                                                              {"nemoh", HydroFormat::nemoh},
                                                              {"bemio", HydroFormat::bemio}},
             "Layout of the files")
            .def("wamit");
        k.path(
             "path", &HydroDatabase::path,
             "wamit, hams: files without their endings (.1 .3 .hst .8); capytaine: the .nc; bemio: "
             "the .h5; nemoh: its folder; relative to this file")
            .required()
            .eg("hydro/truss_spar");
        k.integer("body", &HydroDatabase::body,
                  "Which body of files with several; forces from the motion of the others are left "
                  "out")
            .follows("the only one")
            .at_least(1)
            .eg("1");
        k.number("ulen", &HydroDatabase::ulen, length, "WAMIT's length unit ULEN")
            .def("1 m")
            .above(0);
        k.number("rho", &HydroDatabase::rho, density,
                 "Density of water that makes the files dimensional")
            .follows("what the files say; required with wamit and hams")
            .above(0)
            .eg("1025 kg/m3");
        k.number("displaced_volume", &HydroDatabase::displaced_volume, volume,
                 "Volume displaced by what the database contains")
            .follows("what the files say; required with wamit and hams")
            .above(0)
            .eg("100530.965 m3");
        k.vector("centre_of_buoyancy", &HydroDatabase::centre_of_buoyancy, {length},
                 "Its centre, on platform axes")
            .follows("what the files say; required with wamit and hams")
            .eg("[0, 0, -51.875 m]");
        k.flag("includes_weight", &HydroDatabase::includes_weight,
               "Does the hydrostatic stiffness contain the weight part -m g z_G of C44 and C55? "
               "The program applies "
               "weight itself")
            .required()
            .eg("false");
        k.number("included_mass", &HydroDatabase::included_mass, mass,
                 "Mass that the .frc had; with includes_weight: true")
            .needed_with("includes_weight", {"true"})
            .above(0)
            .eg("98434 t");
        k.number("included_z", &HydroDatabase::included_z, length,
                 "Height of the centre of gravity that the .frc had; with includes_weight: true")
            .needed_with("includes_weight", {"true"})
            .eg("-66 m");
        k.vector("reference_point", &HydroDatabase::reference_point, {length},
                 "Origin of the files' rotations and moments, on platform axes")
            .def("[0, 0, 0]");
        k.numbers(
             "phase_origin", &HydroDatabase::phase_origin, length, 2, 2,
             "Where the reference point stood, x and y, in the axes at whose origin the files' "
             "phases count from a crest")
            .def("[0, 0]");
        k.choice("period_column", &HydroDatabase::period_column,
                 std::vector<std::pair<std::string, PeriodColumn>>{
                     {"period", PeriodColumn::period},
                     {"frequency", PeriodColumn::frequency},
                     {"deep_wavenumber", PeriodColumn::deep_wavenumber},
                     {"wavenumber", PeriodColumn::wavenumber},
                     {"auto", PeriodColumn::automatic}},
                 "What the first column of the files holds: periods, frequencies in rad/s, w2/g "
                 "ulen, k ulen; auto tries the first two (wamit, hams)")
            .follows("period; required with hams, whose control file chooses it")
            .eg("period");
        k.choice("limits", &HydroDatabase::limits,
                 std::vector<std::pair<std::string, HydroLimits>>{
                     {"wamit", HydroLimits::wamit}, {"reversed", HydroLimits::reversed}},
                 "Limits in the .1: wamit has a negative first column for zero frequency and 0 for "
                 "infinite; reversed has 0 for zero and a negative one for infinite")
            .follows("wamit for periods, reversed with hams; else required where there are any")
            .eg("wamit");
        Key& symmetry = k.custom(
            "symmetry", Form::words, {},
            "Planes of symmetry of the hull: the files' headings are mirrored across them",
            [](HydroDatabase& d, const Value& v) {
                d.symmetry = std::get<std::vector<std::string>>(v);
            },
            [](const HydroDatabase& d) -> Value {
                if (d.symmetry.empty()) return {};
                return d.symmetry;
            });
        symmetry.choices = {"xz", "yz"};
        symmetry.eg("[xz]");
        k.flag(
             "estimate_infinite", &HydroDatabase::estimate_infinite,
             "Where the files lack the added mass at infinite frequency that memory needs: work it "
             "out of the others (Ogilvie's relation)")
            .def("false");
        return k.done();
    }();
    return table;
}

const Table& matrix_keys() {
    static const Table table = [] {
        Keys<HydroMatrix> k("matrix");
        k.matrix("added_mass", &HydroMatrix::added_mass, 6,
                 blocks(mass, first_moment, first_moment, inertia),
                 "Added mass about the reference point, 6 rows of 6")
            .required();
        k.matrix(
            "damping", &HydroMatrix::damping, 6,
            blocks(dimension::damping, force_per_angular_speed, axial_damping, rotational_damping),
            "Radiation damping about the reference point, 6 rows of 6");
        k.matrix("stiffness", &HydroMatrix::stiffness, 6,
                 blocks(dimension::stiffness, force_per_angle, force, rotational_stiffness),
                 "Waterplane stiffness about the reference point, 6 rows of 6; heave, roll and "
                 "pitch act")
            .required();
        return k.done();
    }();
    return table;
}

const Table& memory_keys() {
    static const Table table = [] {
        using Form = RadiationMemoryKeys::Form;
        Keys<RadiationMemoryKeys> k("convolution");
        k.choice("form", &RadiationMemoryKeys::form,
                 std::vector<std::pair<std::string, Form>>{{"fitted", Form::fitted},
                                                           {"discrete", Form::discrete}},
                 "How the memory is kept: as damped oscillators fitted to the database, or as the "
                 "convolution over the platform's steps")
            .def("fitted");
        k.integer("order", &RadiationMemoryKeys::order,
                  "Number of oscillators of the fitted form, 12 at most")
            .or_word("auto")
            .follows("the fewest that fit the database within 0.5 %")
            .at_least(1)
            .at_most(12)
            .eg("4");
        k.number("duration", &RadiationMemoryKeys::duration, time,
                 "Time after which the hull has forgotten a motion, discrete form")
            .def("60 s")
            .above(0);
        return k.done();
    }();
    return table;
}

const Table& added_mass_keys() {
    static const Table table = [] {
        Keys<Hydrodynamics> k("added_mass");
        k.number("constant", &Hydrodynamics::added_mass_frequency, frequency,
                 "Frequency at which added mass and radiation damping are taken, both constant")
            .or_word("auto")
            .follows("the spectral peak; in still water the frequency must be given")
            .above(0)
            .eg("0.4 rad/s");
        k.map("convolution", &Hydrodynamics::memory, memory_keys,
              "Radiation with memory, from all frequencies of the database, instead of constant "
              "matrices (footnote 3 of the paper)");
        k.rule(KeyRule::Count::at_most_one, {"constant", "convolution"});
        return k.done();
    }();
    return table;
}

const Table& hydrodynamics_keys() {
    static const Table table = [] {
        Keys<Hydrodynamics> k("hydrodynamics");
        k.map("database", &Hydrodynamics::database, database_keys,
              "Coefficients from a diffraction program");
        k.map("matrix", &Hydrodynamics::matrix, matrix_keys,
              "Constant matrices, for a platform with no database");
        k.group("added_mass", added_mass_keys, "Added mass and radiation damping");
        k.choice("drift", &Hydrodynamics::drift,
                 std::vector<std::pair<std::string, Drift>>{{"none", Drift::none},
                                                            {"mean", Drift::mean},
                                                            {"newman", Drift::newman},
                                                            {"full_qtf", Drift::full_qtf}},
                 "Second-order wave forces: none, mean drift alone, slow drift by Newman's "
                 "approximation, or difference and sum frequencies from full QTFs")
            .later_words({"table"})
            .def("none");
        k.choice("wave_phase", &Hydrodynamics::wave_phase,
                 std::vector<std::pair<std::string, WavePhase>>{
                     {"slow", WavePhase::slow}, {"instantaneous", WavePhase::instantaneous}},
                 "Position at which first-order excitation takes its phase: low-pass filtered, or "
                 "that of the moment")
            .follows("slow if there is drift, else instantaneous")
            .eg("slow");
        k.number("slow_cutoff", &Hydrodynamics::slow_cutoff, frequency,
                 "Cut-off frequency of that filter")
            .or_word("auto")
            .follows("a quarter of the spectral peak")
            .above(0)
            .eg("0.1 rad/s");
        k.rule(KeyRule::Count::at_most_one, {"database", "matrix"});
        return k.done();
    }();
    return table;
}

const Table& member_keys() {
    static const Table table = [] {
        Keys<Member> k("members");
        k.text("name", &Member::name, "Name for messages").required().eg("hard tank");
        k.vector("from", &Member::from, {length}, "One end of the cylinder, on platform axes")
            .required()
            .eg("[0, 0, 19 m]");
        k.vector("to", &Member::to, {length}, "The other end").required().eg("[0, 0, -70 m]");
        k.number("diameter", &Member::diameter, length, "Drag width")
            .required()
            .above(0)
            .eg("40 m");
        k.number("Cd", &Member::Cd, dimension::number, "Normal drag on diameter x wetted length")
            .required()
            .at_least(0)
            .eg("1.2");
        k.number("axial_Cd", &Member::axial_Cd, dimension::number,
                 "Skin drag on diameter x wetted length")
            .def("0")
            .at_least(0);
        Key& ends = k.custom(
            "end_Cd", Form::numbers, {dimension::number},
            "Drag of the end faces on pi D^2/4, [at from, at to] or one number for both",
            [](Member& m, const Value& v) {
                const auto& cd = std::get<std::vector<double>>(v);
                m.end_Cd_from = cd.front();
                m.end_Cd_to = cd.back();
            },
            [](const Member& m) -> Value {
                return std::vector<double>{m.end_Cd_from, m.end_Cd_to};
            });
        ends.most = 2;
        ends.def("[0, 0]").at_least(0);
        k.flag("inertia", &Member::inertia,
               "Do Froude-Krylov force and added mass act? false for what the database contains")
            .follows("true; false with a database")
            .eg("false");
        k.number("displaced_area", &Member::displaced_area, area,
                 "Section that displaces water: buoyancy, Froude-Krylov and Ca refer to it")
            .follows("pi D^2/4; 0 where inertia is false")
            .at_least(0)
            .eg("7.77 m2");
        k.number("Ca", &Member::Ca, dimension::number, "Added mass coefficient on displaced_area")
            .def("1")
            .at_least(0);
        k.flag("waves_in_drag", &Member::waves_in_drag,
               "false: the drag sees current and hull motion only")
            .def("true");
        k.flag("current", &Member::current, "Does the drag see the current?").def("true");
        return k.done();
    }();
    return table;
}

const Table& plate_keys() {
    static const Table table = [] {
        Keys<PlateKeys> k("plates");
        k.text("name", &PlateKeys::name, "Name for messages").required().eg("heave plates");
        Key& z = k.custom(
            "z", Form::numbers, {length},
            "Height on the platform's axis; a list makes one plate each",
            [](PlateKeys& p, const Value& v) { p.z = std::get<std::vector<double>>(v); },
            [](const PlateKeys& p) -> Value {
                if (p.z.empty()) return {};
                return p.z;
            });
        z.most = 100;
        z.eg("[-95 m, -115 m, -135 m]");
        k.vector("position", &PlateKeys::position, {length}, "Centre of the plate, instead of z")
            .eg("[0, 0, -95 m]");
        k.vector("normal", &PlateKeys::normal, {dimension::number}, "Direction of the normal")
            .def("[0, 0, 1]");
        k.number("area", &PlateKeys::area, dimension::area, "Area of one plate")
            .required()
            .above(0)
            .eg("900 m2");
        k.number("Cd", &PlateKeys::Cd, dimension::number, "Drag coefficient along the normal")
            .required()
            .at_least(0)
            .eg("5");
        k.number("added_mass", &PlateKeys::added_mass, mass,
                 "Added mass of one plate along the normal")
            .required()
            .at_least(0)
            .eg("13000 t");
        k.rule(KeyRule::Count::exactly_one, {"z", "position"});
        return k.done();
    }();
    return table;
}

/// Six numbers by the names of the modes: metres (a speed) for three, angles (their rate) for
/// three.
void mode_numbers(Keys<PlatformMotion>& k, Vec3 PlatformMotion::*linear,
                  Vec3 PlatformMotion::*angular, const Dimension& of_linear,
                  const Dimension& of_angular, const std::string& sentence) {
    static constexpr std::array modes{"surge", "sway", "heave", "roll", "pitch", "yaw"};
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Dimension& d = i < 3 ? of_linear : of_angular;
        Vec3 PlatformMotion::*const member = i < 3 ? linear : angular;
        const std::string mode = modes[static_cast<std::size_t>(i)];
        k.number(
             mode, [i, member](PlatformMotion& m) -> double& { return (m.*member)[i % 3]; }, d,
             sentence + mode)
            .def("0 " + std::string(d.unit));
    }
}

const Table& velocity_keys() {
    static const Table table = [] {
        Keys<PlatformMotion> k("velocity");
        mode_numbers(k, &PlatformMotion::velocity, &PlatformMotion::angle_rates, speed,
                     angular_speed, "Rate at the start of ");
        return k.done();
    }();
    return table;
}

const Table& initial_keys() {
    static const Table table = [] {
        Keys<PlatformMotion> k("initial");
        mode_numbers(k, &PlatformMotion::position, &PlatformMotion::angles, length, angle,
                     "Added to the static ");
        k.group("velocity", velocity_keys, "Rates at the start");
        return k.done();
    }();
    return table;
}

const Table& gyration_keys() {
    static const Table table = [] {
        Keys<Vec3> k("radii_of_gyration");
        static constexpr std::array modes{"roll", "pitch", "yaw"};
        for (Eigen::Index i = 0; i < 3; ++i) {
            const std::string mode = modes[static_cast<std::size_t>(i)];
            k.number(
                 mode, [i](Vec3& r) -> double& { return r[i]; }, length,
                 "Radius of gyration in " + mode)
                .required()
                .above(0)
                .eg("83 m");
        }
        return k.done();
    }();
    return table;
}

const Table& wind_area_keys() {
    static const Table table = [] {
        Keys<WindArea> k("wind");
        k.number("area", &WindArea::area, dimension::area, "Projected area")
            .required()
            .at_least(0)
            .eg("2500 m2");
        k.number("centre_height", &WindArea::centre_height, length,
                 "Height of its centre above the reference point")
            .required()
            .above(0)
            .eg("45 m");
        k.number("Cs", &WindArea::Cs, dimension::number, "Shape coefficient")
            .required()
            .at_least(0)
            .eg("1.0");
        return k.done();
    }();
    return table;
}

const Table& damping_keys() {
    static const Table table = [] {
        Keys<Platform> k("damping");
        k.modes(
             "linear", &Platform::linear_damping,
             blocks(dimension::damping, force_per_angular_speed, axial_damping, rotational_damping),
             "Linear damping about the reference point, per mode or 6 rows of 6")
            .eg("{yaw: 2.0e8 N.m.s/rad}");
        k.modes("quadratic", &Platform::quadratic_damping,
                blocks(quadratic_damping, quadratic_cross_force, quadratic_cross_moment,
                       quadratic_rotational_damping),
                "Quadratic damping F_i = -sum_j B_ij |v_j| v_j, per mode or 6 rows of 6")
            .eg("{heave: 200 kN.s2/m2}");
        return k.done();
    }();
    return table;
}

}  // namespace

const Table& platform_keys() {
    static const Table table = [] {
        Keys<PlatformKeys> k("platform");
        k.text("name", &Platform::name, "Name in result paths and in end_a.platform")
            .def("platform")
            .eg("spar");
        k.number("mass", &Platform::mass, mass,
                 "Mass; auto: (acting buoyancy - static line loads)/g, floats at its design draft")
            .or_word("auto")
            .required()
            .above(0)
            .eg("auto");
        k.number("displacement", &Platform::displacement, mass,
                 "What the displacement is believed to be; compared with the acting buoyancy, "
                 "never acts")
            .above(0)
            .eg("103800 t");
        k.number("draft", &Platform::draft, length, "Keel below the reference point")
            .follows("lowest member")
            .at_least(0)
            .eg("175 m");
        k.vector("centre_of_gravity", &Platform::centre_of_gravity, {length},
                 "Centre of gravity, on platform axes")
            .required()
            .eg("[0, 0, -66 m]");
        k.map("radii_of_gyration", &PlatformKeys::gyration, gyration_keys,
              "Radii of gyration about the centre of gravity");
        k.matrix("inertia", &Platform::inertia, 3, std::vector<Dimension>(9, dimension::inertia),
                 "Moments of inertia about the centre of gravity, 3 rows of 3, instead of radii");
        k.map("initial", &Platform::initial, initial_keys,
              "Added to the static position at the start");
        k.map("hydrodynamics", &Platform::hydrodynamics, hydrodynamics_keys,
              "Potential-flow loads");
        k.list("members", &Platform::members, member_keys, "Cylinders with Morison loads");
        k.list("plates", &PlatformKeys::plate_groups, plate_keys,
               "Heave plates: drag and added mass along the normal");
        k.map("wind", &Platform::wind, wind_area_keys, "Wind load of the topsides");
        k.group("damping", damping_keys, "Damping given by hand");
        k.later("current_coefficients", "Current load coefficients by heading");
        k.later("fixed_modes", "Modes that are held");
        k.later("prescribed_motion", "Motion by time history or harmonic");
        k.rule(KeyRule::Count::exactly_one, {"radii_of_gyration", "inertia"});
        return k.done();
    }();
    return table;
}

}  // namespace hawser
