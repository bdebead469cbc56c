// The sum over Airy components: elevation and particle kinematics at one point. The hottest code of
// the environment: components side by side in lanes, sine and cosine shared by both passes.
// Source: Airy theory (DNV-RP-C205 3.2), stretching (the same,
// 3.3.3; Wheeler 1970), depth filter P:6. Flat bottom.
#pragma once

#include <vector>

#include "environment/wave_components.hpp"
#include "lanes.hpp"

namespace hawser {

/// Particle velocity [m/s], local acceleration [m/s2] and the elevation above the point [m].
struct WaveSample {
    double ux = 0.0, uy = 0.0, uz = 0.0;
    double ax = 0.0, ay = 0.0, az = 0.0;
    double eta = 0.0;
};

/// Airy components over a flat bottom at depth h. With theta = w t - k (x cos b + y sin b) + phase:
///
///     eta = sum A cos theta
///     u_h = sum A w cosh k(z'+h)/sinh kh cos theta (cos b, sin b)      a_h = du_h/dt, z' fixed
///     u_z = -sum A w sinh k(z'+h)/sinh kh sin theta                    a_z = du_z/dt, z' fixed
///
/// Stretching:
/// * none: z' = z; the water ends at mean sea level, above it the values there hold.
/// * vertical: z' = z; above mean sea level the values there hold, up to the surface.
/// * wheeler: z' = (z - eta) h/(h + eta), the same for every component.
/// * extrapolation: z' = z; above mean sea level the profile goes on along its tangent,
///   u(z) = u(0) + z du/dz(0), up to the surface, above which the surface's value holds. The
///   tangent grows with k: high frequencies under a high crest are overdone.
///
/// z' is kept within [-h, 0]. With a depth filter f > 0 a component is left out where -z' > f
/// wavelengths.
class WaveField {
 public:
    struct Settings {
        double depth = 0.0;         ///< h [m]
        double depth_filter = 0.0;  ///< f [wavelengths], 0: none
        Stretching stretching = Stretching::wheeler;
    };

    WaveField() = default;  ///< still water
    WaveField(std::vector<WaveComponent> components, const Settings& settings);

    /// Kinematics at one point, everything times `ramp` (also the elevation that stretches).
    /// Without stretching WaveSample::eta is 0: water then ends at mean sea level (R:18).
    [[nodiscard]] WaveSample sample(double t, double ramp, double x, double y, double z) const;
    /// Surface elevation [m].
    [[nodiscard]] double elevation(double t, double ramp, double x, double y) const;
    /// By rising frequency.
    [[nodiscard]] const std::vector<WaveComponent>& components() const { return components_; }

 private:
    using Batch = Lanes<8>;
    /// Eight components; the last block is filled up with components of zero amplitude.
    struct Block {
        Batch amplitude, omega, k, kx, ky, phase, cos_heading, sin_heading;
        Batch bottom;   ///< e^(-2 k h): weight of the wave's mirror image in the bottom
        Batch inverse;  ///< 1/(1 - e^(-2 k h))
        double k_min;   ///< smallest k of the block
    };
    std::vector<WaveComponent> components_;
    std::vector<Block> blocks_;
    Settings settings_;
};

}  // namespace hawser
