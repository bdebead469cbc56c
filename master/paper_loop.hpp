// The paper's time loop, P:3: fourth-order Runge-Kutta for the platform, four passes of the lines
// per step, of which they keep the last.
#pragma once

#include <type_traits>

#include "paper_rate.hpp"

namespace hawser::master {

/// Advances platform - or platforms, Y then a JointState - and lines together with the platform
/// step D [s] from the static start y.
///
///      0  |
///     1/2 | 1/2
///     1/2 |  0   1/2
///      1  |  0    0    1
///     ----+--------------------
///         | 1/6  1/3  1/3  1/6
///
/// `record(step, t, y)` sees the state at every t = step D with the evaluation there
/// (`rate.loads()` ...), sets the flags of the next order and returns false to end the run.
/// @return the last state
template <class Platform, class Y, class Record>
Y paper_loop(PaperRate<Platform, Y>& rate, std::type_identity_t<Y> y, double D, Record&& record) {
    Y k1 = rate.at_start(y);  // lines' forces at the static start
    for (int step = 0; record(step, step * D, y); ++step) {
        const double t = step * D, half = (step + 0.5) * D, end = (step + 1) * D;  // no running sum
        const Y k2 = rate(1, t, y, half, y + D / 2 * k1);                          // P:3 step 1
        const Y k3 = rate(2, t, y, half, y + D / 2 * k2);                          // P:3 step 2
        const Y k4 = rate(3, t, y, end, y + D * k3);                               // P:3 step 3
        const Y y1 = rate.led(end, y + D / 6 * (k1 + 2 * k2 + 2 * k3 + k4));       // P:3 step 4 ...
        k1 = rate(4, t, y, end, y1);  // ... whose pass the lines keep: first rate of the next step
        rate.keep();
        y = y1;
    }
    return y;
}

}  // namespace hawser::master
