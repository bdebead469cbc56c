#include "io/rank_times.hpp"

#include <array>

namespace hawser::io {

std::vector<RankTimes> gather_times(const Link& link, const RankTimes& mine) {
    const std::array<double, 3> sent{mine.user_cpu, mine.busy, mine.waited};
    std::vector<double> all;
    std::vector<int> counts;
    if (link.rank() == 0) {
        counts.assign(static_cast<std::size_t>(link.size()), 3);
        all.resize(3 * counts.size());
    }
    link.gather(sent, counts, all);
    std::vector<RankTimes> times(counts.size());
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = {.user_cpu = all[3 * i], .busy = all[3 * i + 1], .waited = all[3 * i + 2]};
    return times;
}

ExitCode agree(const Link& link, ExitCode mine) {
    return static_cast<ExitCode>(link.greatest(static_cast<int>(mine)));
}

}  // namespace hawser::io
