#include "plate_loads.hpp"

#include <cmath>

#include "point_load.hpp"

namespace hawser::master {

PlateLoads::PlateLoads(const std::vector<Plate>& plates, const Water& water)
    : plates_(plates), density_(water.density), block_(plates.size()) {}

PlateLoad PlateLoads::load(double t, const Sea& sea, double current_factor,
                           const PlatformMotion& motion, const Mat3& R, const Vec3& w) const {
    PlateLoad sum;
    if (plates_.empty()) return sum;
    for (std::size_t i = 0; i < plates_.size(); ++i)
        block_.place(i, motion.position + R * plates_[i].position);
    block_.sample(sea, t);
    for (std::size_t i = 0; i < plates_.size(); ++i) {
        if (block_.z[i] >= block_.eta[i]) continue;
        const Plate& plate = plates_[i];
        const Vec3 r = R * plate.position, n = R * plate.normal;
        const Vec3 u = block_.velocity(i) - (1.0 - current_factor) * sea.current(block_.z[i]);
        const double speed = (u - motion.velocity - w.cross(r)).dot(n);
        const double drag = 0.5 * density_ * plate.Cd * plate.area * std::abs(speed) * speed;
        const double inertia =
            plate.added_mass * (block_.acceleration(i) - w.cross(w.cross(r))).dot(n);
        add_point_load_to(sum.rest, r, (drag + inertia) * n);
        add_point_mass_to(sum.added_mass, r, plate.added_mass, n * n.transpose());
    }
    sum.current = current_load(sea, current_factor, motion, R);
    sum.rest -= sum.current;
    return sum;
}

Vec6 PlateLoads::current_load(const Sea& sea, double current_factor, const PlatformMotion& pose,
                              const Mat3& R) const {
    Vec6 sum = Vec6::Zero();
    for (const Plate& plate : plates_) {
        const Vec3 r = R * plate.position, n = R * plate.normal;
        const double z = pose.position.z() + r.z();
        if (z >= 0.0) continue;
        const double speed = current_factor * sea.current(z).dot(n);
        add_point_load_to(sum, r,
                          0.5 * density_ * plate.Cd * plate.area * std::abs(speed) * speed * n);
    }
    return sum;
}

}  // namespace hawser::master
