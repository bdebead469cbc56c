#include "pose.hpp"

#include <cmath>

namespace hawser::master {

Vec3 angles_of(const Mat3& R) {
    return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
            std::atan2(R(1, 0), R(0, 0))};
}

PlatformMotion displaced(const PlatformMotion& pose, const Vec6& step) {
    PlatformMotion moved = pose;
    moved.position += step.head<3>();
    const Vec3 v = step.tail<3>();
    const double angle = v.norm();
    if (angle > 0.0) {
        const Mat3 turn = Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
        moved.angles = angles_of(turn * rotation(pose.angles));
        moved.angles.z() +=
            2.0 * M_PI * std::round((pose.angles.z() - moved.angles.z()) / (2.0 * M_PI));
    }
    return moved;
}

}  // namespace hawser::master
