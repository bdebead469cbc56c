#include "io/line_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace hawser::io {
namespace {

struct Words {
    const char* name;
    const char* units;
    const char* description;
    bool vector = false;
};

constexpr std::array<Words, 5> end_words{{
    {"effective_tension", "N", "Effective tension"},
    {"declination", "deg", "Angle from vertical down of the tangent from end A to end B"},
    {"azimuth", "deg",
     "Angle from +x, counter-clockwise from above, of the tangent from end A to end B"},
    {"force", "N", "Force of the line on what holds it, world axes", true},
    {"moment", "N.m", "Moment of the line on what holds it, world axes", true},
}};

constexpr std::array<Words, 6> constraint_result_words{{
    {"force", "N",
     "Force between line and what holds it: normal force of guides, sliders and pull tubes, whole "
     "force of joints"},
    {"moment", "N.m", "Moment between line and what holds it, its size"},
    {"tension", "N", "Tension of the tensioner"},
    {"gap", "m", "Gap left before contact; negative: pressed in"},
    {"stroke", "m", "Stroke of the tensioner, growing as the riser's top goes down"},
    {"slip", "m", "Way that the line has slid along the axis since the start"},
}};

const Words& words_of(EndResult result) { return end_words[static_cast<std::size_t>(result)]; }
const Words& words_of(ConstraintResult result) {
    return constraint_result_words[static_cast<std::size_t>(result)];
}

bool asks(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

template <class Asked>
bool some_entry(const Output& output, const std::string& line, Asked&& asked) {
    return std::any_of(output.lines.begin(), output.lines.end(), [&](const LineOutput& entry) {
        return matches(entry.select, line) && asked(entry);
    });
}

template <class Asked>
bool some_line(const Case& input, Asked&& asked) {
    return std::any_of(input.lines.begin(), input.lines.end(), asked);
}

std::string end_group(bool end_a) { return end_a ? "/lines/end_a/" : "/lines/end_b/"; }

}  // namespace

std::string end_path(bool end_a, EndResult result) {
    return end_group(end_a) + words_of(result).name;
}
std::string end_path(bool end_a, LineQuantity quantity) {
    return end_group(end_a) + hawser::words_of(quantity).name;
}

bool is_recorded(const Output& output, const std::string& line, bool end_a, EndResult result) {
    return some_entry(output, line, [&](const LineOutput& entry) {
        return (end_a ? entry.end_a : entry.end_b) && asks(entry.results, words_of(result).name);
    });
}
bool is_recorded(const Output& output, const std::string& line, bool end_a, LineQuantity quantity) {
    return some_entry(output, line, [&](const LineOutput& entry) {
        return (end_a ? entry.end_a : entry.end_b) &&
               asks(entry.results, hawser::words_of(quantity).name);
    });
}

std::vector<LineQuantity> further_end_quantities() {
    std::vector<LineQuantity> all;
    for (std::size_t k = 0; k < n_line_quantities; ++k) {
        const auto q = static_cast<LineQuantity>(k);
        if (q != LineQuantity::effective_tension && q != LineQuantity::declination &&
            q != LineQuantity::azimuth)
            all.push_back(q);
    }
    return all;
}

std::vector<LinePlace> recorded_places(const Case& input) {
    std::set<LinePlace> places;
    for (const LineOutput& entry : input.output.lines) {
        for (std::size_t i = 0; i < input.lines.size(); ++i) {
            if (!matches(entry.select, input.lines[i].name)) continue;
            for (const double s : entry.at_arc)  // other lines of the entry may be longer
                if (s <= input.lines[i].length()) places.insert({static_cast<int>(i), s});
        }
    }
    return {places.begin(), places.end()};
}

bool is_recorded(const Case& input, const LinePlace& place, LineQuantity quantity) {
    return some_entry(input.output, input.lines[static_cast<std::size_t>(place.line)].name,
                      [&](const LineOutput& entry) {
                          return asks(entry.results, hawser::words_of(quantity).name) &&
                                 std::find(entry.at_arc.begin(), entry.at_arc.end(),
                                           place.arc_length) != entry.at_arc.end();
                      });
}

std::string place_path(LineQuantity quantity) {
    return std::string("/lines/at/") + hawser::words_of(quantity).name;
}

bool is_touchdown_recorded(const Output& output, const std::string& line, std::string_view result) {
    return some_entry(output, line, [&](const LineOutput& entry) {
        return asks(entry.results, "touchdown") ||
               (result == "arc_length" && asks(entry.results, "touchdown.arc_length"));
    });
}

std::string touchdown_path(std::string_view result) {
    return "/lines/touchdown/" + std::string(result);
}

std::vector<ConstraintOfLine> constraints_of(const Case& input) {
    std::vector<ConstraintOfLine> all;
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const Line& line = input.lines[i];
        for (std::size_t c = 0; c < line.constraints.size(); ++c)
            all.push_back({static_cast<int>(i), static_cast<int>(c),
                           line.name + "/" + line.constraints[c].name});
    }
    return all;
}

bool is_recorded(const Case& input, const ConstraintOfLine& constraint, ConstraintResult result) {
    const Line& line = input.lines[static_cast<std::size_t>(constraint.line)];
    const ConstraintType type = line.constraints[static_cast<std::size_t>(constraint.index)].type;
    return some_entry(input.output, line.name, [&](const LineOutput& entry) {
        return std::any_of(
            constraint_words.begin(), constraint_words.end(), [&](const ConstraintWord& c) {
                return c.type == type && c.result == result && asks(entry.results, c.word);
            });
    });
}

std::string constraint_path(ConstraintResult result) {
    return std::string("/constraints/") + words_of(result).name;
}

std::vector<LineQuantity> range_quantities(const Case& input) {
    std::vector<LineQuantity> all;
    for (std::size_t k = 0; k < n_line_quantities; ++k) {
        const auto q = static_cast<LineQuantity>(k);
        if (some_line(input,
                      [&](const Line& line) { return is_in_range(input.output, line.name, q); }))
            all.push_back(q);
    }
    return all;
}

bool is_in_range(const Output& output, const std::string& line, LineQuantity quantity) {
    return some_entry(output, line, [&](const LineOutput& entry) {
        return asks(entry.range, hawser::words_of(quantity).name);
    });
}

std::string range_path(LineQuantity quantity, std::string_view statistic) {
    return fmt::format("/lines/range/{}/{}", hawser::words_of(quantity).name, statistic);
}
std::string extreme_path(std::string_view name) { return "/lines/extremes/" + std::string(name); }
std::string start_path(std::string_view name) { return "/statics/lines/" + std::string(name); }

namespace {

void add_end_fields(const Case& input, std::vector<SeriesField>& fields) {
    const int n_lines = static_cast<int>(input.lines.size());
    for (const bool end_a : {true, false}) {
        const std::string where = std::string(", at end ") + (end_a ? "A" : "B");
        const auto add = [&](auto result, const std::string& units, const std::string& description,
                             bool vector) {
            if (!some_line(input, [&](const Line& line) {
                    return is_recorded(input.output, line.name, end_a, result);
                }))
                return;
            fields.push_back({end_path(end_a, result), units, description + where,
                              vector ? std::vector<int>{n_lines, 3} : std::vector<int>{n_lines}});
        };
        for (const EndResult result : end_results) {
            const Words& w = words_of(result);
            add(result, w.units, w.description, w.vector);
        }
        for (const LineQuantity q : further_end_quantities())
            add(q, hawser::words_of(q).units, hawser::words_of(q).description, false);
    }
}

void add_place_fields(const Case& input, std::vector<SeriesField>& fields) {
    const std::vector<LinePlace> places = recorded_places(input);
    for (std::size_t k = 0; k < n_line_quantities; ++k) {
        const auto q = static_cast<LineQuantity>(k);
        if (std::any_of(places.begin(), places.end(),
                        [&](const LinePlace& place) { return is_recorded(input, place, q); }))
            fields.push_back({place_path(q),
                              line_quantities[k].units,
                              std::string(line_quantities[k].description) +
                                  ", at the places of /lines/at/line and /lines/at/arc_length",
                              {static_cast<int>(places.size())}});
    }
}

void add_touchdown_fields(const Case& input, std::vector<SeriesField>& fields) {
    for (const std::string_view result : touchdown_results) {
        if (!some_line(input, [&](const Line& line) {
                return is_touchdown_recorded(input.output, line.name, result);
            }))
            continue;
        fields.push_back(
            {touchdown_path(result),
             "m",
             result == "arc_length"
                 ? "Arc length from end A where the line first touches the seabed"
                 : fmt::format("Position where the line first touches the seabed: {}", result),
             {static_cast<int>(input.lines.size())}});
    }
}

void add_constraint_fields(const Case& input, std::vector<SeriesField>& fields) {
    const std::vector<ConstraintOfLine> all = constraints_of(input);
    const std::vector<int> shape{static_cast<int>(all.size())};
    for (const ConstraintResult result : constraint_results) {
        if (std::any_of(all.begin(), all.end(),
                        [&](const ConstraintOfLine& c) { return is_recorded(input, c, result); }))
            fields.push_back({constraint_path(result), words_of(result).units,
                              words_of(result).description, shape});
    }
    if (!all.empty())
        fields.push_back({std::string(mismatch_path), "1",
                          "Impulse given to the platform less that given to the line, over the "
                          "whole impulse (R:40)",
                          shape, Clock::latest});
}

void add_kept_fields(const Case& input, const std::vector<int>& nodes,
                     std::vector<SeriesField>& fields) {
    const int n_lines = static_cast<int>(input.lines.size());
    const int all = std::accumulate(nodes.begin(), nodes.end(), 0);
    const auto add = [&](const std::string& path, const std::string& units,
                         const std::string& description, std::vector<int> shape) {
        fields.push_back({path, units, description, std::move(shape), Clock::latest});
    };
    for (const LineQuantity q : range_quantities(input)) {
        const LineQuantityWords& w = hawser::words_of(q);
        const std::string what = std::string(w.description) + " at the nodes: ";
        add(range_path(q, "min"), w.units, what + "least value", {all});
        add(range_path(q, "mean"), w.units, what + "mean", {all});
        add(range_path(q, "max"), w.units, what + "greatest value", {all});
        add(range_path(q, "std"), w.units, what + "standard deviation", {all});
        add(range_path(q, "t_min"), "s", what + "time of the least value", {all});
        add(range_path(q, "t_max"), "s", what + "time of the greatest value", {all});
        add(range_path(q, "at_maximum"), w.units,
            what + "at the time of the greatest value along the line", {all});
        add(range_path(q, "time_of_maximum"), "s",
            std::string(w.description) + ": time of the greatest value along the line", {n_lines});
    }
    constexpr std::array<Words, 5> extremes{{{"", "N", "Least effective tension"},
                                             {"", "N", "Greatest effective tension"},
                                             {"", "Pa", "Greatest von Mises stress"},
                                             {"", "1", "Greatest von Mises stress over yield"},
                                             {"", "1", "Greatest tension over breaking load"}}};
    for (std::size_t k = 0; k < extremes.size(); ++k)
        add(extreme_path(line_extremes[k]), std::string(extremes[k].units) + ", m, s",
            std::string(extremes[k].description) +
                " of each line over the whole run: value, arc length from end A, time",
            {n_lines, 3});
    add(extreme_path("slack"), "N, s, s",
        fmt::format("Slack: the tension below which a line counts as slack, {:g} of its greatest "
                    "at the start; for how long some part of it was; first time",
                    slack_share),
        {n_lines, 3});
    constexpr std::array<Words, 5> start{
        {{"", "N", "Effective tension at end B"},
         {"", "deg", "Angle from vertical down of the line as it leaves end A"},
         {"", "deg", "Angle from vertical down of the line as it arrives at end B"},
         {"", "m", "Length in contact with the seabed"},
         {"", "m", "Arc length from end A where the line first touches the seabed"}}};
    for (std::size_t k = 0; k < start.size(); ++k)
        add(start_path(start_results[k]), start[k].units,
            std::string(start[k].description) +
                ", at the start (of a run with platform.initial: moved so)",
            {n_lines});
}

}  // namespace

void add_line_fields(const Case& input, const std::vector<int>& nodes,
                     std::vector<SeriesField>& fields) {
    if (input.lines.empty()) return;
    add_end_fields(input, fields);
    add_place_fields(input, fields);
    add_touchdown_fields(input, fields);
    add_constraint_fields(input, fields);
    add_kept_fields(input, nodes, fields);
    if (input.output.snapshots) {
        const int all = std::accumulate(nodes.begin(), nodes.end(), 0);
        fields.push_back({"/lines/nodes/position",
                          "m",
                          "Positions of the nodes of all lines, world axes",
                          {all, 3},
                          Clock::snapshot,
                          true});
    }
}

std::vector<LineChannel> line_channels(const Case& input, const std::vector<SeriesField>& fields) {
    std::vector<LineChannel> channels;
    const auto field_of = [&](const std::string& path) -> const SeriesField* {
        for (const SeriesField& field : fields)
            if (field.path == path) return &field;
        return nullptr;
    };
    const auto add = [&](const std::string& path, const std::string& field, std::size_t column,
                         int width, bool in_statistics) {
        channels.push_back({path, field_of(field), width * static_cast<int>(column), width,
                            in_statistics && width == 1});
    };
    const auto end = [&](bool end_a, auto result, int width, bool in_statistics) {
        const std::string field = end_path(end_a, result);
        if (field_of(field) == nullptr) return;
        for (std::size_t i = 0; i < input.lines.size(); ++i)
            if (is_recorded(input.output, input.lines[i].name, end_a, result))
                add("/line/" + input.lines[i].name + field.substr(6), field, i, width,
                    in_statistics);
    };
    for (const bool end_a : {true, false}) {
        for (const EndResult result : end_results)  // an azimuth jumps by 360 deg: no statistics
            end(end_a, result, words_of(result).vector ? 3 : 1, result != EndResult::azimuth);
        for (const LineQuantity q : further_end_quantities()) end(end_a, q, 1, true);
    }
    const std::vector<LinePlace> places = recorded_places(input);
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (std::size_t n = 0; n < n_line_quantities; ++n) {
            const auto q = static_cast<LineQuantity>(n);
            if (is_recorded(input, places[k], q))
                add(fmt::format("/line/{}/at/{}/{}",
                                input.lines[static_cast<std::size_t>(places[k].line)].name,
                                places[k].arc_length, line_quantities[n].name),
                    place_path(q), k, 1, q != LineQuantity::azimuth);
        }
    }
    for (std::size_t i = 0; i < input.lines.size(); ++i)
        for (const std::string_view result : touchdown_results)
            if (is_touchdown_recorded(input.output, input.lines[i].name, result))
                add("/line/" + input.lines[i].name + "/touchdown/" + std::string(result),
                    touchdown_path(result), i, 1, true);
    const std::vector<ConstraintOfLine> constraints = constraints_of(input);
    for (std::size_t k = 0; k < constraints.size(); ++k)
        for (const ConstraintResult result : constraint_results)
            if (is_recorded(input, constraints[k], result))
                add("/constraint/" + constraints[k].name + "/" + words_of(result).name,
                    constraint_path(result), k, 1, true);
    return channels;
}

}  // namespace hawser::io
