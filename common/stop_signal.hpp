// Asked to stop: SIGINT, SIGTERM and SIGUSR1 are noted; the time loop looks once a step. POSIX.
#pragma once

namespace hawser {

/// From now on the signals are noted instead of ending the process. A second SIGINT or SIGTERM ends
/// it at once with exit code 7.
void watch_stop_signals();

/// The signal that asked to stop, 0 if none has.
[[nodiscard]] int stop_signal();

}  // namespace hawser
