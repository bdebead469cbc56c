// The parts of a result file, each written by a file of its own. Private to result_file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/hdf5.hpp"
#include "io/result_file.hpp"
#include "io/series_file.hpp"

namespace hawser::io {

/// The attributes that every dataset has.
void describe(Hdf5File& file, const std::string& path, const std::string& units,
              const std::string& description);
/// A dataset of doubles with its attributes; `shape` empty: a scalar.
void write_numbers(Hdf5File& file, const std::string& path, std::span<const double> values,
                   const Extent& shape, const std::string& units, const std::string& description);

// result_series.cpp: what the segments hold

/// Times of both clocks in all segments, in order.
struct JoinedTimes {
    std::vector<double> sample, snapshot;
};
JoinedTimes joined_times(const std::vector<std::filesystem::path>& segments);
/// All fields of all segments, chunked and compressed. Each segment is opened once.
void join_fields(Hdf5File& file, const std::vector<std::filesystem::path>& segments,
                 const std::vector<SeriesField>& fields, const JoinedTimes& times);

// result_lines.cpp: names and nodes of the lines, and the same results line by line

void write_lines(Hdf5File& file, const Case& input);
/// /line/<name>/...: per line the columns that were asked for, as virtual datasets.
void write_line_views(Hdf5File& file, const Case& input, const std::vector<SeriesField>& fields);
/// Where /lines/at/* stand and whose /constraints/* are.
void write_places(Hdf5File& file, const Case& input);
std::vector<LineCourse> line_courses(const Hdf5File& file, const Case& input);
std::vector<LineStart> line_starts(const Hdf5File& file, const RunRecord& record);

// result_tables.cpp: equilibrium, statistics, ledger

void write_statics(Hdf5File& file, const Case& input, const StaticState& statics);
/// Mass, buoyancy, GM, natural periods ... as /statics/platform/<name>/<fact>.
void write_platform_facts(Hdf5File& file, const Platform& platform, const std::vector<Fact>& facts);
void write_statistics(Hdf5File& file, const std::vector<ChannelStatistics>& rows, double from);
void write_ledger(Hdf5File& file, const Platform& platform, const LedgerTable& ledger);
/// Where a platform is designed to be, unless that is the origin of a single one.
void write_design_position(Hdf5File& file, const Case& input);

// result_input.cpp: what went in

/// The case as text, its sources, and the geometry that pictures need.
void write_input(Hdf5File& file, const RunRecord& record);
/// Attributes of the file itself.
void write_root(Hdf5File& file, const RunRecord& record);

}  // namespace hawser::io
