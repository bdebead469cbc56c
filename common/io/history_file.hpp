// Time histories of the platform in text files: forces given by hand, prescribed motion (case keys
// `platform.forces[].file`, `platform.prescribed_motion.file`).
#pragma once

#include "case/platform.hpp"
#include "case/problem.hpp"

namespace hawser::io {

/// Rows of seven numbers, time [s] first and ascending; separated by blanks, commas or semicolons.
/// A comment goes from # to the end of its line.
/// @param key  of the case, for problems; those of the file have its name and line
SixSeries read_six_series(const std::string& path, const std::string& key, Problems& problems);

/// Reads every file that the platform names. Angles of motions are in degrees there. A motion must
/// be known from 0 to `duration` [s].
void read_histories(Platform& platform, double duration, Problems& problems);

}  // namespace hawser::io
