#include "frames.hpp"

#include <cmath>

namespace hawser {

Mat3 rotation(const Vec3& angles) {
    const double cf = std::cos(angles[0]), sf = std::sin(angles[0]);
    const double ct = std::cos(angles[1]), st = std::sin(angles[1]);
    const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
    Mat3 R;
    R << cp * ct, cp * st * sf - sp * cf, cp * st * cf + sp * sf,  //
        sp * ct, sp * st * sf + cp * cf, sp * st * cf - cp * sf,   //
        -st, ct * sf, ct * cf;
    return R;
}

Mat3 angular_velocity_matrix(const Vec3& angles) {
    const double ct = std::cos(angles[1]), st = std::sin(angles[1]);
    const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
    Mat3 E;
    E << cp * ct, -sp, 0,  //
        sp * ct, cp, 0,    //
        -st, 0, 1;
    return E;
}

Mat3 angular_velocity_matrix_rate(const Vec3& angles, const Vec3& angle_rates) {
    const double ct = std::cos(angles[1]), st = std::sin(angles[1]);
    const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
    const double t_rate = angle_rates[1], p_rate = angle_rates[2];
    Mat3 E_rate;
    E_rate << -sp * ct * p_rate - cp * st * t_rate, -cp * p_rate, 0,  //
        cp * ct * p_rate - sp * st * t_rate, -sp * p_rate, 0,         //
        -ct * t_rate, 0, 0;
    return E_rate;
}

Vec3 angular_velocity(const PlatformMotion& motion) {
    return angular_velocity_matrix(motion.angles) * motion.angle_rates;
}

PointMotion point_motion(const PlatformMotion& motion, const PlatformAcceleration& acceleration,
                         const Vec3& rho) {
    const Mat3 E = angular_velocity_matrix(motion.angles);
    const Mat3 E_rate = angular_velocity_matrix_rate(motion.angles, motion.angle_rates);
    const Vec3 l = rotation(motion.angles) * rho;
    const Vec3 w = E * motion.angle_rates;
    const Vec3 w_rate = E * acceleration.angles + E_rate * motion.angle_rates;
    return {.position = motion.position + l,
            .velocity = motion.velocity + w.cross(l),
            .acceleration = acceleration.position + w_rate.cross(l) + w.cross(w.cross(l))};
}

PointMotion point_motion(const PlatformMotion& motion, const Vec3& rho) {
    const Vec3 l = rotation(motion.angles) * rho;
    return {.position = motion.position + l,
            .velocity = motion.velocity + angular_velocity(motion).cross(l)};
}

}  // namespace hawser
