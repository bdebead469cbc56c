#include "line_ranges.hpp"

#include <cmath>
#include <limits>

#include "io/line_fields.hpp"

namespace hawser::worker {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double or_nan(double x) { return std::isfinite(x) ? x : nan; }

}  // namespace

QuantityRange::QuantityRange(LineQuantity quantity, int nodes)
    : quantity_(quantity),
      node_(static_cast<std::size_t>(nodes),
            {.min = inf, .t_min = nan, .max = -inf, .t_max = nan, .mean = 0.0, .squares = 0.0}),
      greatest_(-inf),
      time_(nan),
      profile_(static_cast<std::size_t>(nodes), Quad(nan)) {}

void QuantityRange::add(const Recovery<Quad>& now, double t) {
    const std::size_t q = index_of(quantity_);
    count_ += 1.0;
    const Quad time(t), inverse_n(1.0 / count_);
    Quad greatest(-inf);
    for (int n = 0; n < now.nodes(); ++n) {
        const Quad x = now.node(n)[q];
        Node& node = node_[static_cast<std::size_t>(n)];
        // of a tension that jumps at the node the lesser and the greater side
        const bool tension = quantity_ == LineQuantity::effective_tension;
        const Quad least = tension ? now.tensions(n)[0] : x,
                   most = tension ? now.tensions(n)[1] : x;
        const auto less = least<node.min, more = most> node.max;  // not where x is NaN
        node.min = select(less, least, node.min), node.t_min = select(less, time, node.t_min);
        node.max = select(more, most, node.max), node.t_max = select(more, time, node.t_max);
        const Quad from_mean = x - node.mean;
        node.mean += from_mean * inverse_n;
        node.squares += from_mean * (x - node.mean);
        greatest = select(most > greatest, most, greatest);
    }
    const auto record = greatest > greatest_;
    if (!any(record)) return;
    greatest_ = select(record, greatest, greatest_);
    time_ = select(record, time, time_);
    for (int n = 0; n < now.nodes(); ++n) {
        Quad& kept = profile_[static_cast<std::size_t>(n)];
        kept = select(record, now.node(n)[q], kept);
    }
}

double QuantityRange::value(std::size_t statistic, int lane, int n) const {
    const Node& node = node_[static_cast<std::size_t>(n)];
    if (count_ == 0.0) return nan;
    switch (statistic) {  // in the order of io::range_statistics
        case 0:
            return or_nan(node.min[lane]);
        case 1:
            return node.mean[lane];
        case 2:
            return or_nan(node.max[lane]);
        case 3:
            return std::sqrt(node.squares[lane] / count_);
        case 4:
            return node.t_min[lane];
        case 5:
            return node.t_max[lane];
        default:
            return profile_[static_cast<std::size_t>(n)][lane];
    }
}

double QuantityRange::time_of_maximum(int lane) const { return time_[lane]; }

LineWatch::LineWatch(int nodes)
    : limit_(0.0), duration_(0.0), first_(nan), counts_(static_cast<std::size_t>(nodes)) {
    for (Extreme& e : extremes_) e = {.value = -inf, .node = nan, .time = nan};
}

void LineWatch::add(const Recovery<Quad>& now, double t) {
    using Q = LineQuantity;
    constexpr std::array<Q, 5> watched{Q::effective_tension, Q::effective_tension,
                                       Q::von_mises_stress, Q::yield_utilisation,
                                       Q::load_utilisation};
    constexpr std::size_t T = index_of(Q::effective_tension);
    if (!started_) {
        for (int n = 0; n < now.nodes(); ++n)
            limit_ = max(limit_, Quad(io::slack_share) * now.node(n)[T]);
        for (int n = 0; n < now.nodes(); ++n)
            counts_[static_cast<std::size_t>(n)] =
                select(now.node(n)[T] >= Quad(2.0) * limit_, Quad(1.0), Quad(0.0));
    }
    const Quad time(t);
    Quad slack(0.0);
    for (int n = 0; n < now.nodes(); ++n) {
        const Quad counted = counts_[static_cast<std::size_t>(n)];
        const auto counts = counted > Quad(0.5);
        for (std::size_t k = 0; k < watched.size(); ++k) {
            const Quad value = k < 2 ? now.tensions(n)[k] : now.node(n)[index_of(watched[k])];
            const Quad x = k == 0 ? -value : value;  // least tension: greatest of the negative
            Extreme& e = extremes_[k];
            auto more = x > e.value;
            if (k == 0) more = more & counts;
            e.value = select(more, x, e.value);
            e.node = select(more, Quad(static_cast<double>(n)), e.node);
            e.time = select(more, time, e.time);
        }
        slack = select((now.tensions(n)[0] < limit_) & counts, Quad(1.0), slack);
    }
    const auto is_slack = slack > Quad(0.5);
    if (started_) duration_ += select(is_slack, Quad(t - last_time_), Quad(0.0));
    first_ = select(is_slack & !(first_ <= first_), time, first_);
    last_time_ = t;
    started_ = true;
}

std::array<double, 3> LineWatch::extreme(std::size_t which, int lane) const {
    const Extreme& e = extremes_[which];
    const double value = which == 0 ? -e.value[lane] : e.value[lane];
    return {or_nan(value), e.node[lane], e.time[lane]};
}

std::array<double, 3> LineWatch::slack(int lane) const {
    return {limit_[lane], duration_[lane], first_[lane]};
}

}  // namespace hawser::worker
