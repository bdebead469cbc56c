#include "shares.hpp"

#include <algorithm>

#include "line_mesh.hpp"
#include "packing.hpp"

namespace hawser {

std::vector<std::vector<int>> packs_of_ranks(const Case& input, int ranks) {
    std::vector<std::vector<int>> shares(static_cast<std::size_t>(ranks));
    const std::vector<int> worker = assign(packs_of(input), ranks - 1);
    for (std::size_t pack = 0; pack < worker.size(); ++pack)
        shares[static_cast<std::size_t>(worker[pack]) + 1].push_back(static_cast<int>(pack));
    return shares;
}

std::vector<std::vector<int>> lines_of_ranks(const Case& input, int ranks) {
    const std::vector<Pack> packs = packs_of(input);
    std::vector<std::vector<int>> shares(static_cast<std::size_t>(ranks));
    const auto packs_of_rank = packs_of_ranks(input, ranks);
    for (std::size_t rank = 0; rank < shares.size(); ++rank) {
        for (const int pack : packs_of_rank[rank])
            for (const int line : packs[static_cast<std::size_t>(pack)].lines)
                shares[rank].push_back(line);
        std::sort(shares[rank].begin(), shares[rank].end());
    }
    return shares;
}

std::vector<int> nodes_per_line(const Case& input) {
    std::vector<int> nodes;
    for (const Line& line : input.lines)
        nodes.push_back(static_cast<int>(mesh_of(line).arc_length.size()));
    return nodes;
}

}  // namespace hawser
