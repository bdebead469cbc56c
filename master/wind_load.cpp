#include "wind_load.hpp"

#include <cmath>

namespace hawser::master {

WindLoad::WindLoad(const std::optional<Wind>& wind, const std::optional<WindArea>& area,
                   double ramp) {
    if (!wind || !area) return;
    field_.emplace(*wind, ramp, area->centre_height);
    factor_ = 0.5 * wind->density * area->Cs * area->area;
    direction_ = {std::cos(wind->heading), std::sin(wind->heading), 0.0};
    centre_ = {0.0, 0.0, area->centre_height};
}

Vec6 WindLoad::load_of(const Vec3& u, const Vec3& arm) const {
    const Vec3 force = factor_ * u.norm() * u;
    Vec6 load;
    load << force, arm.cross(force);
    return load;
}

Vec6 WindLoad::load(double t, const PlatformMotion& m, const Mat3& R, const Vec3& w) const {
    if (!field_) return Vec6::Zero();
    const Vec3 arm = R * centre_;
    Vec3 relative = field_->speed(t) * direction_ - m.velocity - w.cross(arm);
    relative.z() = 0.0;
    return load_of(relative, arm);
}

Vec6 WindLoad::mean_load(const Mat3& R) const {
    if (!field_) return Vec6::Zero();
    return load_of(field_->mean_speed() * direction_, R * centre_);
}

}  // namespace hawser::master
