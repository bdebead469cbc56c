// What constraints remember from step to step and report: loads, energy, impulse.
#include <algorithm>

#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

template <class V>
void RodPack<V>::settle_constraints(Mask iterating) {
    // What a lane found in its own last iteration; later ones are its neighbours'.
    const V moves(friction_on_ ? 1.0 : 0.0);  // statics know no friction and no way slid
    for (PlacedConstraint<V>& c : constraints_) {
        ConstraintState<V>& to = c.settled;
        const auto put = [&](V& x, V found) { x = select(iterating, found, x); };
        put(to.element, c.element), put(to.xi, c.xi);
        put(to.friction, moves * c.reading.friction);
        to.force = select(iterating, c.force, to.force);
        to.moment = select(iterating, c.moment, to.moment);
        to.point = select(iterating, c.point, to.point);
        put(to.magnitude, c.reading.magnitude), put(to.opening, c.reading.opening);
        put(to.slip, moves * c.motion.slide);  // in this step
        put(to.energy, c.reading.load.energy + c.joint_load.energy);
        put(to.power, moves * c.reading.power);
    }
}

template <class V>
void RodPack<V>::keep_constraints(Mask accepted, V h, const RodState<V>& before, RodState<V>& s) {
    const V half = V(0.5) * h;
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        const ConstraintState<V>& c = constraints_[n].settled;
        const ConstraintState<V> was = before.constraints()[n];
        ConstraintState<V>& to = s.constraints()[n];
        const auto put = [&](V& x, V found) { x = select(accepted, found, x); };
        const auto put3 = [&](Vector<V>& x, const Vector<V>& found) {
            x = select(accepted, found, x);
        };
        // sums over the steps by the trapezoidal rule
        put(to.dissipated, was.dissipated + half * (was.power + c.power));
        put3(to.impulse, was.impulse + half * (was.force + c.force));
        put(to.impulse_size, was.impulse_size + half * (sqrt(dot(was.force, was.force)) +
                                                        sqrt(dot(c.force, c.force))));
        put(to.slip, was.slip + c.slip);
        put(to.element, c.element), put(to.xi, c.xi), put(to.friction, c.friction);
        put3(to.force, c.force), put3(to.moment, c.moment), put3(to.point, c.point);
        put(to.magnitude, c.magnitude), put(to.opening, c.opening);
        put(to.energy, c.energy), put(to.power, c.power);
        if (friction_on_) continue;
        // a static solution: R:40 counts from here, and this is what the first rate takes
        put3(to.hull_force, c.force);
        put3(to.impulse, Vector<V>{}), put3(to.hull_impulse, Vector<V>{});
        put(to.impulse_size, V(0.0));
    }
}

template <class V>
auto RodPack<V>::static_joint_axes() const -> Mask {
    Mask out = LaneTraits<V>::none();
    for (const PlacedConstraint<V>& c : constraints_) out = out | c.axis_is_static;
    return out;
}

template <class V>
void RodPack<V>::take_joint_axes(RodState<V>& s) {
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        const PlacedConstraint<V>& c = constraints_[n];
        Vector<V>& axis = s.constraints()[n].axis;
        axis = select(c.axis_is_static, (V(1.0) / sqrt(dot(c.slope, c.slope))) * c.slope, axis);
    }
}

template <class V>
template <class Combine>
void RodPack<V>::for_points_of(int c, Combine&& combine) const {
    for (std::size_t n = 0; n < constraints_.size(); ++n)
        if (constraints_[n].declared == c) combine(working_.constraints()[n]);
}

template <class V>
Vec3 RodPack<V>::constraint_force(int lane, int c) const {
    Vec3 sum = Vec3::Zero();
    for_points_of(c, [&](const ConstraintState<V>& s) { sum += lane_vector(s.force, lane); });
    return sum;
}
template <class V>
Vec3 RodPack<V>::constraint_point(int lane, int c) const {
    Vec3 first = Vec3::Zero();
    bool found = false;
    for_points_of(c, [&](const ConstraintState<V>& s) {
        if (!found) first = lane_vector(s.point, lane);
        found = true;
    });
    return first;
}
template <class V>
Vec3 RodPack<V>::constraint_moment(int lane, int c) const {
    const Vec3 about = constraint_point(lane, c);
    Vec3 sum = Vec3::Zero();
    for_points_of(c, [&](const ConstraintState<V>& s) {
        sum += lane_vector(s.moment, lane) +
               (lane_vector(s.point, lane) - about).cross(lane_vector(s.force, lane));
    });
    return sum;
}
template <class V>
double RodPack<V>::constraint_magnitude(int lane, int c) const {
    double largest = 0.0;
    bool found = false;
    for_points_of(c, [&](const ConstraintState<V>& s) {
        const double x = LaneTraits<V>::get(s.magnitude, lane);
        largest = found ? std::max(largest, x) : x;
        found = true;
    });
    return largest;
}
template <class V>
double RodPack<V>::constraint_opening(int lane, int c) const {
    double least = INFINITY;
    for_points_of(c, [&](const ConstraintState<V>& s) {
        least = std::min(least, LaneTraits<V>::get(s.opening, lane));
    });
    return least;
}
template <class V>
double RodPack<V>::constraint_slip(int lane, int c) const {
    double farthest = 0.0;
    for_points_of(c, [&](const ConstraintState<V>& s) {
        const double x = LaneTraits<V>::get(s.slip, lane);
        if (std::abs(x) > std::abs(farthest)) farthest = x;
    });
    return farthest;
}
template <class V>
double RodPack<V>::constraint_energy(int lane, int c) const {
    double sum = 0.0;
    for_points_of(c,
                  [&](const ConstraintState<V>& s) { sum += LaneTraits<V>::get(s.energy, lane); });
    return sum;
}
template <class V>
double RodPack<V>::constraint_dissipated(int lane, int c) const {
    double sum = 0.0;
    for_points_of(
        c, [&](const ConstraintState<V>& s) { sum += LaneTraits<V>::get(s.dissipated, lane); });
    return sum;
}
template <class V>
double RodPack<V>::impulse_mismatch(int lane, int c) const {
    double largest = 0.0;
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        if (constraints_[n].declared != c) continue;
        // of the kept state: the hull's share of a pass that is not kept is not yet known
        const ConstraintState<V>& s = kept_.constraints()[n];
        const double size = LaneTraits<V>::get(s.impulse_size, lane);
        const Vec3 off = lane_vector(s.impulse, lane) - lane_vector(s.hull_impulse, lane);
        if (size > 0.0) largest = std::max(largest, off.norm() / size);
    }
    return largest;
}

template void RodPack<Single>::settle_constraints(Single::Mask);
template void RodPack<Single>::keep_constraints(Single::Mask, Single, const RodState<Single>&,
                                                RodState<Single>&);
template auto RodPack<Single>::static_joint_axes() const -> Single::Mask;
template void RodPack<Single>::take_joint_axes(RodState<Single>&);
template Vec3 RodPack<Single>::constraint_force(int, int) const;
template Vec3 RodPack<Single>::constraint_point(int, int) const;
template Vec3 RodPack<Single>::constraint_moment(int, int) const;
template double RodPack<Single>::constraint_magnitude(int, int) const;
template double RodPack<Single>::constraint_opening(int, int) const;
template double RodPack<Single>::constraint_slip(int, int) const;
template double RodPack<Single>::constraint_energy(int, int) const;
template double RodPack<Single>::constraint_dissipated(int, int) const;
template double RodPack<Single>::impulse_mismatch(int, int) const;
template void RodPack<Quad>::settle_constraints(Quad::Mask);
template void RodPack<Quad>::keep_constraints(Quad::Mask, Quad, const RodState<Quad>&,
                                              RodState<Quad>&);
template auto RodPack<Quad>::static_joint_axes() const -> Quad::Mask;
template void RodPack<Quad>::take_joint_axes(RodState<Quad>&);
template Vec3 RodPack<Quad>::constraint_force(int, int) const;
template Vec3 RodPack<Quad>::constraint_point(int, int) const;
template Vec3 RodPack<Quad>::constraint_moment(int, int) const;
template double RodPack<Quad>::constraint_magnitude(int, int) const;
template double RodPack<Quad>::constraint_opening(int, int) const;
template double RodPack<Quad>::constraint_slip(int, int) const;
template double RodPack<Quad>::constraint_energy(int, int) const;
template double RodPack<Quad>::constraint_dissipated(int, int) const;
template double RodPack<Quad>::impulse_mismatch(int, int) const;

}  // namespace hawser::worker
