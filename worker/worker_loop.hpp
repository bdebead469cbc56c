// A worker's life: take an order, carry it out on this rank's lines, reply; until told to stop.
#pragma once

#include "io/link.hpp"
#include "lines.hpp"

namespace hawser::io {
class SeriesWriter;
}

namespace hawser::worker {

struct WorkerTimes {
    double busy = 0.0, waited = 0.0;  ///< [s] carrying out orders; waiting for them
};

/// @param lines   this rank's lines, replying in ascending line order
/// @param results null: nothing is recorded (the master then sets no flags)
WorkerTimes worker_loop(const io::Link& link, Lines& lines, io::SeriesWriter* results);

}  // namespace hawser::worker
