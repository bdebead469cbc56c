// What a run costs: wall clock and processor time of this process. POSIX.
#pragma once

namespace hawser {

/// Monotonic wall clock [s], from an arbitrary origin.
[[nodiscard]] double wall_seconds();
/// User time of this process so far [s].
[[nodiscard]] double user_cpu_seconds();

}  // namespace hawser
