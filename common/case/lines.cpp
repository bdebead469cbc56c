// Keys of lines: families of lines and what they are made of.
#include "case/lines.hpp"

#include <charconv>
#include <numbers>

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;
constexpr double turn = 2.0 * std::numbers::pi;

/// n of "joint n".
int joint_number(const std::string& text) {
    int n = 0;
    std::from_chars(text.data() + 6, text.data() + text.size(), n);
    return n;
}

const Table& polar_keys() {
    static const Table table = [] {
        Keys<PolarKeys> k("polar");
        k.number("radius", &PolarKeys::radius, length, "From the axis of that platform")
            .required()
            .at_least(0)
            .eg("20.5 m");
        k.number("azimuth", &PolarKeys::azimuth, angle, "Counter-clockwise from +x, from above")
            .follows("the line's azimuth")
            .at_least(-turn)
            .at_most(turn)
            .eg("60 deg");
        k.number("z", &PolarKeys::z, length, "Height on the platform").required().eg("-60 m");
        return k.done();
    }();
    return table;
}

const Table& anchor_keys() {
    static const Table table = [] {
        Keys<AnchorKeys> k("anchor");
        k.number("radius", &AnchorKeys::radius, length,
                 "From the axis of the platform of end A (else of end B, else of the first "
                 "constraint on one) at its design position")
            .above(0)
            .eg("2068 m");
        k.number("azimuth", &AnchorKeys::azimuth, angle, "Counter-clockwise from +x, from above")
            .follows("the line's azimuth")
            .at_least(-turn)
            .at_most(turn)
            .eg("60 deg");
        Key& position = k.custom(
            "position", Form::numbers, {length}, "x and y (z is that of the seabed)",
            [](AnchorKeys& a, const Value& v) { a.position = std::get<std::vector<double>>(v); },
            [](const AnchorKeys& a) -> Value {
                if (!a.position) return {};
                return *a.position;
            });
        position.fewest = 2;
        position.most = 3;
        position.eg("[2068 m, 0 m]");
        k.rule(KeyRule::Count::exactly_one, {"radius", "position"});
        return k.done();
    }();
    return table;
}

const Table& wellhead_keys() {
    static const Table table = [] {
        Keys<EndKeys> k("wellhead");
        k.number("z", &EndKeys::wellhead_z, length, "Height of the wellhead, below end A")
            .required()
            .eg("-1500 m");
        return k.done();
    }();
    return table;
}

const Table& harmonic_keys() {
    static const Table table = [] {
        Keys<HarmonicKeys> k("harmonic");
        k.number("amplitude", &HarmonicKeys::amplitude, length, "Amplitude").required().eg("2 m");
        k.number("period", &HarmonicKeys::period, dimension::time, "Period")
            .required()
            .above(0)
            .eg("12 s");
        k.number("phase", &HarmonicKeys::phase, angle, "Phase of the sine").def("0 deg");
        return k.done();
    }();
    return table;
}

const Table& motion_keys() {
    static const Table table = [] {
        Keys<MotionKeys> k("motion");
        k.map("surge", &MotionKeys::surge, harmonic_keys, "Harmonic motion along x");
        k.map("sway", &MotionKeys::sway, harmonic_keys, "Harmonic motion along y");
        k.map("heave", &MotionKeys::heave, harmonic_keys, "Harmonic motion along z");
        return k.done();
    }();
    return table;
}

const Table& end_keys() {
    static const Table table = [] {
        Keys<EndKeys> k("end");
        k.text("platform", &EndKeys::platform,
               "The end moves with the platform of this name; end B turns freely there")
            .eg("spar");
        k.vector(
             "position", &EndKeys::position, {length},
             "Place on the platform; of a free end A, where it is on the platform that holds it, "
             "at the design position")
            .eg("[20.5 m, 0 m, -60 m]");
        k.map("polar", &EndKeys::polar, polar_keys, "Place on the platform, by radius and azimuth");
        k.map("anchor", &EndKeys::anchor, anchor_keys, "The end is held on the seabed");
        k.group("wellhead", wellhead_keys, "The end is held on the earth, straight below end A");
        k.vector("fixed", &EndKeys::fixed, {length}, "The end is held on the earth, at x, y, z")
            .eg("[0 m, 0 m, -10 m]");
        k.map("motion", &EndKeys::motion, motion_keys, "Prescribed motion of a fixed end");
        Key& free = k.flag("free", &EndKeys::free, "The end hangs free");
        free.eg("true");
        k.choice("joint", &EndKeys::joint,
                 std::vector<std::pair<std::string, Joint>>{
                     {"ball", Joint::ball}, {"clamped", Joint::clamped}, {"flex", Joint::flex}},
                 "No moment, direction held, or rotational spring")
            .def("ball");
        k.curve(
             "rotational_stiffness", &EndKeys::rotational_stiffness, &EndKeys::rotational_curve,
             {dimension::rotational_stiffness, angle, moment},
             "Of a flex joint: moment per angle, or rows of angle and moment from [0, 0] upwards")
            .needed_with("joint", {"flex"})
            .at_least(0)
            .eg("15 kN.m/deg");
        k.number("direction", &EndKeys::direction, angle,
                 "Axis of a flex joint or clamp: angle from vertical down, in the plane of the "
                 "line's azimuth; static: the tangent in still water")
            .only_with("joint", {"clamped", "flex"})
            .or_word("static")
            .at_least(-turn)
            .at_most(turn)
            .eg("10 deg");
        k.text("line", &EndKeys::line,
               "The end is tied to a point of this other line; {n} is the number of this line in "
               "its family")
            .eg("ml1");
        k.number("arc", &EndKeys::arc, length, "Where on that line: arc length from its end A")
            .at_least(0)
            .eg("50 m");
        k.rule(KeyRule::Count::exactly_one,
               {"platform", "anchor", "wellhead", "fixed", "free", "line"});
        k.rule(KeyRule::Count::at_most_one, {"position", "polar"});
        return k.done();
    }();
    return table;
}

const Table& section_keys() {
    static const Table table = [] {
        Keys<SectionKeys> k("sections");
        k.text("type", &SectionKeys::type, "Name under line_types").required().eg("chain");
        k.number("length", &SectionKeys::length, dimension::length, "Unstretched length")
            .required()
            .above(0)
            .eg("91 m");
        k.integer("elements", &SectionKeys::elements, "Number of elements")
            .follows("50 a line, shared by length, at least 2 a section")
            .at_least(1)
            .at_most(100000)
            .eg("6");
        k.number("element_length", &SectionKeys::element_length, dimension::length,
                 "Length of an element, instead of their number")
            .above(0)
            .eg("15 m");
        k.number("growth", &SectionKeys::growth, dimension::number,
                 "Ratio of neighbouring elements, from end A")
            .def("1")
            .above(0)
            .at_most(10);
        k.rule(KeyRule::Count::at_most_one, {"elements", "element_length"});
        return k.done();
    }();
    return table;
}

const Table& attachment_keys() {
    static const Table table = [] {
        Keys<AttachmentKeys> k("attachments");
        k.custom(
             "at", Form::place, {length}, "Arc length from end A, or joint n between two sections",
             [](AttachmentKeys& a, const Value& v) {
                 if (const auto* s = std::get_if<double>(&v)) {
                     a.arc_length = *s;
                 } else {
                     a.joint = joint_number(std::get<std::string>(v));
                 }
             },
             [](const AttachmentKeys& a) -> Value {
                 if (a.joint) return "joint " + std::to_string(*a.joint);
                 if (a.arc_length) return *a.arc_length;
                 return {};
             })
            .required()
            .at_least(0)
            .eg("joint 1");
        k.number("mass", &AttachmentKeys::mass, dimension::mass, "Mass")
            .def("0 kg")
            .at_least(0)
            .eg("4 t");
        k.number("volume", &AttachmentKeys::volume, dimension::volume, "Displaced volume")
            .def("0 m3")
            .at_least(0)
            .eg("0.5 m3");
        k.number("drag_area", &AttachmentKeys::drag_area, area, "Drag coefficient x area")
            .def("0 m2")
            .at_least(0);
        k.number("Ca", &AttachmentKeys::Ca, dimension::number,
                 "Added mass coefficient on the volume")
            .def("0")
            .at_least(0);
        return k.done();
    }();
    return table;
}

const Table& sheltered_keys() {
    static const Table table = [] {
        Keys<LineKeys> k("sheltered");
        k.number("above", &LineKeys::sheltered_above, length,
                 "Height on the platform above which the water moves with the platform")
            .required()
            .eg("-70 m");
        return k.done();
    }();
    return table;
}

const Table& fail_keys() {
    static const Table table = [] {
        Keys<FailKeys> k("fail");
        k.text("line", &FailKeys::line, "Which line of the family")
            .follows("the only one")
            .eg("ml1");
        k.number("time", &FailKeys::time, dimension::time, "When it parts")
            .required()
            .at_least(0)
            .eg("600 s");
        Key& at = k.custom(
            "at", Form::place, {length},
            "Where: an arc length from end A, joint n between two sections, or an end",
            [](FailKeys& f, const Value& v) {
                if (const auto* s = std::get_if<double>(&v)) {
                    f.arc_length = *s;
                } else if (const auto& text = std::get<std::string>(v); text == "end_b") {
                    f.end_b = true;
                } else if (text != "end_a") {
                    f.joint = joint_number(text);
                }
            },
            [](const FailKeys& f) -> Value {
                if (f.joint) return "joint " + std::to_string(*f.joint);
                if (f.arc_length) return *f.arc_length;
                return std::string(f.end_b ? "end_b" : "end_a");
            });
        at.choices = {"end_a", "end_b"};
        at.def("end_a").at_least(0);
        return k.done();
    }();
    return table;
}

}  // namespace

const Table& pattern_keys() {
    static const Table table = [] {
        Keys<PatternKeys> k("pattern");
        k.text("names", &PatternKeys::names, "Names of the lines; {n} counts from 1")
            .required()
            .eg("ml{n}");
        k.integer("groups", &PatternKeys::groups, "Number of groups")
            .required()
            .at_least(1)
            .at_most(1000)
            .eg("3");
        k.number("group_spacing", &PatternKeys::group_spacing, angle,
                 "Angle from one group to the next")
            .def("0 deg")
            .eg("120 deg");
        k.integer("per_group", &PatternKeys::per_group, "Lines in a group")
            .def("1")
            .at_least(1)
            .at_most(1000)
            .eg("4");
        k.number("spacing", &PatternKeys::spacing, angle, "Angle between neighbours in a group")
            .def("0 deg")
            .eg("5 deg");
        k.number("first_group", &PatternKeys::first_group, angle,
                 "Azimuth of the first group's middle")
            .def("0 deg");
        return k.done();
    }();
    return table;
}

const Table& positions_keys() {
    static const Table table = [] {
        Keys<PositionsKeys> k("positions");
        k.text("names", &PositionsKeys::names, "Names of the lines; {n} counts from 1")
            .required()
            .eg("ttr{n}");
        Key& xy = k.custom(
            "xy", Form::rows, {length, length}, "x and y of end A on the platform, a row per line",
            [](PositionsKeys& p, const Value& v) {
                p.xy = std::get<std::vector<std::vector<double>>>(v);
            },
            [](const PositionsKeys& p) -> Value { return p.xy; });
        xy.fewest = xy.most = 2;
        xy.required().eg("[[4.5, 4.5], [-4.5, 4.5]]");
        return k.done();
    }();
    return table;
}

const Table& line_keys() {
    static const Table table = [] {
        Keys<LineKeys> k("lines");
        k.plain("like", Form::text, "Start from this other family");
        Key& pattern = k.plain("pattern", Form::map, "Lines in groups round the platform");
        pattern.table = pattern_keys;
        Key& positions = k.plain("positions", Form::map, "Vertical lines at given places");
        positions.table = positions_keys;
        Key& top = k.plain("top_z", Form::number,
                           "With positions: height of end A at the design position");
        top.dimensions = {length};
        top.eg("22 m");
        k.plain("each", Form::entries,
                "A list of maps, one line each: its name names the line, every key becomes "
                "${key} in the rest of the family");
        k.text("family", &LineKeys::family, "Family of the line in results")
            .follows("the name it stands under")
            .eg("mooring");
        k.number("azimuth", &LineKeys::azimuth, angle,
                 "Direction from the platform's centre towards the anchor")
            .follows("that of the pattern, else from end A to end B")
            .at_least(-2 * turn)
            .at_most(2 * turn)
            .eg("60 deg");
        k.map("end_a", &LineKeys::end_a, end_keys,
              "The platform end; between two platforms, either")
            .required();
        k.map("end_b", &LineKeys::end_b, end_keys, "The seabed end").required();
        k.list("sections", &LineKeys::sections, section_keys, "Sections from end A").required();
        k.list("attachments", &LineKeys::attachments, attachment_keys,
               "Point masses, clumps, buoys");
        k.number("time_step", &LineKeys::time_step, dimension::time,
                 "Upper bound of this family's rod step")
            .follows("analysis.dynamics.steps.lines")
            .above(0)
            .eg("0.02 s");
        k.list("constraints", &LineKeys::constraints, constraint_keys,
               "Tensioners, guides and other constraints along the line, in any order");
        k.group("sheltered", sheltered_keys,
                "Part of the line in water that moves with the platform: no wave, no current");
        k.choice("model", &LineKeys::model, line_model_words(), "How these lines respond")
            .follows("analysis.dynamics.line_model")
            .later_words({"linear_spring"})
            .eg("dynamic");
        k.number("pretension", &LineKeys::pretension, force,
                 "Effective tension at end A that statics meets, in still water at the design "
                 "position, by what `adjust` names")
            .above(0)
            .eg("2496 kN");
        k.number("hang_off_angle", &LineKeys::hang_off_angle, angle,
                 "Angle of end A from vertical down that statics meets, likewise")
            .at_least(0)
            .at_most(turn / 4)
            .eg("10 deg");
        k.text("adjust", &LineKeys::adjust,
               "What statics changes to meet pretension, hang_off_angle or the nominal tension of "
               "the tensioner: anchor_radius, or length of section n")
            .eg("length of section 1");
        k.number("internal_pressure", &LineKeys::internal_pressure, stress,
                 "Pressure of the contents at end A, for wall tension and stress; their own weight "
                 "comes on top below it")
            .def("0 Pa")
            .at_least(0);
        k.later("reference_temperature", "For wall tension and stress");
        k.map("fail", &LineKeys::fail, fail_keys, "A line of this family parts; of dynamic lines");
        k.rule(KeyRule::Count::at_most_one, {"pretension", "hang_off_angle"});
        k.rule(KeyRule::Count::at_most_one, {"pattern", "positions", "each"});
        return k.done();
    }();
    return table;
}

}  // namespace hawser
