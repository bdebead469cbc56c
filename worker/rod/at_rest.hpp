// What people want to know of a line in its static solution: tensions, angles, the part that lies
// on the seabed, constraints.
#pragma once

#include "case/case.hpp"
#include "resting_lines.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

/// Reads a lane of a pack whose last order was `equilibrium`.
template <class V>
LineAtRest at_rest(const RodPack<V>& pack, int lane, const Case& input);

}  // namespace hawser::worker
