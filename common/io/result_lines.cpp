#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/result_fields.hpp"
#include "io/result_parts.hpp"
#include "line_mesh.hpp"

namespace hawser::io {
namespace {

/// Of a quantity of line types that need not be given: the lesser one beside each node.
template <class Get>
std::vector<double> least_beside_nodes(const Case& input, Get&& get) {
    std::vector<double> values;
    for (const Line& line : input.lines) {
        const LineMesh mesh = mesh_of(line);
        const auto of = [&](int element) {
            const Section& section = line.sections[static_cast<std::size_t>(
                mesh.section[static_cast<std::size_t>(element)])];
            const double first = get(input.line_types[static_cast<std::size_t>(section.type)]);
            if (section.type_at_end < 0) return first;
            return std::fmin(first,
                             get(input.line_types[static_cast<std::size_t>(section.type_at_end)]));
        };
        const int N = mesh.elements();
        for (int n = 0; n <= N; ++n)  // NaN: not given
            values.push_back(std::fmin(of(std::max(n - 1, 0)), of(std::min(n, N - 1))));
    }
    return values;
}

}  // namespace

void write_lines(Hdf5File& file, const Case& input) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::string> names, families;
    std::vector<std::int64_t> first{0};
    std::vector<double> arc_length;
    for (const Line& line : input.lines) {
        names.push_back(line.name);
        families.push_back(line.family);
        const LineMesh mesh = mesh_of(line);
        arc_length.insert(arc_length.end(), mesh.arc_length.begin(), mesh.arc_length.end());
        first.push_back(static_cast<std::int64_t>(arc_length.size()));
    }
    file.write_texts("/lines/names", names);
    describe(file, "/lines/names", "", "Names of the lines, in the order of all line results");
    file.write_texts("/lines/family", families);
    describe(file, "/lines/family", "", "Family of each line in the case file");
    if (std::any_of(input.lines.begin(), input.lines.end(),
                    [](const Line& line) { return line.fail.has_value(); })) {
        std::vector<double> parted;
        for (const Line& line : input.lines) {
            parted.push_back(line.fail ? line.fail->time : nan);
            parted.push_back(line.fail ? line.fail->arc_length : nan);
        }
        write_numbers(file, "/lines/parted", parted, {input.lines.size(), 2}, "s, m",
                      "When and at which arc length each line parts by the case; NaN: never");
    }
    file.write("/lines/nodes/first", first, {first.size()});
    describe(file, "/lines/nodes/first", "", "Line i has the nodes first[i] to first[i + 1] - 1");
    write_numbers(file, "/lines/nodes/arc_length", arc_length, {arc_length.size()}, "m",
                  "Unstretched arc length of the nodes from end A");
    const std::vector<double> breaking = least_beside_nodes(
        input, [nan](const LineType& type) { return type.breaking_load.value_or(nan); });
    write_numbers(file, "/lines/nodes/breaking_load", breaking, {breaking.size()}, "N",
                  "Breaking load of the section at each node, the lesser one where two meet");
    const std::vector<double> yield = least_beside_nodes(input, [nan](const LineType& type) {
        return type.wall ? type.wall->yield.value_or(nan) : nan;
    });
    write_numbers(file, "/lines/nodes/yield", yield, {yield.size()}, "Pa",
                  "Yield stress of the section at each node, the lesser one where two meet");
}

void write_line_views(Hdf5File& file, const Case& input, const std::vector<SeriesField>& fields) {
    std::uint64_t node = 0;
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const Line& line = input.lines[i];
        const std::string root = "/line/" + line.name + "/";
        const std::uint64_t nodes = mesh_of(line).arc_length.size();
        const auto view = [&](const std::string& path, const std::string& source,
                              const Extent& shape, const Hdf5Box& box, const SeriesField* field) {
            file.write_virtual(path, shape, source, box);
            describe(file, path, field != nullptr ? field->units : "m",
                     field != nullptr ? field->description
                                      : "Unstretched arc length of the nodes from end A");
        };
        view(root + "nodes/arc_length", "/lines/nodes/arc_length", {nodes}, {{node}, {nodes}},
             nullptr);
        for (const SeriesField& field : fields) {
            if (!file.exists(field.path)) continue;
            const std::uint64_t rows = file.dataset(field.path).shape().at(0);
            if (field.path == "/lines/nodes/position" && rows > 0)
                view(root + "nodes/position", field.path, {rows, nodes, 3},
                     {{0, node, 0}, {rows, nodes, 3}}, &field);
        }
        for (const LineQuantity q : range_quantities(input)) {
            if (!is_in_range(input.output, line.name, q)) continue;
            for (const std::string_view statistic : range_statistics) {
                const std::string source = range_path(q, statistic);
                const auto field =
                    std::find_if(fields.begin(), fields.end(),
                                 [&](const SeriesField& f) { return f.path == source; });
                if (file.exists(source))
                    view(root + source.substr(std::string("/lines/").size()), source, {nodes},
                         {{node}, {nodes}}, &*field);
            }
        }
        node += nodes;
    }
    for (const LineChannel& channel : line_channels(input, fields)) {
        const SeriesField& field = *channel.field;
        const std::uint64_t rows = file.dataset(field.path).shape().at(0);
        if (rows == 0) continue;
        const auto column = static_cast<std::uint64_t>(channel.column / channel.width);
        if (channel.width == 1) {
            file.write_virtual(channel.path, {rows}, field.path, {{0, column}, {rows, 1}});
        } else {
            file.write_virtual(channel.path, {rows, 3}, field.path, {{0, column, 0}, {rows, 1, 3}});
        }
        describe(file, channel.path, field.units, field.description);
    }
}

void write_places(Hdf5File& file, const Case& input) {
    const std::vector<LinePlace> places = recorded_places(input);
    if (!places.empty()) {
        std::vector<std::string> names;
        std::vector<double> arc_length;
        for (const LinePlace& place : places) {
            names.push_back(input.lines[static_cast<std::size_t>(place.line)].name);
            arc_length.push_back(place.arc_length);
        }
        file.write_texts("/lines/at/line", names);
        describe(file, "/lines/at/line", "", "Lines of the places at which results are recorded");
        write_numbers(file, "/lines/at/arc_length", arc_length, {arc_length.size()}, "m",
                      "Unstretched arc length of these places from end A");
    }
    const std::vector<ConstraintOfLine> constraints = constraints_of(input);
    if (constraints.empty()) return;
    std::vector<std::string> names;
    names.reserve(constraints.size());
    for (const ConstraintOfLine& c : constraints) names.push_back(c.name);
    file.write_texts("/constraints/names", names);
    describe(file, "/constraints/names", "",
             "Constraints along the lines, <line>/<constraint>, in the order of their results");
}

std::vector<LineStart> line_starts(const Hdf5File& file, const RunRecord& record) {
    const std::size_t n = record.input.lines.size();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<LineStart> starts(n, {nan, nan, nan, nan, nan, nan});
    constexpr std::array<double LineStart::*, start_results.size()> members{
        &LineStart::end_b_tension, &LineStart::end_a_declination, &LineStart::end_b_declination,
        &LineStart::grounded, &LineStart::touchdown};
    for (std::size_t k = 0; k < members.size(); ++k) {
        const std::string path = start_path(start_results[k]);
        if (!file.exists(path)) continue;
        const std::vector<double> row = file.read(path);
        for (std::size_t i = 0; i < n; ++i) starts[i].*members[k] = row[i];
    }
    if (record.statics && record.statics->end_a_tension.size() == n)
        for (std::size_t i = 0; i < n; ++i)
            starts[i].end_a_tension = record.statics->end_a_tension[i];
    return starts;
}

std::vector<LineCourse> line_courses(const Hdf5File& file, const Case& input) {
    const std::size_t n = input.lines.size();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<LineCourse> courses(n);
    for (LineCourse& c : courses) {
        for (Extreme& e : c.extremes) e = {nan, nan, nan};
        c.slack_limit = c.slack_first = nan;
    }
    for (std::size_t k = 0; k < line_extremes.size(); ++k) {
        const std::string path = extreme_path(line_extremes[k]);
        if (!file.exists(path)) continue;
        const std::vector<double> rows = file.read(path);
        for (std::size_t i = 0; i < n; ++i)
            courses[i].extremes[k] = {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
    }
    if (file.exists(extreme_path("slack"))) {
        const std::vector<double> rows = file.read(extreme_path("slack"));
        for (std::size_t i = 0; i < n; ++i) {
            courses[i].slack_limit = rows[3 * i];
            courses[i].slack_duration = rows[3 * i + 1];
            courses[i].slack_first = rows[3 * i + 2];
        }
    }
    return courses;
}

}  // namespace hawser::io
