// Potential on the radii of a ring from the flux through them, one mode at a time, H:6.
#pragma once

#include <Eigen/Core>

#include "hydro/column_modes.hpp"

namespace hawser::hydro {

/// phi(outer), phi(inner) from dphi/dr there, times the radius and a sign that make it symmetric:
///
///     outer phi_o = oo q_o + oi q_i,   -inner phi_i = oi q_o + ii q_i       per mode [m^2]
///
/// Where the column begins at the axis or goes to infinity one face is missing and its terms are 0.
struct Radial {
    Eigen::ArrayXd oo, oi, ii;
};

/// For azimuth number m. The propagating mode of a column that goes to infinity is left at 0: see
/// CylinderFlow. A constant mode with m = 0 has the potential of the outer radius (of the inner
/// one, if ...) free: only what differs from it is in here.
Radial radial_of(const Column& column, const ColumnModes& modes, int m);

/// The same where k times the radii is large, with K'/K = -1 - 1/2x + (1/8 - m^2/2)/x^2 ...
Radial radial_far(const Column& column, const ColumnModes& modes, int m);

}  // namespace hawser::hydro
