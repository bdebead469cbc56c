// What the lines of this process give to the results at a sampling time: their columns of the
// fields that the case's output asks for.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "io/result_fields.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

class LineSamples {
 public:
    LineSamples() = default;
    /// @param results  null: nothing is recorded
    LineSamples(const Case& input, const std::vector<RodPack<Quad>>& packs,
                io::SeriesWriter* results);

    /// Results at the ends, for the sample whose time has been added.
    void put_ends(const std::vector<RodPack<Quad>>& packs);
    /// Positions of all nodes, for the snapshot whose time has been added.
    void put_nodes(const std::vector<RodPack<Quad>>& packs);

 private:
    /// A field and the rods that fill it, in the order of the columns provided.
    struct Channel {
        int field = -1;
        bool end_a = true;
        io::EndResult result{};
        std::vector<std::pair<std::size_t, int>> rods;  ///< pack, lane
    };
    io::SeriesWriter* results_ = nullptr;
    std::vector<Channel> ends_;
    int node_field_ = -1;
    std::vector<double> values_;
};

}  // namespace hawser::worker
