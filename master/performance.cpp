#include "performance.hpp"

#include <fmt/format.h>

namespace hawser::master {

std::vector<io::Fact> performance_facts(const std::vector<io::RankTimes>& times, double simulated,
                                        int orders) {
    const double loop = times.empty() ? 0.0 : times[0].busy + times[0].waited;  // wall clock
    double cpu = 0.0;
    for (const io::RankTimes& rank : times) cpu += rank.user_cpu;
    std::vector<io::Fact> facts = {
        {"wall_loop", "s", "wall clock of the time loop", loop},
        {"orders", "1", "orders sent to the lines", static_cast<double>(orders)}};
    if (simulated > 0.0 && loop > 0.0) {
        facts.push_back({"real_time_factor", "1", "simulated time over wall clock of the time loop",
                         simulated / loop});
        facts.push_back({"cpu_per_second", "s",
                         times.size() == 1
                             ? "user time of the time loop per simulated second"
                             : "user time of the time loop per simulated second, all ranks, "
                               "waiting included",
                         cpu / simulated});
    }
    if (times.size() > 1)
        for (std::size_t rank = 0; rank < times.size(); ++rank) {
            facts.push_back({fmt::format("busy_rank_{}", rank), "s",
                             fmt::format("rank {}: at work in the time loop", rank),
                             times[rank].busy});
            facts.push_back({fmt::format("wait_rank_{}", rank), "s",
                             fmt::format("rank {}: waiting for other ranks", rank),
                             times[rank].waited});
        }
    return facts;
}

}  // namespace hawser::master
