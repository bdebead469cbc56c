#include "wind_load.hpp"

#include <cmath>

namespace hawser::master {

WindLoad::WindLoad(const std::optional<Wind>& wind, const std::optional<WindArea>& area,
                   double ramp) {
    if (!wind || !area) return;
    field_.emplace(*wind, ramp, area->centre_height);
    factor_ = 0.5 * wind->density * area->Cs * area->area;
    const double side = area->side_area.value_or(area->area);
    table_ = HeadingCoefficients(area->coefficients);
    q_ = 0.5 * wind->density * Vec3(area->area, side, side * area->length);
    direction_ = {std::cos(wind->heading), std::sin(wind->heading), 0.0};
    centre_ = {0.0, 0.0, area->centre_height};
}

Vec6 WindLoad::load_of(const Vec3& u, const Vec3& arm, double yaw) const {
    Vec6 load = Vec6::Zero();
    if (table_.empty())
        load.head<3>() = factor_ * u.norm() * u;
    else
        load = table_.load(u, yaw, q_);
    load.tail<3>() += arm.cross(Vec3(load.head<3>()));
    return load;
}

Vec6 WindLoad::load(double t, const PlatformMotion& m, const Mat3& R, const Vec3& w) const {
    if (!field_) return Vec6::Zero();
    const Vec3 arm = R * centre_;
    Vec3 relative = field_->speed(t) * direction_ - m.velocity - w.cross(arm);
    relative.z() = 0.0;
    return load_of(relative, arm, m.angles.z());
}

Vec6 WindLoad::mean_load(const PlatformMotion& pose, const Mat3& R) const {
    if (!field_) return Vec6::Zero();
    return load_of(field_->mean_speed() * direction_, R * centre_, pose.angles.z());
}

}  // namespace hawser::master
