// Laws that act on the position of a point of a rod: the spring-damper to a point of the platform
// or the earth. A law knows the relative motion only.
#pragma once

#include <variant>

#include "constraint/slope_laws.hpp"

namespace hawser::worker {

/// Spring and dashpot along the line from the support X to the rod's point:
///
///     f = -[K (l - l0) + C l'] e,   l = |r - X|,  e = (r - X)/l
///     energy = 1/2 K (l - l0)^2
template <class V>
struct Spring {
    V stiffness, damping, length;  ///< K [N/m], C [N.s/m], l0 [m]
};

struct NoPointLaw {};

template <class V>
using PointLaw = std::variant<NoPointLaw, Spring<V>>;

/// @param g, g_rate  position and velocity of the rod's point against the support [m, m/s]
/// @param a1         d(velocity)/d(position) of the time scheme [1/s]
template <class V>
ConstraintLoad<V> load(const Spring<V>& spring, const Vector<V>& g, const Vector<V>& g_rate, V a1) {
    const V l = max(sqrt(dot(g, g)), V(1e-9));
    const Vector<V> e = (V(1.0) / l) * g;
    const V stretch = l - spring.length;
    const V pull = spring.stiffness * stretch + spring.damping * dot(g_rate, e);
    ConstraintLoad<V> out;
    out.force = -pull * e;
    const V across = max(pull, V(0.0)) / l;  // a pushing spring would soften: left out
    out.stiffness = Symmetric<V>::scaled_identity(across);
    out.stiffness.add_outer(spring.stiffness + a1 * spring.damping - across, e);
    out.energy = V(0.5) * spring.stiffness * stretch * stretch;
    return out;
}

template <class V>
ConstraintLoad<V> load(const NoPointLaw&, const Vector<V>&, const Vector<V>&, V) {
    return {};
}

}  // namespace hawser::worker
