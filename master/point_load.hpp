// A force or a mass at one point of the hull, carried to the reference point O.
#pragma once

#include "vector.hpp"

namespace hawser::master {

/// Force F [N] at r from O [m]: adds (F, r x F).
inline void add_point_load_to(Vec6& load, const Vec3& r, const Vec3& force) {
    load.head<3>() += force;
    load.tail<3>() += r.cross(force);
}

/// Added mass m [kg] at r that resists in the directions of the projector N: adds
///
///     m J^T N J,   J = ( 1, -[r] ):  the point's acceleration is J (x_O'', w') + w x (w x r)
inline void add_point_mass_to(Mat6& mass, const Vec3& r, double m, const Mat3& N) {
    const Mat3 mN = m * N, S = skew(r);
    const Mat3 mNS = mN * S;
    mass.block<3, 3>(0, 0) += mN;
    mass.block<3, 3>(0, 3) -= mNS;
    mass.block<3, 3>(3, 0) += S * mN;
    mass.block<3, 3>(3, 3) -= S * mNS;
}

}  // namespace hawser::master
