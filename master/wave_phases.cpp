// Phases of the wave components at one place and time, eight at once.
#include "wave_phases.hpp"

#include <algorithm>
#include <cmath>

#include "vector_math.hpp"

namespace hawser::master {

WavePhases::WavePhases(const std::vector<WaveComponent>& components) {
    for (std::size_t i = 0; i < components.size(); ++i) {
        const WaveComponent& c = components[i];
        const int lane = static_cast<int>(i % Batch::size);
        if (lane == 0) blocks_.emplace_back();
        Block& block = blocks_.back();
        block.amplitude.set(lane, c.amplitude);
        block.omega.set(lane, c.omega);
        block.phase.set(lane, c.phase);
        block.kx.set(lane, c.k * std::cos(c.heading));
        block.ky.set(lane, c.k * std::sin(c.heading));
    }
}

void WavePhases::set(double t, const WavePosition& at, std::vector<Complex>& out) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Block& block = blocks_[b];
        const SinCos<Batch::size> wave = sincos(block.omega * Batch(t) + block.phase -
                                                (block.kx * Batch(at.x) + block.ky * Batch(at.y)));
        const Batch re = block.amplitude * wave.cos, im = block.amplitude * wave.sin;
        const std::size_t first = b * Batch::size;
        const std::size_t n = std::min<std::size_t>(Batch::size, out.size() - first);
        for (std::size_t i = 0; i < n; ++i)
            out[first + i] = {re[static_cast<int>(i)], im[static_cast<int>(i)]};
    }
}

}  // namespace hawser::master
