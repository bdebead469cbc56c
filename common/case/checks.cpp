// Checks of a finished case that need no simulation: geometry and physical sense. Limits and their
// reasons are in the README of this folder. NaN (a number that could not be read) passes unnoticed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/declared.hpp"
#include "case/hydro_of_case.hpp"
#include "case/line_checks.hpp"
#include "case/wave_rules.hpp"
#include "line_quantities.hpp"

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi;

class Checks {
 public:
    Checks(const Case& c, const DeclaredCase& declared, Problems& problems)
        : case_(c), declared_(declared), problems_(problems) {}

    void run() {
        water();
        check_waves(case_, problems_);
        for (int k = 0; k < case_.platform_count(); ++k) platform(case_.platform_at(k));
        between_platforms();
        for (const LineType& type : case_.line_types) line_type(type);
        for (std::size_t i = 0; i < case_.lines.size(); ++i) {
            check_line(case_.lines[i], declared_.lines[i], case_, problems_);
        }
        times();
        output();
    }

 private:
    void error(const std::string& path, const std::string& message) {
        problems_.push_back({Severity::error, path, message, {}});
    }
    void warning(const std::string& path, const std::string& message) {
        problems_.push_back({Severity::warning, path, message, {}});
    }

    /// Units that were mistaken: t/m3, ft/s2.
    void water() {
        const Water& water = case_.environment.water;
        if (water.density < 900.0 || water.density > 1300.0)
            warning(
                "environment.water.density",
                fmt::format("{:.6g} kg/m3 is no water: fresh is 1000, the sea 1020 to 1030 kg/m3",
                            water.density));
        if (water.gravity < 9.7 || water.gravity > 9.9)
            warning(
                "environment.water.gravity",
                fmt::format("{:.6g} m/s2 is not found on earth: 9.78 to 9.83 m/s2", water.gravity));
    }

    void platform(const Platform& p) {
        // Where only the files tell the volume, this waits for them (hydro_of_case.hpp).
        if (const auto& d = p.hydrodynamics.database; !d || d->displaced_volume)
            check_displacement(case_, p, d ? *d->displaced_volume : 0.0, problems_);
        const Hydrodynamics& hydro = p.hydrodynamics;
        if (hydro.wave_phase == WavePhase::instantaneous && hydro.database) {
            warning(p.key_path + ".hydrodynamics.wave_phase",
                    hydro.drift == Drift::none
                        ? "instantaneous gives the first-order force of a hull that follows the "
                          "waves a mean of its own, of the size of the mean drift and no part of "
                          "the data; use slow"
                        : "instantaneous counts part of the mean drift twice; use slow");
        }
        if (hydro.database && hydro.database->rho &&
            std::abs(*hydro.database->rho / case_.environment.water.density - 1.0) > 0.005) {
            warning(p.key_path + ".hydrodynamics.database.rho",
                    fmt::format("{:.6g} kg/m3, but the water has {:.6g} kg/m3",
                                *hydro.database->rho, case_.environment.water.density));
        }
        if (!p.members.empty() && p.quadratic_damping.norm() > 0.0) {
            warning(p.key_path + ".damping.quadratic",
                    "acts together with the drag of the members");
        }
        if (hydro.database) counted_twice(p);
        if (p.current_coefficients && std::any_of(p.members.begin(), p.members.end(),
                                                  [](const Member& m) { return m.Cd > 0.0; })) {
            warning(p.key_path + ".current_coefficients",
                    "the members' drag on the hull's own motion acts beside them");
        }
        const double depth = -case_.environment.seabed.height(p.position.x(), p.position.y());
        double highest = -1e300;
        for (std::size_t i = 0; i < p.members.size(); ++i) {
            const Member& m = p.members[i];
            highest = std::max({highest, m.from.z(), m.to.z()});
            if (std::min(m.from.z(), m.to.z()) < -depth) {
                error(fmt::format("{}.members[{}]", p.key_path, i), "reaches below the seabed");
            }
        }
        const bool surface_piercing = highest > 0.0;
        if (surface_piercing && highest < expected_crest(case_.environment.waves)) {
            warning(
                p.key_path + ".members",
                fmt::format("the highest end is at {:.6g} m, below the expected crest at {:.1f} "
                            "m: no drag above it",
                            highest, expected_crest(case_.environment.waves)));
        }
        if (p.draft && *p.draft > depth) {
            error(p.key_path + ".draft", "deeper than the water");
        }
        if (case_.environment.wind && !p.wind) {
            warning("environment.wind",
                    case_.platform_count() > 1
                        ? fmt::format("{} has no wind area, so wind has no effect on it", p.name)
                        : "the platform has no wind area, so wind has no effect");
        }
    }

    /// Does a member displace water where the database has its hull? A member of `inertia: false`
    /// says where that is: another one more than half of whose axis below the surface runs inside
    /// its cylinder would count twice.
    void counted_twice(const Platform& p) {
        const auto displaces = [](const Member& m) {
            return m.displaced_area > 0.0 || m.displaced_area_to.value_or(0.0) > 0.0;
        };
        const auto inside = [](const Vec3& x, const Member& hull) {
            const Vec3 along = hull.to - hull.from, from = x - hull.from;
            const double q = from.dot(along) / along.squaredNorm();
            const double width =
                std::lerp(hull.diameter, hull.diameter_to.value_or(hull.diameter), q);
            return q > 0.0 && q < 1.0 && (from - q * along).norm() < 0.5 * width;
        };
        constexpr int places = 50;
        for (std::size_t i = 0; i < p.members.size(); ++i) {
            const Member& m = p.members[i];
            if (!displaces(m)) continue;
            for (const Member& hull : p.members) {
                if (hull.inertia) continue;
                int wet = 0, within = 0;
                for (int k = 0; k < places; ++k) {
                    const Vec3 x = m.from + (k + 0.5) / places * (m.to - m.from);
                    if (x.z() > 0.0) continue;
                    ++wet;
                    if (inside(x, hull)) ++within;
                }
                if (2 * within <= wet) continue;
                error(
                    fmt::format("{}.members[{}]", p.key_path, i),
                    fmt::format("displaces water inside \"{}\", whose inertia is false because the "
                                "database contains it: its volume would count twice; give it "
                                "inertia: false",
                                hull.name));
                break;
            }
        }
    }

    /// What several platforms in one sea do not feel of each other.
    void between_platforms() {
        if (case_.platform_count() < 2 || case_.environment.waves.empty()) return;
        warning("platforms",
                "no hydrodynamic interaction: each platform meets the undisturbed sea, radiation "
                "of the others does not reach it and none shields another; right where they are "
                "far apart or small against the waves");
    }

    void line_type(const LineType& type) {
        const std::string path = "line_types." + type.name;
        const double submerged =
            (type.mass - case_.environment.water.density * type.displaced_area) *
            case_.environment.water.gravity;
        if (submerged <= 0.0) {
            warning(path, fmt::format("floats: submerged weight {:.4g} N/m", submerged));
        }
        // EA/w is the length whose weight stretches it by half: 2.6e6 m of steel
        const double stiff = type.EA / (type.mass * 9.80665);
        if (type.mass > 0.0 && stiff > 1e13)
            error(path,
                  fmt::format("EA = {:.3g} N carries the weight of {:.1g} m of it: its stretch "
                              "is lost in the rounding of positions; steel has 2.6e6 m",
                              type.EA, stiff));
        const double d = type.outer_diameter;
        if (type.category == "chain") {
            const double ratio = std::sqrt(4.0 * type.displaced_area / pi) / d;
            if (ratio < 1.7 || ratio > 2.0) {
                warning(path, fmt::format("volume diameter {:.2f} times nominal; chain has 1.7 to "
                                          "2.0: check mass and nominal_diameter",
                                          ratio));
            }
            const double factor = type.EA / (d * d) / 1e3;  // kN per m2
            if (factor < 0.7e8 || factor > 1.1e8) {
                warning(path,
                        fmt::format("EA = {:.3g} d2 kN; chain has 0.7e8 to 1.1e8 d2 kN", factor));
            }
        }
        if (type.viscoelastic) {
            const double ratio = type.viscoelastic->EA_dynamic / type.viscoelastic->EA_static;
            if ((ratio > 1.0 && ratio < 1.2) || ratio > 3.0) {
                warning(
                    path + ".viscoelastic",
                    fmt::format("EA_dynamic/EA_static = {:.2f}; polyester has 1.2 to 3", ratio));
            }
        }
        if (type.breaking_load) {
            const double strain = *type.breaking_load / long_run_stiffness(type);
            if (strain < 0.001 || strain > 0.4) {
                warning(path + ".breaking_load",
                        fmt::format("would be reached at {:.2g} % of stretch: check EA",
                                    100.0 * strain));
            }
        }
    }

    static double long_run_stiffness(const LineType& type) {
        return type.viscoelastic ? type.viscoelastic->EA_static : type.EA;
    }

    void times() {
        const Dynamics& d = case_.analysis.dynamics;
        if (d.statistics_from >= d.duration) {
            error("analysis.dynamics.statistics_from",
                  fmt::format("{:.6g} s is not before the end at {:.6g} s; lower it (--set "
                              "analysis.dynamics.statistics_from=\"{:.6g} s\"), or leave it out",
                              d.statistics_from, d.duration, d.duration / 2.0));
        }
        if (!multiple(d.duration, d.platform_step)) {
            warning("analysis.dynamics.duration",
                    fmt::format("{:.6g} s is not a multiple of the platform step {:.6g} s: the run "
                                "goes on to {:.6g} s",
                                d.duration, d.platform_step,
                                d.platform_step * std::ceil(d.duration / d.platform_step)));
        }
        if (d.line_step > d.platform_step) {
            warning("analysis.dynamics.steps.lines", "longer than the platform step");
        }
    }

    static bool multiple(double interval, double step) {
        const double n = interval / step;
        return !(std::abs(n - std::round(n)) > 1e-9 * n) && !(std::round(n) < 1.0);
    }

    void output() {
        const double step = case_.analysis.dynamics.platform_step;
        const auto whole = [&](const char* key, double interval) {
            if (!multiple(interval, step)) {
                error(fmt::format("output.{}", key),
                      fmt::format("{:.6g} s is not a multiple of the platform step {:.6g} s",
                                  interval, step));
            }
        };
        whole("interval", case_.output.interval);
        if (case_.output.snapshots) whole("snapshots", *case_.output.snapshots);
        for (std::size_t i = 0; i < case_.output.lines.size(); ++i) {
            const std::string& select = case_.output.lines[i].select;
            bool found = false;
            for (const Line& line : case_.lines) found = found || matches(select, line.name);
            if (!found) {
                warning(fmt::format("output.lines[{}].select", i),
                        fmt::format("no line has a name like \"{}\"", select));
            }
            line_output(i);
        }
    }

    void line_output(std::size_t i) {
        const LineOutput& entry = case_.output.lines[i];
        const std::string path = fmt::format("output.lines[{}]", i);
        double longest = 0.0;
        for (const Line& line : case_.lines)
            if (matches(entry.select, line.name)) longest = std::max(longest, line.length());
        if (longest == 0.0) return;
        for (const double s : entry.at_arc) {
            if (s > longest)
                error(path + ".at_arc",
                      fmt::format("{:.6g} m lies beyond the end of the longest of these lines, "
                                  "{:.6g} m",
                                  s, longest));
        }
        const auto along_line = [](const std::string& word) {
            return std::any_of(line_quantities.begin(), line_quantities.end(),
                               [&](const LineQuantityWords& q) { return word == q.name; });
        };
        if (!entry.at_arc.empty() &&
            std::none_of(entry.results.begin(), entry.results.end(), along_line))
            warning(path + ".at_arc",
                    "nothing is recorded there: \"results\" names no quantity along the line");
        for (const std::string& word : entry.results) {
            const auto* constraint =
                std::find_if(constraint_words.begin(), constraint_words.end(),
                             [&](const ConstraintWord& c) { return c.word == word; });
            if (constraint == constraint_words.end()) continue;
            bool found = false;
            for (const Line& line : case_.lines)
                for (const LineConstraint& c : line.constraints)
                    found =
                        found || (matches(entry.select, line.name) && c.type == constraint->type);
            if (!found)
                warning(path + ".results",
                        fmt::format("{}: none of these lines has such a constraint", word));
        }
    }

    const Case& case_;
    const DeclaredCase& declared_;
    Problems& problems_;
};

}  // namespace

void check(const Case& value, const DeclaredCase& declared, Problems& problems) {
    Checks(value, declared, problems).run();
}

}  // namespace hawser
