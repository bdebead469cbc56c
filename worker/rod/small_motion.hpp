// Linear undamped motion of a rod about its static solution: the finite-element tangent as sparse
// matrices, R:43.
#pragma once

#include <Eigen/SparseCore>

namespace hawser::worker {

/// J x = omega^2 M x with seven unknowns a node, r (3), r' (3), lambda, nodes from end B to end A;
/// the middle multipliers are condensed (R:20), the nodal ones are rows of constraint and have no
/// mass. Held positions are rows of the identity without mass.
struct SmallMotion {
    Eigen::SparseMatrix<double> stiffness;  ///< J, symmetric, indefinite
    Eigen::SparseMatrix<double> mass;       ///< M, with the added mass of the water
};

}  // namespace hawser::worker
