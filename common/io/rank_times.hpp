// What the ranks of a run tell each other beside orders and replies: how they fared and what it
// cost.
#pragma once

#include <vector>

#include "io/link.hpp"

namespace hawser::io {

/// Where a rank's time in the time loop went [s].
struct RankTimes {
    double user_cpu = 0.0;  ///< user time of the process, waiting included where MPI polls
    double busy = 0.0;      ///< wall clock at work
    double waited = 0.0;    ///< wall clock waiting for other ranks
};

/// Collective: all ranks' times on rank 0, in rank order; empty elsewhere.
std::vector<RankTimes> gather_times(const Link& link, const RankTimes& mine);

/// Collective: the worst exit code of all ranks, so that they go on or end together.
ExitCode agree(const Link& link, ExitCode mine);

}  // namespace hawser::io
