// What a line weighs in water: sections, tapers and what is attached.
#pragma once

#include "case/case.hpp"

namespace hawser {

/// Weight in water of the sections and attachments at and below an arc length from end A [N].
/// Along a taper mass and displaced area run linearly, so the mean of the part's two ends counts.
double submerged_weight(const Line& line, const Case& input, double from_arc_length = 0.0);

}  // namespace hawser
