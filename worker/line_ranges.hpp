// What the rods of a pack went through: of chosen quantities least, mean, greatest value and
// standard deviation at every node; of every line its extremes. Sums run in order of time and lane
// by lane, so that they do not depend on neighbours or ranks. No allocation after the set-up.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "case/case.hpp"
#include "rod/recovered.hpp"

namespace hawser::worker {

/// Course of one quantity along the rods of a pack.
class QuantityRange {
 public:
    QuantityRange(LineQuantity quantity, int nodes);
    /// The values at one time [s].
    void add(const Recovery<Quad>& now, double t);

    /// One of the range_statistics at node n from end A of a lane; NaN without values.
    [[nodiscard]] double value(std::size_t statistic, int lane, int n) const;
    /// When the lane's greatest value along the line occurred [s].
    [[nodiscard]] double time_of_maximum(int lane) const;
    [[nodiscard]] LineQuantity quantity() const { return quantity_; }

 private:
    /// min, t_min, max, t_max; mean and sum of squares about it, updated value by value.
    struct Node {
        Quad min, t_min, max, t_max, mean, squares;
    };
    LineQuantity quantity_;
    double count_ = 0.0;
    std::vector<Node> node_;
    Quad greatest_, time_;       ///< along the whole line
    std::vector<Quad> profile_;  ///< values at that time
};

/// Extremes of every rod of a pack over the whole run, and how long it was slack.
class LineWatch {
 public:
    explicit LineWatch(int nodes);
    /// The values at one time [s]; the first call sets what counts as slack.
    void add(const Recovery<Quad>& now, double t);

    /// Value, node from end A and time of one of io::line_extremes; NaN where there is none.
    [[nodiscard]] std::array<double, 3> extreme(std::size_t which, int lane) const;
    /// Limit [N], duration [s], first time [s].
    [[nodiscard]] std::array<double, 3> slack(int lane) const;

 private:
    struct Extreme {
        Quad value, node, time;
    };
    bool started_ = false;
    double last_time_ = 0.0;
    std::array<Extreme, 5> extremes_;
    Quad limit_, duration_, first_;
    std::vector<Quad> counts_;  ///< 1 where the node had tension enough at the start, else 0
};

}  // namespace hawser::worker
