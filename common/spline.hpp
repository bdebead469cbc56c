// The platform's motion between the ends of a Runge-Kutta stage: P:4, P:5.
#pragma once

#include "frames.hpp"

namespace hawser {

/// Cubic Hermite spline of the six motions over [t0, t0 + H], P:5. With dt = t - t0:
///
///     x(dt) = a0 + a1 dt + a2 dt^2 + a3 dt^3,   a0 = x(t0),  a1 = v(t0)
///     a2 =  3 [x(t0+H) - x(t0)]/H^2 - [2 v(t0) + v(t0+H)]/H
///     a3 = -2 [x(t0+H) - x(t0)]/H^3 + [v(t0) + v(t0+H)]/H^2
///
/// Exact for cubics. A pass of zero length (H = 0) holds the motion at t0.
class MotionSpline {
 public:
    MotionSpline() = default;
    MotionSpline(double t0, const PlatformMotion& from, double t1, const PlatformMotion& to);

    struct Sample {
        PlatformMotion motion;
        PlatformAcceleration acceleration;
    };
    /// Motion and acceleration at time t [s], t0 <= t <= t1.
    [[nodiscard]] Sample at(double t) const;

 private:
    double t0_ = 0.0;
    Vec6 a0_ = Vec6::Zero(), a1_ = Vec6::Zero(), a2_ = Vec6::Zero(), a3_ = Vec6::Zero();
};

}  // namespace hawser
