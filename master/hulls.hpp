// The platforms of a case, each with its own coefficients.
#pragma once

#include <vector>

#include "hull.hpp"

namespace hawser::master {

/// All of them, in the order of the case; none without a platform. Reads the files that they name.
/// Throws RunError (input, io) with file and line.
std::vector<Hull> hulls_of(const Case& input);

}  // namespace hawser::master
