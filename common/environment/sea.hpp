// The sea as the hull and the rods feel it: waves and current at blocks of points.
// Source: case keys `environment.waves` and `environment.current`; P:6 (depth filter); the ramp
// rule beside K:8. Waves and current do not change each other.
#pragma once

#include <vector>

#include "case/environment.hpp"
#include "environment/current.hpp"
#include "environment/ramp.hpp"
#include "environment/wave_field.hpp"
#include "vector.hpp"

namespace hawser {

/// Where Sea::sample puts its results, n numbers each. Velocity of waves and current together
/// [m/s], local acceleration of the waves [m/s2], height at which the water ends above the point
/// [m]: the elevation of the instant, 0 without stretching (R:18).
struct WaterKinematics {
    double *ux, *uy, *uz;
    double *ax, *ay, *az;
    double* eta;
};

/// Gradient of the dynamic pressure [Pa/m] from the local particle acceleration a [m/s2]:
///
///     grad p = -rho a
///
/// taken with the acceleration at the stretched height, not as the derivative of the stretched
/// pressure. The Froude-Krylov force per volume is minus this.
inline Vec3 dynamic_pressure_gradient(double density, const Vec3& acceleration) {
    return -density * acceleration;
}

/// Waves and current of a case.
class Sea {
 public:
    /// @param ramp          length of the ramp of the waves [s]
    /// @param depth_filter  wavelengths down to which a component is seen; 0: all the way
    /// @param ramp_current  for a current that the static start leaves out: it is ramped like waves
    Sea(const Environment& environment, double ramp, double depth_filter,
        bool ramp_current = false);

    /// Water at n points x, y, z [m] at time t [s]: waves times ramp_factor(t), current in full (or
    /// ramped). A point's bits do not depend on the other points of the block.
    void sample(double t, int n, const double* x, const double* y, const double* z,
                const WaterKinematics& out) const;
    /// Current alone, for statics: acceleration and eta are zero.
    void sample_current(int n, const double* x, const double* y, const double* z,
                        const WaterKinematics& out) const;
    /// What the current is multiplied by at time t: 1, or its ramp.
    [[nodiscard]] double current_factor(double t) const {
        return ramp_current_ ? ramp_factor(t, ramp_) : 1.0;
    }
    /// Surface elevation [m], ramped.
    [[nodiscard]] double elevation(double t, double x, double y) const;
    /// Surface elevation of one wave train alone [m], ramped.
    [[nodiscard]] double elevation_of_train(int train, double t, double x, double y) const;
    [[nodiscard]] int trains() const { return static_cast<int>(trains_.size()); }
    /// Current at height z above mean sea level [m/s].
    [[nodiscard]] Vec3 current(double z) const { return current_.velocity(z); }

    [[nodiscard]] bool has_waves() const { return !waves_.components().empty(); }
    [[nodiscard]] bool has_current() const { return !current_.empty(); }
    /// Wave components, by rising frequency, not ramped.
    [[nodiscard]] const std::vector<WaveComponent>& components() const {
        return waves_.components();
    }
    /// Lowest spectral peak of the wave trains, lowest_peak() [rad/s]; 0 in still water.
    [[nodiscard]] double peak_frequency() const { return peak_frequency_; }

 private:
    double ramp_;
    bool ramp_current_;
    double peak_frequency_ = 0.0;
    WaveField waves_;
    std::vector<WaveField> trains_;  ///< each alone
    CurrentProfile current_;
};

}  // namespace hawser
