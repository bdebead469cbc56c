#include "user_stiffness.hpp"

#include <Eigen/LU>

#include "yaw_axes.hpp"

namespace hawser::master {

Vec6 user_stiffness_load(const Mat6& K, bool turns_with_yaw, const PlatformMotion& pose) {
    Vec6 y;
    y << pose.position, pose.angles;
    if (turns_with_yaw) {
        const double yaw = pose.angles.z();
        // Roll and pitch count on axes that turn with yaw already.
        y.head<3>() = turned_by_yaw(pose.position, -yaw);
        return turned_by_yaw(Vec6(-K * y), yaw);
    }
    Vec6 load = -K * y;
    load.tail<3>() =
        angular_velocity_matrix(pose.angles).transpose().partialPivLu().solve(Vec3(load.tail<3>()));
    return load;
}

}  // namespace hawser::master
