#include "spline.hpp"

namespace hawser {

namespace {

Vec6 stacked(const Vec3& upper, const Vec3& lower) {
    Vec6 both;
    both << upper, lower;
    return both;
}

}  // namespace

MotionSpline::MotionSpline(double t0, const PlatformMotion& from, double t1,
                           const PlatformMotion& to)
    : t0_(t0),
      a0_(stacked(from.position, from.angles)),
      a1_(stacked(from.velocity, from.angle_rates)) {
    const double H = t1 - t0;
    if (H <= 0.0) return;
    const Vec6 rise = stacked(to.position, to.angles) - a0_;
    const Vec6 v1 = stacked(to.velocity, to.angle_rates);
    a2_ = 3.0 / (H * H) * rise - (2.0 * a1_ + v1) / H;
    a3_ = -2.0 / (H * H * H) * rise + (a1_ + v1) / (H * H);
}

MotionSpline::Sample MotionSpline::at(double t) const {
    const double dt = t - t0_;
    const Vec6 x = a0_ + dt * (a1_ + dt * (a2_ + dt * a3_));
    const Vec6 v = a1_ + dt * (2.0 * a2_ + dt * 3.0 * a3_);
    const Vec6 a = 2.0 * a2_ + dt * 6.0 * a3_;
    return {.motion = {.position = x.head<3>(),
                       .angles = x.tail<3>(),
                       .velocity = v.head<3>(),
                       .angle_rates = v.tail<3>()},
            .acceleration = {.position = a.head<3>(), .angles = a.tail<3>()}};
}

}  // namespace hawser
