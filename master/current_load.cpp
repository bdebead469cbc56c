#include "current_load.hpp"

namespace hawser::master {

CurrentLoad::CurrentLoad(const std::optional<CurrentCoefficients>& given, double water_density) {
    if (!given) return;
    table_ = HeadingCoefficients(given->coefficients);
    const double q = 0.5 * water_density * given->draft * given->length;
    q_ = {q, q, q * given->length};
    place_ = {0.0, 0.0, -given->depth.value_or(0.5 * given->draft)};
}

Vec6 CurrentLoad::load(const Sea& sea, double factor, const PlatformMotion& m, const Mat3& R,
                       const Vec3& w) const {
    if (table_.empty()) return Vec6::Zero();
    const Vec3 arm = R * place_;
    const Vec3 u = factor * sea.current(m.position.z() + arm.z()) - m.velocity - w.cross(arm);
    Vec6 load = table_.load(u, m.angles.z(), q_);
    load.tail<3>() += arm.cross(Vec3(load.head<3>()));
    return load;
}

}  // namespace hawser::master
