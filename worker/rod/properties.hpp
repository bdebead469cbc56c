// What one element of a rod is made of, per unit unstretched length, for all lanes of a pack.
// Coefficients as they appear in R:4, R:9 and R:16.
#pragma once

#include "case/case.hpp"
#include "line_mesh.hpp"

namespace hawser::worker {

template <class V>
struct ElementProperties {
    V L;                   ///< unstretched length [m]
    V B, Db;               ///< bending stiffness [N.m2], bending damping [N.m2.s]
    V m;                   ///< mass with contents [kg/m]
    V weight;              ///< m g [N/m]
    V rhoA, buoyancy;      ///< displaced mass [kg/m], its weight [N/m]
    V ma, ma_less_mt;      ///< normal added mass, normal less axial [kg/m]
    V cn, ct;              ///< drag factors 1/2 rho C D [N/(m/s)2 per m]
    V D;                   ///< outer diameter: contact, immersion [m]
    V K_damper, c_damper;  ///< Kelvin-Voigt element of the structural damping: EA [N], c [N.s]
    V K_creep, c_creep;    ///< of the two-modulus rope [N], [N.s]; without creep K is huge, c zero
};

/// Retardation time of the dual-stiffness rope: no creep in any run [s], R:39.
inline constexpr double no_creep = 1e20;

/// The line type at a fraction 0 ... 1 of a section's length. Of a taper every property per length,
/// every coefficient and diameter runs linearly; laws (tension table, model) are those of `type`.
/// EA of a tension table is its mean slope.
LineType line_type_at(const Case& input, const Section& section, double fraction);

/// Scalar properties of element `e` (counted from end A) of a line, taken at its middle: of a
/// taper right to second order in the element's length.
/// @param axial_frequency_integral  int_0^L sqrt(m/EA) ds of the whole line [s], for R:5
ElementProperties<double> element_properties(const Case& input, const Line& line,
                                             const LineMesh& mesh, int e,
                                             double axial_frequency_integral);

/// int_0^L sqrt(m/EA) ds: the travel time of an axial wave [s], R:5.
double axial_travel_time(const Case& input, const Line& line);

}  // namespace hawser::worker
