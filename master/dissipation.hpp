// A memory of radiation takes energy from every motion at every frequency: the damping of a fit is
// looked at, and the fit changed where it would give energy.
#pragma once

#include "memory_samples.hpp"

namespace hawser::master {

struct Dip {
    double frequency;
    Vec6 motion;  ///< eigenvector of the least damping there
};

struct Damping {
    double least = 0.0, most = 0.0;  ///< eigenvalues of Re H over all frequencies, scaled
    std::vector<Dip> dips;           ///< where it goes below zero
};

/// Distance of the frequencies at which damping is looked at [rad/s]: from there to three times the
/// last datum.
double look_spacing(const Samples& s);

/// Of the fit with these poles and coefficients.
/// @param C  2 poles x entries
Damping damping_of(const Samples& s, const std::vector<Poles>& poles, const Eigen::MatrixXd& C);

/// Changes the coefficients least, in the norm of the fit, so that no motion gains energy:
///
///     least |A C - A C_start|  with  u^T Re H(w) u >= 0
///
/// for the motion u and frequency w of every dip below zero, found one set after another.
///
/// @param A  weighted basis, its norm that of the fit
/// @param T  at_rest_at_zero: C stays in its range
void make_dissipative(const Samples& s, const std::vector<Poles>& poles, const Eigen::MatrixXd& A,
                      const Eigen::MatrixXd& T, Eigen::MatrixXd& C);

}  // namespace hawser::master
