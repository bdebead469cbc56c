// Defaults and rules of wave trains that follow from other keys.
#pragma once

#include <vector>

#include "case/declared.hpp"

namespace hawser {

/// Fills in what follows from other keys (gamma, humps, the common stretching, the cut of white
/// noise) and says what does not fit together.
void complete_waves(std::vector<WaveTrain>& waves, const Given& given, Problems& problems);

/// What makes physical sense: steepness, depth, shape, seeds, the window of a record.
void check_waves(const Case& input, Problems& problems);

/// Crest to be expected in three hours [m].
double expected_crest(const std::vector<WaveTrain>& waves);

}  // namespace hawser
