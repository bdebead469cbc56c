// Guide: a ring around the rod with a radial gap, the rod slides through (R:32, R:34). Signs: the
// normal force pushes the rod back to the axis, friction against its slide along the axis.
#pragma once

#include "constraint/constraint_load.hpp"

namespace hawser::worker {

/// Contact across the axis k:
///
///     N = R:33(pen) + c on pen', not below 0,   pen = |g_across| - gap,   f = -N e
///     friction: R:34 along k, limit mu N
///
/// A guide without friction is a slider with a gap. Energy is that of the contact; what friction's
/// spring stores (at most mu N um/2) passes through `power`.
template <class V>
struct Guide {
    V gap, stiffness, damping, friction, mobilisation, smoothing;  ///< [m, N/m, N.s/m, -, m, m]
};

template <class V>
ConstraintReading<V> load(const Guide<V>& guide, const ConstraintMotion<V>& m, V a1) {
    const Vector<V> across = m.g - dot(m.g, m.k) * m.k;
    const V distance = max(sqrt(dot(across, across)), V(1e-12));
    const Vector<V> e = (V(1.0) / distance) * across;
    const V pen = distance - guide.gap, pen_rate = dot(m.g_rate, e);
    const SmoothContact<V> contact = smooth_contact(pen, guide.stiffness, guide.smoothing);
    const V c_on = guide.damping * contact.on;
    const V unlimited = contact.force + c_on * pen_rate;
    const V pushes = select(unlimited > V(0.0), V(1.0), V(0.0));
    const V N = unlimited * pushes;

    ConstraintReading<V> out;
    out.load.force = -N * e;
    const V around = N / distance;
    out.load.stiffness = Symmetric<V>::scaled_identity(around);
    out.load.stiffness.add_outer(-around, m.k);
    out.load.stiffness.add_outer((guide.stiffness * contact.on + a1 * c_on) * pushes - around, e);
    out.load.energy = contact.energy;

    const Friction<V> rub =
        friction_of(m.friction, m.slide, m.rubs * guide.friction * N, guide.mobilisation);
    out.load.force -= rub.force * m.k;
    out.load.stiffness.add_outer(rub.stiffness, m.k);
    out.friction = select(N > V(0.0), rub.deflection, V(0.0));
    out.power = (N - contact.force) * pen_rate + rub.force * dot(m.g_rate, m.k);
    out.magnitude = N;
    out.opening = -pen;
    return out;
}

/// R:49  stiffness for small motion, where a gap counts as closed whatever it is at rest: full
/// across the axis k, none along it.
template <class V>
Symmetric<V> closed_stiffness(const Guide<V>& guide, const Vector<V>& k) {
    Symmetric<V> out = Symmetric<V>::scaled_identity(guide.stiffness);
    out.add_outer(V(0.0) - guide.stiffness, k);
    return out;
}

}  // namespace hawser::worker
