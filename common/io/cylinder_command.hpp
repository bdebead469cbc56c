// `hawser hydro cylinder`: computes, writes, and says what came out.
#pragma once

#include <string>

#include "hydro/cylinder_data.hpp"

namespace hawser::io {

/// Computes the request, writes the WAMIT set STEM.1 and so on, prints a summary to standard output
/// and, where it takes long, progress to standard error. Returns the exit code.
int cylinder_command(const hydro::CylinderRequest& request, const std::string& stem, bool quiet);

}  // namespace hawser::io
