// Which rods run side by side, and on which rank: rods of equal layout share a pack of four lanes;
// rods tied to each other stand in the same lane of several packs, a group, on one rank.
#pragma once

#include <vector>

#include "case/case.hpp"

namespace hawser {

/// The platforms that a line touches, itself or by lines that it is tied to. Those of one bundle
/// have the same.
struct Touched {
    int first = 0, second = -1;  ///< indices in the case; second -1: one platform, or none
    [[nodiscard]] bool two() const { return second >= 0; }
    /// 0 or 1: the first or the second of the line's.
    [[nodiscard]] int place_of(int platform) const { return platform == second ? 1 : 0; }
};

/// Of every line. The first platform is that of the lowest line's end A where it has one.
std::vector<Touched> touched_platforms(const Case& input);
/// Does any line of the case touch two platforms?
bool joins_platforms(const Case& input);

inline constexpr int lanes_per_pack = 4;

/// Up to four lines that are advanced together. A rod's bits do not depend on its neighbours.
struct Pack {
    std::vector<int> lines;  ///< indices into Case::lines, at most lanes_per_pack
    double cost = 0.0;       ///< element steps per simulated second
    /// Packs of one group stand side by side: line i of each of them belongs to bundle i, lines
    /// that are tied to each other.
    int group = 0;
};

/// Lines that are tied to each other, directly or through others, in ascending order; a line that
/// is tied to nothing is a bundle of one. In the order of the bundles' first lines.
std::vector<std::vector<int>> bundles_of(const Case& input);

/// All lines in packs, groups in the order of their first lines. Two lines share a layout when they
/// have the same model, number of elements, kinds of ends and joints, and attachments at the same
/// nodes; two bundles share a group when their lines do, one by one, with the same ties.
std::vector<Pack> packs_of(const Case& input);

/// Worker (0 ... workers - 1) of each pack: the costliest group first, each to the worker with
/// least to do. More workers than groups leaves some without work.
std::vector<int> assign(const std::vector<Pack>& packs, int workers);

}  // namespace hawser
