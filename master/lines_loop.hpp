// The time loop of a case without a platform: lines whose ends are fixed or move as prescribed.
#pragma once

#include "lines.hpp"
#include "paper_rate.hpp"

namespace hawser::master {

/// One pass of the lines per platform step D [s], and they keep each. `record(step, t, reply)` sees
/// the lines' loads at t = step D, sets the flags of the next order and returns false to end the
/// run.
/// @param start  the static loads at t = 0
template <class Record>
void lines_loop(Lines& lines, const Reply& start, Order& next, double D, Record&& record) {
    const Reply* reply = &start;
    for (int step = 0; record(step, step * D, *reply); ++step) {
        next.ask = Ask::run_to;
        next.t0 = step * D;
        next.t1 = (step + 1) * D;
        lines.send(next);
        next = Order{};
        reply = &lines.receive();
        if (!reply->status.ok()) throw LinesFailed(reply->status, 0);
        next.keep_previous = true;
    }
}

}  // namespace hawser::master
