// Laws that act on the slope of a rod's end: flex joint R:31 and clamp. A law knows the slope d =
// dr/ds and the joint's axis k (unit) only; where it sits is the placement's business.
#pragma once

#include <cmath>
#include <variant>

#include "rod/vector3.hpp"

namespace hawser::worker {

/// What a law gives back: force conjugate to the slope [N.m], its stiffness, and stored energy
/// [N.m].
template <class V>
struct ConstraintLoad {
    Vector<V> force;         ///< on the slope: minus the gradient of energy
    Symmetric<V> stiffness;  ///< -d force/d slope, positive semidefinite
    V energy{};
};

/// Elastic joint with moment M = stiffness theta, theta the angle between axis and tangent, R:31.
template <class V>
struct FlexJoint {
    V stiffness;  ///< [N.m/rad]
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

/// R:31  energy = 1/2 kt theta^2; force on the slope = -M n/|d|, n = (t cos theta - k)/sin theta.
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

    ConstraintLoad<V> out;
    out.force = (joint.stiffness * over_sine / length) * (k - cosine * t);
    const V scale = joint.stiffness / (length * length);
    out.stiffness = Symmetric<V>::scaled_identity(scale * over_tangent);
    out.stiffness.add_outer(-scale * over_tangent, t);
    const Vector<V> n = (V(1.0) / max(sine, V(1e-12))) * (cosine * t - k);
    out.stiffness.add_outer(scale * (V(1.0) - over_tangent), n);
    const V theta = over_sine * sine;
    out.energy = V(0.5) * joint.stiffness * theta * theta;
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
