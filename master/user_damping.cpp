#include "user_damping.hpp"

#include "yaw_axes.hpp"

namespace hawser::master {

Vec6 user_damping_load(const Mat6& linear, const Mat6& quadratic, const PlatformMotion& m,
                       const Vec3& w) {
    Vec6 world;
    world << m.velocity, w;
    const double yaw = m.angles.z();
    const Vec6 v = turned_by_yaw(world, -yaw);
    const Vec6 load = -linear * v - quadratic * v.cwiseAbs().cwiseProduct(v);
    return turned_by_yaw(load, yaw);
}

}  // namespace hawser::master
