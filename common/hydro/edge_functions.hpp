// The radial velocity through an opening, developed in functions that have the singularity of its
// edges built in: Gegenbauer's polynomials with their weight, H:4. Porter & Evans 1995 (J. Fluid
// Mech. 306) call this the multi-term Galerkin method; it converges exponentially.
#pragma once

#include <Eigen/Core>

#include "hydro/column_modes.hpp"

namespace hawser::hydro {

/// Projections of the first functions of an opening on the modes of a column, H:5.
///
///     u_n(x) = (1 - x^2)^(nu - 1/2) C_n(x) / gamma_n,   integral u_n e^(i q x) dx = i^n
///     J_(nu+n)(q) / q^nu
///
/// with x = (z - centre) / half, nu = 1/6. An opening with one edge takes half of the even
/// functions (at infinite frequency, under the surface, of the odd ones).
/// @param odd  take the odd functions of an opening under the surface
/// @return     functions x modes [m^(1/2)]
Eigen::MatrixXd project(const Opening& opening, int functions, const ColumnModes& modes, bool odd);

}  // namespace hawser::hydro
