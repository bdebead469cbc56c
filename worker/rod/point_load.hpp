// Loads per unit length at one point of a rod and their symmetric Jacobian: R:16, R:17, the free
// surface R:18, the seabed (seabed.hpp). Forces are those ON the rod, entering the residual with a
// minus sign.
#pragma once

#include "rod/properties.hpp"
#include "rod/seabed.hpp"
#include "rod/state.hpp"

namespace hawser::worker {

template <class V>
struct PointMotion3 {
    Vector<V> r, v, a;
    Vector<V> p;  ///< dr/dxi of the element (any parameter of the centre line will do) [m]
};

template <class V>
struct PointLoad {
    Vector<V> f;     ///< residual per length: inertia less external loads [N/m]
    Symmetric<V> S;  ///< its Jacobian [N/m2]
    V on_bed;        ///< normal force of the bed [N/m]
};

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
    const BedContact<V> contact =
        bed_contact(bed, height_on_bed(bed, x.r), speed_off_bed(bed, x.v), e.D, a1);
    load.on_bed = contact.force;
    load.f.z += e.weight - W * e.buoyancy;

    load.S = Symmetric<V>::scaled_identity(a0 * (e.m + added) + a1 * drag_n);
    load.S.add_outer((a1 * (V(2.0) * drag_t - drag_n) - a0 * axial) * inverse_n2, x.p);
    load.S.add_outer(a1 * W * e.cn / speed, vn);
    if (bed.slopes) {
        const Vector<V> n{V(bed.normal.x()), V(bed.normal.y()), V(bed.normal.z())};
        load.f -= contact.force * n;
        load.S.add_outer(contact.stiffness, n);
    } else {
        load.f.z -= contact.force;
        load.S.zz += contact.stiffness;
    }
    return load;
}

}  // namespace hawser::worker
