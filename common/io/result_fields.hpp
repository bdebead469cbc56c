// What a run records over time: the paths, units and shapes that the output section of a case asks
// for. All ranks make the same list from the same case.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "io/series_file.hpp"

namespace hawser::io {

/// Loads on the platform that are recorded one by one, in the order of the result file; each is
/// force [N] and moment about O [N.m] on world axes.
inline constexpr std::array<std::string_view, 12> load_names{
    "wave1",  "drift",   "radiation", "hydrostatic", "weight", "members",
    "plates", "current", "wind",      "damping",     "lines",  "total"};

/// Results at the ends of a line.
enum class EndResult { effective_tension, declination, azimuth, force, moment };
inline constexpr std::array<EndResult, 5> end_results{EndResult::effective_tension,
                                                      EndResult::declination, EndResult::azimuth,
                                                      EndResult::force, EndResult::moment};

/// Path of a result at end A (or B), e.g. /lines/end_a/effective_tension.
std::string end_path(bool end_a, EndResult result);

/// Does some entry of output.lines ask for this result of this line? Columns of lines that are not
/// asked for stay NaN.
bool is_recorded(const Output& output, const std::string& line, bool end_a, EndResult result);

/// Does a name match a glob of * and ? ?
bool matches(std::string_view glob, std::string_view name);

/// /platform/<name>/ with the name of the case's platform.
std::string platform_path(const Case& input);

/// All fields of the case, in a fixed order. @param nodes of each line, in line order
std::vector<SeriesField> result_fields(const Case& input, const std::vector<int>& nodes);

}  // namespace hawser::io
