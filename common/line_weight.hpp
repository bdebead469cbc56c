// What a line weighs in water, with sections, tapers and what is attached; how far it gives.
#pragma once

#include "case/case.hpp"

namespace hawser {

/// Weight in water of the sections and attachments at and below an arc length from end A [N].
/// Along a taper mass and displaced area run linearly, so the mean of the part's two ends counts.
double submerged_weight(const Line& line, const Case& input, double from_arc_length = 0.0);

/// About what a line can be longer by, stretched, before it breaks [m]: 3 % of rope and lines of a
/// general kind, 0.3 % of chain, wire and pipe.
double greatest_stretch(const Line& line, const Case& input);

}  // namespace hawser
