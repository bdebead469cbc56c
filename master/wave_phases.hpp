// Phases of the wave components at one place and time, shared by first-order and drift forces.
#pragma once

#include <vector>

#include "environment/sea.hpp"
#include "hydro_data.hpp"
#include "lanes.hpp"
#include "slow_motion.hpp"

namespace hawser::master {

/// The components side by side in lanes; what does not change in time is worked out once.
class WavePhases {
 public:
    WavePhases() = default;
    explicit WavePhases(const std::vector<WaveComponent>& components);

    /// a e^{i (w t - k (x cos b + y sin b) + eps)} of every component [m]: its real part is the
    /// component's elevation at (x, y), not ramped.
    ///
    /// @param out  one number for each component, in their order
    void set(double t, const WavePosition& at, std::vector<Complex>& out) const;

 private:
    using Batch = Lanes<8>;
    struct Block {
        Batch amplitude, omega, phase, kx, ky;
    };
    std::vector<Block> blocks_;  ///< the last one filled up with components of zero amplitude
};

}  // namespace hawser::master
