// Slider (centralizer without a gap) and held point (ball joint along a rod): linear springs and
// dampers on the position, across the axis or in all three directions. The force draws the rod's
// point to its place.
#pragma once

#include "constraint/constraint_load.hpp"

namespace hawser::worker {

/// Held across the axis k, free along it: f = -K g_across - C g'_across.
template <class V>
struct Slider {
    V stiffness, damping;  ///< [N/m, N.s/m]
};

/// Held in all directions: f = -K g - C g'.
template <class V>
struct HeldPoint {
    V stiffness, damping;  ///< [N/m, N.s/m]
};

template <class V>
ConstraintReading<V> load(const Slider<V>& slider, const ConstraintMotion<V>& m, V a1) {
    const Vector<V> across = m.g - dot(m.g, m.k) * m.k;
    const Vector<V> rate = m.g_rate - dot(m.g_rate, m.k) * m.k;
    ConstraintReading<V> out;
    out.load.force = -slider.stiffness * across - slider.damping * rate;
    const V tangent = slider.stiffness + a1 * slider.damping;
    out.load.stiffness = Symmetric<V>::scaled_identity(tangent);
    out.load.stiffness.add_outer(-tangent, m.k);
    out.load.energy = V(0.5) * slider.stiffness * dot(across, across);
    out.magnitude = sqrt(dot(out.load.force, out.load.force));
    out.opening = sqrt(dot(across, across));
    out.power = slider.damping * dot(rate, rate);
    return out;
}

template <class V>
ConstraintReading<V> load(const HeldPoint<V>& held, const ConstraintMotion<V>& m, V a1) {
    ConstraintReading<V> out;
    out.load.force = -held.stiffness * m.g - held.damping * m.g_rate;
    out.load.stiffness = Symmetric<V>::scaled_identity(held.stiffness + a1 * held.damping);
    out.load.energy = V(0.5) * held.stiffness * dot(m.g, m.g);
    out.magnitude = sqrt(dot(out.load.force, out.load.force));
    out.opening = sqrt(dot(m.g, m.g));
    out.power = held.damping * dot(m.g_rate, m.g_rate);
    return out;
}

}  // namespace hawser::worker
