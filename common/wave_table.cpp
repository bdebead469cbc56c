#include "wave_table.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

namespace {
constexpr double turn = 2.0 * M_PI;
constexpr double same_heading = 1e-6;  // [rad]
}  // namespace

template <class Value>
void order_headings(WaveTable<Value>& table) {
    auto& all = table.headings;
    if (all.empty()) return;
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.heading < b.heading; });
    const std::size_t n = all.size();
    std::size_t first = 0;  // the heading after the widest gap
    double widest = all.front().heading + turn - all.back().heading, widest_inside = 0.0;
    for (std::size_t i = 1; i < n; ++i)
        if (const double gap = all[i].heading - all[i - 1].heading; gap > widest + same_heading) {
            widest = gap;
            first = i;
        }
    for (std::size_t i = first; i < n; ++i)
        if (first > 0) all[i].heading -= turn;
    std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
    for (std::size_t i = 1; i < n; ++i)
        widest_inside = std::max(widest_inside, all[i].heading - all[i - 1].heading);
    table.full_circle =
        n > 2 && widest <= widest_inside + same_heading && widest <= M_PI / 2 + same_heading;
}

WaveTable<CVec6> diagonal(const Qtf& qtf) {
    WaveTable<CVec6> table;
    table.frequencies = qtf.frequencies;
    const std::size_t n = qtf.frequencies.size();
    for (const QtfPair& p : qtf.pairs) {
        if (std::abs(std::remainder(p.heading_1 - p.heading_2, turn)) > same_heading) continue;
        HeadingData<CVec6>& to = table.headings.emplace_back();
        to.heading = p.heading_1;
        for (std::size_t i = 0; i < n; ++i) to.values.push_back(p.values[i * n + i]);
    }
    order_headings(table);
    return table;
}

template void order_headings(WaveTable<Vec6>&);
template void order_headings(WaveTable<CVec6>&);

}  // namespace hawser
