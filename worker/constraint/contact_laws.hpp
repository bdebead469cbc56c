// Laws along a rod: guide (contact with a gap, R:32), slider (centralizer) and ram tensioner. A law
// knows the motion of the rod's point against its place on the platform or the earth, and the
// place's axis, nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "constraint/point_laws.hpp"

namespace hawser::worker {

inline constexpr double contact_smoothing = 0.002;  ///< d0 of steel on steel in R:33 [m]
inline constexpr double stop_stiffness = 1e8;       ///< of a tensioner's end stops [N/m]

/// Relative motion at a constraint: g = r - X and its rate seen from the place [m, m/s], the
/// place's axis k (unit), and the elastic deflection of the friction spring along k at the start of
/// the step [m].
template <class V>
struct ConstraintMotion {
    Vector<V> g, g_rate, k;
    V friction{};     ///< d_n of R:34, one-dimensional
    V slide{};        ///< motion of the rod's material along k in this step [m]
    V rubs = V(1.0);  ///< 0: no friction, in statics
};

/// R:33 for any contact: N = k pen^2/(2 d0), then k (pen - d0/2); on = (dN/dpen)/k; energy its
/// integral.
template <class V>
struct SmoothContact {
    V force, on, energy;
};
template <class V>
[[gnu::always_inline]] inline SmoothContact<V> smooth_contact(V pen, V stiffness, V d0) {
    const V on = min(max(pen / d0, V(0.0)), V(1.0));
    const V inside = min(max(pen, V(0.0)), d0), beyond = max(pen - d0, V(0.0));
    return {stiffness * (inside * inside * V(0.5) / d0 + beyond), on,
            stiffness * (inside * inside * inside / (V(6.0) * d0) +
                         beyond * (V(0.5) * d0 + V(0.5) * beyond))};
}

/// Ring around the rod with radial gap: contact across the axis, the rod slides through, R:32.
///
///     N = R:33(pen) + c on pen',   pen = |g_across| - gap;   friction: spring-slider along k,
///     limit mu N
template <class V>
struct Guide {
    V gap, stiffness, damping, friction, mobilisation, smoothing;  ///< [m, N/m, N.s/m, -, m, m]
};

/// Held across the axis, free along it: a guide without a gap, in both senses.
template <class V>
struct Slider {
    V stiffness, damping;  ///< [N/m, N.s/m]
};

/// Ram tensioner: pull F(x) along the axis, x the stroke [m], growing when the rod's top goes down
/// against the platform. Stroke limits are stiff stops.
///
///     linear  F = F0 + K x        gas  F = F0 (L/(L - x))^n        both plus C x'
template <class V>
struct Tensioner {
    V nominal, stiffness, damping;             ///< F0 [N], K [N/m] (linear), C [N.s/m]
    V exponent, column;                        ///< n, L [m] of the gas law; exponent 0: linear
    V stroke_min, stroke_max, stop_stiffness;  ///< [m, m, N/m]
};

using NoLaw = NoPointLaw;

template <class V>
using Law = std::variant<Guide<V>, Slider<V>, Tensioner<V>>;

/// What a constraint reports beside its force.
template <class V>
struct ConstraintReading {
    ConstraintLoad<V> load;
    V magnitude{};  ///< normal force of a guide, tension of a tensioner [N]
    V opening{};    ///< gap left of a guide, stroke of a tensioner [m]
    V friction{};   ///< deflection of the friction spring after the step [m]
};

template <class V>
ConstraintReading<V> load(const Guide<V>& guide, const ConstraintMotion<V>& m, V a1) {
    const Vector<V> across = m.g - dot(m.g, m.k) * m.k;
    const V distance = max(sqrt(dot(across, across)), V(1e-12));
    const Vector<V> e = (V(1.0) / distance) * across;
    const V pen = distance - guide.gap;
    const SmoothContact<V> contact = smooth_contact(pen, guide.stiffness, guide.smoothing);
    const V c_on = guide.damping * contact.on;
    const V unlimited = contact.force + c_on * dot(m.g_rate, e);
    const V pushes = select(unlimited > V(0.0), V(1.0), V(0.0));
    const V N = unlimited * pushes;

    ConstraintReading<V> out;
    out.load.force = -N * e;
    const V around = N / distance;
    out.load.stiffness = Symmetric<V>::scaled_identity(around);
    out.load.stiffness.add_outer(-around, m.k);
    out.load.stiffness.add_outer((guide.stiffness * contact.on + a1 * c_on) * pushes - around, e);
    // R:34 in one dimension: the spring follows the slide until mu N drags it along
    const V trial = m.friction + m.slide;
    const V ratio = min(V(1.0), guide.mobilisation / max(abs(trial), V(1e-12)));
    const V d = select(N > V(0.0), ratio * trial, V(0.0));
    const V rate = m.rubs * guide.friction * N / guide.mobilisation;
    out.load.force -= (rate * d) * m.k;
    out.load.stiffness.add_outer(select(ratio < V(1.0), V(0.0), rate), m.k);
    out.load.energy = contact.energy + V(0.5) * rate * d * d;
    out.magnitude = N;
    out.opening = guide.gap - distance;
    out.friction = d;
    return out;
}

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
    return out;
}

template <class V>
ConstraintReading<V> load(const Tensioner<V>& t, const ConstraintMotion<V>& m, V a1) {
    using T = LaneTraits<V>;
    const V x = -dot(m.g, m.k), x_rate = -dot(m.g_rate, m.k);
    V F = t.nominal + t.stiffness * x, K = t.stiffness;
    V energy = t.nominal * x + V(0.5) * t.stiffness * x * x;
    for (int i = 0; i < T::count; ++i) {  // gas: a power, lane by lane
        const double n = T::get(t.exponent, i);
        if (n == 0.0) continue;
        const double L = T::get(t.column, i), F0 = T::get(t.nominal, i);
        // beyond the column there is no gas left: the law ends at 95 % of it, the stop acts before
        const double q = std::min(T::get(x, i), 0.95 * L);
        const double f = F0 * std::pow(L / (L - q), n);
        T::set(F, i, f);
        T::set(K, i, n * f / (L - q));
        T::set(energy, i,
               n == 1.0 ? F0 * L * std::log(L / (L - q))
                        : F0 * L / (n - 1.0) * (std::pow(L / (L - q), n - 1.0) - 1.0));
    }
    const V d0(contact_smoothing);
    const SmoothContact<V> top = smooth_contact(x - t.stroke_max, t.stop_stiffness, d0);
    const SmoothContact<V> bottom = smooth_contact(t.stroke_min - x, t.stop_stiffness, d0);
    ConstraintReading<V> out;
    out.magnitude = F + top.force - bottom.force + t.damping * x_rate;
    out.load.force = out.magnitude * m.k;
    out.load.stiffness.add_outer(K + t.stop_stiffness * (top.on + bottom.on) + a1 * t.damping, m.k);
    out.load.energy = energy + top.energy + bottom.energy;
    out.opening = x;
    return out;
}

}  // namespace hawser::worker
