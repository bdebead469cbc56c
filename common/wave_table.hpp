// What tables over frequency and heading have in common: the order of their headings, and the
// diagonal of a quadratic transfer function as a table.
#pragma once

#include <cmath>

#include "hydro_data.hpp"

namespace hawser {

/// A table of one heading is held this far to either side of it [rad]: head seas met by a hull that
/// yaws a little.
constexpr double one_heading_reach = 5.0 * M_PI / 180.0;

/// Sorts the headings so that the widest gap of the circle lies outside the range; says whether the
/// range closes: no gap wider than 90 deg, none wider outside than inside.
template <class Value>
void order_headings(WaveTable<Value>& table);

/// Q(w, w, b, b) over the file's frequencies, zero where the file has none. Its real part is, of
/// difference frequencies, the mean drift per amplitude squared.
WaveTable<CVec6> diagonal(const Qtf& qtf);

}  // namespace hawser
