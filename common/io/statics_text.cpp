#include "io/statics_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "environment/weather_words.hpp"
#include "io/text_table.hpp"
#include "line_weight.hpp"
#include "motion_names.hpp"

namespace hawser::io {
namespace {

/// Of the first section; without bound where the case gives none [N].
double breaking_load_at_top(const Line& line, const Case& input) {
    const LineType& first = input.line_types[static_cast<std::size_t>(line.sections.front().type)];
    return first.breaking_load.value_or(std::numeric_limits<double>::infinity());
}

constexpr double degrees = 180.0 / M_PI;

std::string fact(const std::string& what, const std::string& value) {
    return fmt::format("{:<58} {}\n", what, value);
}

std::string environment_text(const Environment& e) {
    std::string out = title("Environment");
    out += fact("water depth", number(e.seabed.depth, 1) + " m");
    for (const WaveTrain& w : e.waves) {
        if (w.type == WaveType::airy) {
            out += fact("regular wave", fmt::format("H {:g} m, T {:g} s", w.H, w.T));
            continue;
        }
        out += fact("waves", words_of(w));
        if (w.Tp == 0.0) continue;
        // Rayleigh crests: most probable greatest of N = duration/Tz, Tz = 0.75 Tp, in 3 h
        const double crest = 0.5 * w.Hs * std::sqrt(0.5 * std::log(3.0 * 3600.0 / (0.75 * w.Tp)));
        out += fact("greatest crest to be expected in 3 h (linear)", number(crest, 1) + " m");
    }
    if (e.current && !e.current->profile.empty())
        out += fact("current at the surface",
                    fmt::format("{:g} m/s, towards {:g} deg", e.current->profile.front().speed,
                                degrees * e.current->heading));
    if (e.wind) out += fact("wind", words_of(*e.wind));
    return out;
}

/// @param its  the platform as the case has it
std::string platform_text(const Case& input, const Platform& its, const PlatformAtRest& p) {
    std::string out = title("Platform " + p.name);
    out += fact(p.mass_is_auto ? "mass (auto: floats at its design draft)" : "mass",
                number(p.mass / 1e3, 0) + " t");
    out += fact("acting buoyancy", number(p.acting_buoyancy / 1e3, 0) + " kN");
    if (its.displacement)
        out += fact("displacement as given", number(*its.displacement / 1e3, 0) + " t");
    if (!input.lines.empty())
        out += fact("vertical line load, design position in still water",
                    number(p.vertical_line_load / 1e3, 0) + " kN");
    const Stability& s = p.stability;
    if (p.acting_buoyancy > 0.0) {
        out += fact("GM of the hull alone (weight and buoyancy), roll / pitch",
                    number(s.hull_GM_roll, 2) + " / " + number(s.hull_GM_pitch, 2) + " m");
        out += fact("stiffness of hull and lines over buoyancy, roll / pitch",
                    number(s.GM_roll, 2) + " / " + number(s.GM_pitch, 2) + " m");
    }
    std::string stands = s.stable() ? "stable: no negative stiffness" : "NOT STABLE in";
    for (const std::string& motion : s.unstable) stands += " " + motion;
    if (!s.unheld.empty()) stands += "; nothing holds it in";
    for (const std::string& motion : s.unheld) stands += " " + motion;
    out += fact("equilibrium", stands);
    std::string periods;
    for (std::size_t i = 0; i < 6; ++i)
        if (p.periods[i])
            periods += fmt::format("{}{} {:.2f}", periods.empty() ? "" : ", ", motion_names[i],
                                   *p.periods[i]);
    if (!periods.empty()) out += fact("natural periods", periods + " s");
    const bool loose = std::any_of(input.lines.begin(), input.lines.end(), [](const Line& line) {
        return std::any_of(line.constraints.begin(), line.constraints.end(),
                           [](const LineConstraint& c) { return c.gap > 0.0; });
    });
    if (loose) out += fact("stability and natural periods", "guides with a gap count as closed");
    if (p.added_mass_frequency > 0.0)
        out += fact("added mass taken at", number(p.added_mass_frequency, 4) + " rad/s");
    const Vec3 x = p.position.position - its.position, q = degrees * p.position.angles;
    if (its.position != Vec3::Zero())
        out += fact("designed to be at x, y",
                    number(its.position.x(), 1) + ", " + number(its.position.y(), 1) + " m");
    out += fact("rests at surge, sway, heave",
                number(x[0], 3) + ", " + number(x[1], 3) + ", " + number(x[2], 3) + " m");
    out += fact("         roll, pitch, yaw",
                number(q[0], 3) + ", " + number(q[1], 3) + ", " + number(q[2], 3) + " deg");
    return out;
}

std::string stiffness_text(const std::string& name, const Mat6& K) {
    std::string out = title(name + ": -d(load)/d(motion)");
    TextTable table;
    table.column("force, moment along");
    for (std::size_t i = 0; i < 6; ++i) table.column(motion_names[i], i < 3 ? "per m" : "per rad");
    for (int i = 0; i < 6; ++i) {
        std::vector<std::string> cells{fmt::format(
            "{} {}", motion_names[static_cast<std::size_t>(i)], i < 3 ? "[N]" : "[N.m]")};
        for (int k = 0; k < 6; ++k) {
            const double least = 1e-9 * std::sqrt(std::abs(K(i, i) * K(k, k)));
            cells.push_back(digits(std::abs(K(i, k)) < least ? 0.0 : K(i, k), 4));
        }
        table.row(cells);
    }
    return out + table.text();
}

/// What lines between platforms do to one when another moves.
std::string between_text(const StaticsReport& report) {
    std::string out;
    for (std::size_t i = 0; i < report.platforms.size(); ++i)
        for (std::size_t k = 0; k < report.platforms.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(6 * i),
                       column = static_cast<Eigen::Index>(6 * k);
            if (i == k || row >= report.stiffness.rows() || column >= report.stiffness.cols())
                continue;
            const Mat6 part = report.stiffness.block<6, 6>(row, column);
            if (part.isZero(0.0)) continue;
            out += stiffness_text(fmt::format("Load on {} by motions of {}",
                                              report.platforms[i].name, report.platforms[k].name),
                                  part);
        }
    return out;
}

std::string lines_text(const Case& input, const StaticsReport& report, bool brief) {
    if (input.lines.empty()) return "";
    std::string out = title("Lines");
    TextTable table;
    table.column("line");
    table.column("length", "m");
    table.column("submerged", "kN");
    table.column("tension A", "kN");
    table.column("tension B", "kN");
    table.column("decl. A", "deg");
    table.column("decl. B", "deg");
    if (!brief) table.column("azimuth", "deg");
    table.column("grounded", "m");
    if (!brief) {
        table.column("touchdown", "m");
        table.column("lowest", "kN");
        table.column("at", "m");
    }
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const Line& line = input.lines[i];
        const LineAtRest& r = report.lines[i];
        std::vector<std::string> cells{line.name,
                                       number(line.length(), 1),
                                       number(submerged_weight(line, input) / 1e3, 1),
                                       number(r.tension_a / 1e3, 1),
                                       number(r.tension_b / 1e3, 1),
                                       number(degrees * r.declination_a, 2),
                                       number(degrees * r.declination_b, 2)};
        if (!brief) cells.push_back(number(degrees * r.azimuth_a, 1));
        cells.push_back(number(r.grounded, 1));
        if (!brief)
            for (const auto& cell : {number(r.touchdown, 1), number(r.lowest_tension / 1e3, 1),
                                     number(r.lowest_at, 1)})
                cells.push_back(cell);
        table.row(cells);
    }
    out += table.text();
    return out +
           "submerged: weight in water. decl.: angle from vertical down of the line as it leaves "
           "end A and arrives at end B.\n" +
           (brief ? ""
                  : "azimuth: of the line as it leaves end A. touchdown, at: arc length from end "
                    "A. lowest: least effective tension.\n");
}

std::string stress_text(const Case& input, const StaticsReport& report) {
    TextTable table;
    table.column("line");
    table.column("tension", "kN");
    table.column("at", "m");
    table.column("von Mises", "MPa");
    table.column("at", "m");
    table.column("bending", "MPa");
    table.column("at", "m");
    table.column("curvature", "1/km");
    table.column("at", "m");
    table.column("of yield", "%");
    table.column("of breaking load", "%");
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const LineAtRest& r = report.lines[i];
        std::vector<std::string> cells{input.lines[i].name};
        for (const auto& [extreme, factor, decimals] : {std::tuple(&r.tension, 1e-3, 1),
                                                        {&r.von_mises, 1e-6, 1},
                                                        {&r.bending, 1e-6, 1},
                                                        {&r.curvature, 1e3, 3}}) {
            cells.push_back(number(factor * extreme->value, decimals));
            cells.push_back(number(extreme->at, 1));
        }
        cells.push_back(number(100.0 * r.yield.value, 1));
        cells.push_back(number(100.0 * r.breaking_load.value, 1));
        table.row(std::move(cells));
    }
    if (input.lines.empty()) return "";
    return title("Greatest along the lines") + table.text() +
           "tension: effective. of yield: von Mises stress. of breaking load: effective tension. A "
           "dash: the line type does not say.\n";
}

/// Which of the columns of the constraints' table tells a constraint's opening.
enum class Opening { gap, stroke, off_place };
Opening opening_of(ConstraintType type) {
    switch (type) {
        case ConstraintType::tensioner:
            return Opening::stroke;
        case ConstraintType::guide:
        case ConstraintType::slider:
        case ConstraintType::pull_tube:
            return Opening::gap;
        default:
            return Opening::off_place;
    }
}

std::string constraints_text(const Case& input, const StaticsReport& report) {
    TextTable table;
    table.column("constraint");
    table.column("kind");
    table.column("tension, force", "kN");
    table.column("gap left", "mm");
    table.column("stroke", "m");
    table.column("off its place", "mm");
    bool any = false;
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        for (std::size_t c = 0; c < input.lines[i].constraints.size(); ++c) {
            const LineConstraint& constraint = input.lines[i].constraints[c];
            const ConstraintAtRest& r = report.lines[i].constraints[c];
            static constexpr std::array kinds = {
                "ball_joint", "flex_joint", "clamp", "tensioner", "guide", "slider", "pull_tube"};
            const Opening is = opening_of(constraint.type);
            const auto cell = [&](Opening column, double factor, int decimals) {
                return number(is == column ? factor * r.opening : NAN, decimals);
            };
            table.row({input.lines[i].name + "/" + constraint.name,
                       kinds.at(static_cast<std::size_t>(constraint.type)),
                       number(r.magnitude / 1e3, 2), cell(Opening::gap, 1e3, 1),
                       cell(Opening::stroke, 1.0, 4), cell(Opening::off_place, 1e3, 2)});
            any = true;
        }
    }
    if (!any) return "";
    return title("Constraints along the lines") + table.text() +
           "gap left: negative where the line is pressed in. off its place: how far the point held "
           "by a joint gives.\n";
}

/// The motions beside the offset that were free, or those that were not.
std::string motions_of(const FreeMotions& f, bool free) {
    std::string out;
    for (const auto& [is_free, name] : {std::pair(f.transverse, "transverse"),
                                        {f.heave, "heave"},
                                        {f.roll, "roll"},
                                        {f.pitch, "pitch"},
                                        {f.yaw, "yaw"}})
        if (is_free == free) out += (out.empty() ? "" : ", ") + std::string(name);
    return out;
}

std::string curve_text(const Case& input, const OffsetCurve& curve) {
    const FreeMotions& f = curve.free;
    const bool several = input.platform_count() > 1, all = curve.lines.size() == input.lines.size();
    std::string out =
        title(fmt::format("Restoring{} towards {:g} deg, {} of {} lines, still water",
                          several ? " of " + input.platform_at(curve.platform).name : "",
                          degrees * curve.heading, curve.lines.size(), input.lines.size()));
    const std::string held = motions_of(f, false);
    out += held.empty() ? "" : "held as designed: " + held + ". ";
    out += f.any() ? "free, settled under weight, buoyancy and all lines: " + motions_of(f, true)
                   : "nothing is free";
    out += " (change with --free)\n";
    if (several)
        out += all ? "the other platforms settle too\n" : "the other platforms stay as designed\n";
    TextTable table;
    table.column("offset", "m");
    table.column("restoring", "kN");
    table.column("slope", "kN/m");
    if (f.transverse) table.column("across", "m");
    if (f.heave) table.column("heave", "m");
    if (f.roll) table.column("roll", "deg");
    if (f.pitch) table.column("pitch", "deg");
    if (f.yaw) table.column("yaw", "deg");
    if (!f.transverse) table.column("transverse", "kN");
    if (!f.yaw) table.column("yaw moment", "kN.m");
    table.column("least tension", "kN");
    table.column("line");
    table.column("greatest", "kN");
    table.column("line");
    bool broken = false;
    for (const OffsetPoint& p : curve.points) {
        std::vector<std::string> cells{number(p.offset, 2), number(p.restoring / 1e3, 1),
                                       number(p.slope / 1e3, 1)};
        const Vec3 turned = degrees * p.pose.angles;
        if (f.transverse) cells.push_back(number(p.across, 3));
        if (f.heave) cells.push_back(number(p.pose.position.z(), 3));
        if (f.roll) cells.push_back(number(turned.x(), 3));
        if (f.pitch) cells.push_back(number(turned.y(), 3));
        if (f.yaw) cells.push_back(number(turned.z(), 3));
        if (!f.transverse) cells.push_back(number(p.transverse / 1e3, 1));
        if (!f.yaw) cells.push_back(number(p.yaw_moment / 1e3, 0));
        cells.push_back(number(p.least / 1e3, 1));
        cells.push_back(input.lines[static_cast<std::size_t>(p.least_line)].name);
        const Line& greatest = input.lines[static_cast<std::size_t>(p.greatest_line)];
        const bool breaks = p.greatest > breaking_load_at_top(greatest, input);
        broken = broken || breaks;
        cells.push_back(number(p.greatest / 1e3, 1));
        cells.push_back(greatest.name + (breaks ? " !" : ""));
        table.row(std::move(cells));
    }
    return out + table.text() +
           (broken ? "!: above the breaking load of the line's first section\n" : "") +
           "restoring: what holds the platform there pulls as much, at its reference point. "
           "slope: with the free motions following.\ntensions are those at end A" +
           (several ? ", of the lines that touch the platform\n" : "\n");
}

std::string heading(const Case& input) {
    return fmt::format("{}: static solution\n", input.title.empty() ? input.name : input.title);
}

}  // namespace

std::string statics_text(const Case& input, const StaticsReport& report) {
    std::string out = heading(input);
    const bool several = report.platforms.size() > 1;
    for (std::size_t k = 0; k < report.platforms.size(); ++k) {
        const PlatformAtRest& p = report.platforms[k];
        const std::string of =
            several ? " on " + p.name + ", the others held, about its" : " about the";
        const std::string about = of + " reference point";
        out += platform_text(input, input.platform_at(static_cast<int>(k)), p);
        out += stiffness_text("Stiffness of platform and lines" + about, p.stiffness);
        if (!input.lines.empty())
            out += stiffness_text("Stiffness of the lines" + about, p.line_stiffness);
    }
    out += between_text(report);
    out += lines_text(input, report, false);
    out += stress_text(input, report);
    out += constraints_text(input, report);
    if (report.curve) out += curve_text(input, *report.curve);
    return out;
}

std::string statics_summary(const Case& input, const StaticsReport& report) {
    std::string out = heading(input) + environment_text(input.environment);
    for (std::size_t k = 0; k < report.platforms.size(); ++k)
        out += platform_text(input, input.platform_at(static_cast<int>(k)), report.platforms[k]);
    out += lines_text(input, report, true);
    return out;
}

}  // namespace hawser::io
