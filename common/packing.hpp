// Which rods run side by side, and on which rank: rods of equal layout share a pack of four lanes.
#pragma once

#include <vector>

#include "case/case.hpp"

namespace hawser {

inline constexpr int lanes_per_pack = 4;

/// Up to four lines that are advanced together. A rod's bits do not depend on its neighbours.
struct Pack {
    std::vector<int> lines;  ///< indices into Case::lines, at most lanes_per_pack
    double cost = 0.0;       ///< element steps per simulated second
};

/// All lines in packs, in the order of each pack's first line. Two lines share a layout when they
/// have the same model, number of elements, kinds of ends and joints, and attachments at the same
/// nodes.
std::vector<Pack> packs_of(const Case& input);

/// Worker (0 ... workers - 1) of each pack: the costliest pack first, each to the worker with least
/// to do. More workers than packs leaves some without work.
std::vector<int> assign(const std::vector<Pack>& packs, int workers);

}  // namespace hawser
