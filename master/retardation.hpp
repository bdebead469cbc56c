// Memory of the radiated waves, from the coefficients of a database: the retardation function and
// the added mass at infinite frequency. Cummins 1962, Ogilvie 1964. Linear, zero speed.
#pragma once

#include "hydro_data.hpp"

namespace hawser::master {

/// Retardation function of a hull about O on body axes, K:9
///
///     K(tau) = 2/pi int_0^inf B(w) cos(w tau) dw      [N.s/m/s and so on, 6 x 6]
///
/// with B straight between the data, zero at w = 0 and beyond the last frequency: then the integral
/// is exact. What the data leave out beyond their end shows as K's ringing with that frequency.
class Retardation {
 public:
    explicit Retardation(const HydroData& data);

    [[nodiscard]] Mat6 at(double tau) const;
    /// Added mass that belongs to K at frequency w: A(inf) - 1/w int_0^T K(tau) sin(w tau) dtau.
    /// @param duration  T, where K has died away [s]
    [[nodiscard]] Mat6 added_mass(const Mat6& infinite, double w, double duration) const;

 private:
    std::vector<double> frequencies_;  ///< from 0, ascending [rad/s]
    std::vector<Mat6> damping_;
};

/// A(inf) by Ogilvie's relation: the mean over the data's frequencies, each weighed by w^2, of
/// A(w) + 1/w int_0^T K(tau) sin(w tau) dtau.
Mat6 estimated_infinite_added_mass(const HydroData& data, double duration);

}  // namespace hawser::master
