// Where the time of a run went, as numbers for /performance and the summary.
#pragma once

#include <vector>

#include "io/rank_times.hpp"
#include "io/result_file.hpp"

namespace hawser::master {

/// @param times      of each rank, in the time loop
/// @param simulated  time reached [s]
/// @param orders     orders sent in all
std::vector<io::Fact> performance_facts(const std::vector<io::RankTimes>& times, double simulated,
                                        int orders);

}  // namespace hawser::master
