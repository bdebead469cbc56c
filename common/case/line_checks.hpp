// Checks of one line that need no simulation: geometry, constraints, what goes together.
#pragma once

#include "case/declared.hpp"

namespace hawser {

/// @param keys  what the line was built of: where in the file things stand
void check_line(const Line& line, const LineKeys& keys, const Case& whole, Problems& problems);

}  // namespace hawser
