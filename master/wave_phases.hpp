// Phases of the wave components at one place and time, shared by first-order and drift forces.
#pragma once

#include <cmath>
#include <vector>

#include "environment/sea.hpp"
#include "hydro_data.hpp"
#include "slow_motion.hpp"

namespace hawser::master {

/// a e^{i (w t - k (x cos b + y sin b) + eps)} of every component [m]: its real part is the
/// component's elevation at (x, y).
inline void set_wave_phases(const std::vector<WaveComponent>& components, double t,
                            const WavePosition& at, std::vector<Complex>& out) {
    for (std::size_t i = 0; i < components.size(); ++i) {
        const WaveComponent& c = components[i];
        const double phase =
            c.omega * t + c.phase - c.k * (at.x * std::cos(c.heading) + at.y * std::sin(c.heading));
        out[i] = {c.amplitude * std::cos(phase), c.amplitude * std::sin(phase)};
    }
}

}  // namespace hawser::master
