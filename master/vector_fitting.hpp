// Poles of a rational function by vector fitting: Gustavsen and Semlyen 1999, IEEE Trans. Power
// Delivery 14. Common to all entries of a matrix, stable, not faster than a limit.
#pragma once

#include "memory_samples.hpp"

namespace hawser::master {

/// Poles moved a dozen times by vector fitting; those with the least error on the way.
/// @param fastest  limit of |-a + i b| [rad/s]
std::vector<Poles> settled(const Samples& s, std::vector<Poles> poles, double fastest);

}  // namespace hawser::master
