// What the fit of the radiation memory is held against: scaled entries of B + i w (A - A(inf)), and
// the functions they are fitted with. Scaling and weights are those of memory_fit.hpp.
#pragma once

#include <utility>
#include <vector>

#include "hydro_data.hpp"

namespace hawser::master {

/// A pair of poles -a +- i b [rad/s].
struct Poles {
    double a, b;
};

/// What is fitted: entries (i, j) of the upper triangle that matter, scaled, one column each.
struct Samples {
    Eigen::VectorXd frequencies, weights;
    std::vector<std::pair<int, int>> entries;
    Eigen::MatrixXcd values;  ///< frequencies x entries
    Vec6 scale;               ///< sqrt of the size of each motion's entry
    double largest = 0.0;
};

/// Throws RunError (input) if the data have fewer than eight frequencies.
/// @param D  step of the platform [s]
Samples samples_of(const HydroData& data, const Mat6& infinite_added_mass, double D);

/// The last frequency [rad/s].
double last_of(const Samples& s);

/// Columns 2 (s + a)/((s + a)^2 + b^2) and -2 b/((s + a)^2 + b^2) of each pair, at s = i w.
Eigen::MatrixXcd basis(const Eigen::VectorXd& w, const std::vector<Poles>& poles);

/// N x (N - 1): the combinations of the N basis functions that vanish at w = 0.
Eigen::MatrixXd at_rest_at_zero(const std::vector<Poles>& poles);

/// Rows times the weights of their frequencies, real parts above imaginary ones.
Eigen::MatrixXd weighted(const Samples& s, const Eigen::MatrixXcd& rows);

}  // namespace hawser::master
