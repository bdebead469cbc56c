#include "member_loads.hpp"

#include <cmath>

#include "point_load.hpp"

namespace hawser::master {

namespace {
constexpr double longest_strip = 2.5;  // [m]: a wave of 15 m (2 rad/s) decays by e over this depth

// Drag of one strip of wet length l: across and along the axis t.
Vec3 strip_drag(const Member& m, double half_density, double l, const Vec3& t, const Vec3& u) {
    const double along = u.dot(t);
    const Vec3 across = u - along * t;
    return half_density * m.diameter * l *
           (m.Cd * across.norm() * across + m.axial_Cd * std::abs(along) * along * t);
}
}  // namespace

MemberLoads::MemberLoads(const std::vector<Member>& members, const Water& water)
    : members_(members),
      strips_(strips_of(members, longest_strip)),
      density_(water.density),
      gravity_(water.gravity) {
    for (std::size_t i = 0; i < members.size(); ++i) {
        const Member& m = members[i];
        const Vec3 axis = (m.to - m.from).normalized();
        const double face = 0.5 * density_ * M_PI / 4 * m.diameter * m.diameter;
        if (m.end_Cd_from > 0.0) faces_.push_back({m.from, axis, face * m.end_Cd_from, i});
        if (m.end_Cd_to > 0.0) faces_.push_back({m.to, axis, face * m.end_Cd_to, i});
    }
    block_ = WaterBlock(strips_.size() + faces_.size());
}

// Velocity of the water that drags point i of the block.
Vec3 MemberLoads::water_velocity(std::size_t i, const Member& m, const Sea& sea,
                                 double current_factor, bool current_alone) const {
    const Vec3 current = sea.current(block_.z[i]);
    const Vec3 waves =
        m.waves_in_drag && !current_alone ? Vec3(block_.velocity(i) - current) : Vec3(Vec3::Zero());
    return m.current ? Vec3(waves + current_factor * current) : waves;
}

MemberLoad MemberLoads::load(double t, const Sea& sea, double current_factor,
                             const PlatformMotion& motion, const Mat3& R, const Vec3& w) const {
    MemberLoad sum;
    if (strips_.empty()) return sum;
    for (std::size_t i = 0; i < strips_.size(); ++i)
        block_.place(i, motion.position + R * strips_[i].middle);
    for (std::size_t i = 0; i < faces_.size(); ++i)
        block_.place(strips_.size() + i, motion.position + R * faces_[i].place);
    block_.sample(sea, t);

    for (std::size_t i = 0; i < strips_.size(); ++i) {
        const Strip& strip = strips_[i];
        const Member& m = members_[strip.member];
        const Vec3 axis = R * strip.axis;
        const Wetting wet = wetting(strip, axis.z(), block_.z[i], block_.eta[i]);
        if (wet.fraction <= 0.0) continue;
        const Vec3 r = R * strip.middle + wet.shift * axis;  // from O to the middle of the wet part
        if (wet.fraction < 1.0) {
            block_.place(i, motion.position + r);
            block_.sample_one(sea, t, i);
        }
        const double l = wet.fraction * strip.length;
        const Vec3 v = motion.velocity + w.cross(r);
        const Vec3 u = water_velocity(i, m, sea, current_factor, false);
        Vec3 force = strip_drag(m, 0.5 * density_, l, axis, u - v);
        const double water_mass = density_ * m.displaced_area * l;
        if (m.displaced_area > 0.0)
            add_point_load_to(sum.buoyancy, r, Vec3(0, 0, gravity_ * water_mass));
        if (m.inertia && m.displaced_area > 0.0) {
            const auto across = [&](const Vec3& x) { return Vec3(x - x.dot(axis) * axis); };
            const double added = m.Ca * water_mass;
            const Vec3 a = block_.acceleration(i);
            force += water_mass * a + added * across(a - w.cross(w.cross(r)));
            add_point_mass_to(sum.added_mass, r, added, Mat3::Identity() - axis * axis.transpose());
            if (wet.fraction < 1.0) {
                const double rate = strip.length * (block_.uz[i] - v.z()) / wet.height;
                force += density_ * m.Ca * m.displaced_area * rate * across(block_.velocity(i) - v);
            }
        }
        add_point_load_to(sum.rest, r, force);
    }
    for (std::size_t k = 0; k < faces_.size(); ++k) {
        const std::size_t i = strips_.size() + k;
        if (block_.z[i] >= block_.eta[i]) continue;
        const Face& face = faces_[k];
        const Vec3 r = R * face.place, axis = R * face.axis;
        const Vec3 u = water_velocity(i, members_[face.member], sea, current_factor, false);
        const double along = (u - motion.velocity - w.cross(r)).dot(axis);
        add_point_load_to(sum.rest, r, face.factor * std::abs(along) * along * axis);
    }
    add_current_to(sum, sea, current_factor, motion, R, false);
    sum.rest -= sum.current;
    return sum;
}

MemberLoad MemberLoads::static_load(const Sea& sea, double current_factor,
                                    const PlatformMotion& pose, const Mat3& R) const {
    MemberLoad sum;
    add_current_to(sum, sea, current_factor, pose, R, true);
    return sum;
}

// Still water, hull at rest: the current's drag and, for statics, the buoyancy.
void MemberLoads::add_current_to(MemberLoad& sum, const Sea& sea, double current_factor,
                                 const PlatformMotion& pose, const Mat3& R,
                                 bool with_buoyancy) const {
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        const Strip& strip = strips_[i];
        const Member& m = members_[strip.member];
        const Vec3 axis = R * strip.axis;
        Vec3 r = R * strip.middle;
        const Wetting wet = wetting(strip, axis.z(), pose.position.z() + r.z(), 0.0);
        if (wet.fraction <= 0.0) continue;
        r += wet.shift * axis;
        block_.place(i, pose.position + r);
        const double l = wet.fraction * strip.length;
        const Vec3 u = water_velocity(i, m, sea, current_factor, true);
        add_point_load_to(sum.current, r, strip_drag(m, 0.5 * density_, l, axis, u));
        if (with_buoyancy && m.displaced_area > 0.0)
            add_point_load_to(sum.buoyancy, r,
                              Vec3(0, 0, gravity_ * density_ * m.displaced_area * l));
    }
    for (std::size_t k = 0; k < faces_.size(); ++k) {
        const std::size_t i = strips_.size() + k;
        const Face& face = faces_[k];
        const Vec3 r = R * face.place, axis = R * face.axis;
        block_.place(i, pose.position + r);
        if (block_.z[i] >= 0.0) continue;
        const double along =
            water_velocity(i, members_[face.member], sea, current_factor, true).dot(axis);
        add_point_load_to(sum.current, r, face.factor * std::abs(along) * along * axis);
    }
}

double MemberLoads::design_volume() const {
    double volume = 0.0;
    for (const Strip& s : strips_)
        volume += members_[s.member].displaced_area * s.length *
                  wetting(s, s.axis.z(), s.middle.z(), 0.0).fraction;
    return volume;
}

}  // namespace hawser::master
