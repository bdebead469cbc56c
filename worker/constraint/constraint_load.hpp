// What every law along a rod is told and what it gives back. World axes, SI; forces are those ON
// the rod.
#pragma once

#include <span>

#include "rod/vector3.hpp"

namespace hawser::worker {

/// What a law gives back: the force conjugate to what it holds (a position: N; a slope: N.m), its
/// stiffness and the energy it stores [J].
template <class V>
struct ConstraintLoad {
    Vector<V> force;         ///< minus the gradient of energy, and dampers and friction
    Symmetric<V> stiffness;  ///< -d force/d position (or slope), never negative
    V energy{};
};

template <class M, class V>
ConstraintLoad<V> select(M m, const ConstraintLoad<V>& a, const ConstraintLoad<V>& b) {
    return {select(m, a.force, b.force), select(m, a.stiffness, b.stiffness),
            select(m, a.energy, b.energy)};
}

/// The rod's point r against a place X with axis k that moves with the platform or stands on the
/// earth: g = r - X, and the point's velocity less that of the platform's own point there.
template <class V>
struct ConstraintMotion {
    Vector<V> g, g_rate, k;  ///< [m, m/s, unit]
    V friction{};            ///< deflection d_n of the friction spring before the step, R:34 [m]
    V slide{};               ///< motion of the rod's material along k in this step [m]
    V stroke_before{};       ///< of a tensioner before the step [m]
    V rubs = V(1.0);         ///< 0: no friction, in statics
    std::span<const Vector<V>> cylinders = {};  ///< points of a tensioner's cylinders less X [m]
};

/// What a constraint reports beside its force.
template <class V>
struct ConstraintReading {
    ConstraintLoad<V> load;
    V magnitude{};  ///< normal force of a guide, force of a slider or joint, tension of a tensioner
                    ///< [N]
    V opening{};    ///< gap left of a guide, distance held open by a slider or joint, stroke of a
                    ///< tensioner [m]
    V friction{};   ///< deflection of the friction spring after the step [m]
    V power{};      ///< taken by dampers and friction [W]; gives back what its spring had stored
};

/// R:34 in one dimension: the spring follows the motion until the limit drags its place along.
template <class V>
struct Friction {
    V deflection;  ///< after the step [m]
    V force;       ///< resisting, along the positive direction [N]
    V stiffness;   ///< d force/d motion: 0 while it slides [N/m]
};
/// @param limit         mu N or the friction force [N]
/// @param mobilisation  deflection um at which it is reached [m]
template <class V>
[[gnu::always_inline]] inline Friction<V> friction_of(V before, V motion, V limit, V mobilisation) {
    const V trial = before + motion;
    const V ratio = min(V(1.0), mobilisation / max(abs(trial), V(1e-12)));
    const V rate = limit / mobilisation;
    return {ratio * trial, rate * ratio * trial, select(ratio < V(1.0), V(0.0), rate)};
}

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
inline constexpr double contact_smoothing = 0.002;  ///< d0 of steel on steel in R:33 [m]

}  // namespace hawser::worker
