// Weight and buoyancy of the hull as forces through the exact rotation, and the linear waterplane
// terms: K:6 and K:7. Members float on their own (member_loads).
#pragma once

#include "frames.hpp"

namespace hawser::master {

struct Buoyancy {
    double volume = 0.0;                ///< V of the database [m3]
    Vec3 centre = Vec3::Zero();         ///< r_B, body axes [m]
    Mat3 waterplane = Mat3::Zero();     ///< C' of K:7 for (heave, roll, pitch)
    double density = 0.0, gravity = 0;  ///< rho [kg/m3], g [m/s2]
};

/// K:6  Weight:  F = -m g z,  M_O = c x F,  c = R r_G.  [N, N.m] about O, world axes
Vec6 weight_load(double mass, double gravity, const Vec3& c);

/// K:6 and K:7  Buoyancy rho g V at b = R r_B, and the waterplane terms on axes that turn with yaw:
///
///     F_z, M_x, M_y  -=  C' (z_O, roll, pitch),   M turned to world by Rz(yaw)
///
/// O lies on the waterline at the design position, z_design = 0.
Vec6 hydrostatic_load(const Buoyancy& buoyancy, const PlatformMotion& motion, const Mat3& R);

}  // namespace hawser::master
