// Lines that other ranks compute: one broadcast down, one gather up per order.
#pragma once

#include <vector>

#include "io/link.hpp"
#include "lines.hpp"
#include "packing.hpp"

namespace hawser::master {

/// Rank 0's end of the exchange; worker::worker_loop is the other. The loads are put into line
/// order and never summed on the way, so the bits are those of local lines whatever the number of
/// ranks.
class RemoteLines final : public Lines {
 public:
    /// @param lines_of_rank for each rank the lines it computes, in ascending order; empty for rank
    /// 0
    /// @param platforms  in the case
    /// @param touched    by each line; empty: by all the same one
    RemoteLines(const io::Link& link, std::vector<std::vector<int>> lines_of_rank,
                int platforms = 1, const std::vector<Touched>& touched = {});

    void send(const Order& order) override;
    const Reply& receive() override;

    /// Time spent waiting for the slowest worker so far [s].
    [[nodiscard]] double waited() const { return waited_; }

 private:
    const io::Link& link_;
    std::vector<std::vector<int>> lines_of_rank_;
    std::size_t order_numbers_;
    std::vector<Touched> touched_;
    bool between_ = false;  ///< a line lies between two platforms
    Ask ask_ = Ask::stop;
    std::vector<int> counts_;
    std::vector<double> message_;
    Reply reply_;
    double waited_ = 0.0;
};

}  // namespace hawser::master
