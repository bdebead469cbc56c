// Wave trains and wind in words, for summaries.
#pragma once

#include <string>

#include "case/environment.hpp"

namespace hawser {

/// "JONSWAP (gamma 2.4): Hs 15.2 m, Tp 15.6 s, towards 0 deg, 100 components, seed 1".
std::string words_of(const WaveTrain& train);

/// "45 m/s at 10 m (3600 s mean), towards 0 deg, NPD gusts".
std::string words_of(const Wind& wind);

}  // namespace hawser
