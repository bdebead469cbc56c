// Who does what in a run, as the program's start sees it: rank 0 is the master (platform), the
// others are workers (lines); alone, one process is both. master/ and worker/ define these.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adjustment.hpp"
#include "case/case.hpp"
#include "lines.hpp"
#include "status.hpp"

namespace hawser {

namespace io {
class Link;
class SeriesWriter;
}  // namespace io

enum class ProgressStyle { automatic, bar, lines, none };

/// What a run is told beside its case. Workers need the folder only.
struct RunRequest {
    std::filesystem::path folder;
    bool force = false;    ///< replace an earlier result
    std::string resolved;  ///< text of the case, every default filled in
    std::vector<std::pair<std::string, std::string>> sources;  ///< file name, text
    std::vector<std::string> notes;                            ///< warnings of the check
    std::vector<Adjustment> adjustments;                       ///< that statics made to the case
    std::string command, version, build;                       ///< for the result's attributes
    ProgressStyle progress = ProgressStyle::automatic;
    bool quiet = false;
};

/// Makes a checked case ready to compute, before any of the following: rank 0 finds what the static
/// targets of the lines ask for, every rank puts the same numbers into its case. Collective. A
/// target out of reach throws RunError on every rank, with the message on rank 0 alone.
/// @return what was adjusted; empty on other ranks than 0
std::vector<Adjustment> meet_targets(Case& input, const io::Link& link);

/// Rank 0 of a run, or all of it if the link is alone. Every rank returns the same exit code.
ExitCode run_master(const Case& input, const RunRequest& request, io::Link& link);
/// All other ranks.
ExitCode run_worker(const Case& input, const RunRequest& request, io::Link& link);

/// What a run of the case on so many ranks would take, as text for people: allocation, memory of
/// the busiest rank (measured by building its lines), size of the output.
std::string dry_run(const Case& input, int ranks);

/// The lines of these packs (indices into packs_of(input)), computed in this process. Replies carry
/// this process's lines only, in ascending line order; of several failing lines the first in line
/// order is the one reported. Flags of an order are carried out in send(). On `sample` and
/// `snapshot` the lines put() their columns for the time that the caller has added; add_time() and
/// write_segment() are the caller's, because the platform records into the same file.
/// @param results null: nothing is recorded
std::unique_ptr<Lines> make_local_lines(const Case& input, const std::vector<int>& packs,
                                        io::SeriesWriter* results);

}  // namespace hawser
