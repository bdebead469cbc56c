// A quadratic programme with unknowns that must not be negative: the forces with which inequalities
// hold an answer. Lawson and Hanson 1974, chapter 23. For hundreds of unknowns, dense.
#pragma once

#include <Eigen/Core>

namespace hawser::master {

/// Least x^T K x / 2 - d^T x over x >= 0. For the nearest y to y0 with G^T y >= h: K = G^T G,
/// d = h - G^T y0, y = y0 + G x.
///
/// @param K  n x n, symmetric, may be singular
/// @param x  n, not negative: where to start; then the answer
void solve_nonnegative(const Eigen::MatrixXd& K, const Eigen::VectorXd& d, Eigen::VectorXd& x);

}  // namespace hawser::master
