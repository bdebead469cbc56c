// Kinematics of the platform: Euler angles, angular velocity, points that move with it.
// Sources K:1 to K:3 and K:5 (README.md): R = Rz(yaw) Ry(pitch) Rx(roll). Valid for |pitch| <= 80
// deg.
#pragma once

#include "vector.hpp"

namespace hawser {

/// Motion of a platform's reference point O and its Euler angles: the 12 states of P:1.
/// The rates are those of the coordinates themselves, not body rates.
struct PlatformMotion {
    Vec3 position = Vec3::Zero();     ///< x_O, world axes [m]
    Vec3 angles = Vec3::Zero();       ///< roll, pitch, yaw [rad]
    Vec3 velocity = Vec3::Zero();     ///< x_O' [m/s]
    Vec3 angle_rates = Vec3::Zero();  ///< roll', pitch', yaw' [rad/s]

    bool operator==(const PlatformMotion&) const = default;
};

/// Accelerations that go with a PlatformMotion: x_O'' [m/s2] and the second derivatives of roll,
/// pitch, yaw [rad/s2].
struct PlatformAcceleration {
    Vec3 position = Vec3::Zero();
    Vec3 angles = Vec3::Zero();
};

/// Position, velocity, acceleration of one point on world axes [m, m/s, m/s2].
struct PointMotion {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 acceleration = Vec3::Zero();
};

/// K:1  R = Rz(yaw) Ry(pitch) Rx(roll): takes body vectors to world. @param angles roll, pitch, yaw
/// [rad]
Mat3 rotation(const Vec3& angles);

/// K:2  w = E q': angular velocity on world axes from the rates of the Euler angles.
Mat3 angular_velocity_matrix(const Vec3& angles);

/// K:3  E' = dE/dt, so that w' = E q'' + E' q'.
Mat3 angular_velocity_matrix_rate(const Vec3& angles, const Vec3& angle_rates);

/// Angular velocity w = E q' [rad/s], world axes.
Vec3 angular_velocity(const PlatformMotion& motion);

/// K:5  Motion of the body point rho (body axes, from O):
///
///     P = x_O + l,  P' = x_O' + w x l,  P'' = x_O'' + w' x l + w x (w x l),   l = R rho
PointMotion point_motion(const PlatformMotion& motion, const PlatformAcceleration& acceleration,
                         const Vec3& rho);

/// Same without acceleration (left zero), for loads that need position and velocity only.
PointMotion point_motion(const PlatformMotion& motion, const Vec3& rho);

}  // namespace hawser
