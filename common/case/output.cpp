#include "case/output.hpp"

#include "case/declared.hpp"

namespace hawser {
namespace {

/// A list of words that is kept as it is written.
Key& chosen_words(Keys<LineOutput>& k, const std::string& name,
                  std::vector<std::string> LineOutput::*member, std::vector<std::string> choices,
                  const std::string& sentence) {
    Key& key = k.custom(
        name, Form::words, {}, sentence,
        [member](LineOutput& output, const Value& value) {
            output.*member = std::get<std::vector<std::string>>(value);
        },
        [member](const LineOutput& output) -> Value { return output.*member; });
    key.choices = std::move(choices);
    return key;
}

const Table& line_output_keys() {
    static const Table table = [] {
        Keys<LineOutput> k("lines");
        k.text("select", &LineOutput::select, "Names of lines, with * and ?").def("*").eg("ml*");
        k.words("at", {{"end_a", &LineOutput::end_a}, {"end_b", &LineOutput::end_b}},
                "Where along the line")
            .def("[end_a]");
        chosen_words(k, "results", &LineOutput::results,
                     {"effective_tension", "declination", "azimuth", "force", "moment"},
                     "What is recorded there, of constraints and of the touchdown")
            .later_words({"wall_tension", "axial_strain", "curvature", "bend_moment", "shear_force",
                          "von_mises_stress", "axial_stress", "bending_stress", "seabed_force",
                          "touchdown.arc_length", "tensioner.tension", "tensioner.stroke",
                          "guide.force"})
            .def("[effective_tension]");
        k.later("at_arc", "Places along the line");
        k.later("range", "Least, mean and greatest value along the line");
        return k.done();
    }();
    return table;
}

}  // namespace

const Table& output_keys() {
    static const Table table = [] {
        Keys<Output> k("output");
        k.number("interval", &Output::interval, dimension::time,
                 "Sampling interval, a multiple of the platform step")
            .follows("the platform step")
            .above(0)
            .eg("0.5 s");
        k.number("snapshots", &Output::snapshots, dimension::time,
                 "Interval of node positions, a multiple of the platform step; absent: none")
            .above(0)
            .eg("2 s");
        k.words("channels",
                {{"platform.motions", &Output::platform_motions},
                 {"platform.loads", &Output::platform_loads},
                 {"environment", &Output::environment}},
                "Groups of channels")
            .def("[platform.motions, environment]");
        k.list("lines", &Output::lines, line_output_keys,
               "Results of lines; absent: effective tension at end A of all");
        return k.done();
    }();
    return table;
}

}  // namespace hawser
