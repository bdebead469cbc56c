// What a run records of its lines: at ends and places, of constraints and touchdown over time; over
// the arc as ranges; and what is always kept for the summary. All ranks make the same lists.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "io/series_file.hpp"
#include "line_quantities.hpp"

namespace hawser::io {

/// Results at the ends of a line that are those of its reaction there; other quantities of
/// LineQuantity may be recorded there too.
enum class EndResult { effective_tension, declination, azimuth, force, moment };
inline constexpr std::array<EndResult, 5> end_results{EndResult::effective_tension,
                                                      EndResult::declination, EndResult::azimuth,
                                                      EndResult::force, EndResult::moment};

/// Path of a result at end A (or B), e.g. /lines/end_a/effective_tension.
std::string end_path(bool end_a, EndResult result);
std::string end_path(bool end_a, LineQuantity quantity);

/// Does some entry of output.lines ask for this result of this line? Columns of lines that are not
/// asked for stay NaN.
bool is_recorded(const Output& output, const std::string& line, bool end_a, EndResult result);
bool is_recorded(const Output& output, const std::string& line, bool end_a, LineQuantity quantity);
/// Quantities at the ends beside the EndResults: each has a field /lines/end_a/<quantity>.
std::vector<LineQuantity> further_end_quantities();

/// A place along a line at which something is recorded.
struct LinePlace {
    int line = 0;
    double arc_length = 0.0;
    bool operator<(const LinePlace& other) const {
        return line != other.line ? line < other.line : arc_length < other.arc_length;
    }
};
/// All of them, in line order and along each line; column k of /lines/at/<quantity> is place k.
std::vector<LinePlace> recorded_places(const Case& input);
bool is_recorded(const Case& input, const LinePlace& place, LineQuantity quantity);
std::string place_path(LineQuantity quantity);  ///< /lines/at/<quantity>

/// Where a line first touches the seabed: arc_length, x, y, z.
inline constexpr std::array<std::string_view, 4> touchdown_results{"arc_length", "x", "y", "z"};
bool is_touchdown_recorded(const Output& output, const std::string& line, std::string_view result);
std::string touchdown_path(std::string_view result);  ///< /lines/touchdown/<result>

/// A constraint of the case, in line order and in the order of the line.
struct ConstraintOfLine {
    int line = 0, index = 0;
    std::string name;  ///< <line>/<constraint>
};
std::vector<ConstraintOfLine> constraints_of(const Case& input);
inline constexpr std::array<ConstraintResult, 6> constraint_results{
    ConstraintResult::force, ConstraintResult::moment, ConstraintResult::tension,
    ConstraintResult::gap,   ConstraintResult::stroke, ConstraintResult::slip};
bool is_recorded(const Case& input, const ConstraintOfLine& constraint, ConstraintResult result);
std::string constraint_path(ConstraintResult result);  ///< /constraints/<result>
inline constexpr std::string_view mismatch_path = "/constraints/impulse_mismatch";

/// Quantities of which some line's range is kept, and whether this one's is.
std::vector<LineQuantity> range_quantities(const Case& input);
bool is_in_range(const Output& output, const std::string& line, LineQuantity quantity);
inline constexpr std::array<std::string_view, 7> range_statistics{
    "min", "mean", "max", "std", "t_min", "t_max", "at_maximum"};
/// /lines/range/<quantity>/<statistic>; `time_of_maximum`: when the whole line had its greatest
/// value
std::string range_path(LineQuantity quantity, std::string_view statistic);

/// Always kept, over the whole run: value, arc length and time of a line's extremes.
inline constexpr std::array<std::string_view, 5> line_extremes{
    "effective_tension_min", "effective_tension_max", "von_mises_stress_max",
    "yield_utilisation_max", "load_utilisation_max"};
std::string extreme_path(std::string_view name);  ///< /lines/extremes/<name>
/// Below this part of the greatest tension along it at the start a line counts as slack; places
/// that had less than twice as much then are left out (the free end of a hanging line).
inline constexpr double slack_share = 0.01;

/// State of the lines at the start, kept for all lines.
inline constexpr std::array<std::string_view, 5> start_results{
    "end_b/effective_tension", "end_a/declination", "end_b/declination", "grounded_length",
    "touchdown"};
std::string start_path(std::string_view name);  ///< /statics/lines/<name>

/// Fields of the lines, in a fixed order. @param nodes of each line
void add_line_fields(const Case& input, const std::vector<int>& nodes,
                     std::vector<SeriesField>& fields);

/// What one line, place or constraint has of a field: column `column`, `width` numbers.
struct LineChannel {
    std::string path;  ///< in the result: /line/<name>/..., /constraint/<line>/<name>/...
    const SeriesField* field = nullptr;
    int column = 0, width = 1;
    bool in_statistics = false;
};
/// All channels that are recorded over time at fixed places. @param fields of the case, outliving
/// the answer
std::vector<LineChannel> line_channels(const Case& input, const std::vector<SeriesField>& fields);

}  // namespace hawser::io
