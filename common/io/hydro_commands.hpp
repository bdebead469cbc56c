// `hawser hydro info` and `hawser hydro convert`: neither needs a case.
#pragma once

#include <string>

#include "io/hydro_options.hpp"

namespace hawser::io {

/// Prints what a set holds and what its checks say. Returns ExitCode::input if one says wrong.
/// Throws HydroFileError if it cannot be read.
int hydro_info_command(const HydroRequest& request, bool json);

/// Writes the set as STEM.1 .3 .hst ... and as STEM.h5, whatever it came from. Refuses to write
/// over the files it read. Throws HydroFileError, RunError.
int hydro_convert_command(const HydroRequest& request, const std::string& stem, bool quiet);

}  // namespace hawser::io
