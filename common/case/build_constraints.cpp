#include "case/build_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "case/line_type_rules.hpp"

namespace hawser {
namespace {

class BuildConstraint {
 public:
    BuildConstraint(const ConstraintKeys& keys, std::size_t i, const LineKeys& line_keys,
                    const DeclaredCase& declared, Line& line, Problems& problems)
        : keys_(keys),
          path_(fmt::format("lines.{}.constraints[{}]", line_keys.family, i)),
          line_keys_(line_keys),
          declared_(declared),
          line_(line),
          problems_(problems) {}

    void run() {
        if (!keys_.type) return;  // reported already
        if (keys_.type == ConstraintKind::winch) return winch();
        LineConstraint c = common();
        law(c);
        if (keys_.line) {
            c.name = name(1);
            if (c.other_line >= 0) add(c);
            return;
        }
        const std::vector<Vec3> places = this->places(c);
        if (keys_.names && keys_.names->find("{n}") == std::string::npos && places.size() > 1) {
            return error(".names", "several places need \"{n}\" in their names, e.g. \"plate{n}\"");
        }
        if (!keys_.names && places.size() > 1) {
            return error("", "several heights need \"names\", e.g. names: \"plate{n}\"");
        }
        if (keys_.arc && (places.size() > 1 || keys_.length > 0.0)) {
            return error(".arc",
                         "holds one point of the line, which cannot be at several places: leave "
                         "it out, so that whatever passes them is held");
        }
        for (std::size_t n = 0; n < places.size(); ++n) {
            c.position = places[n];
            c.name = name(n + 1);
            if (keys_.length > 0.0) {
                const Vec3 half = 0.5 * keys_.length * (c.axis.z() < 0.0 ? -c.axis : c.axis);
                LineConstraint lower = c;
                c.position += half;
                c.name += ".upper";
                lower.position -= half;
                lower.name += ".lower";
                add(c);
                add(lower);
            } else {
                add(c);
            }
        }
    }

 private:
    void error(const std::string& key, const std::string& message) {
        problems_.push_back({Severity::error, path_ + key, message, {}});
    }

    static ConstraintType type(ConstraintKind kind) {
        switch (kind) {
            case ConstraintKind::ball_joint:
                return ConstraintType::ball_joint;
            case ConstraintKind::flex_joint:
                return ConstraintType::flex_joint;
            case ConstraintKind::clamp:
                return ConstraintType::clamp;
            case ConstraintKind::tensioner:
                return ConstraintType::tensioner;
            case ConstraintKind::slider:
                return ConstraintType::slider;
            case ConstraintKind::pull_tube:
                return ConstraintType::pull_tube;
            case ConstraintKind::guide:
            case ConstraintKind::winch:
                break;
        }
        return ConstraintType::guide;
    }

    std::string name(std::size_t n) const { return constraint_name(keys_, n); }

    void add(const LineConstraint& c) {
        for (const LineConstraint& other : line_.constraints) {
            if (other.name != c.name) continue;
            return error(keys_.names ? ".names" : ".name",
                         fmt::format("two constraints of this line are named \"{}\"", c.name));
        }
        line_.constraints.push_back(c);
    }

    /// What every constraint has, and where it belongs.
    LineConstraint common() {
        LineConstraint c;
        c.type = type(*keys_.type);
        c.arc_length = keys_.arc;
        c.stiffness = keys_.stiffness.value_or(0.0);
        c.damping = keys_.damping;
        c.gap = keys_.gap;
        c.mobilisation = keys_.mobilisation;
        if (keys_.axis) {
            if (keys_.axis->norm() == 0.0) error(".axis", "the axis has no length");
            c.axis = keys_.axis->normalized();
        }
        if (keys_.arc && *keys_.arc > line_.length()) {
            error(".arc", fmt::format("beyond the end of the line at {:.6g} m", line_.length()));
        }
        if (keys_.line) {
            tie(c);
        } else if (!keys_.platform) {
            error("", "required key \"platform\" is missing: its name, or seabed for the earth");
        } else if (*keys_.platform == "seabed") {
            c.on_platform = false;
        } else if (std::vector<std::string> known = declared_.platform_names(); known.empty()) {
            error(".platform", "the case has no platform; seabed stands for the earth");
        } else if (c.platform = declared_.find_platform(*keys_.platform); c.platform < 0) {
            c.platform = 0;
            known.emplace_back("seabed");
            error(".platform", fmt::format("unknown platform \"{}\"{}", *keys_.platform,
                                           suggestion(*keys_.platform, known)));
        }
        return c;
    }

    /// To a point of another line.
    void tie(LineConstraint& c) {
        c.on_platform = false;
        if (keys_.platform) error(".platform", "\"line\" stands instead of \"platform\"");
        if (!keys_.z.empty() || keys_.position || keys_.axis) {
            error("",
                  "a tie to another line has no place nor axis of its own: they are those of "
                  "that line");
        }
        if (!keys_.arc) {
            error("", "required key \"arc\" is missing: which point of this line is tied?");
        }
        if (keys_.type == ConstraintKind::ball_joint && !keys_.line_arc) {
            error("", "required key \"line_arc\" is missing: which point of the other line?");
        }
        c.other_arc = keys_.line_arc.value_or(0.0);
        c.other_line = tied_line(*keys_.line, c.other_arc, line_keys_, declared_, path_ + ".line",
                                 path_ + ".line_arc", problems_);
    }

    /// Where it stands, on its own axes: heights are on the line's own vertical.
    std::vector<Vec3> places(const LineConstraint& c) {
        if (keys_.type == ConstraintKind::pull_tube) {
            if (keys_.path.size() < 2) error(".path", "expected at least two points");
            if (!keys_.z.empty() || keys_.position)
                error("", "a pull tube stands where its path is");
            return {keys_.path.empty() ? Vec3::Zero().eval() : keys_.path.front()};
        }
        if (keys_.position) return {*keys_.position};
        if (keys_.z.empty()) {
            error("", "expected \"z\" or \"position\": where?");
            return {};
        }
        const bool placed = line_keys_.end_a.free != true || line_keys_.end_a.position;
        if (!placed) {
            error(".z", "x and y are those of end A, which has none: give \"position\"");
            return {};
        }
        const auto design = [this](bool on_platform, int k) {
            return on_platform ? declared_.design_of(k) : Vec3::Zero().eval();
        };
        const LineEnd& a = line_.end_a;
        const Vec3 top = a.position + design(a.kind == EndKind::platform, a.platform) -
                         design(c.on_platform, c.platform);
        std::vector<Vec3> places;
        for (const double z : keys_.z) places.emplace_back(top.x(), top.y(), z);
        return places;
    }

    void law(LineConstraint& c) {
        using Kind = ConstraintKind;
        c.path = keys_.path;
        switch (*keys_.type) {
            case Kind::guide:
            case Kind::pull_tube:
                if (!keys_.stiffness) {
                    error("", fmt::format("required key \"stiffness\" is missing (with type: {})",
                                          keys_.type == Kind::guide ? "guide" : "pull_tube"));
                }
                c.friction = keys_.friction;
                break;
            case Kind::flex_joint:
                c.rotational_curve = keys_.rotational_curve;
                check_curve(c.rotational_curve, path_ + ".rotational_stiffness", problems_);
                c.rotational_stiffness =
                    first_slope(c.rotational_curve, keys_.rotational_stiffness);
                [[fallthrough]];
            case Kind::clamp:
                if (keys_.direction) {
                    c.direction = direction_down(*keys_.direction, line_keys_.azimuth);
                }
                break;
            case Kind::tensioner:
                tensioner(c);
                break;
            case Kind::ball_joint:
            case Kind::slider:
            case Kind::winch:
                break;
        }
    }

    void tensioner(LineConstraint& c) {
        c.friction_force = keys_.friction;
        c.cylinders = keys_.cylinders;
        c.nominal_tension = keys_.nominal_tension.value_or(NAN);
        if (keys_.stroke.size() == 2) {
            c.stroke_min = keys_.stroke[0];
            c.stroke_max = keys_.stroke[1];
            if (c.stroke_min >= c.stroke_max) {
                error(".stroke", "the lower end must be below the upper");
            } else if (c.stroke_min > 0.0 || c.stroke_max < 0.0) {
                error(".stroke", "must contain stroke 0, the design position");
            }
        }
        if (!keys_.law) return;
        const bool linear = *keys_.law == TensionerLaw::linear;
        if (linear && !keys_.stiffness) {
            error("", "required key \"stiffness\" is missing (with law: linear)");
        } else if (!linear && keys_.stiffness) {
            error(".stiffness", "means something only with law: linear");
        }
        if (*keys_.law == TensionerLaw::gas) {
            c.exponent = keys_.exponent.value_or(NAN);
            c.gas_column = keys_.gas_column.value_or(NAN);
            // Without limits the law itself ends where the gas is gone.
            const double longest = 0.95 * c.gas_column;
            if (keys_.stroke.size() == 2 && c.stroke_max > longest) {
                error(".stroke", fmt::format("{:.6g} m would leave less than 5 % of the gas column "
                                             "of {:.6g} m",
                                             c.stroke_max, c.gas_column));
            }
        }
        if (*keys_.law == TensionerLaw::table) table(c);
    }

    void table(LineConstraint& c) {
        c.pull = keys_.pull;
        if (c.pull.size() < 2) return error(".table", "expected at least two rows");
        for (std::size_t i = 1; i < c.pull.size(); ++i) {
            if (c.pull[i][0] <= c.pull[i - 1][0]) {
                return error(".table", fmt::format("row {}: stroke must ascend", i + 1));
            }
            if (c.pull[i][1] < c.pull[i - 1][1]) {
                return error(".table",
                             fmt::format("row {}: tension falls as the stroke grows: such a "
                                         "tensioner holds nothing in place",
                                         i + 1));
            }
        }
        if (c.pull.front()[0] > 0.0 || c.pull.back()[0] < 0.0) {
            return error(".table", "must contain stroke 0, the design position");
        }
        for (std::size_t i = 1; i < c.pull.size(); ++i) {
            const auto &a = c.pull[i - 1], &b = c.pull[i];
            if (b[0] < 0.0) continue;
            c.nominal_tension = std::lerp(a[1], b[1], -a[0] / (b[0] - a[0]));
            break;
        }
    }

    void winch() {
        if (line_.winch) return error("", "a line has one winch");
        if (keys_.platform || !keys_.z.empty() || keys_.position || keys_.arc) {
            error("", "a winch stands at end A: it has no place of its own");
        }
        if (keys_.stiffness) error(".stiffness", "a winch has none: the line itself gives");
        if (keys_.damping > 0.0) error(".damping", "a winch has none: the line itself gives");
        if (line_.end_a.kind == EndKind::free) {
            error("", "a winch stands at end A, which is free here: it has nothing to pull at");
        }
        const Curve& rows = keys_.paid_out;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            if (rows[i][0] <= rows[i - 1][0]) {
                return error(".paid_out", fmt::format("row {}: time must ascend", i + 1));
            }
        }
        if (rows.empty()) return error(".paid_out", "expected at least one row");
        line_.winch = Winch{rows};
    }

    const ConstraintKeys& keys_;
    std::string path_;
    const LineKeys& line_keys_;
    const DeclaredCase& declared_;
    Line& line_;
    Problems& problems_;
};

}  // namespace

std::string constraint_name(const ConstraintKeys& keys, std::size_t n) {
    std::string text = keys.names.value_or(keys.name.value_or(""));
    if (const std::size_t at = text.find("{n}"); at != std::string::npos) {
        text.replace(at, 3, std::to_string(n));
    }
    return text;
}

Vec3 direction_down(double angle, std::optional<double> azimuth) {
    const double a = azimuth.value_or(0.0);
    return {std::sin(angle) * std::cos(a), std::sin(angle) * std::sin(a), -std::cos(angle)};
}

int tied_line(const std::string& name, double arc, const LineKeys& line,
              const DeclaredCase& declared, const std::string& name_path,
              const std::string& arc_path, Problems& problems) {
    std::string wanted = name;
    if (const std::size_t at = wanted.find("{n}"); at != std::string::npos) {
        int n = 0;
        for (const LineKeys& other : declared.lines) {
            if (other.family == line.family) ++n;
            if (other.name == line.name) break;
        }
        wanted.replace(at, 3, std::to_string(n));
    }
    std::vector<std::string> known;
    for (std::size_t i = 0; i < declared.lines.size(); ++i) {
        const LineKeys& other = declared.lines[i];
        if (other.name != line.name) known.push_back(other.name);
        if (other.name != wanted) continue;
        if (wanted == line.name) {
            problems.push_back({Severity::error, name_path, "a line cannot be tied to itself", {}});
            return -1;
        }
        double length = 0.0;
        for (const SectionKeys& s : other.sections) length += s.length;
        if (arc > length * (1.0 + 1e-12)) {
            problems.push_back({Severity::error,
                                arc_path,
                                fmt::format("beyond the end of {} at {:.6g} m", wanted, length),
                                {}});
        }
        return static_cast<int>(i);
    }
    problems.push_back({Severity::error,
                        name_path,
                        fmt::format("no line is named \"{}\"{}", wanted, suggestion(wanted, known)),
                        {}});
    return -1;
}

void tied_end(const EndKeys& keys, bool is_b, const LineKeys& line_keys,
              const DeclaredCase& declared, Line& line, Problems& problems) {
    if (!keys.line) return;
    const char* name = is_b ? "end_b" : "end_a";
    const std::string path = fmt::format("lines.{}.{}", line_keys.family, name);
    LineConstraint tie;
    tie.type = ConstraintType::ball_joint;
    tie.name = name;
    tie.on_platform = false;
    tie.is_end = true;
    tie.arc_length = is_b ? line.length() : 0.0;
    tie.other_arc = keys.arc.value_or(0.0);
    tie.other_line = tied_line(*keys.line, tie.other_arc, line_keys, declared, path + ".line",
                               path + ".arc", problems);
    if (tie.other_line >= 0) line.constraints.push_back(tie);
}

double first_slope(const Curve& curve, std::optional<double> number) {
    if (curve.size() > 1) return curve[1][1] / curve[1][0];
    return number.value_or(NAN);
}

void line_constraints(const LineKeys& keys, const DeclaredCase& declared, Line& line,
                      Problems& problems) {
    for (std::size_t i = 0; i < keys.constraints.size(); ++i) {
        BuildConstraint(keys.constraints[i], i, keys, declared, line, problems).run();
    }
}

void line_target(const LineKeys& keys, Line& line, Problems& problems) {
    const std::string path = "lines." + keys.family;
    const auto refuse = [&](const std::string& key, const std::string& message) {
        problems.push_back({Severity::error, path + key, message, {}});
    };
    StaticTarget& target = line.target;
    target.pretension = keys.pretension;
    target.hang_off_angle = keys.hang_off_angle;
    const bool tensioner =
        std::any_of(line.constraints.begin(), line.constraints.end(),
                    [](const LineConstraint& c) { return c.type == ConstraintType::tensioner; });
    const bool has_target = target.pretension || target.hang_off_angle;
    if (!keys.adjust) {
        if (has_target) {
            refuse(target.pretension ? ".pretension" : ".hang_off_angle",
                   "needs \"adjust\": what may statics change to meet it?");
        }
        return;
    }
    if (!has_target && !tensioner) {
        return refuse(".adjust", "nothing to meet: give pretension, hang_off_angle or a tensioner");
    }
    const std::string& text = *keys.adjust;
    const std::string start = "length of section ";
    if (text == "anchor_radius") {
        target.adjust = StaticTarget::Adjust::anchor_radius;
        if (!keys.end_b.anchor || !keys.end_b.anchor->radius) {
            refuse(".adjust", "end B has no anchor radius");
        }
    } else if (int n = 0;
               text.starts_with(start) &&
               std::from_chars(text.data() + start.size(), text.data() + text.size(), n).ptr ==
                   text.data() + text.size()) {
        target.adjust = StaticTarget::Adjust::section_length;
        target.section = n - 1;
        const int count = static_cast<int>(line.sections.size());
        if (n < 1 || n > count) {
            refuse(".adjust",
                   fmt::format("expected length of section 1 to {}; got section {}", count, n));
        }
    } else {
        refuse(
            ".adjust",
            fmt::format("expected \"anchor_radius\" or \"length of section n\"; got \"{}\"", text));
    }
}

void line_failure(const LineKeys& keys, const DeclaredCase& declared, Line& line,
                  Problems& problems) {
    if (!keys.fail || !keys.fail->line) return;
    const FailKeys& fail = *keys.fail;
    const std::string path = "lines." + keys.family + ".fail";
    const auto refuse = [&](const std::string& key, const std::string& message) {
        problems.push_back({Severity::error, path + key, message, {}});
    };
    std::vector<std::string> family;
    for (const LineKeys& other : declared.lines) {
        if (other.family == keys.family) family.push_back(other.name);
    }
    if (std::find(family.begin(), family.end(), *fail.line) == family.end()) {
        return refuse(".line", fmt::format("no line of this family is named \"{}\"{}", *fail.line,
                                           suggestion(*fail.line, family)));
    }
    if (*fail.line != line.name) return;
    double arc = fail.end_b ? line.length() : fail.arc_length.value_or(0.0);
    if (fail.joint) {
        const int last = static_cast<int>(line.sections.size()) - 1;
        if (*fail.joint > last) {
            refuse(".at", last < 1 ? "a line of one section has no joints"
                                   : fmt::format("expected joint 1 to {}; got joint {}", last,
                                                 *fail.joint));
        }
        arc = 0.0;
        for (int i = 0; i < std::min(*fail.joint, last + 1); ++i) {
            arc += line.sections[static_cast<std::size_t>(i)].length;
        }
    } else if (arc > line.length()) {
        refuse(".at", fmt::format("beyond the end of the line at {:.6g} m", line.length()));
    }
    line.fail = LineFailure{.time = fail.time, .arc_length = arc};
}

}  // namespace hawser
