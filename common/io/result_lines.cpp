#include <algorithm>
#include <limits>

#include "io/result_fields.hpp"
#include "io/result_parts.hpp"
#include "line_mesh.hpp"

namespace hawser::io {
namespace {

/// Length between neighbouring nodes of which both touch the seabed.
double grounded_length(const Case& input, const Line& line, std::span<const double> position) {
    const LineMesh mesh = mesh_of(line);
    const auto touches = [&](std::size_t node) {
        const std::size_t element = std::min(node, mesh.section.size() - 1);
        const int section = mesh.section[element];
        const int type = line.sections[static_cast<std::size_t>(section)].type;
        const double radius = 0.5 * input.line_types[static_cast<std::size_t>(type)].outer_diameter;
        constexpr double millimetre = 1e-3;  // single precision at 1500 m of depth: 0.1 mm
        return position[3 * node + 2] <= -input.environment.seabed.depth + radius + millimetre;
    };
    double length = 0.0;
    for (std::size_t e = 0; e + 1 < mesh.arc_length.size(); ++e) {
        if (touches(e) && touches(e + 1)) length += mesh.arc_length[e + 1] - mesh.arc_length[e];
    }
    return length;
}

}  // namespace

void write_lines(Hdf5File& file, const Case& input) {
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
    file.write("/lines/nodes/first", first, {first.size()});
    describe(file, "/lines/nodes/first", "", "Line i has the nodes first[i] to first[i + 1] - 1");
    write_numbers(file, "/lines/nodes/arc_length", arc_length, {arc_length.size()}, "m",
                  "Unstretched arc length of the nodes from end A");
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
            const std::uint64_t rows = file.dataset(field.path).shape().at(0);
            if (rows == 0) continue;
            if (field.path == "/lines/nodes/position") {
                view(root + "nodes/position", field.path, {rows, nodes, 3},
                     {{0, node, 0}, {rows, nodes, 3}}, &field);
            }
            for (const bool end_a : {true, false}) {
                for (const EndResult result : end_results) {
                    if (field.path != end_path(end_a, result) ||
                        !is_recorded(input.output, line.name, end_a, result))
                        continue;
                    const std::string path =
                        root + field.path.substr(std::string("/lines/").size());
                    if (field.shape.size() == 1) {
                        view(path, field.path, {rows}, {{0, i}, {rows, 1}}, &field);
                    } else {
                        view(path, field.path, {rows, 3}, {{0, i, 0}, {rows, 1, 3}}, &field);
                    }
                }
            }
        }
        node += nodes;
    }
}

std::vector<LineStart> line_starts(const Hdf5File& file, const RunRecord& record) {
    const Case& input = record.input;
    const std::size_t n = input.lines.size();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<LineStart> starts(n, {nan, nan, nan, nan, nan});
    const auto take = [&](bool end_a, EndResult result, double LineStart::*where) {
        const std::string path = end_path(end_a, result);
        if (!file.exists(path)) return;
        const Hdf5Dataset data = file.dataset(path);
        if (data.shape().at(0) == 0) return;
        std::vector<double> row(n);
        data.read_rows(0, 1, row.data());
        for (std::size_t i = 0; i < n; ++i) starts[i].*where = row[i];
    };
    take(true, EndResult::effective_tension, &LineStart::end_a_tension);
    take(false, EndResult::effective_tension, &LineStart::end_b_tension);
    take(true, EndResult::declination, &LineStart::end_a_declination);
    take(false, EndResult::declination, &LineStart::end_b_declination);
    if (record.statics && record.statics->end_a_tension.size() == n) {
        for (std::size_t i = 0; i < n; ++i) {
            starts[i].end_a_tension = record.statics->end_a_tension[i];
        }
    }
    if (file.exists("/lines/nodes/position")) {
        const Hdf5Dataset data = file.dataset("/lines/nodes/position");
        if (data.shape().at(0) > 0) {
            std::vector<double> position(data.shape().at(1) * 3);
            data.read_rows(0, 1, position.data());
            std::size_t at = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const std::size_t count = 3 * mesh_of(input.lines[i]).arc_length.size();
                starts[i].grounded =
                    grounded_length(input, input.lines[i], std::span(position).subspan(at, count));
                at += count;
            }
        }
    }
    return starts;
}

}  // namespace hawser::io
