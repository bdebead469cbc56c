// Ram tensioner: a pull that is a function of its stroke x, by one ram on the axis or by several
// cylinders. x is 0 in the design position and grows when the rod's top goes down against the
// platform; the pull lifts the rod.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "constraint/constraint_load.hpp"
#include "constraint/piecewise_linear.hpp"

namespace hawser::worker {

inline constexpr double stop_stiffness = 1e8;  ///< of a tensioner's end stops [N/m]

/// Pull over stroke, damping C x', Coulomb friction of the rams (R:34 in x) and stroke limits that
/// are stiff stops:
///
///     linear  F = F0 + K x       gas  F = F0 (L/(L - x))^n       table  F(x) between points
///
/// One ram on the axis: x = -g.k, f = F(x) k. Cylinder i of m runs from the rod's point to P_i, a
/// height a_i > 0 above the place and b_i beside the axis; its own length l_i gives its stroke, the
/// one at which a rod on the axis would give it that length, and its energy, R:45:
///
///     x_i = sqrt(l_i^2 - b_i^2) - a_i,   E_i = (1/m) int F dx  at x_i
///     f = sum (F(x_i)/m) (dx_i/dl_i) e_i,   dx_i/dl_i = l_i/sqrt(l_i^2 - b_i^2)
///
/// On the axis the parts along it sum to F(x). The height left above the rod's point, sqrt(l_i^2 -
/// b_i^2), is not let below a tenth of b_i. Friction acts on the mean of the x_i, which is the
/// stroke reported.
template <class V>
struct Tensioner {
    V nominal{}, stiffness{}, damping{};  ///< F0 [N], K [N/m] (linear), C [N.s/m]
    V exponent{}, column{};               ///< n, L [m] of the gas law; exponent 0: linear
    V stroke_min{}, stroke_max{}, stop_stiffness{};  ///< [m, m, N/m]
    V friction_force{}, mobilisation = V(0.01);      ///< of the rams [N, m]
    /// Tension over stroke of each lane; empty: linear or gas.
    std::array<PiecewiseLinear, static_cast<std::size_t>(LaneTraits<V>::count)> table = {};
};

/// Pull at a stroke with its stops, its slope and its energy [N, N/m, J].
template <class V>
struct Pull {
    V force, slope, energy;
};
template <class V>
Pull<V> pull_at(const Tensioner<V>& t, V x) {
    using T = LaneTraits<V>;
    Pull<V> out{t.nominal + t.stiffness * x, t.stiffness,
                t.nominal * x + V(0.5) * t.stiffness * x * x};
    for (int i = 0; i < T::count; ++i) {  // a power or a table, lane by lane
        const auto set = [&](double force, double slope, double energy) {
            T::set(out.force, i, force), T::set(out.slope, i, slope), T::set(out.energy, i, energy);
        };
        const PiecewiseLinear& table = t.table[static_cast<std::size_t>(i)];
        const double n = T::get(t.exponent, i);
        if (!table.empty()) {
            const PiecewiseLinear::Value v = table.at(T::get(x, i));
            set(v.y, v.slope, v.integral);
        } else if (n != 0.0) {
            const double L = T::get(t.column, i), F0 = T::get(t.nominal, i), q = T::get(x, i);
            // At 95 % of the column there is hardly gas left: the law goes on with its slope there.
            const double inside = std::min(q, 0.95 * L), beyond = q - inside;
            const double f = F0 * std::pow(L / (L - inside), n), slope = n * f / (L - inside);
            const double energy =
                n == 1.0 ? F0 * L * std::log(L / (L - inside))
                         : F0 * L / (n - 1.0) * (std::pow(L / (L - inside), n - 1.0) - 1.0);
            set(f + slope * beyond, slope, energy + beyond * (f + 0.5 * slope * beyond));
        }
    }
    const V d0(contact_smoothing);
    const SmoothContact<V> top = smooth_contact(x - t.stroke_max, t.stop_stiffness, d0);
    const SmoothContact<V> bottom = smooth_contact(t.stroke_min - x, t.stop_stiffness, d0);
    out.force += top.force - bottom.force;
    out.slope += t.stop_stiffness * (top.on + bottom.on);
    out.energy += top.energy + bottom.energy;
    return out;
}

/// A cylinder's direction, its stroke and how that follows its length.
template <class V>
struct CylinderStroke {
    Vector<V> e;             ///< from the rod's point to the cylinder's, unit
    V length, x, x_l, x_ll;  ///< l [m], x [m], dx/dl, d2x/dl2 [1/m]
};
/// @param p  the cylinder's point less the place [m]
template <class V>
CylinderStroke<V> cylinder_stroke(const Vector<V>& p, const ConstraintMotion<V>& m) {
    const Vector<V> q = p - m.g;
    const V a = dot(p, m.k), b2 = max(dot(p, p) - a * a, V(0.0)), l2 = dot(q, q);
    const V l = max(sqrt(l2), V(1e-9));
    const V height = sqrt(max(l2 - b2, max(V(0.01) * b2, V(1e-12))));
    return {(V(1.0) / l) * q, l, height - a, l / height, -b2 / (height * height * height)};
}

template <class V>
ConstraintReading<V> load(const Tensioner<V>& t, const ConstraintMotion<V>& m, V a1) {
    ConstraintReading<V> out;
    const V limit = m.rubs * t.friction_force;
    if (m.cylinders.empty()) {
        const V x = -dot(m.g, m.k), x_rate = -dot(m.g_rate, m.k);
        const Pull<V> pull = pull_at(t, x);
        const Friction<V> rub = friction_of(m.friction, x - m.stroke_before, limit, t.mobilisation);
        out.magnitude = pull.force + t.damping * x_rate + rub.force;
        out.load.force = out.magnitude * m.k;
        out.load.stiffness.add_outer(pull.slope + a1 * t.damping + rub.stiffness, m.k);
        out.load.energy = pull.energy;
        out.friction = rub.deflection;
        out.power = (t.damping * x_rate + rub.force) * x_rate;
        out.opening = x;
        return out;
    }
    const V share(1.0 / static_cast<double>(m.cylinders.size()));
    V mean(0.0);
    Vector<V> lift;  // -d mean/d g
    for (const Vector<V>& p : m.cylinders) {
        const CylinderStroke<V> s = cylinder_stroke(p, m);
        mean += share * s.x;
        lift += (share * s.x_l) * s.e;
    }
    const Friction<V> rub = friction_of(m.friction, mean - m.stroke_before, limit, t.mobilisation);
    for (const Vector<V>& p : m.cylinders) {
        const CylinderStroke<V> s = cylinder_stroke(p, m);
        const V x_rate = -s.x_l * dot(m.g_rate, s.e);
        const Pull<V> pull = pull_at(t, s.x);
        const V F = pull.force + t.damping * x_rate + rub.force;
        out.load.force += (share * F * s.x_l) * s.e;
        // a cylinder that pushes would soften across itself: left out
        const V around = max(share * F * s.x_l / s.length, V(0.0));
        const V along = share * ((pull.slope + a1 * t.damping) * s.x_l * s.x_l + F * s.x_ll);
        out.load.stiffness.add(V(1.0), Symmetric<V>::scaled_identity(around));
        out.load.stiffness.add_outer(along - around, s.e);
        out.load.energy += share * pull.energy;
        out.magnitude += share * F;
        out.power += share * (t.damping * x_rate + rub.force) * x_rate;
    }
    out.load.stiffness.add_outer(rub.stiffness, lift);
    out.friction = rub.deflection;
    out.opening = mean;
    return out;
}

}  // namespace hawser::worker
