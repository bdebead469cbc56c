// The memory of radiation as a sum of damped oscillations, fitted in the frequency domain by vector
// fitting (Gustavsen and Semlyen 1999), and what the fit is worth.
#pragma once

#include <optional>
#include <vector>

#include "hydro_data.hpp"
#include "state.hpp"

namespace hawser::master {

using CMat6 = Eigen::Matrix<Complex, 6, 6>;

/// One pair of poles -a +- i b, common to all entries of the matrix.
struct Oscillator {
    double a = 0.0, b = 0.0;                           ///< decay and frequency [rad/s]
    Mat6 first = Mat6::Zero(), second = Mat6::Zero();  ///< symmetric
};

/// K:10  The transfer function from velocity to load,
///
///     H(s) = sum_p [ 2 (s + a) first - 2 b second ] / ((s + a)^2 + b^2)
///          ~ B(w) + i w (A(w) - A(inf))           at s = i w
struct MemoryFit {
    std::vector<Oscillator> oscillators;
    double rms_error = 0.0;        ///< of H over the data, part of H's own rms, weighted as fitted
    double largest_error = 0.0;    ///< of an entry, part of the largest one
    double worst_frequency = 0.0;  ///< where that is [rad/s]
    int worst_row = 0, worst_column = 0;  ///< and in which entry
    /// Least eigenvalue of the damping Re H over all frequencies, part of the largest: below zero
    /// the fit would feed energy to a motion of that frequency
    double least_damping = 0.0;

    [[nodiscard]] CMat6 at(double w) const;
};

/// Fits data about O on body axes. Entries are compared on the scale of their motions' radiation,
/// frequencies with weight 1/sqrt(1 + (w D)^8): the platform's step D does not resolve what lies
/// above 1/D, and poles stay below 2/D, where the Runge-Kutta step is stable. H(0) = 0 holds
/// exactly. A fit with negative damping anywhere is changed by the least amount that mends it.
/// Oscillators that bring nothing are left out, so a higher order never has a larger rms error.
///
/// @param D      step of the platform [s]
/// @param order  oscillators at most, and at most half the number of frequencies; empty: the fewest
///               with an rms error below 0.5 %, or if none has, within a tenth of the best
/// Throws RunError (input) if the data have fewer than eight frequencies.
MemoryFit fit_memory(const HydroData& data, const Mat6& infinite_added_mass, double D,
                     std::optional<int> order);

}  // namespace hawser::master
