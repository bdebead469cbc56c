// A worker's life: take an order, carry it out on this rank's lines, reply; until told to stop.
#pragma once

#include "io/link.hpp"
#include "io/rank_times.hpp"
#include "lines.hpp"

namespace hawser::io {
class SeriesWriter;
}

namespace hawser::worker {

/// @param lines   this rank's lines, replying in ascending line order
/// @param results null: nothing is recorded (the master then sets no flags)
/// @param platforms in the case
/// @param between   does a line of the case, on whatever rank, lie between two platforms?
/// @return where the time went from the first pass on
io::RankTimes worker_loop(const io::Link& link, Lines& lines, io::SeriesWriter* results,
                          int platforms = 1, bool between = false);

}  // namespace hawser::worker
