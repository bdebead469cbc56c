#include "case/line_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "case/build_constraints.hpp"
#include "line_mesh.hpp"
#include "line_weight.hpp"
#include "message.hpp"
#include "packing.hpp"

namespace hawser {
namespace {

class LineChecks {
 public:
    LineChecks(const Line& line, const LineKeys& keys, const Case& whole, Problems& problems)
        : line_(line),
          keys_(keys),
          case_(whole),
          path_("lines." + line.family),
          problems_(problems) {}

    void run() {
        for (const Section& s : line_.sections) {
            if (s.type < 0) return;  // reported already
        }
        ends();
        for (const LineConstraint& c : line_.constraints) constraint(c);
        if (line_.end_a.kind == EndKind::free) tensioned_from_above();
        held_twice();
        needs();
        response();
        parts();
        ties();
        platforms();
        mesh();
    }

 private:
    void error(const std::string& key, const std::string& message) {
        problems_.push_back({.severity = Severity::error,
                             .path = path_ + key,
                             .message = message,
                             .file = {},
                             .subject = line_.name});
    }
    void warning(const std::string& key, const std::string& message) {
        error(key, message);
        problems_.back().severity = Severity::warning;
    }

    /// Key of a constraint: the declared one that its name was made of.
    std::string key_of(const LineConstraint& c) const {
        if (c.is_end) return "." + c.name;
        for (std::size_t i = 0; i < keys_.constraints.size(); ++i) {
            const ConstraintKeys& declared = keys_.constraints[i];
            for (std::size_t n = 1; n <= std::max<std::size_t>(1, declared.z.size()); ++n) {
                const std::string name = constraint_name(declared, n);
                if (c.name == name || c.name == name + ".upper" || c.name == name + ".lower") {
                    return fmt::format(".constraints[{}]", i);
                }
            }
        }
        return ".constraints";
    }

    const LineType& type(int i) const { return case_.line_types[static_cast<std::size_t>(i)]; }

    /// Of a section, tapered or not: the mean of a quantity of its two types.
    template <class F>
    double mean(const Section& s, F quantity) const {
        const double from = quantity(type(s.type));
        return s.type_at_end < 0 ? from : 0.5 * (from + quantity(type(s.type_at_end)));
    }

    double wet(const LineType& t) const {
        const Water& water = case_.environment.water;
        return (t.mass - water.density * t.displaced_area) * water.gravity;
    }

    double bed(const Vec3& r) const { return case_.environment.seabed.height(r.x(), r.y()); }

    /// What it could stretch to before it breaks [m].
    double stretch() const { return greatest_stretch(line_, case_); }

    /// At a place that the case gives.
    static bool stands(const LineEnd& end) {
        return end.kind != EndKind::free && end.kind != EndKind::line;
    }

    LineModel model_of(const Line& line) const {
        return line.model.value_or(case_.analysis.dynamics.line_model);
    }

    /// Lines tied to each other.
    void ties() {
        if (line_.target.adjust != StaticTarget::Adjust::none) one_target();
        for (const LineConstraint& c : line_.constraints) {
            if (c.other_line < 0) continue;
            const Line& other = case_.lines[static_cast<std::size_t>(c.other_line)];
            if (model_of(other) != model_of(line_)) {
                error(key_of(c), fmt::format("\"{}\" ties it to {}, which has another model: lines "
                                             "that are tied move together",
                                             c.name, other.name));
            }
            if (c.is_end && waits_for_itself(other)) {
                error(key_of(c), fmt::format("the end hangs on {}, which in turn hangs on this "
                                             "line: one of them must stand by itself",
                                             other.name));
            }
        }
    }

    void one_target() {
        for (const std::vector<int>& bundle : bundles_of(case_)) {
            const Line* first = nullptr;
            for (const int i : bundle) {
                const Line& line = case_.lines[static_cast<std::size_t>(i)];
                if (line.target.adjust == StaticTarget::Adjust::none) continue;
                if (first == nullptr) first = &line;
                if (&line != &line_ || first == &line_) continue;
                error(".adjust", fmt::format("{}, to which it is tied, is to be adjusted too: "
                                             "statics meets one target of such lines",
                                             first->name));
            }
        }
    }

    /// Do ends on lines lead from `line` back to this one?
    bool waits_for_itself(const Line& line) const {
        std::vector<const Line*> reached{&line};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            if (reached[i] == &line_) return true;
            for (const LineConstraint& c : reached[i]->constraints) {
                if (!c.is_end || c.other_line < 0) continue;
                const Line* next = &case_.lines[static_cast<std::size_t>(c.other_line)];
                if (std::find(reached.begin(), reached.end(), next) == reached.end())
                    reached.push_back(next);
            }
        }
        return false;
    }

    /// A line, with those that it is tied to, brings its load to two platforms at most.
    void platforms() {
        const std::vector<std::vector<int>> bundles = bundles_of(case_);
        const auto own = std::find_if(bundles.begin(), bundles.end(), [&](const auto& bundle) {
            return &case_.lines[static_cast<std::size_t>(bundle.front())] == &line_;
        });
        if (own == bundles.end()) return;  // said of the first line of a bundle
        std::set<int> touched;
        for (const int i : *own) {
            const Line& line = case_.lines[static_cast<std::size_t>(i)];
            for (const LineEnd* end : {&line.end_a, &line.end_b})
                if (end->kind == EndKind::platform) touched.insert(end->platform);
            for (const LineConstraint& c : line.constraints)
                if (c.on_platform && c.other_line < 0) touched.insert(c.platform);
        }
        if (touched.size() <= most_touched || case_.platform_count() == 0) return;
        std::string names;
        for (const int k : touched)
            names += (names.empty() ? "" : ", ") + case_.platform_at(k).name;
        error("", fmt::format("touches the platforms {}{}; at most {}: the elimination carries the "
                              "coordinates of no more",
                              names, own->size() > 1 ? ", with the lines that it is tied to" : "",
                              most_touched));
    }

    void ends() {
        const Vec3 a = case_.place_of(line_.end_a), b = case_.place_of(line_.end_b);
        const double length = line_.length();
        const bool held = stands(line_.end_a) && stands(line_.end_b);
        const double distance = (b - a).norm();
        const bool moves = line_.target.adjust != StaticTarget::Adjust::none;
        if (held && !moves && distance > length + stretch()) {
            error("",
                  fmt::format("{:.6g} m long, but its ends are {:.6g} m apart", length, distance));
        }
        const double fold = std::hypot(b.x() - a.x(), b.y() - a.y()) + std::abs(b.z() - a.z());
        if (held && !moves && line_.end_b.kind == EndKind::anchor && length > fold) {
            warning("", fmt::format("{:.6g} m long, more than straight down and along the seabed "
                                    "({:.6g} m)",
                                    length, fold));
        }
        for (const auto& [end, key] :
             {std::pair{&line_.end_a, ".end_a"}, {&line_.end_b, ".end_b"}}) {
            const Vec3 at = case_.place_of(*end);
            const double floor = bed(at);
            if (stands(*end) && at.z() < floor - 1e-9 * std::abs(floor)) {
                error(key,
                      fmt::format("z = {:.6g} m is below the seabed at {:.6g} m", at.z(), floor));
            }
        }
        for (const auto& [end, key, arc] :
             {std::tuple{&line_.end_a, ".end_a", 0.0}, std::tuple{&line_.end_b, ".end_b", length}})
            if (end->kind != EndKind::free && end->joint == Joint::clamped && limp_at(arc))
                error(key, no_clamp);
        double travel = 0.0;
        for (const Section& s : line_.sections) {
            travel +=
                s.length * mean(s, [](const LineType& t) { return std::sqrt(t.mass / t.EA); });
        }
        const double period = 2.0 * travel, D = case_.analysis.dynamics.platform_step;
        const bool on_platform =
            line_.end_a.kind == EndKind::platform || line_.end_b.kind == EndKind::platform;
        if (on_platform && held && period < D) {
            warning("", fmt::format("first axial period {:.3g} s is below the platform step {:.3g} "
                                    "s; the coupling may go unstable",
                                    period, D));
        }
    }

    static constexpr const char* no_clamp =
        "a clamp holds a direction, and a line without bending stiffness has none to hold; "
        "expected "
        "EI above 0 there, or a ball joint";

    /// Has the line no bending stiffness at an arc length?
    [[nodiscard]] bool limp_at(double arc_length) const {
        double begins = 0.0;
        for (const Section& s : line_.sections) {
            begins += s.length;
            if (arc_length > begins + 1e-9 * begins) continue;
            return mean(s, [](const LineType& t) { return t.EI; }) == 0.0;
        }
        return false;
    }

    void constraint(const LineConstraint& c) {
        const std::string key = key_of(c);
        const auto say = [&](const std::string& message) {
            error(key, fmt::format("\"{}\": {}", c.name, message));
        };
        if (c.stiffness > 1e10) {
            say(
                fmt::format("{:.3g} N/m is stiffer than steel against steel (about 1e9 N/m): no "
                            "step of the rods resolves such an impact; 1e10 N/m is the limit",
                            c.stiffness));
        }
        const bool limp =
            c.arc_length
                ? limp_at(*c.arc_length)
                : std::all_of(line_.sections.begin(), line_.sections.end(), [&](const Section& s) {
                      return mean(s, [](const LineType& t) { return t.EI; }) == 0.0;
                  });
        if (c.type == ConstraintType::clamp && limp) say(no_clamp);
        if (c.friction > 1.0) {
            warning(key, fmt::format("\"{}\": coefficient of friction {:.3g}; steel has 0.1 to 0.5",
                                     c.name, c.friction));
        }
        if (c.other_line >= 0) return;
        std::vector<Vec3> places = c.path;
        if (places.empty()) places.push_back(c.position);
        for (const Vec3& place : places) this->place(c, place);
        if (!c.arc_length) between_ends(c);
        for (const Vec3& cylinder : c.cylinders) {
            if ((cylinder - c.position).dot(c.axis) > 0.0) continue;
            say(
                fmt::format("a cylinder at z = {:.6g} m is not above the line's top at {:.6g} m: "
                            "it could not pull upwards",
                            cylinder.z(), c.position.z()));
            break;
        }
    }

    void place(const LineConstraint& c, const Vec3& place) {
        const std::string key = key_of(c);
        const auto say = [&](const std::string& message) {
            error(key, fmt::format("\"{}\": {}", c.name, message));
        };
        const Vec3 at = case_.place_of(c, place);
        const double z = place.z(), floor = bed(at);
        if (z < floor - 1e-9 * std::abs(floor)) {
            return say(fmt::format("z = {:.6g} m is below the seabed at {:.6g} m", z, floor));
        }
        const std::optional<double> draft =
            c.on_platform && case_.platform ? case_.platform_at(c.platform).draft : std::nullopt;
        if (draft && z < -*draft - 1.0) {
            warning(key,
                    fmt::format("\"{}\": z = {:.6g} m is below the platform's keel at {:.6g} m",
                                c.name, z, -*draft));
        }
        const bool judged = c.type == ConstraintType::tensioner ||  // by its stroke
                            c.arc_length.value_or(0.0) > line_.length();
        if (judged || line_.target.adjust != StaticTarget::Adjust::none) return;
        // From an end of the line to the place there must be line enough.
        const double length = line_.length(), arc = c.arc_length.value_or(NAN);
        for (const auto& [end, along] :
             {std::pair{&line_.end_a, arc}, {&line_.end_b, length - arc}}) {
            if (!stands(*end)) continue;
            const double distance = (at - case_.place_of(*end)).norm();
            const double reach = (std::isnan(along) ? length : along) * (1.0 + stretch() / length);
            if (distance > reach + 0.1) {
                return say(
                    fmt::format("out of the line's reach: {:.6g} m from its end, to which "
                                "it has {:.6g} m of line",
                                distance, reach));
            }
        }
    }

    /// Where end A is at the design position: where it is held, or above its tensioner's place.
    std::optional<Vec3> top() const {
        if (line_.end_a.kind != EndKind::free) return case_.place_of(line_.end_a);
        for (const LineConstraint& c : line_.constraints)
            if (c.type == ConstraintType::tensioner)
                return case_.place_of(c, c.position) + c.arc_length.value_or(0.0) * c.axis;
        return std::nullopt;
    }

    /// Does a point of the line lie in the plane of a constraint that takes what passes it?
    /// Certain of lines as good as straight, and of places above a heavy line or further away than
    /// the line can go and come back; what sags is left to the statics.
    void between_ends(const LineConstraint& c) {
        using Type = ConstraintType;
        if (c.type == Type::tensioner || c.type == Type::pull_tube || c.other_line >= 0) return;
        if (line_.end_b.kind == EndKind::free || !top()) return;
        const Vec3 at = case_.place_of(c, c.position);
        if (at.z() < bed(at)) return;  // that has been told
        const Vec3 a = *top(), b = case_.place_of(line_.end_b);
        const double from_a = (a - at).dot(c.axis), from_b = (b - at).dot(c.axis);
        const bool slides = c.type == Type::guide || c.type == Type::slider;
        constexpr double touching = 1e-6;
        const bool at_end = slides && std::min(std::abs(from_a), std::abs(from_b)) <= touching;
        if (from_a * from_b <= 0.0 && !at_end) return;
        const Vec3 mirrored = b - 2.0 * from_b * c.axis;  // there and back in one straight line
        const double length = line_.length() + stretch();
        const bool adjusted = line_.target.adjust != StaticTarget::Adjust::none;
        const bool straight = line_.end_a.kind == EndKind::free ||
                              (!adjusted && line_.length() < 1.02 * (b - a).norm());
        const bool above = submerged_weight(line_, case_) > 0.0 && c.axis.z() > 0.999 &&
                           c.position.z() > std::max(a.z(), b.z());
        const bool too_far = !adjusted && (a - mirrored).norm() > length;
        if (!at_end && !straight && !above && !too_far) return;
        const std::string found =
            c.axis.z() > 0.999
                ? fmt::format("stands at z = {:.6g} m, the line's ends at {:.6g} m and {:.6g} m",
                              c.position.z(), a.z(), b.z())
                : fmt::format(
                      "the line's ends stand {:.6g} m and {:.6g} m from its place along "
                      "its axis",
                      from_a, from_b);
        error(key_of(c),
              fmt::format("\"{}\": {}: {}; expected a place between the ends", c.name, found,
                          at_end ? "an end of the line would slip out at once"
                                 : "no point of the line lies there"));
    }

    /// A riser held by tensioners at its top: is it long and tight enough?
    void tensioned_from_above() {
        double pull = 0.0;
        const LineConstraint* tensioner = nullptr;
        for (const LineConstraint& c : line_.constraints) {
            if (c.type != ConstraintType::tensioner) continue;
            pull += c.nominal_tension;
            if (tensioner == nullptr) tensioner = &c;
        }
        if (tensioner == nullptr || !stands(line_.end_b)) return;
        const double weight = submerged_weight(line_, case_, tensioner->arc_length.value_or(0.0));
        if (pull < 1.1 * weight) {
            warning(key_of(*tensioner),
                    fmt::format("tensioners pull with {:.0f} kN, less than 1.1 times the submerged "
                                "weight of {:.0f} kN: the bottom may go into compression",
                                pull / 1e3, weight / 1e3));
        }
        if (line_.target.pretension || line_.target.hang_off_angle) {
            error("",
                  "pretension and hang_off_angle are of an end that is held; this one hangs in "
                  "its tensioner: its nominal_tension is the target");
        }
        span(*tensioner, pull);
    }

    /// Stroke at which the tensioner would stand if nothing were adjusted.
    void span(const LineConstraint& tensioner, double pull) {
        double stretch = 0.0, tension = pull;
        for (const Section& s : line_.sections) {
            const double weight = s.length * mean(s, [this](const LineType& t) { return wet(t); });
            const double EA = mean(s, [](const LineType& t) {
                return t.viscoelastic ? t.viscoelastic->EA_static : t.EA;
            });
            stretch += (tension - 0.5 * weight) / EA * s.length;
            tension -= weight;
        }
        const double distance =
            (case_.place_of(tensioner, tensioner.position) - case_.place_of(line_.end_b)).norm();
        const double length = line_.length() - tensioner.arc_length.value_or(0.0);
        const double stroke = distance - length - stretch;
        const std::string spans = fmt::format(
            "sections sum to {:.6g} m, {:.6g} m with their stretch, for a distance of {:.6g} m",
            length, length + stretch, distance);
        if (line_.target.adjust == StaticTarget::Adjust::section_length) {
            const auto n = static_cast<std::size_t>(line_.target.section);
            if (n >= line_.sections.size()) return;  // reported already
            if (line_.sections[n].length + stroke <= 0.0) {
                error(".sections", fmt::format("{}: section {} is too short to be adjusted by that",
                                               spans, n + 1));
            } else if (std::abs(stroke) > 0.02 * length) {
                warning(".sections", fmt::format("{}: statics will change section {} by {:+.6g} m",
                                                 spans, n + 1, stroke));
            }
        } else if (stroke < tensioner.stroke_min || stroke > tensioner.stroke_max) {
            error(".sections",
                  fmt::format("{}: the tensioner would stand at stroke {:.3g} m, beyond its stop; "
                              "change a length, or give \"adjust\"",
                              spans, stroke));
        } else if (std::abs(stroke) > 0.25) {
            warning(".sections",
                    fmt::format("{}: the tensioner starts at stroke {:.3g} m, where it does not "
                                "have its nominal tension; \"adjust\" meets it",
                                spans, stroke));
        }
    }

    void held_twice() {
        if (line_.end_a.kind == EndKind::free) return;
        for (const LineConstraint& c : line_.constraints) {
            if (c.type != ConstraintType::tensioner || c.arc_length.value_or(1.0) > 0.0) continue;
            error(key_of(c), fmt::format("\"{}\": end A is held already: a tensioner there "
                                         "needs end_a: {{free: true}}",
                                         c.name));
        }
        if (line_.winch && line_.end_a.kind == EndKind::anchor) {
            error(winch_key(), "a winch stands at end A, which is an anchor here");
        }
    }

    /// Keys that need something that is not there.
    void needs() {
        if (line_.sheltered_above && !case_.platform) {
            error(".sheltered", "there is no platform for the water to move with");
        }
        const auto pipe = [this](const Section& s) { return type(s.type).wall.has_value(); };
        if (line_.internal_pressure > 0.0 &&
            std::none_of(line_.sections.begin(), line_.sections.end(), pipe)) {
            error(".internal_pressure", "acts on pipes only; none of its sections is one");
        }
    }

    /// What a line without dynamics cannot have.
    void response() {
        const LineModel its = model_of(line_);
        if (its == LineModel::dynamic) return;
        const auto refuse = [&](bool has, const char* what, const char* instead) {
            if (has) error("", fmt::format("{}; use the model {}", what, instead));
        };
        refuse(line_.fail.has_value(),
               "a line without dynamics cannot part (how the others stand without it: hawser "
               "statics --without NAME)",
               "dynamic");
        refuse(line_.winch.has_value(), "only a dynamic line is paid out", "dynamic");
        if (its != LineModel::catenary) return;
        bool bends = false, curved = false;
        for (const Section& s : line_.sections) {
            bends = bends || type(s.type).EI > 0.0;
            curved = curved || !type(s.type).EA_curve.empty();
        }
        const auto turns_freely = [](const LineEnd& end) {
            return stands(end) && end.joint == Joint::ball;
        };
        refuse(!line_.constraints.empty(), "a catenary runs from end to end without constraints",
               "quasi_static");
        refuse(bends, "a catenary has no bending stiffness", "quasi_static");
        refuse(curved, "a catenary stretches by one stiffness, not by a curve", "quasi_static");
        refuse(!turns_freely(line_.end_a) || !turns_freely(line_.end_b),
               "a catenary hangs between two ball joints", "quasi_static");
        refuse(case_.environment.seabed.slope_angle != 0.0, "a catenary lies on a level bed",
               "quasi_static");
        refuse(line_.end_b.kind == EndKind::platform,
               "a catenary has the stiffness of its end A alone, so its end B cannot be on a "
               "platform",
               "quasi_static");
    }

    std::string winch_key() const {
        for (std::size_t i = 0; i < keys_.constraints.size(); ++i) {
            if (keys_.constraints[i].type != ConstraintKind::winch) continue;
            return fmt::format(".constraints[{}].paid_out", i);
        }
        return ".constraints";
    }

    /// Failure and winch.
    void parts() {
        const double duration = case_.analysis.dynamics.duration;
        if (line_.fail && line_.fail->time >= duration) {
            warning(".fail", fmt::format("at {:.6g} s, after the end of the run at {:.6g} s",
                                         line_.fail->time, duration));
        }
        if (!line_.winch) return;
        const Curve& rows = line_.winch->paid_out;
        double least = 0.0, before = rows.front()[1];
        for (std::size_t i = 0; i < rows.size(); ++i) {
            least = std::min(least, rows[i][1]);
            if (rows[i][0] > 0.0) continue;
            before = rows[i][1];
            if (i + 1 < rows.size() && rows[i + 1][0] > 0.0) {
                const double part = -rows[i][0] / (rows[i + 1][0] - rows[i][0]);
                before = std::lerp(rows[i][1], rows[i + 1][1], part);
            }
        }
        if (before != 0.0) {
            error(winch_key(), fmt::format("the winch has paid out {:.6g} m at the start; the "
                                           "length counts from there: begin with [0 s, 0 m]",
                                           before));
        }
        if (-least >= line_.sections.front().length) {
            error(winch_key(),
                  fmt::format("the winch takes in {:.6g} m, all of section 1", -least));
        }
    }

    double bending_stiffness(const LineMesh& mesh, std::size_t e) const {
        const auto in = static_cast<std::size_t>(mesh.section[e]);
        const Section& s = line_.sections[in];
        const double from = type(s.type).EI;
        if (s.type_at_end < 0) return from;
        double start = 0.0;
        for (std::size_t i = 0; i < in; ++i) start += line_.sections[i].length;
        const double middle = 0.5 * (mesh.arc_length[e] + mesh.arc_length[e + 1]);
        return from + (middle - start) / s.length * (type(s.type_at_end).EI - from);
    }

    /// Tension to be expected at an arc length: what the tensioners or the pretension leave of the
    /// weight above, or else the weight below; never less than a fifth of the line's weight.
    double expected_tension(double arc_length) const {
        const double weight = std::abs(submerged_weight(line_, case_));
        const double below = submerged_weight(line_, case_, arc_length);
        double top = line_.target.pretension.value_or(0.0);
        for (const LineConstraint& c : line_.constraints)
            if (c.type == ConstraintType::tensioner) top += c.nominal_tension;
        const double T = top > 0.0 ? top - (submerged_weight(line_, case_) - below) : below;
        return std::max({T, 0.2 * weight, 1.0});
    }

    /// Elements too coarse for how the line bends: beside short ones, or beside a jump of bending
    /// stiffness. Of each line the worst place.
    void mesh() {
        constexpr double most_ratio = 3.0, most_bending_lengths = 3.0, jump = 1.5;
        const LineMesh mesh = mesh_of(line_);
        double worst = 1.0, suggested = 0.0, bending_length = 0.0;
        std::size_t at = 0, beside = 0;
        const auto length = [&](std::size_t e) {
            return mesh.arc_length[e + 1] - mesh.arc_length[e];
        };
        for (std::size_t e = 0; e < mesh.section.size(); ++e) {
            for (const std::size_t other : {e - 1, e + 1}) {  // e - 1 wraps: beyond the end too
                if (other >= mesh.section.size()) continue;
                const double EI = bending_stiffness(mesh, e), its = bending_stiffness(mesh, other);
                if (EI <= 0.0 || its <= 0.0) continue;
                const double h = length(e), short_one = length(other);
                const double node = mesh.arc_length[std::max(e, other)];
                const double scale = std::sqrt(EI / expected_tension(node));
                const bool jumps = std::max(EI, its) > jump * std::min(EI, its);
                const double by_ratio = h > 2.0 * scale ? h / short_one / most_ratio : 0.0;
                const double by_jump = jumps ? h / scale / most_bending_lengths : 0.0;
                if (std::max(by_ratio, by_jump) <= worst * (1.0 + 1e-9)) continue;
                worst = std::max(by_ratio, by_jump);
                at = e, beside = other, bending_length = scale;
                suggested = h;
                if (by_ratio > 1.0) suggested = std::min(suggested, most_ratio * short_one);
                if (by_jump > 1.0) suggested = std::min(suggested, most_bending_lengths * scale);
            }
        }
        if (worst <= 1.0) return;
        const auto section = static_cast<std::size_t>(mesh.section[at]);
        warning(fmt::format(".sections[{}]", section),
                fmt::format("at {:.4g} m, elements of {:.3g} m follow on {:.3g} m, where the line "
                            "bends over lengths of {:.2g} m: curvature and stress there are rough; "
                            "{:.2g} m or shorter next to it (\"growth\", or a section of its own)",
                            mesh.arc_length[std::max(at, beside)], length(at), length(beside),
                            bending_length, suggested));
    }

    const Line& line_;
    const LineKeys& keys_;
    const Case& case_;
    std::string path_;
    Problems& problems_;
};

}  // namespace

void check_line(const Line& line, const LineKeys& keys, const Case& whole, Problems& problems) {
    LineChecks(line, keys, whole, problems).run();
}

}  // namespace hawser
