// Wind speed in time at one height: mean and gusts. Source: case key `environment.wind`; NPD wind
// of ISO 19901-1, gust_spectra.hpp. One point speaks for the platform's whole wind area (no
// coherence over it).
#pragma once

#include <array>
#include <vector>

#include "case/environment.hpp"

namespace hawser {

/// One harmonic of the gust: amplitude [m/s] times cos(omega t + phase).
struct GustComponent {
    double amplitude = 0.0, omega = 0.0, phase = 0.0;
};

/// Wind at one height. `constant`: the given speed at every height, no gusts. `npd`: the 1 h mean
/// of the NPD profile and gusts of its spectrum, 1/600 to 0.5 Hz, as 200 components: one random
/// frequency in each of 200 bins of equal width in ln f, carrying the exact energy of its bin. So
/// the lines are 2.9 % of their frequency apart, three or four of them inside the half-power width
/// of a surge mode with 5 % of damping, and the sum does not repeat. `api`, `kaimal`: likewise from
/// 1/3600 to 1 Hz on 290 lines. `time_history`: the rows at every height, linear between, the end
/// values outside; its mean is that of its rows over their time.
class WindField {
 public:
    /// @param ramp    length of the ramp of the gusts [s]
    /// @param height  above mean sea level [m]
    WindField(const Wind& wind, double ramp, double height);

    /// Mean speed at that height [m/s].
    [[nodiscard]] double mean_speed() const { return mean_; }
    /// Mean plus ramp_factor(t) times gust [m/s].
    [[nodiscard]] double speed(double t) const;
    [[nodiscard]] const std::vector<GustComponent>& components() const { return gusts_; }

 private:
    [[nodiscard]] double history_at(double t) const;

    double ramp_, mean_;
    std::vector<GustComponent> gusts_;
    std::vector<std::array<double, 2>> history_;
};

}  // namespace hawser
