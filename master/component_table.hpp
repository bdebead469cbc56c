// Coefficients of a wave table for the components of the sea: interpolated in frequency once, in
// heading whenever the platform turns.
#pragma once

#include <array>
#include <vector>

#include "environment/sea.hpp"
#include "hydro_data.hpp"
#include "wave_table.hpp"

namespace hawser::master {

/// Four headings of a table and their weights, for one direction of travel seen from the platform.
struct HeadingWeights {
    std::array<int, 4> index{};
    std::array<double, 4> weight{};
};

/// Cubic Hermite interpolation between the neighbouring headings, with slopes of the parabola
/// through three of them: continuous slope, so that the loads are smooth in yaw; exact for
/// parabolas inside. Ends of an open range have the slope of their interval. A table of one heading
/// serves within one_heading_reach to either side.
///
/// @param headings  ascending [rad]
/// @param heading   any [rad]; reduced to the range. Throws RunError (diverged) outside an open one
HeadingWeights heading_weights(const std::vector<double>& headings, bool full_circle,
                               double heading);

template <class Value>
class ComponentTable {
 public:
    ComponentTable() = default;
    /// Linear in frequency; beyond the table its end value is held. Throws RunError (input) if more
    /// than 1 % of the waves' energy lies there, or a wave comes from a heading outside the table.
    ComponentTable(const WaveTable<Value>& table, const std::vector<WaveComponent>& components);

    /// Coefficient of component i, for weights made with weights().
    [[nodiscard]] Value at(int i, const HeadingWeights& w) const {
        const Value* row = values_.data() + static_cast<std::size_t>(i) * headings_.size();
        return w.weight[0] * row[w.index[0]] + w.weight[1] * row[w.index[1]] +
               w.weight[2] * row[w.index[2]] + w.weight[3] * row[w.index[3]];
    }
    [[nodiscard]] HeadingWeights weights(double heading) const {
        return heading_weights(headings_, full_circle_, heading);
    }
    [[nodiscard]] bool empty() const { return values_.empty(); }

 private:
    std::vector<double> headings_;
    bool full_circle_ = false;
    std::vector<Value> values_;  ///< component by component, headings within
};

extern template class ComponentTable<CVec6>;
extern template class ComponentTable<Vec6>;

}  // namespace hawser::master
