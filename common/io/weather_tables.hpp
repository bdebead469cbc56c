// Text files of two columns: a wave spectrum, a measured elevation, a wind speed in time.
#pragma once

#include <filesystem>

#include "case/declared.hpp"

namespace hawser::io {

/// Reads the `file` of each train that has one into its `spectrum` or `record`, SI, and that of the
/// wind into its `history`; where the
/// rows are there already no file is needed; only the resolved text of a case has both. Columns are
/// separated by blanks, commas or semicolons; a line that does not start with a number is skipped
/// before the first row and an error after it. Problems name file, line and column.
void read_weather_tables(Environment& environment, const std::filesystem::path& folder,
                         bool resolved, Problems& problems);

}  // namespace hawser::io
