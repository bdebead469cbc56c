#include "case/environment.hpp"

#include <numbers>

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;
constexpr double turn = 2.0 * std::numbers::pi;

const Table& water_keys() {
    static const Table table = [] {
        Keys<Water> k("water");
        k.number("density", &Water::density, density, "Density of the water")
            .def("1025 kg/m3")
            .above(0);
        k.number("gravity", &Water::gravity, acceleration, "Acceleration of gravity")
            .def("9.80665 m/s2")
            .above(0);
        return k.done();
    }();
    return table;
}

const Table& slope_keys() {
    static const Table table = [] {
        Keys<Seabed> k("slope");
        k.number("angle", &Seabed::slope_angle, angle, "Angle of the bed against the horizontal")
            .def("0 deg")
            .at_least(0)
            .at_most(turn / 8)
            .eg("2 deg");
        k.number("direction", &Seabed::slope_direction, angle, "Heading in which the bed rises")
            .def("0 deg")
            .at_least(-turn)
            .at_most(turn);
        return k.done();
    }();
    return table;
}

const Table& friction_keys() {
    static const Table table = [] {
        Keys<Seabed> k("friction");
        k.number("axial", &Seabed::friction_axial, number, "Coefficient along the line")
            .def("0.3")
            .at_least(0)
            .at_most(5);
        k.number("lateral", &Seabed::friction_lateral, number, "Coefficient across the line")
            .def("0.5")
            .at_least(0)
            .at_most(5);
        k.number("mobilisation", &Seabed::friction_mobilisation, length,
                 "Slide after which friction is fully mobilised")
            .def("50 mm")
            .above(0);
        return k.done();
    }();
    return table;
}

const Table& seabed_keys() {
    static const Table table = [] {
        Keys<Seabed> k("seabed");
        k.number("depth", &Seabed::depth, length, "Still-water depth at the origin")
            .required()
            .above(0)
            .eg("1500 m");
        k.number("normal_stiffness", &Seabed::normal_stiffness, stiffness_per_length,
                 "Normal stiffness: force per length of line and penetration (a stiffness per unit "
                 "area times the diameter)")
            .def("100 kN/m2")
            .above(0);
        k.number("damping", &Seabed::damping, damping_per_length,
                 "Normal damping: force per length of line and speed while in contact, never "
                 "pulling")
            .def("10 kN.s/m2")
            .at_least(0);
        k.group("slope", slope_keys, "Slope of the seabed; absent: level");
        k.group("friction", friction_keys,
                "Coulomb friction of lines on the seabed; none in statics");
        return k.done();
    }();
    return table;
}

const Table& wave_keys() {
    static const Table table = [] {
        Keys<WaveTrain> k("waves");
        k.choice("type", &WaveTrain::type,
                 std::vector<std::pair<std::string, WaveType>>{
                     {"airy", WaveType::airy},
                     {"jonswap", WaveType::jonswap},
                     {"pierson_moskowitz", WaveType::pierson_moskowitz}},
                 "Kind of wave: one regular wave (airy) or a spectrum")
            .eg("jonswap")
            .later_words({"ochi_hubble", "torsethaugen", "white_noise", "spectrum_file",
                          "elevation_file", "components"})
            .required();
        k.number("Hs", &WaveTrain::Hs, length, "Significant wave height of a spectrum")
            .needed_with("type", {"jonswap", "pierson_moskowitz"})
            .above(0)
            .eg("15.2 m");
        k.number("Tp", &WaveTrain::Tp, dimension::time, "Peak period of a spectrum")
            .needed_with("type", {"jonswap", "pierson_moskowitz"})
            .above(0)
            .eg("15.6 s");
        k.number("gamma", &WaveTrain::gamma, dimension::number, "Peak enhancement of jonswap")
            .or_word("auto")
            .follows("rule of DNV-RP-C205 from Tp/sqrt(Hs)")
            .only_with("type", {"jonswap"})
            .at_least(1)
            .at_most(10)
            .eg("2.4");
        k.number("H", &WaveTrain::H, length, "Height of a regular wave, trough to crest")
            .needed_with("type", {"airy"})
            .above(0)
            .eg("4 m");
        k.number("T", &WaveTrain::T, dimension::time, "Period of a regular wave")
            .needed_with("type", {"airy"})
            .above(0)
            .eg("10 s");
        k.number("phase", &WaveTrain::phase, angle,
                 "Phase of a regular wave: leads the crest at the origin")
            .def("0 deg")
            .only_with("type", {"airy"});
        k.number("heading", &WaveTrain::heading, angle,
                 "Direction the waves travel towards, counter-clockwise from +x")
            .required()
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        k.integer("seed", &WaveTrain::seed, "Seed of the random phases and frequencies")
            .needed_with("type", {"jonswap", "pierson_moskowitz"})
            .at_least(0)
            .eg("1");
        k.integer("components", &WaveTrain::components, "Number of wave components of a spectrum")
            .only_with("type", {"jonswap", "pierson_moskowitz"})
            .def("100")
            .at_least(1)
            .at_most(100000);
        k.choice("discretisation", &WaveTrain::discretisation,
                 std::vector<std::pair<std::string, Discretisation>>{
                     {"equal_energy", Discretisation::equal_energy},
                     {"equal_frequency_random", Discretisation::equal_frequency_random}},
                 "How a spectrum is cut into components: bins of equal energy, or one random "
                 "frequency in each of equal bins")
            .only_with("type", {"jonswap", "pierson_moskowitz"})
            .def("equal_energy");
        Key& range = k.custom(
            "range", Form::numbers, {dimension::number},
            "Lowest and highest frequency of a spectrum, as multiples of the peak",
            [](WaveTrain& w, const Value& v) {
                const auto& ends = std::get<std::vector<double>>(v);
                w.range_min = ends[0];
                w.range_max = ends[1];
            },
            [](const WaveTrain& w) -> Value {
                return std::vector<double>{w.range_min, w.range_max};
            });
        range.fewest = range.most = 2;
        range.only_with("type", {"jonswap", "pierson_moskowitz"}).def("[0.5, 5]").above(0);
        k.choice("stretching", &WaveTrain::stretching,
                 std::vector<std::pair<std::string, Stretching>>{{"none", Stretching::none},
                                                                 {"wheeler", Stretching::wheeler}},
                 "How wave kinematics reach from mean sea level to the instantaneous surface")
            .later_words({"vertical", "extrapolation"})
            .def("wheeler");
        k.later("spreading", "Directional spreading");
        return k.done();
    }();
    return table;
}

const Table& current_keys() {
    static const Table table = [] {
        Keys<Current> k("current");
        k.number("heading", &Current::heading, angle,
                 "Direction the current flows towards, counter-clockwise from +x")
            .required()
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        Key& profile = k.custom(
            "profile", Form::rows, {length, speed, angle},
            "Rows of depth below mean sea level, speed and, if it turns, heading; linear between, "
            "constant outside",
            [](Current& c, const Value& v) {
                c.profile.clear();
                for (const auto& row : std::get<std::vector<std::vector<double>>>(v)) {
                    CurrentPoint point{.depth = row[0], .speed = row[1], .heading = {}};
                    if (row.size() > 2) point.heading = row[2];
                    c.profile.push_back(point);
                }
            },
            [](const Current& c) -> Value {
                std::vector<std::vector<double>> rows;
                for (const CurrentPoint& p : c.profile) {
                    rows.push_back({p.depth, p.speed});
                    if (p.heading) rows.back().push_back(*p.heading);
                }
                return rows;
            });
        profile.fewest = 2;
        profile.most = 3;
        profile.required().eg("[[0 m, 1.9 m/s], [75 m, 0 m/s]]");
        return k.done();
    }();
    return table;
}

const Table& wind_keys() {
    static const Table table = [] {
        Keys<Wind> k("wind");
        k.choice("spectrum", &Wind::spectrum,
                 std::vector<std::pair<std::string, WindSpectrum>>{
                     {"constant", WindSpectrum::constant}, {"npd", WindSpectrum::npd}},
                 "Steady wind, or gusts by the NPD spectrum of ISO 19901-1")
            .eg("npd")
            .later_words({"api", "kaimal", "time_history"})
            .required();
        k.number("speed", &Wind::speed, dimension::speed,
                 "Mean speed over `averaging` at `reference_height`")
            .required()
            .at_least(0)
            .eg("87.5 knot");
        k.number("averaging", &Wind::averaging, dimension::time, "Averaging time of the speed")
            .only_with("spectrum", {"npd"})
            .def("1 h")
            .above(0)
            .at_most(3600);
        k.number("reference_height", &Wind::reference_height, length,
                 "Height of the speed above mean sea level")
            .only_with("spectrum", {"npd"})
            .def("10 m")
            .above(0);
        k.number("heading", &Wind::heading, angle,
                 "Direction the wind blows towards, counter-clockwise from +x")
            .required()
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        k.integer("seed", &Wind::seed, "Seed of the gusts")
            .needed_with("spectrum", {"npd"})
            .at_least(0)
            .eg("11");
        k.number("density", &Wind::density, dimension::density, "Density of the air")
            .def("1.226 kg/m3")
            .above(0);
        return k.done();
    }();
    return table;
}

}  // namespace

const Table& environment_keys() {
    static const Table table = [] {
        Keys<Environment> k("environment");
        k.map("water", &Environment::water, water_keys, "The water");
        k.map("seabed", &Environment::seabed, seabed_keys, "The seabed").required();
        k.list("waves", &Environment::waves, wave_keys,
               "Wave trains (this version: none or one); none: still water");
        k.map("current", &Environment::current, current_keys, "Current; absent: none");
        k.map("wind", &Environment::wind, wind_keys, "Wind; absent: none");
        return k.done();
    }();
    return table;
}

}  // namespace hawser
