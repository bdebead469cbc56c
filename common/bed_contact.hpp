// How a line lies on the sea floor when nothing else acts on it: the height of its axis there.
#pragma once

#include "case/case.hpp"

namespace hawser {

/// Depth over which the bed's spring comes into play: d0 of R:33 [m].
inline constexpr double bed_smoothing = 0.025;

/// How deep a weight per length [N/m] sinks in: the inverse of R:33,
///
///     pen = sqrt(2 d0 w/k) up to d0,   then w/k + d0/2   [m];   0 for what floats
double resting_penetration(double weight, const Seabed& seabed);

/// Height of a line's axis above the bed, along the vertical, where it lies at rest: its radius
/// less what it sinks in, not below the bed [m]. An anchor holds its line at this height, so that
/// what lies there is straight up to it.
double resting_height(const LineType& type, const Environment& environment);

}  // namespace hawser
