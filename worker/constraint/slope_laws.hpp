// Laws that act on the slope of a rod, at an end or between the ends: flex joint R:31 and clamp. A
// law knows the slope d = dr/ds and the joint's axis k (unit, both from end B to end A) only; where
// it sits is the placement's business. The force on the slope gives the rod the moment d x force
// [N.m]; what holds the joint feels the opposite one.
#pragma once

#include <array>
#include <cmath>
#include <variant>

#include "constraint/constraint_load.hpp"
#include "constraint/piecewise_linear.hpp"

namespace hawser::worker {

/// Elastic joint with a moment M(theta), theta the angle between axis and tangent, R:31: M =
/// stiffness theta, or a table that starts at (0, 0).
template <class V>
struct FlexJoint {
    V stiffness;  ///< [N.m/rad]
    /// Moment [N.m] over angle [rad] of each lane; empty: linear.
    std::array<PiecewiseLinear, static_cast<std::size_t>(LaneTraits<V>::count)> table = {};
};

/// Direction held by a stiff spring on the slope component across the axis.
template <class V>
struct Clamp {
    V stiffness;  ///< [N.m]
};

/// No constraint of the slope: ball joint or free end.
struct NoSlopeLaw {};

template <class V>
using SlopeLaw = std::variant<NoSlopeLaw, FlexJoint<V>, Clamp<V>>;

/// theta/sin(theta) and theta/tan(theta) of each lane, from sine and cosine.
template <class V>
inline void angle_ratios(V sine, V cosine, V& over_sine, V& over_tangent) {
    using T = LaneTraits<V>;
    for (int i = 0; i < T::count; ++i) {
        const double s = T::get(sine, i), c = T::get(cosine, i);
        const double theta = std::atan2(s, c);
        const bool small = theta < 1e-4;  // next terms of both series below 1e-16
        T::set(over_sine, i, small ? 1 + theta * theta / 6 : theta / s);
        T::set(over_tangent, i, small ? 1 - theta * theta / 3 : theta * c / s);
    }
}

/// Moment of a flex joint over its angle, its slope there, and energy.
template <class V>
struct JointMoment {
    V secant, slope, energy;  ///< M/theta, dM/dtheta [N.m/rad], integral of M [J]
};
template <class V>
JointMoment<V> moment_at(const FlexJoint<V>& joint, V theta) {
    using T = LaneTraits<V>;
    JointMoment<V> out{joint.stiffness, joint.stiffness, V(0.5) * joint.stiffness * theta * theta};
    for (int i = 0; i < T::count; ++i) {
        const PiecewiseLinear& table = joint.table[static_cast<std::size_t>(i)];
        if (table.empty()) continue;
        const double angle = T::get(theta, i);
        const PiecewiseLinear::Value v = table.at(angle);
        T::set(out.secant, i, angle < 1e-9 ? v.slope : v.y / angle);
        T::set(out.slope, i, v.slope);
        T::set(out.energy, i, v.integral);
    }
    return out;
}

/// R:31  energy = int M dtheta; force on the slope = -M n/|d|, n = (t cos theta - k)/sin theta.
/// The parts of the tangent along t are left out: they are indefinite.
template <class V>
ConstraintLoad<V> load(const FlexJoint<V>& joint, const Vector<V>& d, const Vector<V>& k) {
    const V length = sqrt(dot(d, d));
    const Vector<V> t = (V(1.0) / length) * d;
    const V cosine = dot(t, k);
    const Vector<V> across = cross(k, t);
    const V sine = sqrt(dot(across, across));
    V over_sine, over_tangent;
    angle_ratios(sine, cosine, over_sine, over_tangent);
    const JointMoment<V> M = moment_at(joint, over_sine * sine);

    ConstraintLoad<V> out;
    out.force = (M.secant * over_sine / length) * (k - cosine * t);
    const V scale = V(1.0) / (length * length), around = M.secant * over_tangent;
    out.stiffness = Symmetric<V>::scaled_identity(scale * around);
    out.stiffness.add_outer(-scale * around, t);
    const Vector<V> n = (V(1.0) / max(sine, V(1e-12))) * (cosine * t - k);
    out.stiffness.add_outer(scale * (M.slope - around), n);
    out.energy = M.energy;
    return out;
}

/// energy = 1/2 kt |d - (k.d) k|^2; force = -kt (I - k k^T) d. The slope along the axis is free: it
/// carries the stretch.
template <class V>
ConstraintLoad<V> load(const Clamp<V>& clamp, const Vector<V>& d, const Vector<V>& k) {
    const Vector<V> across = d - dot(d, k) * k;
    ConstraintLoad<V> out;
    out.force = (-clamp.stiffness) * across;
    out.stiffness = Symmetric<V>::scaled_identity(clamp.stiffness);
    out.stiffness.add_outer(-clamp.stiffness, k);
    out.energy = V(0.5) * clamp.stiffness * dot(across, across);
    return out;
}

template <class V>
ConstraintLoad<V> load(const NoSlopeLaw&, const Vector<V>&, const Vector<V>&) {
    return {};
}

}  // namespace hawser::worker
