// Where rank 0's time in the time loop goes.
#pragma once

#include "clocks.hpp"
#include "io/rank_times.hpp"

namespace hawser::master {

class LoopClock {
 public:
    /// @param waited  what had been waited for other ranks when the loop began [s]
    void start(double waited) {
        wall_ = wall_seconds();
        cpu_ = user_cpu_seconds();
        waited_ = waited;
        running_ = true;
    }
    /// So far; zero if the loop never began.
    [[nodiscard]] io::RankTimes times(double waited) const {
        if (!running_) return {};
        const double wait = waited - waited_;
        return {.user_cpu = user_cpu_seconds() - cpu_,
                .busy = wall_seconds() - wall_ - wait,
                .waited = wait};
    }

 private:
    double wall_ = 0.0, cpu_ = 0.0, waited_ = 0.0;
    bool running_ = false;
};

}  // namespace hawser::master
