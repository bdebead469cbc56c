#include "case/output.hpp"

#include "case/declared.hpp"
#include "line_quantities.hpp"

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

std::vector<std::string> quantity_words() {
    std::vector<std::string> words;
    words.reserve(line_quantities.size());
    for (const LineQuantityWords& q : line_quantities) words.emplace_back(q.name);
    return words;
}

std::vector<std::string> result_words() {
    std::vector<std::string> words = quantity_words();
    words.insert(words.end(), {"force", "moment", "touchdown", "touchdown.arc_length"});
    for (const ConstraintWord& c : constraint_words) words.emplace_back(c.word);
    return words;
}

const Table& line_output_keys() {
    static const Table table = [] {
        Keys<LineOutput> k("lines");
        k.text("select", &LineOutput::select, "Names of lines, with * and ?").def("*").eg("ml*");
        k.words("at", {{"end_a", &LineOutput::end_a}, {"end_b", &LineOutput::end_b}},
                "Where along the line")
            .def("[end_a]");
        Key& places = k.custom(
            "at_arc", Form::numbers, {dimension::length},
            "Further places, arc lengths from end A; the quantities in `results` are recorded "
            "there",
            [](LineOutput& output, const Value& value) {
                output.at_arc = std::get<std::vector<double>>(value);
            },
            [](const LineOutput& output) -> Value {
                if (output.at_arc.empty()) return {};
                return output.at_arc;
            });
        places.fewest = 1;
        places.most = 1000;
        places.at_least(0).eg("[1500 m, 1650 m]");
        chosen_words(k, "results", &LineOutput::results, result_words(),
                     "What is recorded at the ends and places; of constraints; of the touchdown")
            .follows("[effective_tension]; nothing where an entry has a range alone")
            .eg("[effective_tension, declination]");
        chosen_words(k, "range", &LineOutput::range, quantity_words(),
                     "Quantities of which least, mean, greatest value and standard deviation along "
                     "the line are kept")
            .def("[]")
            .eg("[effective_tension, von_mises_stress]");
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
