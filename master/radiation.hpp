// Constant added mass and radiation damping that turn with the body: K:4. No memory, no velocity
// terms of a turning added mass (Munk moment), no effect of current.
#pragma once

#include "hydro_data.hpp"

namespace hawser::master {

/// A and B about O on body axes, at one frequency.
struct Radiation {
    Mat6 added_mass = Mat6::Zero();
    Mat6 damping = Mat6::Zero();
    double frequency = 0.0;  ///< where they were taken [rad/s]; 0: not from a database
};

/// A(w) and B(w), linear between the frequencies of the data (A(0) with B = 0 counts as one).
/// Throws RunError (input) where w lies outside them.
Radiation radiation_at(const HydroData& data, double frequency);

/// A_w = Q A Q^T, Q = diag(R, R): a matrix of the body turned to world axes.
Mat6 turned(const Mat6& A, const Mat3& R);

}  // namespace hawser::master
