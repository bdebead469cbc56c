#include "case/platform.hpp"

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;

constexpr std::array mode_words{"surge", "sway", "heave", "roll", "pitch", "yaw"};

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
            .follows(
                "the fewest that fit the database within 0.5 %, or else within a tenth of the "
                "best of 12 (fewer with few frequencies); the summary tells the error")
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
        k.choice(
             "wave_phase", &Hydrodynamics::wave_phase,
             std::vector<std::pair<std::string, WavePhase>>{
                 {"slow", WavePhase::slow}, {"instantaneous", WavePhase::instantaneous}},
             "Position at which first-order excitation takes its phase: low-pass filtered, or "
             "that of the moment, which gives the force of a hull that follows the waves a mean "
             "of its own, of the size of the mean drift")
            .def("slow");
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

/// One number, or that of each end.
std::vector<double> ends_of(double from, const std::optional<double>& to) {
    if (to) return {from, *to};
    return {from};
}

const Table& member_keys() {
    static const Table table = [] {
        Keys<Member> k("members");
        k.text("name", &Member::name, "Name for messages").required().eg("hard tank");
        k.vector("from", &Member::from, {length}, "One end of the cylinder, on platform axes")
            .required()
            .eg("[0, 0, 19 m]");
        k.vector("to", &Member::to, {length}, "The other end").required().eg("[0, 0, -70 m]");
        Key& width = k.custom(
            "diameter", Form::numbers, {length}, "Drag width; of a tapered member [at from, at to]",
            [](Member& m, const Value& v) {
                const auto& d = std::get<std::vector<double>>(v);
                m.diameter = d.front();
                if (d.size() > 1) m.diameter_to = d.back();
            },
            [](const Member& m) -> Value { return ends_of(m.diameter, m.diameter_to); });
        width.most = 2;
        width.required().above(0).eg("40 m");
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
        Key& section = k.custom(
            "displaced_area", Form::numbers, {area},
            "Section that displaces water: buoyancy, Froude-Krylov and Ca refer to it; of a "
            "tapered "
            "member [at from, at to]",
            [](Member& m, const Value& v) {
                const auto& a = std::get<std::vector<double>>(v);
                m.displaced_area = a.front();
                if (a.size() > 1) m.displaced_area_to = a.back();
            },
            [](const Member& m) -> Value {
                return ends_of(m.displaced_area, m.displaced_area_to);
            });
        section.most = 2;
        section.follows("pi D^2/4; 0 where inertia is false").at_least(0).eg("7.77 m2");
        k.number("Ca", &Member::Ca, dimension::number, "Added mass coefficient on displaced_area")
            .def("1")
            .at_least(0);
        k.number("axial_Ca", &Member::axial_Ca, dimension::number,
                 "Added mass coefficient along the axis, on displaced_area")
            .def("0")
            .at_least(0);
        Key& faces = k.custom(
            "end_Ca", Form::numbers, {dimension::number},
            "Added mass of the end faces along the axis on 2/3 pi r^3, [at from, at to] or one "
            "number for both; a flat face has 0.64",
            [](Member& m, const Value& v) {
                const auto& ca = std::get<std::vector<double>>(v);
                m.end_Ca_from = ca.front();
                m.end_Ca_to = ca.back();
            },
            [](const Member& m) -> Value {
                return std::vector<double>{m.end_Ca_from, m.end_Ca_to};
            });
        faces.most = 2;
        faces.def("[0, 0]").at_least(0);
        k.flag(
             "flooded", &Member::flooded,
             "Free-flooding: the water inside moves with the member, and its inside is no buoyancy")
            .def("false");
        k.flag("waves_in_drag", &Member::waves_in_drag,
               "false: the drag sees current and hull motion only")
            .def("true");
        k.flag(
             "current", &Member::current,
             "Does the drag see the current? Must be false beside current_coefficients, which hold "
             "it")
            .def("true");
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

/// Coefficients by heading.
template <class T>
void heading_rows(Keys<T>& k, HeadingTable T::*table, const std::string& sentence) {
    Key& rows = k.custom(
        "coefficients", Form::rows,
        {angle, dimension::number, dimension::number, dimension::number}, sentence,
        [table](T& object, const Value& v) {
            (object.*table).clear();
            for (const auto& row : std::get<std::vector<std::vector<double>>>(v))
                (object.*table).push_back({row[0], row[1], row[2], row[3]});
        },
        [table](const T& object) -> Value {
            if ((object.*table).empty()) return {};
            std::vector<std::vector<double>> out;
            for (const auto& row : object.*table) out.emplace_back(row.begin(), row.end());
            return out;
        });
    rows.fewest = rows.most = 4;
    rows.eg("[[0 deg, 0.7, 0, 0], [90 deg, 0, 0.9, 0.05], [180 deg, -0.7, 0, 0]]");
}

const Table& current_coefficient_keys() {
    static const Table table = [] {
        Keys<CurrentCoefficients> k("current_coefficients");
        k.number("draft", &CurrentCoefficients::draft, length, "Reference draft")
            .required()
            .above(0)
            .eg("20 m");
        k.number("length", &CurrentCoefficients::length, length,
                 "Reference length: forces on draft x length, the yaw moment on draft x length^2")
            .required()
            .above(0)
            .eg("100 m");
        k.number("depth", &CurrentCoefficients::depth, length,
                 "Depth below the reference point at which the current is taken and the force acts")
            .follows("half the draft")
            .at_least(0)
            .eg("10 m");
        heading_rows(
            k, &CurrentCoefficients::coefficients,
            "Rows of heading, Cx, Cy, Cyaw: heading of the current against that of the "
            "platform, 0 from astern, 90 deg towards port, 180 deg from ahead (OCIMF's); 0 "
            "to 180 deg are mirrored, else 0 to 360");
        return k.done();
    }();
    return table;
}

const Table& stiffness_keys() {
    static const Table table = [] {
        Keys<Platform> k("stiffness");
        k.modes("linear", &Platform::stiffness,
                blocks(dimension::stiffness, force_per_angle, force, rotational_stiffness),
                "Linear stiffness about the design position, per mode or 6 rows of 6")
            .eg("{yaw: 98.34 MN.m/rad}");
        k.choice("axes", &Platform::stiffness_turns,
                 std::vector<std::pair<std::string, bool>>{{"earth", false}, {"yaw", true}},
                 "Axes of the displacement and the force: those of the world, or such that turn "
                 "with yaw")
            .def("earth");
        return k.done();
    }();
    return table;
}

const Table& force_keys() {
    static const Table table = [] {
        Keys<AppliedForce> k("forces");
        k.text("name", &AppliedForce::name, "Name for messages").required().eg("thruster");
        Key& push = k.vector("force", &AppliedForce::force, {dimension::force}, "Force");
        push.follows("none").eg("[500 kN, 0, 0]");
        Key& twist = k.vector("moment", &AppliedForce::moment, {dimension::moment}, "Moment");
        twist.follows("none").eg("[0, 0, 20 MN.m]");
        k.vector("position", &AppliedForce::position, {length},
                 "Point at which the force acts, on platform axes")
            .def("[0, 0, 0]");
        k.choice(
             "axes", &AppliedForce::on_platform_axes,
             std::vector<std::pair<std::string, bool>>{{"earth", false}, {"platform", true}},
             "Axes of force and moment: those of the world, or such that turn with the platform")
            .def("earth");
        k.points(
             "factor", &AppliedForce::factor, {time, dimension::number},
             "Rows of time and factor on both, straight between and constant outside: steps and "
             "ramps; the static start has that of t = 0")
            .eg("[[0 s, 0], [100 s, 1]]");
        k.number("period", &AppliedForce::period, time,
                 "Harmonic: times cos(2 pi t/period + phase) and the run's ramp, not in the static "
                 "start")
            .above(0)
            .eg("12 s");
        k.number("phase", &AppliedForce::phase, angle, "Phase of the cosine").def("0 deg");
        k.path(
             "file", &AppliedForce::path,
             "Instead of force and moment: a text file of rows t, Fx, Fy, Fz, Mx, My, Mz in s, N, "
             "N.m, straight between; relative to this file")
            .eg("thruster.txt");
        k.rule(KeyRule::Count::at_least_one, {"force", "moment", "file"});
        return k.done();
    }();
    return table;
}

template <int mode>
const Table& motion_keys() {
    static const Table table = [] {
        Keys<HarmonicMotion> k("motion");
        const Dimension& d = mode < 3 ? length : angle;
        const std::string zero = std::string("0 ") + std::string(d.unit);
        k.number("mean", &HarmonicMotion::mean, d, "Mean place").def(zero);
        k.number("amplitude", &HarmonicMotion::amplitude, d, "Amplitude, brought in by the ramp")
            .required()
            .eg(mode < 3 ? "5 m" : "3 deg");
        k.number("period", &HarmonicMotion::period, time, "Period").required().above(0).eg("12 s");
        k.number("phase", &HarmonicMotion::phase, angle, "Phase of the sine").def("0 deg");
        return k.done();
    }();
    return table;
}

const Table& prescribed_keys() {
    static const Table table = [] {
        Keys<PrescribedMotion> k("prescribed_motion");
        const auto mode = [&k](std::size_t i, const char* name, const Table& (*of_mode)()) {
            k.map(
                name,
                [i](PrescribedMotion& m) -> std::optional<HarmonicMotion>& {
                    return m.harmonic[i];
                },
                of_mode, std::string("Harmonic motion in ") + name);
        };
        mode(0, "surge", motion_keys<0>);
        mode(1, "sway", motion_keys<1>);
        mode(2, "heave", motion_keys<2>);
        mode(3, "roll", motion_keys<3>);
        mode(4, "pitch", motion_keys<4>);
        mode(5, "yaw", motion_keys<5>);
        k.path(
             "file", &PrescribedMotion::path,
             "Instead of harmonics: a text file of rows t, surge, sway, heave, roll, pitch, yaw in "
             "s, m, deg, joined by a spline with continuous acceleration; relative to this file")
            .eg("motion.txt");
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
        Key& shape = k.number("Cs", &WindArea::Cs, dimension::number,
                              "Shape coefficient, the same for every heading");
        shape.at_least(0).eg("1.0");
        shape.get = [](const void* object) -> Value {
            const auto& w = *static_cast<const WindArea*>(object);
            if (!w.coefficients.empty()) return {};
            return w.Cs;
        };
        k.number("side_area", &WindArea::side_area, dimension::area,
                 "Area of Cy and Cyaw; `area` is that of Cx")
            .follows("as area")
            .above(0)
            .eg("4000 m2");
        k.number("length", &WindArea::length, length, "Length of Cyaw").def("0 m").at_least(0);
        heading_rows(
            k, &WindArea::coefficients,
            "Instead of Cs, rows of heading, Cx, Cy, Cyaw: heading of the wind against that "
            "of the platform, 0 from astern, 90 deg towards port, 180 deg from ahead "
            "(OCIMF's); 0 to 180 deg are mirrored, else 0 to 360");
        k.rule(KeyRule::Count::exactly_one, {"Cs", "coefficients"});
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

namespace {

Table table_of_platform(bool named) {
    Keys<PlatformKeys> k("platform");
    if (!named)
        k.text("name", &Platform::name, "Name in result paths and in end_a.platform")
            .def("platform")
            .eg("spar");
    Key& place = k.custom(
        "position", Form::numbers, {length},
        "x and y of the reference point where the platform is designed to be; its surge and "
        "sway are displacements from there",
        [](PlatformKeys& p, const Value& v) {
            const auto& xy = std::get<std::vector<double>>(v);
            p.position = {xy[0], xy[1], 0.0};
        },
        [](const PlatformKeys& p) -> Value {
            return std::vector<double>{p.position.x(), p.position.y()};
        });
    place.fewest = place.most = 2;
    place.def("[0 m, 0 m]");
    Key& mass_key =
        k.number("mass", &Platform::mass, mass,
                 "Mass; auto: (acting buoyancy - static line loads)/g, floats at its design draft");
    mass_key.or_word("auto")
        .follows("0 with prescribed_motion, else required")
        .at_least(0)
        .eg("auto");
    mass_key.get = [](const void* object) -> Value {
        const std::optional<double>& given = static_cast<const PlatformKeys*>(object)->mass;
        if (given) return *given;
        return std::string("auto");
    };
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
        .follows("the origin; required without prescribed_motion")
        .eg("[0, 0, -66 m]");
    k.map("radii_of_gyration", &PlatformKeys::gyration, gyration_keys,
          "Radii of gyration about the centre of gravity");
    k.matrix("inertia", &Platform::inertia, 3, std::vector<Dimension>(9, dimension::inertia),
             "Moments of inertia about the centre of gravity, 3 rows of 3, instead of radii");
    k.map("initial", &Platform::initial, initial_keys, "Added to the static position at the start");
    k.map("hydrodynamics", &Platform::hydrodynamics, hydrodynamics_keys, "Potential-flow loads");
    k.list("members", &Platform::members, member_keys, "Cylinders with Morison loads");
    k.list("plates", &PlatformKeys::plate_groups, plate_keys,
           "Heave plates: drag and added mass along the normal");
    k.map("wind", &Platform::wind, wind_area_keys, "Wind load of the topsides");
    k.group("damping", damping_keys, "Damping given by hand");
    k.group("stiffness", stiffness_keys, "Stiffness given by hand");
    k.list("forces", &Platform::forces, force_keys, "Forces given by hand, constant or in time");
    k.map("current_coefficients", &Platform::current_coefficients, current_coefficient_keys,
          "Load of the current on the whole hull by heading (OCIMF's form), instead of that on "
          "members");
    Key& fixed = k.custom(
        "fixed_modes", Form::words, {},
        "Motions that are held where `initial` puts them; the force that holds them is "
        "recorded",
        [](PlatformKeys& p, const Value& v) {
            p.fixed.fill(false);
            for (const std::string& word : std::get<std::vector<std::string>>(v))
                for (std::size_t i = 0; i < 6; ++i)
                    if (word == mode_words[i]) p.fixed[i] = true;
        },
        [](const PlatformKeys& p) -> Value {
            std::vector<std::string> words;
            for (std::size_t i = 0; i < 6; ++i)
                if (p.fixed[i]) words.emplace_back(mode_words[i]);
            if (words.empty()) return {};
            return words;
        });
    fixed.choices.assign(mode_words.begin(), mode_words.end());
    fixed.eg("[heave, roll, pitch]");
    k.map("prescribed_motion", &Platform::prescribed, prescribed_keys,
          "The platform goes as told, for studies of lines alone; motions left out are held");
    k.rule(KeyRule::Count::at_most_one, {"radii_of_gyration", "inertia"});
    return k.done();
}

}  // namespace

const Table& platform_keys() {
    static const Table table = table_of_platform(false);
    return table;
}

const Table& named_platform_keys() {
    static const Table table = table_of_platform(true);
    return table;
}

}  // namespace hawser
