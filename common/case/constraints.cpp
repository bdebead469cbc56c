// Keys of constraints along a line (case key `lines.*.constraints`).
#include <numbers>

#include "case/declared.hpp"

namespace hawser {
namespace {

using namespace dimension;
constexpr double turn = 2.0 * std::numbers::pi;

/// Points x, y, z kept as vectors.
Key& places(Keys<ConstraintKeys>& k, const std::string& name,
            std::vector<Vec3> ConstraintKeys::*member, const std::string& sentence) {
    Key& key = k.custom(
        name, Form::rows, {length}, sentence,
        [member](ConstraintKeys& c, const Value& value) {
            for (const auto& row : std::get<std::vector<std::vector<double>>>(value)) {
                (c.*member).emplace_back(row[0], row[1], row[2]);
            }
        },
        [member](const ConstraintKeys& c) -> Value {
            std::vector<std::vector<double>> rows;
            for (const Vec3& x : c.*member) rows.push_back({x.x(), x.y(), x.z()});
            if (rows.empty()) return {};
            return rows;
        });
    key.fewest = key.most = 3;
    return key;
}

void place_keys(Keys<ConstraintKeys>& k) {
    using C = ConstraintKeys;
    k.text("platform", &C::platform,
           "Platform that it belongs to; seabed: the earth, where places are x, y, z of the world")
        .eg("spar");
    k.text("line", &C::line,
           "Other line that a slider or ball joint ties this one to, instead of a platform; {n} is "
           "the number of this line in its family")
        .only_with("type", {"slider", "ball_joint"})
        .eg("carrier");
    k.number("line_arc", &C::line_arc, length,
             "Of a ball joint to another line: arc length there, from its end A")
        .only_with("type", {"ball_joint"})
        .at_least(0)
        .eg("120 m");
    k.text("name", &C::name, "Name in the results").follows("its type").eg("keel");
    k.text("names", &C::names, "With a list of heights: names of each; {n} counts from 1")
        .eg("plate{n}");
    k.number("arc", &C::arc, length,
             "Arc length from end A of the point that is held; of a tensioner 0 m by default, else "
             "whatever passes the place; with \"line\" always")
        .at_least(0)
        .eg("0 m");
    k.numbers("z", &C::z, length, 1, 1000,
              "Height of the place, or a list of heights; x and y are those of the line's end A")
        .eg("-173 m");
    k.vector("position", &C::position, {length}, "Place, instead of z").eg("[0 m, 0 m, -173 m]");
    k.vector("axis", &C::axis, {dimension::number}, "Axis along which the line slides")
        .only_with("type", {"guide", "slider"})
        .follows("vertical")
        .eg("[0, 0, 1]");
}

void contact_keys(Keys<ConstraintKeys>& k) {
    using C = ConstraintKeys;
    k.number("gap", &C::gap, length, "Radial gap between line and guide")
        .only_with("type", {"guide", "slider", "pull_tube"})
        .def("0 m")
        .at_least(0)
        .eg("25 mm");
    k.number("length", &C::length, dimension::length,
             "Length of a guide: contact points <name>.upper and <name>.lower at half of it above "
             "and below; 0: one point")
        .only_with("type", {"guide"})
        .def("0 m")
        .at_least(0)
        .eg("2 m");
    k.number("stiffness", &C::stiffness, dimension::stiffness,
             "Force per displacement: of the contact, of the linear tensioner; a contact (guide, "
             "pull tube, slider with a gap) begins softly: k pen^2/(4 mm) up to a penetration pen "
             "of 2 mm, k (pen - 1 mm) beyond")
        .follows(
            "joints and clamps: ten times that of the element they hold; sliders 100 MN/m; none "
            "for "
            "the others")
        .above(0)
        .eg("20 MN/m");
    k.number("damping", &C::damping, dimension::damping, "Force per speed, with the stiffness")
        .def("0 N.s/m")
        .at_least(0)
        .eg("200 kN.s/m");
    Key& friction = k.number("friction", &C::friction, dimension::number,
                             "Of a guide or pull tube the Coulomb coefficient along it, of a "
                             "tensioner the friction force of its rams");
    friction.only_with("type", {"guide", "pull_tube", "tensioner"}).def("0").at_least(0).eg("0.1");
    friction.dimensions.push_back(force);
    friction.dimension_index = [](const void* object) -> std::size_t {
        return static_cast<const C*>(object)->type == ConstraintKind::tensioner ? 1 : 0;
    };
    k.number("mobilisation", &C::mobilisation, dimension::length,
             "Slide after which friction is fully mobilised")
        .only_with("type", {"guide", "pull_tube", "tensioner"})
        .def("10 mm")
        .above(0);
    places(k, "path", &C::path, "Points of a pull tube in the order of the line, from end A")
        .needed_with("type", {"pull_tube"})
        .eg("[[20 m, 0 m, -100 m], [21 m, 0 m, -140 m], [25 m, 0 m, -165 m]]");
}

void tensioner_keys(Keys<ConstraintKeys>& k) {
    using C = ConstraintKeys;
    k.choice("law", &C::law,
             std::vector<std::pair<std::string, TensionerLaw>>{{"linear", TensionerLaw::linear},
                                                               {"gas", TensionerLaw::gas},
                                                               {"table", TensionerLaw::table}},
             "Tension against stroke x: F0 + K x, F0 (L/(L - x))^n, or a table")
        .needed_with("type", {"tensioner"})
        .eg("gas");
    k.number("nominal_tension", &C::nominal_tension, force,
             "Tension F0 at stroke 0, which is the design position in still water")
        .needed_with("law", {"linear", "gas"})
        .above(0)
        .eg("5338 kN");
    k.number("exponent", &C::exponent, dimension::number, "Polytropic exponent n of the gas")
        .needed_with("law", {"gas"})
        .above(0)
        .at_most(3)
        .eg("1.1");
    k.number("gas_column", &C::gas_column, length, "Length L of the gas column at stroke 0")
        .needed_with("law", {"gas"})
        .above(0)
        .eg("40 m");
    k.points("table", &C::pull, {length, force},
             "Rows of stroke and tension, straight between; stroke grows when the line's top goes "
             "down against the platform")
        .needed_with("law", {"table"})
        .eg("[[-4.5 m, 4700 kN], [0 m, 5338 kN], [4.5 m, 6100 kN]]");
    k.numbers("stroke", &C::stroke, length, 2, 2, "Stroke at which the rams stop, up and down")
        .only_with("type", {"tensioner"})
        .follows("unlimited")
        .eg("[-4.5 m, 4.5 m]");
    places(k, "cylinders", &C::cylinders,
           "Points of the platform where the cylinders are hung up, their pull shared evenly")
        .only_with("type", {"tensioner"})
        .follows("one, on the line's axis")
        .eg("[[2 m, 0 m, 30 m], [-2 m, 0 m, 30 m]]");
}

}  // namespace

const Table& constraint_keys() {
    static const Table table = [] {
        using C = ConstraintKeys;
        Keys<C> k("constraints");
        k.choice(
             "type", &C::type,
             std::vector<std::pair<std::string, ConstraintKind>>{
                 {"ball_joint", ConstraintKind::ball_joint},
                 {"flex_joint", ConstraintKind::flex_joint},
                 {"clamp", ConstraintKind::clamp},
                 {"tensioner", ConstraintKind::tensioner},
                 {"guide", ConstraintKind::guide},
                 {"slider", ConstraintKind::slider},
                 {"pull_tube", ConstraintKind::pull_tube},
                 {"winch", ConstraintKind::winch}},
             "Kind of constraint; a guide or slider without arc holds what passes its plane and "
             "must stand between the line's ends; a slider is a guide without friction, in both "
             "senses where it has no gap; a winch stands at end A: no platform, place or arc")
            .required()
            .eg("guide");
        place_keys(k);
        contact_keys(k);
        tensioner_keys(k);
        k.curve(
             "rotational_stiffness", &C::rotational_stiffness, &C::rotational_curve,
             {dimension::rotational_stiffness, angle, moment},
             "Of a flex joint: moment per angle, or rows of angle and moment from [0, 0] upwards")
            .needed_with("type", {"flex_joint"})
            .at_least(0)
            .eg("15 kN.m/deg");
        k.number("direction", &C::direction, angle,
                 "Axis of a flex joint or clamp: angle from vertical down, in the plane of the "
                 "line's azimuth; static: the tangent in still water")
            .only_with("type", {"flex_joint", "clamp"})
            .or_word("static")
            .at_least(-turn)
            .at_most(turn)
            .eg("0 deg");
        k.points("paid_out", &C::paid_out, {dimension::time, length},
                 "Of a winch at end A, dynamic lines only: rows of time and length paid out since "
                 "the start (taken in: negative), straight between, constant outside")
            .needed_with("type", {"winch"})
            .eg("[[0 s, 0 m], [600 s, 50 m]]");
        k.rule(KeyRule::Count::at_most_one, {"name", "names"});
        k.rule(KeyRule::Count::at_most_one, {"z", "position"});
        return k.done();
    }();
    return table;
}

}  // namespace hawser
