// Who computes which lines: packs dealt to ranks. Rank 0 has the platform and no lines.
#pragma once

#include <vector>

#include "case/case.hpp"

namespace hawser {

/// For each rank the packs (indices into packs_of) it computes; empty for rank 0.
std::vector<std::vector<int>> packs_of_ranks(const Case& input, int ranks);
/// For each rank the lines it computes, ascending; empty for rank 0.
std::vector<std::vector<int>> lines_of_ranks(const Case& input, int ranks);

/// Nodes of each line, in line order.
std::vector<int> nodes_per_line(const Case& input);

}  // namespace hawser
