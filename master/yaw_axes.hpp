// Axes that turn with the platform's yaw alone: those of waterplane terms, first-order waves, drift
// and the user's damping.
#pragma once

#include <cmath>

#include "vector.hpp"

namespace hawser::master {

/// Rz(yaw) v.
inline Vec3 turned_by_yaw(const Vec3& v, double yaw) {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
}

/// diag(Rz, Rz) v, for a force and a moment or a velocity and an angular velocity.
inline Vec6 turned_by_yaw(const Vec6& v, double yaw) {
    Vec6 r;
    r << turned_by_yaw(Vec3(v.head<3>()), yaw), turned_by_yaw(Vec3(v.tail<3>()), yaw);
    return r;
}

}  // namespace hawser::master
