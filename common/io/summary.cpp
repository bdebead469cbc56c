#include "io/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "environment/wave_trains.hpp"
#include "environment/weather_words.hpp"
#include "io/files.hpp"
#include "io/result_fields.hpp"
#include "line_weight.hpp"
#include "motion_names.hpp"

namespace hawser::io {
namespace {

constexpr double degrees = 180.0 / 3.14159265358979323846;

/// A number in a column of a table; a dash where there is none.
std::string cell(double x, int width, int decimals) {
    if (!std::isfinite(x)) return fmt::format("{:>{}}", "-", width);
    if (std::abs(x) < 0.5 * std::pow(10.0, -decimals)) x = 0.0;  // no "-0.0"
    return fmt::format("{:>{}.{}f}", x, width, decimals);
}

/// A single figure with four digits, whole numbers written out up to ten millions.
std::string figure(double x) {
    const double size = std::abs(x);
    if (size >= 1e3 && size < 1e7) return fmt::format("{:.0f}", x);
    return fmt::format("{:.4g}", x);
}

std::string heading(std::string_view text) {
    return fmt::format("\n{}\n{}\n", text, std::string(text.size(), '-'));
}

std::size_t widest(std::size_t least, const std::vector<std::string>& names) {
    for (const std::string& name : names) least = std::max(least, name.size());
    return least;
}

std::string environment_text(const Case& input, const ResultDigest& digest) {
    const Environment& e = input.environment;
    std::string out = heading("Environment");
    out += fmt::format("water depth {:g} m, density {:g} kg/m3, gravity {:g} m/s2\n",
                       e.seabed.depth, e.water.density, e.water.gravity);
    const auto measured = [&](const std::string& channel, double asked) {
        for (const ChannelStatistics& row : digest.statistics)
            if (row.channel == channel && row.values.n > 1)
                return fmt::format("; measured at the origin {:.4g} m ({:+.1f} %)",
                                   4.0 * row.values.std,
                                   100.0 * (4.0 * row.values.std / asked - 1.0));
        return std::string();
    };
    double square = 0.0;  // of the significant height of all
    for (std::size_t i = 0; i < e.waves.size(); ++i) {
        const double asked = significant_height(e.waves[i]);
        square += asked * asked;
        out += words_of(e.waves[i]);
        if (e.waves.size() == 1 && e.waves[i].type == WaveType::airy) {
            out += "\n";
            continue;
        }
        out +=
            measured(e.waves.size() == 1 ? "environment/elevation"
                                         : fmt::format("environment/elevation_of_train_{}", i + 1),
                     asked) +
            "\n";
    }
    if (e.waves.size() > 1)
        out += fmt::format("all trains together: Hs {:.4g} m", std::sqrt(square)) +
               measured("environment/elevation", std::sqrt(square)) + "\n";
    if (e.waves.empty()) out += "still water\n";
    if (e.current && !e.current->profile.empty()) {
        out += fmt::format("current: {:g} m/s at the surface, towards {:g} deg\n",
                           e.current->profile.front().speed, degrees * e.current->heading);
    }
    if (e.wind) out += "wind: " + words_of(*e.wind) + "\n";
    return out;
}

/// Facts of platform k, and where it starts.
std::string platform_text(const RunRecord& record, std::size_t k) {
    const Platform& platform = record.input.platform_at(static_cast<int>(k));
    std::string out = heading("Platform " + platform.name);
    const std::vector<Fact> facts =
        k < record.platforms.size() ? record.platforms[k] : std::vector<Fact>{};
    std::vector<std::string> names;
    names.reserve(facts.size());
    for (const Fact& fact : facts) names.push_back(fact.description);
    const std::size_t width = widest(0, names);
    for (const Fact& fact : facts) {
        const bool large = fact.units == "kg" || fact.units == "N";
        const std::string units = fact.units == "kg" ? "t" : fact.units == "N" ? "kN" : fact.units;
        out += fmt::format("{:<{}}  {:>12} {}\n", fact.description, width,
                           figure(large ? fact.value / 1e3 : fact.value), units);
    }
    if (record.input.platform_count() > 1 || platform.position != Vec3::Zero())
        out +=
            fmt::format("designed to be at x {:g} m, y {:g} m; surge and sway count from there\n",
                        platform.position.x(), platform.position.y());
    if (record.statics && k < record.statics->platforms.size()) {
        const PlatformMotion& found = record.statics->platforms[k];
        const Vec3 x = found.position - platform.position;
        const Vec3 q = degrees * found.angles;
        out += "equilibrium under the mean loads: surge" + cell(x[0], 7, 2) + ", sway" +
               cell(x[1], 6, 2) + ", heave" + cell(x[2], 6, 2) + " m, roll" + cell(q[0], 6, 2) +
               ", pitch" + cell(q[1], 6, 2) + ", yaw" + cell(q[2], 6, 2) + " deg\n";
    }
    for (const std::string& doubt : record.doubts)
        if (doubt.starts_with(platform.name + ": "))
            out += "! " + doubt.substr(platform.name.size() + 2) + "\n";
    return out;
}

std::string lines_text(const RunRecord& record, const ResultDigest& digest) {
    const Case& input = record.input;
    if (input.lines.empty()) return "";
    std::string out = heading("Lines at the start");
    std::vector<std::string> names, families;
    for (const Line& line : input.lines)
        names.push_back(line.name), families.push_back(line.family);
    const std::size_t name = widest(4, names), family = widest(6, families);
    const auto row = [&](const std::array<const char*, 10>& w) {
        return fmt::format("{:<{}}  {:<{}} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8} {:>9} {:>9}\n",
                           w[0], name, w[1], family, w[2], w[3], w[4], w[5], w[6], w[7], w[8],
                           w[9]);
    };
    out += row({"", "", "length", "submerged", "tension", "tension", "angle", "angle", "on the",
                "touches"});
    out +=
        row({"line", "family", "", "weight", "end A", "end B", "end A", "end B", "seabed", "at"});
    out += row({"", "", "m", "kN", "kN", "kN", "deg", "deg", "m", "m"});
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const Line& line = input.lines[i];
        const LineStart& s = digest.lines.at(i);
        out += fmt::format("{:<{}}  {:<{}} {}{}{}{}{}{}{}{}\n", line.name, name, line.family,
                           family, cell(line.length(), 10, 1),
                           cell(submerged_weight(line, input) / 1e3, 11, 1),
                           cell(s.end_a_tension / 1e3, 11, 1), cell(s.end_b_tension / 1e3, 11, 1),
                           cell(s.end_a_declination, 9, 2), cell(s.end_b_declination, 9, 2),
                           cell(s.grounded, 10, 1), cell(s.touchdown, 10, 1));
    }
    std::string before;  // lines of one family as a rule say the same
    for (const Adjustment& a : record.adjustments) {
        const std::string& line = input.lines[static_cast<std::size_t>(a.line)].name;
        const std::string note = note_of(a, input).substr(line.size());
        if (note == before) {
            out.insert(out.size() - note.size() - 1, ", " + line);
        } else {
            out += line + note + "\n";
        }
        before = note;
    }
    out +=
        "angle: from vertical down, of the line as it leaves end A and as it arrives at end B; "
        "touches: arc length from end A\n";
    return out;
}

/// Of the tensioners of a line whose stroke was recorded: which stood on their stops.
std::vector<std::string> stops_of(const Line& line, const ResultDigest& digest) {
    std::vector<std::string> out;
    for (const LineConstraint& c : line.constraints) {
        if (c.type != ConstraintType::tensioner) continue;
        const std::string channel = fmt::format("constraint/{}/{}/stroke", line.name, c.name);
        for (const ChannelStatistics& row : digest.statistics) {
            if (row.channel != channel) continue;
            const Statistics& stroke = row.values;
            const auto say = [&](const char* which, double stop, double reached, double t) {
                out.push_back(fmt::format(
                    "{}/{}: on its {} stop of {:g} m, furthest at t = {:g} s with {:.3f} m",
                    line.name, c.name, which, stop, t, reached));
            };
            if (stroke.min <= c.stroke_min) say("upper", c.stroke_min, stroke.min, stroke.t_min);
            if (stroke.max >= c.stroke_max) say("lower", c.stroke_max, stroke.max, stroke.t_max);
        }
    }
    return out;
}

/// What the lines went through: extremes with place and time, utilisation, slack.
std::string courses_text(const RunRecord& record, const ResultDigest& digest) {
    const Case& input = record.input;
    if (digest.courses.empty() || digest.samples == 0) return "";
    std::string out = heading("Lines over the whole run");
    std::vector<std::string> names;
    for (const Line& line : input.lines) names.push_back(line.name);
    const std::size_t name = widest(4, names);
    out += fmt::format("{:<{}}{:>30}{:>30}{:>30}{:>9}{:>9}\n", "", name, "least tension",
                       "greatest tension", "von Mises stress", "of", "of");
    out += fmt::format("{:<{}}{:>12}{:>9}{:>9}{:>12}{:>9}{:>9}{:>12}{:>9}{:>9}{:>9}{:>9}\n", "line",
                       name, "kN", "at m", "at s", "kN", "at m", "at s", "MPa", "at m", "at s",
                       "breaking", "yield");
    std::vector<std::string> flags;
    for (std::size_t i = 0; i < digest.courses.size(); ++i) {
        const LineCourse& c = digest.courses[i];
        const auto place = [](const Extreme& e, double scale) {
            return cell(scale * e.value, 12, 1) + cell(e.arc_length, 9, 1) + cell(e.time, 9, 1);
        };
        const auto& [least, greatest, stress, of_yield, of_breaking] = c.extremes;
        out += fmt::format("{:<{}}{}{}{}{}{}\n", names[i], name, place(least, 1e-3),
                           place(greatest, 1e-3), place(stress, 1e-6),
                           cell(of_breaking.value, 9, 3), cell(of_yield.value, 9, 3));
        const Line& line = input.lines[i];
        if (line.fail && line.fail->time <= digest.last_time)
            flags.push_back(fmt::format("{}: parted at {:g} s at {:.1f} m, as the case says",
                                        names[i], line.fail->time, line.fail->arc_length));
        for (const std::string& stop : stops_of(line, digest)) flags.push_back(stop);
        if (of_breaking.value > 1.0)
            flags.push_back(fmt::format("{}: above its breaking load at {:.1f} m, t = {:g} s",
                                        names[i], of_breaking.arc_length, of_breaking.time));
        if (of_yield.value > 1.0)
            flags.push_back(fmt::format("{}: above yield at {:.1f} m, t = {:g} s", names[i],
                                        of_yield.arc_length, of_yield.time));
        if (least.value < 0.0)
            flags.push_back(fmt::format("{}: compression of {:.1f} kN at {:.1f} m, t = {:g} s",
                                        names[i], -least.value / 1e3, least.arc_length,
                                        least.time));
        if (std::isfinite(c.slack_first))
            flags.push_back(fmt::format(
                "{}: slack (below {:.1f} kN somewhere) for {:g} s in all, first at t = {:g} s, "
                "least tension at {:.1f} m",
                names[i], c.slack_limit / 1e3, c.slack_duration, c.slack_first, least.arc_length));
    }
    out +=
        "effective tensions; of breaking, of yield: greatest utilisation, where the case gives "
        "these; places without tension at the start do not count as least\n";
    for (const std::string& flag : flags) out += "! " + flag + "\n";
    return out;
}

/// Units for people, and how much larger they are.
struct Shown {
    std::string units;
    double scale;
    int decimals;
};
Shown shown(const std::string& units) {
    if (units == "N") return {"kN", 1e-3, 1};
    if (units == "N.m") return {"kN.m", 1e-3, 1};
    if (units == "Pa") return {"MPa", 1e-6, 2};
    if (units == "1/m") return {"1/km", 1e3, 4};
    if (units == "1") return {"", 1.0, 5};
    return {units, 1.0, 3};
}

std::string statistics_text(const RunRecord& record, const ResultDigest& digest) {
    const double from = record.input.analysis.dynamics.statistics_from;
    if (digest.statistics.empty()) return "";
    if (std::all_of(digest.statistics.begin(), digest.statistics.end(),
                    [](const ChannelStatistics& row) { return row.values.n == 0; }))
        return heading("Statistics") +
               fmt::format("none: they begin at {:g} s, the run ended at {:g} s\n", from,
                           digest.last_time);
    std::string out =
        heading(fmt::format("Statistics from {:g} s to {:g} s", from, digest.last_time));
    std::vector<std::string> names;
    for (const ChannelStatistics& row : digest.statistics) names.push_back(row.channel);
    const std::size_t width = widest(7, names);
    out += fmt::format("{:<{}} {:>4} {:>11} {:>10} {:>11} {:>9} {:>11} {:>9} {:>8}\n", "channel",
                       width, "unit", "mean", "std", "min", "at s", "max", "at s", "Tz s");
    for (const ChannelStatistics& row : digest.statistics) {
        const Statistics& s = row.values;
        const auto [units, scale, decimals] = shown(row.units);
        out +=
            fmt::format("{:<{}} {:>4} {} {} {} {} {} {} {}\n", row.channel, width, units,
                        cell(scale * s.mean, 11, decimals), cell(scale * s.std, 10, decimals),
                        cell(scale * s.min, 11, decimals), cell(s.t_min, 9, 1),
                        cell(scale * s.max, 11, decimals), cell(s.t_max, 9, 1), cell(s.tz, 8, 2));
    }
    return out;
}

/// @param of  the platform's name where there are several
std::string ledger_text(const LedgerTable& ledger, const std::string& of, double step) {
    std::string out = heading(fmt::format("Load ledger{}: means from {:g} s to {:g} s",
                                          of.empty() ? "" : " of " + of, ledger.from, ledger.to));
    const std::size_t width = widest(19, ledger.components);
    out += fmt::format("{:<{}} {:>12} {:>12} {:>12} {:>14} {:>14} {:>14}\n", "", width, "surge kN",
                       "sway kN", "heave kN", "roll kN.m", "pitch kN.m", "yaw kN.m");
    const auto row = [&](const std::string& name, const Vec6& v) {
        out +=
            fmt::format("{:<{}} {} {} {} {} {} {}\n", name, width, cell(v[0] / 1e3, 12, 2),
                        cell(v[1] / 1e3, 12, 2), cell(v[2] / 1e3, 12, 2), cell(v[3] / 1e3, 14, 1),
                        cell(v[4] / 1e3, 14, 1), cell(v[5] / 1e3, 14, 1));
    };
    for (std::size_t k = 0; k < ledger.components.size(); ++k) {
        const std::string& name = ledger.components[k];
        const bool by_hand = name == "stiffness" || name == "forces" || name == "holding";
        if (by_hand && ledger.mean[k].isZero(0.0)) continue;
        row(name, ledger.mean[k]);
    }
    row("sum", ledger.sum);
    row("mass x acceleration", ledger.momentum);
    row("residual", ledger.residual);
    out += fmt::format("{:<{}}", "residual, % of largest", width);
    std::string large;
    for (int k = 0; k < 6; ++k) {
        const double percent = ledger.is_loaded(k) ? 100.0 * ledger.residual_fraction(k) : NAN;
        out += fmt::format(" {}", cell(percent, k < 3 ? 12 : 14, 3));
        if (percent > 100.0 * large_residual)
            large += fmt::format("{}{} {:.2g} %", large.empty() ? "" : ", ",
                                 motion_names[static_cast<std::size_t>(k)], percent);
    }
    out +=
        "\nweight and hydrostatic count as one component; moments are about the reference point; "
        "-: nothing acts\n";
    if (!large.empty())
        out += fmt::format(
            "! residual above {:g} %: {}. The loads that acted do not explain the change of "
            "momentum:\n  a load is missing or counted twice, or the platform turns fast within a "
            "step of {:g} s\n  (with half of it the residual of turning falls sixteenfold)\n",
            100.0 * large_residual, large, step);
    return out;
}

std::string impulses_text(const std::vector<ImpulseMismatch>& impulses) {
    if (impulses.empty()) return "";
    std::string out =
        heading("Impulse of rod and platform at contacts: largest mismatch of a line");
    std::vector<std::string> names;
    names.reserve(impulses.size());
    for (const ImpulseMismatch& i : impulses) names.push_back(i.constraint);
    const std::size_t width = widest(0, names);
    for (const ImpulseMismatch& i : impulses)
        out += fmt::format("{:<{}} {} %{}\n", i.constraint, width, cell(100.0 * i.value, 10, 3),
                           i.value > large_mismatch
                               ? "  large: a shorter platform step or force: impulse_matched"
                               : "");
    return out;
}

std::string performance_text(const RunRecord& record) {
    if (record.performance.empty()) return "";
    std::string out = heading("Where the time went");
    std::vector<std::string> names;
    for (const Fact& fact : record.performance) names.push_back(fact.description);
    const std::size_t width = widest(0, names);
    for (const Fact& fact : record.performance) {
        out += fmt::format("{:<{}}  {:>12} {}\n", fact.description, width, figure(fact.value),
                           fact.units == "1" ? "" : fact.units);
    }
    return out;
}

/// What is left of second-order wave forces.
const char* drift_limit(Drift drift) {
    switch (drift) {
        case Drift::none:
            return "no second-order wave forces";
        case Drift::mean:
            return "second-order wave forces by their mean alone";
        case Drift::newman:
            return "slow drift by Newman's approximation";
        case Drift::full_qtf:
            break;
    }
    return "second-order wave forces as far as the QTFs go";
}

std::string limits_text(const Case& input) {
    std::string out = heading("What the physics leaves out");
    const int platforms = input.platform_count();
    for (int k = 0; k < platforms; ++k) {
        const Platform& p = input.platform_at(k);
        out += "platform: ";
        if (platforms > 1) out += p.name + ": ";
        if (!p.hydrodynamics.memory)
            out += "constant added mass and radiation damping (no memory);\n          ";
        out += "no wave drift damping; no effect of current on drift and radiation;\n";
        out += fmt::format("          no Munk moment; {}; rigid hull\n",
                           drift_limit(p.hydrodynamics.drift));
    }
    if (platforms > 1)
        out +=
            "between:  no hydrodynamic interaction: each platform meets the undisturbed sea, the\n"
            "          radiation of the others does not reach it, none shields another\n";
    if (!input.lines.empty()) {
        out +=
            "lines:    no torsion; contact between lines at sliders only; no vortex-induced "
            "vibration;\n"
            "          static solutions without friction of the seabed\n";
    }
    out += "sea:      linear waves; plane seabed\n";
    return out;
}

}  // namespace

std::string summary_text(const RunRecord& record, const ResultDigest& digest) {
    const Case& input = record.input;
    std::string out = input.title.empty() ? input.name : input.title;
    out += fmt::format("\n{}\n", std::string(out.size(), '='));
    out += fmt::format("case {}, hawser {}, {} rank{}\n", input.name, record.version, record.ranks,
                       record.ranks == 1 ? "" : "s");
    out += fmt::format("{}: {}\n", record.complete ? "complete" : "NOT COMPLETE", record.outcome);
    const Dynamics& d = input.analysis.dynamics;
    out += fmt::format(
        "simulated to {:g} s of {:g} s, {} samples, {} snapshots; platform step "
        "{:g} s, rod step {:g} s\n",
        digest.last_time, d.duration, digest.samples, digest.snapshots, d.platform_step,
        d.line_step);
    out += environment_text(input, digest);
    for (int k = 0; k < input.platform_count(); ++k)
        out += platform_text(record, static_cast<std::size_t>(k));
    out += lines_text(record, digest);
    out += courses_text(record, digest);
    out += statistics_text(record, digest);
    for (std::size_t k = 0; k < record.ledgers.size(); ++k)
        out += ledger_text(
            record.ledgers[k],
            record.ledgers.size() > 1 ? input.platform_at(static_cast<int>(k)).name : std::string(),
            d.platform_step);
    out += impulses_text(record.impulses);
    out += performance_text(record);
    out += limits_text(input);
    return out;
}

std::string statistics_csv(const std::vector<ChannelStatistics>& statistics) {
    std::string out = "channel,unit,n,mean,std,min,t_min,max,t_max,skewness,kurtosis,tz\n";
    for (const ChannelStatistics& row : statistics) {
        const Statistics& s = row.values;
        out += fmt::format("{},{},{}", row.channel, row.units, s.n);
        for (const double x :
             {s.mean, s.std, s.min, s.t_min, s.max, s.t_max, s.skewness, s.kurtosis, s.tz}) {
            out += std::isfinite(x) ? fmt::format(",{}", x) : ",";
        }
        out += '\n';
    }
    return out;
}

void write_summary(const std::filesystem::path& folder, const RunRecord& record,
                   const ResultDigest& digest) {
    write_atomically(folder / "summary.txt", summary_text(record, digest));
    write_atomically(folder / "statistics.csv", statistics_csv(digest.statistics));
}

}  // namespace hawser::io
