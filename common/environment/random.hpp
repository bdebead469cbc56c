// Random numbers that are the same on every machine and with every compiler: phases and random
// frequencies of waves and gusts follow from the case's seed alone.
// Source: the mixing function "splitmix64" (Steele, Lea, Flood 2014), uniform mapping of our own.
#pragma once

#include <cstdint>

namespace hawser {

/// Sequence of independent uniform numbers, fixed by its seed.
class Random {
 public:
    explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

    /// Next number, uniform in [0, 1): the upper 53 bits of the mixed counter.
    double uniform() {
        state_ += 0x9e3779b97f4a7c15u;
        return static_cast<double>(mix(state_) >> 11) * 0x1.0p-53;
    }

 private:
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }
    std::uint64_t state_;
};

}  // namespace hawser
