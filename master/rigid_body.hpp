// The platform as a rigid body whose reference point O is not its centre of gravity: K:4.
#pragma once

#include "frames.hpp"

namespace hawser::master {

struct RigidBody {
    double mass = 0.0;                      ///< m [kg]
    Vec3 centre_of_gravity = Vec3::Zero();  ///< r_G on body axes, from O [m]
    Mat3 inertia = Mat3::Zero();            ///< I_G about the centre of gravity, body axes [kg.m2]
};

/// c = R r_G and I_O = R [I_G + m (r_G.r_G 1 - r_G r_G^T)] R^T at one attitude, world axes.
struct TurnedBody {
    double mass = 0.0;
    Vec3 c = Vec3::Zero();        ///< [m]
    Mat3 inertia = Mat3::Zero();  ///< about O [kg.m2]
};
TurnedBody turned(const RigidBody& body, const Mat3& R);

/// K:4  Mass matrix for (x_O'', w'):  | m 1  -m [c] ;  m [c]  I_O |
Mat6 mass_matrix(const TurnedBody& body);

/// K:4  What the right-hand side loses to rotation:  ( m w x (w x c),  w x (I_O w) )  [N, N.m]
Vec6 gyroscopic_load(const TurnedBody& body, const Vec3& w);

/// Linear momentum m (v + w x c) [kg.m/s] and angular momentum about O, m c x v + I_O w [kg.m2/s].
Vec6 momentum(const TurnedBody& body, const Vec3& velocity, const Vec3& w);

/// What the angular momentum about the moving O loses by O's own motion: dL_O/dt = M_O - v x p.
/// Linear part zero; moment part v x m (w x c) [N.m].
Vec6 momentum_transport(const TurnedBody& body, const Vec3& velocity, const Vec3& w);

}  // namespace hawser::master
