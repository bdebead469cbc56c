#include "hydrostatics.hpp"

#include "yaw_axes.hpp"

namespace hawser::master {

Vec6 weight_load(double mass, double gravity, const Vec3& c) {
    const Vec3 force(0.0, 0.0, -mass * gravity);
    Vec6 load;
    load << force, c.cross(force);
    return load;
}

Vec6 hydrostatic_load(const Buoyancy& b, const PlatformMotion& m, const Mat3& R) {
    const Vec3 lift(0.0, 0.0, b.density * b.gravity * b.volume);
    const Vec3 moment = (R * b.centre).cross(lift);
    const Vec3 waterplane =
        -b.waterplane * Vec3(m.position.z(), m.angles.x(), m.angles.y());  // F_z, M_x, M_y
    Vec6 load;
    load << lift, moment;
    load[2] += waterplane[0];
    load.tail<3>() += turned_by_yaw(Vec3(waterplane[1], waterplane[2], 0.0), m.angles.z());
    return load;
}

}  // namespace hawser::master
