#include "member_loads.hpp"

#include <cmath>

#include "point_load.hpp"

namespace hawser::master {

namespace {
constexpr double longest_strip = 2.5;  // [m]: a wave of 15 m (2 rad/s) decays by e over this depth

// Drag of one strip: across and along the axis t. @param area  wet drag width x length
Vec3 strip_drag(const Member& m, double half_density, double area, const Vec3& t, const Vec3& u) {
    const double along = u.dot(t);
    const Vec3 across = u - along * t;
    return half_density * area *
           (m.Cd * across.norm() * across + m.axial_Cd * std::abs(along) * along * t);
}

bool displaces(const Member& m) {
    return m.displaced_area > 0.0 || m.displaced_area_to.value_or(0.0) > 0.0;
}

// Centre of the wet volume from O. @param axis  world axes
Vec3 volume_centre(const Vec3& middle, const Vec3& axis, const Wetting& wet) {
    Vec3 r = middle + wet.along * axis;
    const Vec3 upwards = Vec3::UnitZ() - axis.z() * axis;
    const double sine = upwards.norm();
    if (wet.up != 0.0 && sine > 0.0) r += wet.up / sine * upwards;
    return r;
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
        const auto face = [&](const Vec3& place, double diameter, double area, double Cd,
                              double Ca) {
            if (Cd <= 0.0 && Ca <= 0.0) return;
            const double r = displaces(m) ? std::sqrt(area / M_PI) : 0.5 * diameter;
            faces_.push_back({.place = place,
                              .axis = axis,
                              .drag = 0.5 * density_ * Cd * M_PI / 4 * diameter * diameter,
                              .added_mass = density_ * Ca * 2.0 / 3.0 * M_PI * r * r * r,
                              .member = i});
        };
        face(m.from, m.diameter, m.displaced_area, m.end_Cd_from, m.end_Ca_from);
        face(m.to, m.diameter_to.value_or(m.diameter),
             m.displaced_area_to.value_or(m.displaced_area), m.end_Cd_to, m.end_Ca_to);
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
        if (wet.length <= 0.0) continue;
        const Vec3 middle = R * strip.middle;
        const Vec3 r = middle + wet.shift * axis;  // from O to the middle of the wet part
        if (!wet.whole) {
            block_.place(i, motion.position + r);
            block_.sample_one(sea, t, i);
        }
        const Vec3 v = motion.velocity + w.cross(r);
        const Vec3 u = water_velocity(i, m, sea, current_factor, false);
        add_point_load_to(sum.rest, r, strip_drag(m, 0.5 * density_, wet.drag_area, axis, u - v));
        if (!displaces(m)) continue;
        const double water_mass = density_ * wet.volume;
        if (!m.flooded)
            add_point_load_to(sum.buoyancy, volume_centre(middle, axis, wet),
                              Vec3(0, 0, gravity_ * water_mass));
        if (!m.inertia) continue;
        const Vec3 c = middle + wet.along * axis;
        const Mat3 along = axis * axis.transpose(), across = Mat3::Identity() - along;
        const Mat3 Ca = m.Ca * across + m.axial_Ca * along;
        const Mat3 moved = m.flooded ? Mat3(Ca + Mat3::Identity()) : Ca;  // with the hull
        const Vec3 a = block_.acceleration(i);
        Vec3 force = water_mass * (a + Ca * a - moved * w.cross(w.cross(c)));
        add_point_mass_to(sum.added_mass, c, water_mass, moved);
        if (!wet.whole) {
            const double rate = density_ * wet.waterplane * (block_.uz[i] - v.z());
            force += rate * (Ca * (block_.velocity(i) - v));
        }
        add_point_load_to(sum.rest, c, force);
    }
    for (std::size_t k = 0; k < faces_.size(); ++k) {
        const std::size_t i = strips_.size() + k;
        if (block_.z[i] >= block_.eta[i]) continue;
        const Face& face = faces_[k];
        const Vec3 r = R * face.place, axis = R * face.axis;
        const Vec3 u = water_velocity(i, members_[face.member], sea, current_factor, false);
        const double along = (u - motion.velocity - w.cross(r)).dot(axis);
        const double inertia =
            face.added_mass * (block_.acceleration(i) - w.cross(w.cross(r))).dot(axis);
        add_point_load_to(sum.rest, r, (face.drag * std::abs(along) * along + inertia) * axis);
        if (face.added_mass > 0.0)
            add_point_mass_to(sum.added_mass, r, face.added_mass, axis * axis.transpose());
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
    if (!sea.has_current() && !with_buoyancy) return;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        const Strip& strip = strips_[i];
        const Member& m = members_[strip.member];
        if (!m.current && !with_buoyancy) continue;
        const Vec3 axis = R * strip.axis;
        const Vec3 middle = R * strip.middle;
        const Wetting wet = wetting(strip, axis.z(), pose.position.z() + middle.z(), 0.0);
        if (wet.length <= 0.0) continue;
        const Vec3 r = middle + wet.shift * axis;
        block_.place(i, pose.position + r);
        const Vec3 u = water_velocity(i, m, sea, current_factor, true);
        add_point_load_to(sum.current, r, strip_drag(m, 0.5 * density_, wet.drag_area, axis, u));
        if (with_buoyancy && displaces(m) && !m.flooded)
            add_point_load_to(sum.buoyancy, volume_centre(middle, axis, wet),
                              Vec3(0, 0, gravity_ * density_ * wet.volume));
    }
    for (std::size_t k = 0; k < faces_.size(); ++k) {
        const std::size_t i = strips_.size() + k;
        const Face& face = faces_[k];
        const Vec3 r = R * face.place, axis = R * face.axis;
        block_.place(i, pose.position + r);
        if (block_.z[i] >= 0.0) continue;
        const double along =
            water_velocity(i, members_[face.member], sea, current_factor, true).dot(axis);
        add_point_load_to(sum.current, r, face.drag * std::abs(along) * along * axis);
    }
}

double MemberLoads::design_volume() const {
    double volume = 0.0;
    for (const Strip& s : strips_)
        if (displaces(members_[s.member]) && !members_[s.member].flooded)
            volume += wetting(s, s.axis.z(), s.middle.z(), 0.0).volume;
    return volume;
}

}  // namespace hawser::master
