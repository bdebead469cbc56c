// The result of a run: at its end, also after a failure or a stop, rank 0 joins the segments into
// result.h5 and adds what does not depend on time. Paths and shapes: README.md, "Results".
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adjustment.hpp"
#include "case/case.hpp"
#include "io/hdf5.hpp"
#include "io/line_fields.hpp"
#include "ledger.hpp"
#include "statistics.hpp"

namespace hawser::io {

/// The common equilibrium from which the run started.
struct StaticState {
    std::vector<PlatformMotion> platforms;  ///< in the order of the case, on world axes
    std::vector<double> end_a_tension;      ///< effective, per line [N]; may be empty
};

/// A number worth keeping, for people and for /performance.
struct Fact {
    std::string name, units, description;
    double value = 0.0;
};

/// Impulse that a constraint gave its rod against the one it gave the platform, R:40.
struct ImpulseMismatch {
    std::string constraint;  ///< line/constraint
    double value = 0.0;      ///< |I_rod - I_hull| / sum h |f| over the run
};

inline constexpr double large_mismatch = 0.01;

/// What rank 0 knows about a run when it ends.
struct RunRecord {
    Case input;
    std::string resolved;                                      ///< text of the case as run
    std::vector<std::pair<std::string, std::string>> sources;  ///< file name, text
    std::string version, build, command;
    int ranks = 1;
    bool complete = false;  ///< false: stopped or failed on the way
    std::string outcome;    ///< one line for people: "done", or what went wrong
    std::optional<StaticState> statics;
    std::vector<std::string> doubts;        ///< that the static start left, `NAME: sentence`
    std::vector<Adjustment> adjustments;    ///< that statics made to `input`
    std::vector<LedgerTable> ledgers;       ///< of each platform; empty: not kept
    std::vector<ImpulseMismatch> impulses;  ///< of each line with constraints, the largest
    /// Of each platform mass, acting buoyancy, GM, periods; empty: the run did not get so far
    std::vector<std::vector<Fact>> platforms;
    std::vector<Fact> performance;  ///< `name` as in /performance/<name>; times in s
};

/// Statistics of one recorded channel.
struct ChannelStatistics {
    std::string channel;  ///< e.g. platform/spar/surge, line/ml1/end_a/effective_tension
    std::string units;
    Statistics values;
};

/// State of one line at the start; NaN where a run did not get so far.
struct LineStart {
    double end_a_tension, end_b_tension;          ///< effective [N]
    double end_a_declination, end_b_declination;  ///< [deg]
    double grounded;                              ///< length in contact with the seabed [m]
    double touchdown;  ///< arc length of its first contact with the seabed [m]; NaN: none
};

/// A greatest or least value along a line, where and when [m, s]; NaN: the line has no such thing.
struct Extreme {
    double value, arc_length, time;
};

/// What a line went through in the whole run.
struct LineCourse {
    std::array<Extreme, line_extremes.size()> extremes;  ///< in the order of line_extremes
    double slack_limit = 0.0, slack_duration = 0.0, slack_first = 0.0;  ///< [N, s, s]
};

/// What the joined result tells the summary.
struct ResultDigest {
    std::vector<ChannelStatistics> statistics;
    std::vector<LineStart> lines;
    std::vector<LineCourse> courses;  ///< one per line
    double last_time = 0.0;           ///< of the samples [s]
    std::int64_t samples = 0, snapshots = 0;
};

/// Writes folder/result.h5 from the segments there: to result.h5.part, synced, renamed; then the
/// segments are deleted. Rank 0 alone. After a failure the segments are still there.
ResultDigest write_result(const std::filesystem::path& folder, const RunRecord& record);

/// Statistics of motions, environment and all numbers recorded of lines and constraints (but
/// azimuths), t >= from [s].
std::vector<ChannelStatistics> result_statistics(const Hdf5File& result, const Case& input,
                                                 const std::vector<SeriesField>& fields,
                                                 double from);

}  // namespace hawser::io
