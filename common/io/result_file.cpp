#include "io/result_file.hpp"

#include "io/files.hpp"
#include "io/result_fields.hpp"
#include "io/result_parts.hpp"
#include "io/series_file.hpp"
#include "line_mesh.hpp"

namespace hawser::io {
namespace fs = std::filesystem;

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

ResultDigest write_result(const fs::path& folder, const RunRecord& record) {
    const Case& input = record.input;
    std::vector<int> nodes;
    for (const Line& line : input.lines) {
        nodes.push_back(static_cast<int>(mesh_of(line).arc_length.size()));
    }
    const std::vector<SeriesField> fields = result_fields(input, nodes);
    const std::vector<fs::path> segments = segment_files(folder);

    const fs::path path = folder / "result.h5";
    Hdf5File file = Hdf5File::create(part_of(path));
    write_root(file, record);
    write_input(file, record);

    const JoinedTimes times = joined_times(segments);
    write_numbers(file, "/time", times.sample, {times.sample.size()}, "s", "Times of the samples");
    if (input.output.snapshots) {
        write_numbers(file, "/snapshot_time", times.snapshot, {times.snapshot.size()}, "s",
                      "Times of the snapshots");
    }
    join_fields(file, segments, fields, times);
    if (!input.lines.empty()) {
        write_lines(file, input);
        write_places(file, input);
        write_line_views(file, input, fields);
    }
    if (record.statics) write_statics(file, input, *record.statics);
    for (std::size_t k = 0; k < record.platforms.size(); ++k)
        write_platform_facts(file, input.platform_at(static_cast<int>(k)), record.platforms[k]);
    for (std::size_t k = 0; k < record.ledgers.size(); ++k)
        write_ledger(file, input.platform_at(static_cast<int>(k)), record.ledgers[k]);
    write_design_position(file, input);
    for (const Fact& fact : record.performance) {
        write_numbers(file, "/performance/" + fact.name, {&fact.value, 1}, {}, fact.units,
                      fact.description);
    }

    ResultDigest digest;
    digest.last_time = times.sample.empty() ? 0.0 : times.sample.back();
    digest.samples = static_cast<std::int64_t>(times.sample.size());
    digest.snapshots = static_cast<std::int64_t>(times.snapshot.size());
    digest.lines = line_starts(file, record);
    digest.courses = line_courses(file, input);
    const double from = input.analysis.dynamics.statistics_from;
    digest.statistics = result_statistics(file, input, fields, from);
    write_statistics(file, digest.statistics, from);

    file.close();
    publish(path);
    for (const fs::path& segment : segments) fs::remove(segment);
    return digest;
}

}  // namespace hawser::io
