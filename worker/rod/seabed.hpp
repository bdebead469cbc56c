// The sea floor as the rods feel it: contact R:33 along the normal of a plane that may slope, and
// friction R:34 in that plane, a spring-slider with two coefficients. No digging in, no suction.
#pragma once

#include <cmath>

#include "bed_contact.hpp"
#include "case/environment.hpp"
#include "rod/state.hpp"
#include "vector.hpp"

namespace hawser::worker {

/// A plane through (0, 0, z). Its axes: the normal, straight up the slope, level along it.
struct Bed {
    double z = 0.0;          ///< height of the bed at the origin [m]
    double stiffness = 0.0;  ///< per metre of line and metre of penetration [N/m2]
    double damping = 0.0;    ///< per metre of line [N.s/m2]
    bool slopes = false;
    Vec3 normal = Vec3::UnitZ(), uphill = Vec3::UnitX(), level = Vec3::UnitY();
    double friction_axial = 0.0, friction_lateral = 0.0;  ///< Coulomb coefficients
    double mobilisation = 0.05;                           ///< slide that mobilises them [m]

    [[nodiscard]] bool rubs() const { return friction_axial > 0.0 || friction_lateral > 0.0; }
};
Bed bed_of(const Seabed& seabed);

/// R:33  N = k pen^2/(2 d0), then k (pen - d0/2); damper through the contact fraction, never
/// pulling. z, v_z: height and speed of the centre line along the normal.
template <class V>
struct BedContact {
    V force;      ///< along the normal, on the rod [N/m]
    V stiffness;  ///< -d force/dz with a1 c included [N/m2]
};
template <class V>
[[gnu::always_inline]] inline BedContact<V> bed_contact(const Bed& bed, V z, V v_z, V D, V a1) {
    const V pen = V(bed.z) + V(0.5) * D - z;
    const V on = min(max(pen * V(1.0 / bed_smoothing), V(0.0)), V(1.0));  // (dN/dpen)/k
    const V inside = min(max(pen, V(0.0)), V(bed_smoothing));
    const V N = V(bed.stiffness) *
                (inside * inside * V(0.5 / bed_smoothing) + max(pen - V(bed_smoothing), V(0.0)));
    const V c_on = V(bed.damping) * on;
    const V total = N - c_on * v_z;
    const V pushes = select(total > V(0.0), V(1.0), V(0.0));
    return {total * pushes, (V(bed.stiffness) * on + a1 * c_on) * pushes};
}

/// Component of x along a fixed axis.
template <class V>
[[gnu::always_inline]] inline V along(const Vec3& axis, const Vector<V>& x) {
    return V(axis.x()) * x.x + V(axis.y()) * x.y + V(axis.z()) * x.z;
}

/// Height above the bed's plane, measured along its normal from z of the bed.
template <class V>
[[gnu::always_inline]] inline V height_on_bed(const Bed& bed, const Vector<V>& r) {
    if (!bed.slopes) return r.z;
    return V(bed.z) + V(bed.normal.x()) * r.x + V(bed.normal.y()) * r.y +
           V(bed.normal.z()) * (r.z - V(bed.z));
}
template <class V>
[[gnu::always_inline]] inline V speed_off_bed(const Bed& bed, const Vector<V>& v) {
    return bed.slopes ? along(bed.normal, v) : v.z;
}

/// The friction spring at a point after it slid: d* = d + Dx, and the part q that stays of it.
template <class V>
struct Slide {
    V uphill, level;  ///< d* [m]
    V length, q;      ///< |d*| [m]; q = min(1, um/|d*|): 1 sticks
};
template <class V>
[[gnu::always_inline]] inline Slide<V> slide_of(const Bed& bed, const Vector<V>& moved,
                                                const Grip<V>& before) {
    Slide<V> s;
    s.uphill = before.uphill + along(bed.uphill, moved);
    s.level = before.level + along(bed.level, moved);
    s.length = sqrt(s.uphill * s.uphill + s.level * s.level + V(1e-24));
    s.q = min(V(1.0), V(bed.mobilisation) / s.length);
    return s;
}

/// R:34  f = -(N/um)[ mu_a (d.y) y + mu_l (d - (d.y) y) ], d = q d*, y the rod's direction in the
/// plane; tangent (N q/um) W [ I - (q < 1) e e^T ] W, W = diag(sqrt mu_a, sqrt mu_l) along y and
/// across. |f| reaches mu N at |d| = um; a reversal dissipates 4 mu N (X - um) per cycle of
/// amplitude X.
template <class V>
struct BedFriction {
    Vector<V> force;         ///< on the rod [N/m]
    Symmetric<V> stiffness;  ///< [N/m2]
};
template <class V>
[[gnu::always_inline]] inline BedFriction<V> bed_friction(const Bed& bed, V N, const Vector<V>& p,
                                                          const Slide<V>& s) {
    const V p1 = along(bed.uphill, p), p2 = along(bed.level, p);
    const V inverse_p = V(1.0) / sqrt(p1 * p1 + p2 * p2 + V(1e-24));
    const V y1 = p1 * inverse_p, y2 = p2 * inverse_p;
    const V d_axial = s.uphill * y1 + s.level * y2, d_lateral = s.level * y1 - s.uphill * y2;
    const V mu_a(bed.friction_axial), mu_l(bed.friction_lateral);
    const V k = N * s.q * V(1.0 / bed.mobilisation);
    const V f_axial = k * mu_a * d_axial, f_lateral = k * mu_l * d_lateral;
    const V slips = select(s.q < V(1.0), V(1.0), V(0.0)) / (s.length * s.length);
    const V root(std::sqrt(bed.friction_axial * bed.friction_lateral));
    const V k_aa = k * mu_a * (V(1.0) - slips * d_axial * d_axial);
    const V k_ll = k * mu_l * (V(1.0) - slips * d_lateral * d_lateral);
    const V k_al = -(k * root * slips * d_axial * d_lateral);

    const auto world = [&](V a, V l) {  // from (along the rod, across it) in the plane
        const V u = a * y1 - l * y2, w = a * y2 + l * y1;
        return Vector<V>{u * V(bed.uphill.x()) + w * V(bed.level.x()),
                         u * V(bed.uphill.y()) + w * V(bed.level.y()),
                         u * V(bed.uphill.z()) + w * V(bed.level.z())};
    };
    BedFriction<V> out;
    out.force = world(-f_axial, -f_lateral);
    const Vector<V> a = world(V(1.0), V(0.0)), l = world(V(0.0), V(1.0));
    out.stiffness.add_outer(k_aa, a);
    out.stiffness.add_outer(k_ll, l);
    const Vector<V> sum = a + l;  // a l^T + l a^T = (a+l)(a+l)^T - a a^T - l l^T
    out.stiffness.add_outer(k_al, sum);
    out.stiffness.add_outer(-k_al, a);
    out.stiffness.add_outer(-k_al, l);
    return out;
}

/// What friction needs of the start of the step at one element.
template <class V>
struct GripBefore {
    const NodeState<V>*a = nullptr, *b = nullptr;
    const Grip<V>* grip = nullptr;  ///< of its Gauss points
};

}  // namespace hawser::worker
