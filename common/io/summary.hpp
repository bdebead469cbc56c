// What a run says to people: summary.txt and statistics.csv. Numbers in kN, m, deg, s, t.
#pragma once

#include <filesystem>
#include <string>

#include "io/result_file.hpp"

namespace hawser::io {

/// The system line by line and the platform, statistics of motions and tensions, the load ledger,
/// where the time went, and what the physics leaves out.
std::string summary_text(const RunRecord& record, const ResultDigest& digest);

/// One row per channel, SI with angles in degrees, full precision.
std::string statistics_csv(const std::vector<ChannelStatistics>& statistics);

/// Writes summary.txt and statistics.csv.
void write_summary(const std::filesystem::path& folder, const RunRecord& record,
                   const ResultDigest& digest);

}  // namespace hawser::io
