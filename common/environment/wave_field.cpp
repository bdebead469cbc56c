// The sum over Airy components, eight at a time.
#include "environment/wave_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "vector_math.hpp"

namespace hawser {

WaveField::WaveField(std::vector<WaveComponent> components, const Settings& settings)
    : components_(std::move(components)), settings_(settings) {
    std::sort(components_.begin(), components_.end(),
              [](const WaveComponent& a, const WaveComponent& b) { return a.k < b.k; });
    const std::size_t lanes = Batch::size;
    for (std::size_t first = 0; first < components_.size(); first += lanes) {
        Block& block = blocks_.emplace_back();
        for (std::size_t i = 0; i < lanes; ++i) {
            WaveComponent c = components_[std::min(first + i, components_.size() - 1)];
            if (first + i >= components_.size()) c.amplitude = 0.0;
            const int lane = static_cast<int>(i);
            const double bottom = std::exp(-2.0 * c.k * settings.depth);
            block.amplitude.set(lane, c.amplitude);
            block.omega.set(lane, c.omega);
            block.k.set(lane, c.k);
            block.kx.set(lane, c.k * std::cos(c.heading));
            block.ky.set(lane, c.k * std::sin(c.heading));
            block.phase.set(lane, c.phase);
            block.cos_heading.set(lane, std::cos(c.heading));
            block.sin_heading.set(lane, std::sin(c.heading));
            block.bottom.set(lane, bottom);
            block.inverse.set(lane, 1.0 / (1.0 - bottom));
        }
        block.k_min = components_[first].k;
    }
}

double WaveField::elevation(double t, double ramp, double x, double y) const {
    Batch eta;
    for (const Block& b : blocks_) {
        const Batch theta = b.phase + b.omega * Batch(t) - b.kx * Batch(x) - b.ky * Batch(y);
        eta += b.amplitude * sincos(theta).cos;
    }
    return ramp * sum(eta);
}

WaveSample WaveField::sample(double t, double ramp, double x, double y, double z) const {
    // First pass: elevation; A cos(theta) and A sin(theta) are kept for the second. A train with
    // more components than the store holds works the rest out again.
    constexpr std::size_t stored = 64;
    std::array<Batch::Raw, stored> sines, cosines;  // left unset: filled as far as needed
    const auto waves_of = [&](const Block& b) {
        const Batch theta = b.phase + b.omega * Batch(t) - b.kx * Batch(x) - b.ky * Batch(y);
        const SinCos<Batch::size> wave = sincos(theta);
        return SinCos<Batch::size>{b.amplitude * wave.sin, b.amplitude * wave.cos};
    };
    Batch elevation;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const SinCos<Batch::size> wave = waves_of(blocks_[i]);
        if (i < stored) {
            sines[i] = wave.sin.v;
            cosines[i] = wave.cos.v;
        }
        elevation += wave.cos;
    }

    const double h = settings_.depth;
    const bool wheeler = settings_.stretching == Stretching::wheeler;
    const bool follows = settings_.stretching != Stretching::none;
    const double eta = follows ? ramp * sum(elevation) : 0.0;
    const double shift = wheeler ? eta : 0.0;
    const double height = std::clamp((z - shift) * h / (h + shift), -h, 0.0);  // z'
    const double above = settings_.stretching == Stretching::extrapolation
                             ? std::clamp(z, 0.0, std::max(eta, 0.0))
                             : 0.0;

    // Second pass: the components that reach this deep. They are sorted by k, so they come first.
    const double k_max = settings_.depth_filter > 0.0 && height < 0.0
                             ? 2.0 * std::numbers::pi * settings_.depth_filter / -height
                             : std::numeric_limits<double>::infinity();
    Batch ux, uy, uz, ax, ay, az;
    for (std::size_t i = 0; i < blocks_.size() && blocks_[i].k_min <= k_max; ++i) {
        const Block& b = blocks_[i];
        const SinCos<Batch::size> wave =
            i < stored ? SinCos<Batch::size>{sines[i], cosines[i]} : waves_of(b);
        // cosh k(z'+h)/sinh kh = (e^kz' + e^-k(z'+2h))/(1 - e^-2kh), sinh likewise with minus.
        const Batch down = exp(b.k * Batch(height));
        const Batch up = b.bottom / down;
        const Batch seen = select(b.k <= Batch(k_max), b.omega * b.inverse, Batch(0.0));
        Batch horizontal = seen * (down + up), vertical = seen * (down - up);
        if (above > 0.0) {  // at z' = 0: d/dz exchanges cosh and sinh and brings k
            const Batch rise = b.k * Batch(above), flat = horizontal;
            horizontal += rise * vertical;
            vertical += rise * flat;
        }
        const Batch u = horizontal * wave.cos, w = vertical * wave.sin;
        const Batch u_dot = b.omega * horizontal * wave.sin, w_dot = b.omega * vertical * wave.cos;
        ux += u * b.cos_heading;
        uy += u * b.sin_heading;
        uz -= w;
        ax -= u_dot * b.cos_heading;
        ay -= u_dot * b.sin_heading;
        az -= w_dot;
    }
    return {.ux = ramp * sum(ux),
            .uy = ramp * sum(uy),
            .uz = ramp * sum(uz),
            .ax = ramp * sum(ax),
            .ay = ramp * sum(ay),
            .az = ramp * sum(az),
            .eta = eta};
}

}  // namespace hawser
