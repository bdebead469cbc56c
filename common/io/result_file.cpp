#include "io/result_file.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "io/files.hpp"
#include "io/result_fields.hpp"
#include "io/series_file.hpp"
#include "line_mesh.hpp"
#include "status.hpp"

namespace hawser::io {
namespace fs = std::filesystem;
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees = 180.0 / 3.14159265358979323846;
constexpr std::uint64_t chunk_bytes = 256 * 1024;

const char* clock_path(Clock clock) { return clock == Clock::sample ? "/time" : "/snapshot_time"; }

std::vector<std::string> names_of(const Case& input) {
    std::vector<std::string> names;
    for (const Line& line : input.lines) names.push_back(line.name);
    return names;
}

void describe(Hdf5File& file, const std::string& path, const std::string& units,
              const std::string& description) {
    file.attribute(path, "units", units);
    file.attribute(path, "description", description);
}

void write_numbers(Hdf5File& file, const std::string& path, std::span<const double> values,
                   const Extent& shape, const std::string& units, const std::string& description) {
    file.write(path, values, shape);
    describe(file, path, units, description);
}

/// A chunk is whole samples, about 256 kB of them: written once, full width, so that a series is
/// read back in few pieces.
Hdf5Layout joined_layout(const SeriesField& field, std::uint64_t rows) {
    Hdf5Layout layout{
        .shape = {rows}, .single_precision = field.single_precision, .nan_fill = false};
    for (const int k : field.shape) layout.shape.push_back(static_cast<std::uint64_t>(k));
    const std::uint64_t row = static_cast<std::uint64_t>(std::max(field.width(), 1)) *
                              (field.single_precision ? sizeof(float) : sizeof(double));
    layout.chunk = layout.shape;
    layout.chunk[0] =
        std::clamp<std::uint64_t>(chunk_bytes / row, 1, std::max<std::uint64_t>(rows, 1));
    layout.deflate = true;
    return layout;
}

/// Appends values to a dataset in whole chunks.
template <class T>
void copy_field(const std::vector<Hdf5File>& segments, const SeriesField& field,
                Hdf5Dataset& target, std::uint64_t chunk_rows) {
    const auto width = static_cast<std::uint64_t>(field.width());
    std::vector<T> held, piece;
    std::uint64_t written = 0;
    const auto flush = [&](bool all) {
        const std::uint64_t rows = held.size() / width;
        const std::uint64_t ready = all ? rows : rows / chunk_rows * chunk_rows;
        if (ready == 0) return;
        target.write_rows(written, ready, held.data());
        written += ready;
        held.erase(held.begin(), held.begin() + static_cast<std::ptrdiff_t>(ready * width));
    };
    for (const Hdf5File& segment : segments) {
        if (!segment.exists(field.path)) continue;  // no tick of this clock in the segment
        const Hdf5Dataset source = segment.dataset(field.path);
        const std::uint64_t rows = source.shape().at(0);
        piece.resize(rows * width);
        source.read_rows(0, rows, piece.data());
        held.insert(held.end(), piece.begin(), piece.end());
        flush(false);
    }
    flush(true);
}

void write_input(Hdf5File& file, const RunRecord& record) {
    file.write_text("/input/case", record.resolved);
    describe(file, "/input/case", "", "The case as run, every default filled in");
    for (const auto& [name, text] : record.sources) {
        std::string key = name;
        std::replace(key.begin(), key.end(), '/', '_');
        const std::string path = "/input/files/" + key;
        if (file.exists(path)) continue;
        file.write_text(path, text);
        describe(file, path, "", "Source " + name);
    }
}

void write_lines(Hdf5File& file, const Case& input) {
    if (input.lines.empty()) return;
    std::vector<std::string> families;
    std::vector<std::int64_t> first{0};
    std::vector<double> arc_length;
    for (const Line& line : input.lines) {
        families.push_back(line.family);
        const LineMesh mesh = mesh_of(line);
        arc_length.insert(arc_length.end(), mesh.arc_length.begin(), mesh.arc_length.end());
        first.push_back(static_cast<std::int64_t>(arc_length.size()));
    }
    file.write_texts("/lines/names", names_of(input));
    describe(file, "/lines/names", "", "Names of the lines, in the order of all line results");
    file.write_texts("/lines/family", families);
    describe(file, "/lines/family", "", "Family of each line in the case file");
    file.write("/lines/nodes/first", first, {first.size()});
    describe(file, "/lines/nodes/first", "", "Line i has the nodes first[i] to first[i + 1] - 1");
    write_numbers(file, "/lines/nodes/arc_length", arc_length, {arc_length.size()}, "m",
                  "Unstretched arc length of the nodes from end A");
}

/// Per line, the columns that were asked for, as virtual datasets /line/<name>/...
void write_virtual_lines(Hdf5File& file, const Case& input,
                         const std::vector<SeriesField>& fields) {
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

void write_statics(Hdf5File& file, const Case& input, const StaticState& statics) {
    if (statics.platform && input.platform) {
        const Vec3 x = statics.platform->position, q = degrees * statics.platform->angles;
        const std::array<double, 6> six{x[0], x[1], x[2], q[0], q[1], q[2]};
        write_numbers(file, "/statics" + platform_path(input) + "position", six, {6},
                      "m, m, m, deg, deg, deg",
                      "Equilibrium under the mean loads: surge, sway, heave, roll, pitch, yaw");
    }
    if (!statics.end_a_tension.empty()) {
        write_numbers(file, "/statics/lines/end_a/effective_tension", statics.end_a_tension,
                      {statics.end_a_tension.size()}, "N",
                      "Effective tension at end A in the equilibrium");
    }
}

void write_statistics(Hdf5File& file, const std::vector<ChannelStatistics>& rows, double from) {
    std::vector<std::string> channel, unit;
    std::vector<std::int64_t> n;
    std::array<std::vector<double>, 9> v;
    for (const ChannelStatistics& row : rows) {
        const Statistics& s = row.values;
        channel.push_back(row.channel);
        unit.push_back(row.units);
        n.push_back(s.n);
        const std::array<double, 9> values{s.mean,  s.std,      s.min,      s.t_min, s.max,
                                           s.t_max, s.skewness, s.kurtosis, s.tz};
        for (std::size_t k = 0; k < values.size(); ++k) v[k].push_back(values[k]);
    }
    file.write_table("/statistics/table", {{"channel", channel},
                                           {"unit", unit},
                                           {"n", n},
                                           {"mean", v[0]},
                                           {"std", v[1]},
                                           {"min", v[2]},
                                           {"t_min", v[3]},
                                           {"max", v[4]},
                                           {"t_max", v[5]},
                                           {"skewness", v[6]},
                                           {"kurtosis", v[7]},
                                           {"tz", v[8]}});
    describe(file, "/statistics/table", "see column unit; times in s",
             fmt::format("Statistics of the samples from t = {} s on; tz: mean period of "
                         "up-crossings of the mean",
                         from));
}

void write_ledger(Hdf5File& file, const Case& input, const LedgerTable& ledger) {
    const std::string root =
        "/ledger/" + (input.platform ? input.platform->name : std::string("platform")) + "/";
    const std::string units = "N, N, N, N.m, N.m, N.m";
    const std::string span =
        fmt::format(" from {} to {} s, about O, world axes", ledger.from, ledger.to);
    file.write_texts(root + "components", ledger.components);
    describe(file, root + "components", "", "Names of the rows of mean");
    std::vector<double> mean;
    for (const Vec6& row : ledger.mean) mean.insert(mean.end(), row.data(), row.data() + 6);
    write_numbers(file, root + "mean", mean, {ledger.mean.size(), 6}, units,
                  "Mean of each load component" + span);
    const auto six = [&](const char* name, const Vec6& v, const char* what) {
        write_numbers(file, root + name, {v.data(), 6}, {6}, units, what + span);
    };
    six("sum", ledger.sum, "Sum of the components");
    six("momentum", ledger.momentum, "Mean of mass x acceleration, from the change of momentum");
    six("residual", ledger.residual, "Sum of the components - mass x acceleration");
}

void write_root(Hdf5File& file, const RunRecord& record) {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    file.attribute("/", "program", std::string("hawser"));
    file.attribute("/", "version", record.version);
    file.attribute("/", "build", record.build);
    file.attribute("/", "build_host", std::string(host.data()));
    file.attribute("/", "format", std::int64_t{1});
    file.attribute("/", "title", record.input.title);
    file.attribute("/", "created",
                   fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
    file.attribute("/", "command", record.command);
    file.attribute("/", "ranks", std::int64_t{record.ranks});
    file.attribute("/", "complete", record.complete);
}

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

std::vector<LineStart> line_starts(const Hdf5File& file, const RunRecord& record) {
    const Case& input = record.input;
    const std::size_t n = input.lines.size();
    std::vector<LineStart> starts(
        n, {not_a_number, not_a_number, not_a_number, not_a_number, not_a_number});
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

}  // namespace

std::vector<ChannelStatistics> result_statistics(const Hdf5File& result, const Case& input,
                                                 double from) {
    std::vector<ChannelStatistics> rows;
    const std::vector<double> time = result.read("/time");
    const auto add = [&](const std::string& channel, const std::string& units,
                         const std::string& path, std::uint64_t column) {
        const std::vector<double> x = result.dataset(path).read_column(column);
        rows.push_back({channel, units, statistics_of(time, x, from)});
    };
    const std::string root = platform_path(input);
    if (result.exists(root + "position")) {
        const std::array<const char*, 6> motions{"surge", "sway", "heave", "roll", "pitch", "yaw"};
        for (std::size_t k = 0; k < 6; ++k) {
            add(root.substr(1) + motions[k], k < 3 ? "m" : "deg", root + "position", k);
        }
    }
    for (const auto& [name, units] :
         {std::pair{"elevation", "m"}, std::pair{"wind_speed", "m/s"}}) {
        const std::string path = std::string("environment/") + name;
        if (result.exists("/" + path)) add(path, units, "/" + path, 0);
    }
    for (const bool end_a : {true, false}) {
        const std::string path = end_path(end_a, EndResult::effective_tension);
        if (!result.exists(path)) continue;
        for (std::size_t i = 0; i < input.lines.size(); ++i) {
            const std::string& line = input.lines[i].name;
            if (!is_recorded(input.output, line, end_a, EndResult::effective_tension)) continue;
            add("line/" + line + (end_a ? "/end_a" : "/end_b") + "/effective_tension", "N", path,
                i);
        }
    }
    return rows;
}

ResultDigest write_result(const fs::path& folder, const RunRecord& record) {
    const Case& input = record.input;
    std::vector<int> nodes;
    for (const Line& line : input.lines) {
        nodes.push_back(static_cast<int>(mesh_of(line).arc_length.size()));
    }
    const std::vector<SeriesField> fields = result_fields(input, nodes);
    const std::vector<fs::path> paths = segment_files(folder);
    std::vector<Hdf5File> segments;
    for (const fs::path& path : paths) segments.push_back(Hdf5File::open(path));

    ResultDigest digest;
    const fs::path path = folder / "result.h5";
    Hdf5File file = Hdf5File::create(part_of(path));
    write_root(file, record);
    write_input(file, record);

    std::array<std::uint64_t, 2> rows{};
    for (const Clock clock : {Clock::sample, Clock::snapshot}) {
        std::vector<double> times;
        for (const Hdf5File& segment : segments) {
            if (!segment.exists(clock_path(clock))) continue;
            const std::vector<double> more = segment.read(clock_path(clock));
            times.insert(times.end(), more.begin(), more.end());
        }
        rows[clock == Clock::sample ? 0 : 1] = times.size();
        if (clock == Clock::sample && !times.empty()) digest.last_time = times.back();
        if (clock == Clock::snapshot && !input.output.snapshots) continue;
        write_numbers(file, clock_path(clock), times, {times.size()}, "s",
                      clock == Clock::sample ? "Times of the samples" : "Times of the snapshots");
    }
    digest.samples = static_cast<std::int64_t>(rows[0]);
    digest.snapshots = static_cast<std::int64_t>(rows[1]);
    write_lines(file, input);
    for (const SeriesField& field : fields) {
        const Hdf5Layout layout = joined_layout(field, rows[field.clock == Clock::sample ? 0 : 1]);
        Hdf5Dataset data = file.create_dataset(field.path, layout);
        data.attribute("units", field.units);
        data.attribute("description", field.description);
        if (field.single_precision) {
            copy_field<float>(segments, field, data, layout.chunk[0]);
        } else {
            copy_field<double>(segments, field, data, layout.chunk[0]);
        }
    }
    write_virtual_lines(file, input, fields);
    if (record.statics) write_statics(file, input, *record.statics);
    if (record.ledger) write_ledger(file, input, *record.ledger);
    for (const Fact& fact : record.performance) {
        write_numbers(file, "/performance/" + fact.name, {&fact.value, 1}, {}, fact.units,
                      fact.description);
    }
    digest.lines = line_starts(file, record);
    const double from = input.analysis.dynamics.statistics_from;
    digest.statistics = result_statistics(file, input, from);
    write_statistics(file, digest.statistics, from);
    file.close();
    publish(path);

    segments.clear();
    for (const fs::path& segment : paths) fs::remove(segment);
    return digest;
}

}  // namespace hawser::io
