// Defaults of a case that follow from other keys.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "case/declared.hpp"
#include "case/line_type_rules.hpp"
#include "case/wave_rules.hpp"
#include "environment/wave_trains.hpp"
#include "message.hpp"

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double default_elements = 50.0;  // of a line

class Completion {
 public:
    Completion(DeclaredCase& c, const Given& given, Problems& problems)
        : case_(c), given_(given), problems_(problems) {}

    void run() {
        waves();
        current();
        wind();
        platforms();
        for (LineTypeKeys& type : case_.line_types) line_type(type);
        for (LineKeys& line : case_.lines) this->line(line);
        analysis_and_output();
    }

 private:
    bool given(const std::string& path) const { return given_.contains(path); }
    void error(const std::string& path, const std::string& message) {
        problems_.push_back({Severity::error, path, message, {}});
    }
    void note(const std::string& path, const std::string& message) {
        problems_.push_back({Severity::note, path, message, {}});
    }

    void waves() { complete_waves(case_.environment.waves, given_, problems_); }

    void current() {
        if (case_.environment.current) {
            const std::string path = "environment.current.profile";
            const auto& profile = case_.environment.current->profile;
            if (profile.empty() && given(path)) error(path, "expected at least one row");
            for (std::size_t i = 0; i < profile.size(); ++i) {
                if (profile[i].depth < 0.0) {
                    error(fmt::format("{}[{}]", path, i),
                          "depth counts downwards from mean sea level and is not negative");
                }
                if (i > 0 && profile[i].depth <= profile[i - 1].depth) {
                    error(fmt::format("{}[{}]", path, i), "depths must ascend from row to row");
                }
            }
        }
    }

    void wind() {
        if (!case_.environment.wind) return;
        const auto& history = case_.environment.wind->history;
        for (std::size_t i = 1; i < history.size(); ++i)
            if (!(history[i][0] > history[i - 1][0])) {
                error(
                    "environment.wind.history",
                    fmt::format("times must ascend; row {} is at {:.6g} s", i + 1, history[i][0]));
                return;
            }
    }

    /// Coefficients by heading.
    void headings(HeadingTable& table, const std::string& path) {
        constexpr double rounding = 1e-9;
        if (table.empty()) return;
        const double first = table.front()[0], last = table.back()[0];
        for (std::size_t i = 1; i < table.size(); ++i)
            if (table[i][0] <= table[i - 1][0])
                return error(fmt::format("{}[{}]", path, i),
                             "headings must ascend from row to row");
        const bool half = std::abs(last - pi) < rounding, full = std::abs(last - 2 * pi) < rounding;
        if (std::abs(first) > rounding || (!half && !full))
            return error(path, "expected headings from 0 to 180 deg or from 0 to 360 deg");
        const auto odd = [](const auto& row) { return row[2] != 0.0 || row[3] != 0.0; };
        if (half && (odd(table.front()) || odd(table.back())))
            error(path,
                  "headings of 0 to 180 deg are mirrored: Cy and Cyaw must be 0 at both; give 0 to "
                  "360 deg for a hull that is not symmetric");
        for (std::size_t k = 1; full && k < 4; ++k)
            if (table.front()[k] != table.back()[k]) {
                error(path, "the rows of 0 and 360 deg must be alike");
                break;
            }
    }

    void wind(WindArea& w, const std::string& path) {
        headings(w.coefficients, path + ".coefficients");
        if (!w.side_area) w.side_area = w.area;
        for (const auto& row : w.coefficients)
            if (row[3] != 0.0 && w.length == 0.0) {
                error(path + ".length", "required key \"length\" is missing (Cyaw is not 0)");
                break;
            }
    }

    /// Forces given by hand, led motion.
    void histories(PlatformKeys& p) {
        for (std::size_t i = 0; i < p.forces.size(); ++i) {
            const AppliedForce& f = p.forces[i];
            const std::string path = fmt::format("{}.forces[{}]", p.key_path, i);
            if (!f.path.empty() && (f.force || f.moment || f.period || !f.factor.empty()))
                error(path + ".file", "the file has force and moment in time: nothing beside it");
            if (f.period && !f.factor.empty())
                error(path + ".period", "expected one of \"factor\", \"period\"");
            for (std::size_t k = 1; k < f.factor.size(); ++k)
                if (f.factor[k][0] <= f.factor[k - 1][0]) {
                    error(path + ".factor", "times must ascend from row to row");
                    break;
                }
        }
        if (!p.prescribed || p.prescribed->path.empty()) return;
        for (const auto& harmonic : p.prescribed->harmonic)
            if (harmonic) {
                error(p.key_path + ".prescribed_motion.file",
                      "the file has all six motions: no harmonic beside it");
                break;
            }
    }

    /// What a platform needs that moves by itself, and one that is led does not.
    void rigid_body(PlatformKeys& p) {
        if (p.prescribed) {
            if (!given(p.key_path + ".mass")) p.mass = 0.0;
            if (p.fixed != std::array<bool, 6>{})
                error(p.key_path + ".fixed_modes", "every motion is prescribed");
            if (p.initial != PlatformMotion{})
                error(p.key_path + ".initial", "every motion is prescribed");
            return;
        }
        const auto missing = [&](const char* key) {
            error(p.key_path, fmt::format("required key \"{}\" is missing", key));
        };
        if (!given(p.key_path + ".mass")) missing("mass");
        if (!given(p.key_path + ".centre_of_gravity")) missing("centre_of_gravity");
        if (!p.gyration && !p.inertia)
            error(p.key_path, "expected one of \"radii_of_gyration\", \"inertia\"");
        if (p.mass && *p.mass == 0.0) error(p.key_path + ".mass", "expected a value above 0 kg");
        for (std::size_t i = 0; i < 6; ++i) {
            const auto k = static_cast<Eigen::Index>(i % 3);
            const double rate = i < 3 ? p.initial.velocity[k] : p.initial.angle_rates[k];
            if (p.fixed[i] && rate != 0.0)
                error(p.key_path + ".initial.velocity", "a motion of fixed_modes has no velocity");
        }
    }

    /// Names that results and lines can use, places that differ, and each platform for itself.
    void platforms() {
        std::vector<PlatformKeys>& all = case_.platforms;
        if (!all.empty()) case_.platform.reset();  // of both, which is told, these are looked at
        if (all.empty() && given("platforms")) error("platforms", "expected at least one platform");
        if (all.size() > most_platforms)
            error("platforms",
                  fmt::format("{} platforms; at most {} in one case: order and reply between the "
                              "ranks have room for no more",
                              all.size(), most_platforms));
        for (PlatformKeys& p : all) p.key_path = "platforms." + p.name;
        if (case_.platform) {
            name(case_.platform->name, "platform.name");
            platform(*case_.platform);
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            name(all[k].name, all[k].key_path);
            for (std::size_t i = 0; i < k; ++i)
                if ((all[i].position - all[k].position).norm() == 0.0)
                    error(
                        all[k].key_path + (given(all[k].key_path + ".position") ? ".position" : ""),
                        fmt::format("stands where \"{}\" stands; expected a position of its own",
                                    all[i].name));
            platform(all[k]);
        }
    }

    /// A name becomes a group of the result file, a part of the paths of keys and a word of
    /// `platform:` in constraints.
    void name(const std::string& name, const std::string& path) {
        if (name == "seabed") {
            error(path, "\"seabed\" stands for the earth: give the platform another name");
        } else if (name.starts_with("seabed_")) {
            error(path, fmt::format("\"{}\": results keep names that begin with seabed_ for the "
                                    "seabed; give the platform another name",
                                    name));
        } else if (name.empty() || name.front() == ' ' || name.back() == ' ' ||
                   name.find_first_of("/.[]{}*?\"\\") != std::string::npos ||
                   std::any_of(name.begin(), name.end(),
                               [](unsigned char c) { return c < ' ' || c == 0x7f; })) {
            error(path, fmt::format("\"{}\" cannot be a name in result paths; expected letters, "
                                    "digits, _ or -",
                                    name));
        }
    }

    void platform(PlatformKeys& p) {
        rigid_body(p);
        if (p.current_coefficients && !p.current_coefficients->depth)
            p.current_coefficients->depth = 0.5 * p.current_coefficients->draft;
        if (p.current_coefficients)
            headings(p.current_coefficients->coefficients,
                     p.key_path + ".current_coefficients.coefficients");
        if (p.wind) wind(*p.wind, p.key_path + ".wind");
        histories(p);
        Hydrodynamics& hydro = p.hydrodynamics;
        const std::string path = p.key_path + ".hydrodynamics";
        const std::vector<WaveTrain>& trains = case_.environment.waves;
        const std::optional<double> peak = main_peak(trains), longest = lowest_peak(trains);
        if (hydro.memory && !hydro.database)
            error(path + ".added_mass.convolution",
                  "memory of radiation needs a hydrodynamics.database");
        if (hydro.database && !hydro.memory && !hydro.added_mass_frequency) {
            if (!peak) {
                error(path,
                      "in still water the frequency of the added mass must be given: "
                      "added_mass: {constant: 0.3 rad/s}");
            } else if (std::isfinite(*peak) && *peak > 0.0) {
                hydro.added_mass_frequency = peak;
                note(path + ".added_mass.constant",
                     fmt::format("auto: {:.5g} rad/s (spectral peak{})", *peak,
                                 trains.size() > 1 ? " of the largest train" : ""));
            }
        }
        if (!hydro.wave_phase) hydro.wave_phase = WavePhase::slow;
        if (*hydro.wave_phase == WavePhase::slow && !hydro.slow_cutoff && longest &&
            std::isfinite(*longest) && *longest > 0.0) {
            hydro.slow_cutoff = *longest / 4.0;
            note(path + ".slow_cutoff",
                 fmt::format("auto: {:.5g} rad/s (a quarter of the {}spectral peak)",
                             *hydro.slow_cutoff, trains.size() > 1 ? "lowest " : ""));
        }
        if (hydro.database) database(*hydro.database, path + ".database");
        if (hydro.drift != Drift::none && !hydro.database) {
            error(path + ".drift", "drift needs a hydrodynamics.database with drift data");
        }
        for (std::size_t i = 0; i < p.members.size(); ++i) member(p, i);
        if (!p.draft && !p.members.empty()) {
            double lowest = 0.0;
            for (const Member& m : p.members) {
                lowest = std::min({lowest, m.from.z(), m.to.z()});
            }
            p.draft = -lowest;
        }
    }

    void database(const HydroDatabase& d, const std::string& path) {
        const bool wamit = d.format == HydroFormat::wamit, hams = d.format == HydroFormat::hams;
        if (!wamit && !hams) {
            for (const auto& [key, is_there] : {std::pair{".ulen", d.ulen != 1.0},
                                                {".period_column", d.period_column.has_value()},
                                                {".limits", d.limits.has_value()}})
                if (is_there) error(path + key, "only files of wamit and hams have it");
            return;
        }
        const auto missing = [&](const char* key) {
            error(path, fmt::format("required key \"{}\" is missing (with format: {})", key,
                                    hams ? "hams" : "wamit"));
        };
        if (!d.rho) missing("rho");
        if (!d.displaced_volume) missing("displaced_volume");
        if (!d.centre_of_buoyancy) missing("centre_of_buoyancy");
        if (hams && !d.period_column) missing("period_column");
    }

    void member(PlatformKeys& p, std::size_t i) {
        Member& m = p.members[i];
        const std::string path = fmt::format("{}.members[{}]", p.key_path, i);
        if (!given(path + ".inertia")) m.inertia = !p.hydrodynamics.database;
        if (!given(path + ".displaced_area")) {
            m.displaced_area = m.inertia ? pi / 4.0 * m.diameter * m.diameter : 0.0;
            if (m.diameter_to && m.inertia)
                m.displaced_area_to = pi / 4.0 * *m.diameter_to * *m.diameter_to;
        } else if (!m.inertia && m.displaced_area > 0.0) {
            error(path + ".displaced_area", "must be 0 where inertia is false");
        }
        if (m.flooded && m.displaced_area == 0.0 && m.displaced_area_to.value_or(0.0) == 0.0)
            error(path + ".flooded", "needs a section that displaces water: inertia: true");
        if (m.current && p.current_coefficients)
            error(given(path + ".current") ? path + ".current" : path,
                  "current must be false beside current_coefficients, which hold the drag of the "
                  "current on the whole hull");
        if ((m.to - m.from).norm() == 0.0) error(path + ".to", "the member has no length");
    }

    void line_type(LineTypeKeys& type) {
        const Material* material = nullptr;
        if (type.material) {
            std::vector<std::string> known;
            for (const Material& m : case_.materials) {
                known.push_back(m.name);
                if (m.name == *type.material) material = &m;
            }
            if (material == nullptr) {
                error("line_types." + type.name + ".material",
                      fmt::format("unknown material \"{}\"{}", *type.material,
                                  suggestion(*type.material, known)));
                // What follows from the material is unknown, not missing.
                if (!type.mass) type.mass = NAN;
                if (!type.EA && !type.viscoelastic && type.EA_curve.empty()) type.EA = NAN;
                if (!type.EI) type.EI = NAN;
            }
        }
        complete_line_type(type, material, problems_);
    }

    void line(LineKeys& line) {
        if (line.family.empty()) line.family = line.name;
        azimuths(line);
        elements(line);
        for (ConstraintKeys& constraint : line.constraints) Completion::constraint(constraint);
        if (line.fail && !line.fail->line) {
            const auto of_family = [&line](const LineKeys& l) { return l.family == line.family; };
            if (std::count_if(case_.lines.begin(), case_.lines.end(), of_family) > 1) {
                error("lines." + line.family + ".fail",
                      "required key \"line\" is missing: the family has several lines");
            }
            line.fail->line = line.name;
        }
    }

    /// The line's own azimuth, and that of its ends where they leave it out.
    void azimuths(LineKeys& line) {
        const std::string path = "lines." + line.family;
        std::optional<double>* open_a = line.end_a.polar ? &line.end_a.polar->azimuth : nullptr;
        std::optional<double>* open_b =
            line.end_b.anchor && line.end_b.anchor->radius ? &line.end_b.anchor->azimuth : nullptr;
        if (!line.azimuth) {
            if (open_b != nullptr && *open_b)
                line.azimuth = **open_b;
            else if (open_a != nullptr && *open_a && open_b == nullptr)
                line.azimuth = **open_a;
        }
        const auto fill = [&](std::optional<double>* azimuth, const char* end) {
            if (azimuth == nullptr || *azimuth) return;
            if (line.azimuth) {
                *azimuth = line.azimuth;
            } else {
                error(path + "." + end, "\"azimuth\" must be given: the line has no pattern");
                *azimuth = NAN;
            }
        };
        fill(open_a, "end_a.polar");
        fill(open_b, "end_b.anchor");
        for (EndKeys* end : {&line.end_a, &line.end_b}) {  // the other places where they may stand
            if (end->anchor && end->anchor->radius && !end->anchor->azimuth) {
                fill(&end->anchor->azimuth, "end_a.anchor");
            }
            if (end->polar && !end->polar->azimuth) fill(&end->polar->azimuth, "end_b.polar");
        }
        if (!line.azimuth) {
            const Vec3 from = case_.design_of(case_.platform_of(line));
            const std::optional<Vec3> a = horizontal(line.end_a, from),
                                      b = horizontal(line.end_b, from);
            const Vec3 span = a && b ? Vec3(*b - *a) : Vec3::Zero().eval();
            line.azimuth = span.head<2>().norm() > 0.0 ? std::atan2(span.y(), span.x()) : 0.0;
        }
    }

    /// Place of an end in plan, at the design position; nothing for a free end.
    /// @param from  where the line's radii count from
    [[nodiscard]] std::optional<Vec3> horizontal(const EndKeys& end, const Vec3& from) const {
        const auto on_circle = [](double radius, double azimuth) {
            return Vec3(radius * std::cos(azimuth), radius * std::sin(azimuth), 0.0);
        };
        const Vec3 on = end.platform ? case_.design_of(case_.find_platform(*end.platform)) : from;
        if (end.position) return on + *end.position;
        if (end.fixed) return *end.fixed;
        if (end.polar && end.polar->azimuth)
            return on + on_circle(end.polar->radius, *end.polar->azimuth);
        if (end.anchor && end.anchor->position && end.anchor->position->size() >= 2) {
            return Vec3((*end.anchor->position)[0], (*end.anchor->position)[1], 0.0);
        }
        if (end.anchor && end.anchor->radius && end.anchor->azimuth)
            return from + on_circle(*end.anchor->radius, *end.anchor->azimuth);
        return {};
    }

    static void constraint(ConstraintKeys& c) {
        using Kind = ConstraintKind;
        if (!c.type) return;
        if (c.type == Kind::slider && !c.stiffness) c.stiffness = 100e6;
        if (c.type == Kind::tensioner && !c.arc) c.arc = 0.0;
        if (!c.axis && !c.line && (c.type == Kind::guide || c.type == Kind::slider))
            c.axis = Vec3::UnitZ();
        if (c.name || c.names) return;
        static constexpr std::array names{"ball_joint", "flex_joint", "clamp",     "tensioner",
                                          "guide",      "slider",     "pull_tube", "winch"};
        c.name = names.at(static_cast<std::size_t>(*c.type));
    }

    static void elements(LineKeys& line) {
        double length = 0.0;
        for (const SectionKeys& s : line.sections) length += s.length;
        for (SectionKeys& s : line.sections) {
            if (s.element_length) {
                const double n = std::round(s.length / *s.element_length);
                s.elements = n >= 1.0 && n < 1e6 ? static_cast<int>(n) : 1;
                s.element_length.reset();
            } else if (!s.elements) {
                const double n = std::round(default_elements * s.length / length);
                s.elements = n >= 2.0 ? static_cast<int>(n) : 2;
            }
        }
    }

    void analysis_and_output() {
        Dynamics& d = case_.analysis.dynamics;
        if (!given("analysis.dynamics.statistics_from")) {
            const double usual = std::max(d.ramp, std::min(600.0, d.duration / 2.0));
            d.statistics_from = usual < d.duration ? usual : d.duration / 2.0;
        }
        Output& out = case_.output;
        if (!given("output.interval")) out.interval = d.platform_step;
        if (!given("output.lines") && !case_.lines.empty()) out.lines = {LineOutput{}};
        for (std::size_t i = 0; i < out.lines.size(); ++i) {  // a range alone asks for no end
            const std::string path = fmt::format("output.lines[{}]", i);
            if (given(path + ".range") && !given(path + ".at") && !given(path + ".at_arc") &&
                !given(path + ".results"))
                out.lines[i].results.clear();
        }
    }

    DeclaredCase& case_;
    const Given& given_;
    Problems& problems_;
};

}  // namespace

void complete(DeclaredCase& declared, const Given& given, Problems& problems) {
    Completion(declared, given, problems).run();
}

}  // namespace hawser
