// Static targets: the length of a section or the radius of an anchor at which a line has its
// pretension, its hang-off angle or its tensioner's nominal tension at stroke 0, at the design
// position in still water. Found with the rods that run afterwards.
#pragma once

#include <vector>

#include "adjustment.hpp"

namespace hawser::worker {

/// What meets the targets of all lines that have one, to 1e-7 of the tension, 1e-7 rad or 1e-7 m of
/// stroke. Throws RunError (no_equilibrium) that names the line, its target, the best that was
/// reached and why there is no more.
[[nodiscard]] std::vector<Adjustment> find_adjustments(const Case& input);

}  // namespace hawser::worker
