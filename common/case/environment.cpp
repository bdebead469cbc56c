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

/// Types whose components are drawn from a spectrum, with seed.
const std::vector<std::string> random_types{"jonswap",      "pierson_moskowitz", "ochi_hubble",
                                            "torsethaugen", "white_noise",       "spectrum_file"};
/// Those of them with a peak that stands in the case.
const std::vector<std::string> peaked_types{"jonswap", "pierson_moskowitz", "ochi_hubble",
                                            "torsethaugen"};

const Table& spreading_keys() {
    static const Table table = [] {
        Keys<Spreading> k("spreading");
        k.only("type", "cos2s", {},
               "cos^2s of half the angle from the heading, over the whole circle (s = 1: half the "
               "energy within 65 deg; large s: narrow)");
        k.number("s", &Spreading::s, number, "Exponent s; the mean cosine is s/(s + 1)")
            .required()
            .above(0)
            .at_most(1000)
            .eg("8");
        k.integer("directions", &Spreading::directions,
                  "Directions of equal energy; every run of so many components by frequency has "
                  "each of them once")
            .def("10")
            .at_least(1)
            .at_most(1000);
        return k.done();
    }();
    return table;
}

Value rows_of(const std::vector<std::array<double, 2>>& points) {
    if (points.empty()) return {};
    return keys_detail::rows_of(points);
}

/// The keys of a train that are tables or come from files.
void add_tables(Keys<WaveTrain>& k) {
    k.path("file", &WaveTrain::file,
           "Text file of two columns, lines that start with a letter or # are skipped: frequency "
           "and density of spectrum_file; time and elevation at equal intervals of elevation_file")
        .only_with("type", {"spectrum_file", "elevation_file"})
        .eg("buoy.txt");
    k.choice("file_frequency", &WaveTrain::file_in_hertz,
             std::vector<std::pair<std::string, bool>>{{"rad/s", false}, {"Hz", true}},
             "Units of a spectrum's file: rad/s and m2.s/rad, or Hz and m2/Hz")
        .only_with("type", {"spectrum_file"})
        .def("rad/s");
    using Points = std::vector<std::array<double, 2>>;
    const auto points = [&k](const char* name, Points WaveTrain::*member, std::vector<Dimension> d,
                             const char* type, const char* sentence) -> Key& {
        Key& key = k.custom(
            name, Form::rows, std::move(d), sentence,
            [member](WaveTrain& w, const Value& v) { w.*member = keys_detail::curve_of(v); },
            [member](const WaveTrain& w) { return rows_of(w.*member); });
        key.fewest = key.most = 2;
        return key.only_with("type", {type});
    };
    points("spectrum", &WaveTrain::spectrum, {frequency, wave_density}, "spectrum_file",
           "In place of a file: rows of frequency and one-sided density, linear between, 0 outside")
        .eg("[[0.3 rad/s, 0 m2.s/rad], [0.5 rad/s, 8 m2.s/rad], [1.2 rad/s, 0 m2.s/rad]]");
    points("record", &WaveTrain::record, {dimension::time, length}, "elevation_file",
           "In place of a file: rows of time and elevation, at equal intervals")
        .eg("[[0 s, 0 m], [0.5 s, 0.4 m], [1 s, 0.1 m]]");
    Key& at = k.custom(
        "measured_at", Form::numbers, {length}, "x and y where the elevation was measured",
        [](WaveTrain& w, const Value& v) {
            const auto& place = std::get<std::vector<double>>(v);
            w.record_x = place[0];
            w.record_y = place[1];
        },
        [](const WaveTrain& w) -> Value {
            return std::vector<double>{w.record_x, w.record_y};
        });
    at.fewest = at.most = 2;
    at.only_with("type", {"elevation_file"}).def("[0 m, 0 m]");
    Key& list = k.custom(
        "list", Form::rows, {frequency, length, angle, angle},
        "Rows of frequency, amplitude, phase and, if it is another, heading",
        [](WaveTrain& w, const Value& v) {
            w.list.clear();
            for (const auto& row : std::get<std::vector<std::vector<double>>>(v)) {
                ListedWave& wave = w.list.emplace_back();
                wave = {.frequency = row[0], .amplitude = row[1], .phase = row[2], .heading = {}};
                if (row.size() > 3) wave.heading = row[3];
            }
        },
        [](const WaveTrain& w) -> Value {
            if (w.list.empty()) return {};
            std::vector<std::vector<double>> rows;
            for (const ListedWave& wave : w.list) {
                rows.push_back({wave.frequency, wave.amplitude, wave.phase});
                if (wave.heading) rows.back().push_back(*wave.heading);
            }
            return rows;
        });
    list.fewest = 3;
    list.most = 4;
    list.needed_with("type", {"components"})
        .eg("[[0.5 rad/s, 1 m, 0 deg], [0.8 rad/s, 0.4 m, 90 deg, 30 deg]]");
}

const Table& wave_keys() {
    static const Table table = [] {
        Keys<WaveTrain> k("waves");
        k.choice("type", &WaveTrain::type,
                 std::vector<std::pair<std::string, WaveType>>{
                     {"airy", WaveType::airy},
                     {"jonswap", WaveType::jonswap},
                     {"pierson_moskowitz", WaveType::pierson_moskowitz},
                     {"ochi_hubble", WaveType::ochi_hubble},
                     {"torsethaugen", WaveType::torsethaugen},
                     {"white_noise", WaveType::white_noise},
                     {"spectrum_file", WaveType::spectrum_file},
                     {"elevation_file", WaveType::elevation_file},
                     {"components", WaveType::components}},
                 "Kind of wave: one regular wave (airy), a spectrum, a measured elevation, or a "
                 "list of components")
            .eg("jonswap")
            .required();
        k.number("Hs", &WaveTrain::Hs, length, "Significant wave height of a spectrum")
            .needed_with("type", {"jonswap", "pierson_moskowitz", "ochi_hubble", "torsethaugen",
                                  "white_noise"})
            .above(0)
            .eg("15.2 m");
        k.number("Tp", &WaveTrain::Tp, dimension::time, "Peak period of a spectrum")
            .needed_with("type", {"jonswap", "pierson_moskowitz", "torsethaugen"})
            .above(0)
            .eg("15.6 s");
        k.number("gamma", &WaveTrain::gamma, dimension::number, "Peak enhancement of jonswap")
            .or_word("auto")
            .follows("rule of DNV-RP-C205 from Tp/sqrt(Hs)")
            .only_with("type", {"jonswap"})
            .at_least(1)
            .at_most(10)
            .eg("2.4");
        Key& humps = k.custom(
            "humps", Form::rows, {length, dimension::time, dimension::number},
            "Hs, Tp and shape lambda of the two humps of ochi_hubble, swell first",
            [](WaveTrain& w, const Value& v) {
                w.humps.clear();
                for (const auto& row : std::get<std::vector<std::vector<double>>>(v))
                    w.humps.push_back({.Hs = row[0], .Tp = row[1], .lambda = row[2]});
            },
            [](const WaveTrain& w) -> Value {
                if (w.humps.empty()) return {};
                std::vector<std::vector<double>> rows;
                for (const SpectrumHump& h : w.humps) rows.push_back({h.Hs, h.Tp, h.lambda});
                return rows;
            });
        humps.fewest = humps.most = 3;
        humps.only_with("type", {"ochi_hubble"})
            .follows("the most probable of the family of Ochi and Hubble for this Hs")
            .above(0)
            .eg("[[4 m, 15 s, 3], [3 m, 8 s, 1]]");
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
        add_tables(k);
        k.number("heading", &WaveTrain::heading, angle,
                 "Direction the waves travel towards, counter-clockwise from +x; of a spread sea "
                 "the mean")
            .required()
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        k.map("spreading", &WaveTrain::spreading, spreading_keys,
              "Directional spreading of a spectrum; absent: long-crested")
            .only_with("type", random_types);
        k.integer("seed", &WaveTrain::seed, "Seed of the random phases, frequencies and directions")
            .needed_with("type", random_types)
            .at_least(0)
            .eg("1");
        k.integer("components", &WaveTrain::components, "Number of wave components of a spectrum")
            .only_with("type", random_types)
            .def("100")
            .at_least(1)
            .at_most(100000);
        k.choice("discretisation", &WaveTrain::discretisation,
                 std::vector<std::pair<std::string, Discretisation>>{
                     {"equal_energy", Discretisation::equal_energy},
                     {"equal_frequency_random", Discretisation::equal_frequency_random}},
                 "How a spectrum is cut into components: bins of equal energy, or one random "
                 "frequency in each of equal bins (always so in white_noise)")
            .only_with("type", random_types)
            .def("equal_energy");
        Key& range = k.custom(
            "range", Form::numbers, {dimension::number},
            "Lowest and highest frequency of a spectrum, as multiples of the peak (of two peaks: "
            "the lowest of the lower, the highest of the higher)",
            [](WaveTrain& w, const Value& v) {
                const auto& ends = std::get<std::vector<double>>(v);
                w.range_min = ends[0];
                w.range_max = ends[1];
            },
            [](const WaveTrain& w) -> Value {
                return std::vector<double>{w.range_min, w.range_max};
            });
        range.fewest = range.most = 2;
        range.only_with("type", peaked_types).def("[0.5, 5]").above(0);
        Key& band = k.custom(
            "band", Form::numbers, {frequency},
            "Lowest and highest frequency of white noise, or of what is kept of a measured "
            "elevation",
            [](WaveTrain& w, const Value& v) {
                const auto& ends = std::get<std::vector<double>>(v);
                w.band_min = ends[0];
                w.band_max = ends[1];
            },
            [](const WaveTrain& w) -> Value {
                if (w.band_max == 0.0) return {};
                return std::vector<double>{w.band_min, w.band_max};
            });
        band.fewest = band.most = 2;
        band.needed_with("type", {"white_noise", "elevation_file"})
            .above(0)
            .eg("[0.2 rad/s, 2 rad/s]");
        k.choice("stretching", &WaveTrain::stretching,
                 std::vector<std::pair<std::string, Stretching>>{
                     {"none", Stretching::none},
                     {"vertical", Stretching::vertical},
                     {"wheeler", Stretching::wheeler},
                     {"extrapolation", Stretching::extrapolation}},
                 "How wave kinematics reach from mean sea level to the instantaneous surface; the "
                 "same for all trains")
            .def("wheeler");
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
                     {"constant", WindSpectrum::constant},
                     {"npd", WindSpectrum::npd},
                     {"api", WindSpectrum::api},
                     {"kaimal", WindSpectrum::kaimal},
                     {"time_history", WindSpectrum::time_history}},
                 "Steady wind, gusts by a spectrum (npd: ISO 19901-1; api: API RP 2A; kaimal: IEC "
                 "61400), or a measured speed")
            .eg("npd")
            .required();
        k.number("speed", &Wind::speed, dimension::speed,
                 "Mean speed over `averaging` at `reference_height`")
            .needed_with("spectrum", {"constant", "npd", "api", "kaimal"})
            .at_least(0)
            .eg("87.5 knot");
        k.number("averaging", &Wind::averaging, dimension::time, "Averaging time of the speed")
            .only_with("spectrum", {"npd"})
            .def("1 h")
            .above(0)
            .at_most(3600);
        k.number("reference_height", &Wind::reference_height, length,
                 "Height of the speed above mean sea level")
            .only_with("spectrum", {"npd", "api", "kaimal"})
            .def("10 m")
            .above(0);
        k.number("turbulence_intensity", &Wind::turbulence_intensity, number,
                 "Standard deviation of the gusts over the mean speed, at all heights")
            .needed_with("spectrum", {"kaimal"})
            .at_least(0)
            .at_most(1)
            .eg("0.12");
        k.path("file", &Wind::file,
               "Text file of two columns, time in s and speed in m/s; lines before the first row "
               "that do not start with a number are skipped")
            .only_with("spectrum", {"time_history"})
            .eg("wind.txt");
        Key& history = k.custom(
            "history", Form::rows, {dimension::time, dimension::speed},
            "In place of a file: rows of time and speed, linear between, constant outside",
            [](Wind& w, const Value& v) { w.history = keys_detail::curve_of(v); },
            [](const Wind& w) { return rows_of(w.history); });
        history.fewest = history.most = 2;
        history.only_with("spectrum", {"time_history"}).eg("[[0 s, 10 m/s], [60 s, 14 m/s]]");
        k.number("heading", &Wind::heading, angle,
                 "Direction the wind blows towards, counter-clockwise from +x")
            .required()
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        k.integer("seed", &Wind::seed, "Seed of the gusts")
            .needed_with("spectrum", {"npd", "api", "kaimal"})
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
               "Wave trains, which add up (swell, wind sea); none: still water");
        k.map("current", &Environment::current, current_keys, "Current; absent: none");
        k.map("wind", &Environment::wind, wind_keys, "Wind; absent: none");
        return k.done();
    }();
    return table;
}

}  // namespace hawser
