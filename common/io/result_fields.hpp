// What a run records over time: the paths, units and shapes that the output section of a case asks
// for. All ranks make the same list from the same case.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "io/line_fields.hpp"
#include "io/series_file.hpp"

namespace hawser::io {

/// Loads on the platform that are recorded one by one, in the order of the result file; each is
/// force [N] and moment about O [N.m] on world axes.
inline constexpr std::array<std::string_view, 16> load_names{
    "wave1",   "drift", "wave2",   "radiation", "hydrostatic", "weight",  "members", "plates",
    "current", "wind",  "damping", "stiffness", "forces",      "holding", "lines",   "total"};

/// Does the platform have this load? Those given by hand are recorded where the case has them.
bool has_load(const Platform& platform, std::string_view name);

/// /platform/<name>/
std::string platform_path(const Platform& platform);

/// All fields of the case, in a fixed order: motions of each platform, loads on each, environment,
/// lines. @param nodes of each line, in line order
std::vector<SeriesField> result_fields(const Case& input, const std::vector<int>& nodes);

}  // namespace hawser::io
