// Loads per unit length at one point of a rod and their symmetric Jacobian: R:16, R:17, the free
// surface R:18, the seabed R:33. Forces are those ON the rod, entering the residual with a minus
// sign.
#pragma once

#include "rod/properties.hpp"
#include "rod/state.hpp"

namespace hawser::worker {

/// The sea floor as the rods feel it. z up.
struct Bed {
    double z = 0.0;          ///< height of the flat bed [m]
    double stiffness = 0.0;  ///< per metre of line and metre of penetration [N/m2]
    double damping = 0.0;    ///< per metre of line [N.s/m2]
};
inline constexpr double bed_smoothing = 0.025;  ///< d0 of R:33 [m]

template <class V>
struct PointMotion3 {
    Vector<V> r, v, a;
    Vector<V> p;  ///< dr/dxi of the element (any parameter of the centre line will do) [m]
};

template <class V>
struct PointLoad {
    Vector<V> f;     ///< residual per length: inertia less external loads [N/m]
    Symmetric<V> S;  ///< its Jacobian [N/m2]
};

/// R:33  N = k pen^2/(2 d0), then k (pen - d0/2); damper through the contact fraction, never
/// pulling.
template <class V>
struct BedContact {
    V force;      ///< upward on the rod [N/m]
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

/// R:18  part of the rod around the point that is in the water, 0 ... 1.
/// @param height  height of the piece of rod the point stands for [m]
template <class V>
[[gnu::always_inline]] inline V immersion(V eta, V z, V D, V height) {
    return min(max(V(0.5) + (eta - z) / (D + height), V(0.0)), V(1.0));
}

/// R:16, R:17. @param length  of the piece of rod the point stands for, L w_gauss [m]
template <class V>
[[gnu::always_inline]] inline PointLoad<V> point_load(const ElementProperties<V>& e,
                                                      const PointMotion3<V>& x,
                                                      const Water<V>& water, const Bed& bed,
                                                      V length, V a0, V a1) {
    const V n2 = dot(x.p, x.p);
    const V inverse_n2 = V(1.0) / n2;
    const V root_n2 = sqrt(n2);
    const V W = immersion(water.eta, x.r.z, e.D, length * abs(x.p.z) * root_n2 * inverse_n2);

    const Vector<V> vr = water.u - x.v;
    const V vt = dot(vr, x.p) * inverse_n2;
    const Vector<V> vn = vr - vt * x.p;
    const V speed = sqrt(dot(vn, vn) + V(1e-12));
    const V abs_vt = abs(vt);

    const Vector<V> da = x.a - water.ud;  // added mass acts on the acceleration against the water
    const V da_t = dot(da, x.p) * inverse_n2;
    const V drag_n = W * e.cn * speed, drag_t = W * e.ct * root_n2 * abs_vt;
    const V added = W * e.ma, axial = W * e.ma_less_mt;

    PointLoad<V> load;
    load.f = e.m * x.a + added * da - (W * e.rhoA) * water.ud - drag_n * vn -
             (axial * da_t + drag_t * vt) * x.p;
    const BedContact<V> contact = bed_contact(bed, x.r.z, x.v.z, e.D, a1);
    load.f.z += e.weight - W * e.buoyancy - contact.force;

    load.S = Symmetric<V>::scaled_identity(a0 * (e.m + added) + a1 * drag_n);
    load.S.add_outer((a1 * (V(2.0) * drag_t - drag_n) - a0 * axial) * inverse_n2, x.p);
    load.S.add_outer(a1 * W * e.cn / speed, vn);
    load.S.zz += contact.stiffness;
    return load;
}

}  // namespace hawser::worker
