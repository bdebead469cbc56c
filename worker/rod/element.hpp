// One rod element: residual and symmetric Jacobian of its 15 coefficients, the middle multiplier
// condensed away: R:9 to R:15, R:20. All unknowns are nodal (r, r', lambda) afterwards.
#pragma once

#include <cstddef>

#include "rod/point_load.hpp"

namespace hawser::worker {

/// A node during a Newton iteration: the trial values of one step.
template <class V>
struct TrialNode {
    Vector<V> r, d, v, vd, a, ad;
};

/// The material of one element during one step, R:3: |r'| = 1 + b + s T with b and s per Gauss
/// point.
template <class V>
struct Compliance {
    V s[gauss_points];  ///< [1/N]
    V b[gauss_points];  ///< [-]
};

/// Two nodes' share of an element: rows and columns r (3), r' (3), lambda of node a, then of node
/// b.
template <class V>
struct ElementSystem {
    V aa[7][7], ab[7][7], bb[7][7];         ///< Jacobian blocks; aa and bb lower triangle
    V Ra[7], Rb[7];                         ///< residuals
    V column[14], inverse_pivot, R_middle;  ///< for the recovery of the middle multiplier, R:20
};

namespace detail {

/// Writes the 3 x 3 block c S + k I into rows i0.., columns j0.. of a 7 x 7 block.
template <class V>
[[gnu::always_inline]] inline void place(V (&block)[7][7], int i0, int j0, const Symmetric<V>& S,
                                         V c, V k) {
    const V xy = c * S.xy, xz = c * S.xz, yz = c * S.yz;
    block[i0][j0] = c * S.xx + k;
    block[i0 + 1][j0 + 1] = c * S.yy + k;
    block[i0 + 2][j0 + 2] = c * S.zz + k;
    block[i0][j0 + 1] = block[i0 + 1][j0] = xy;
    block[i0][j0 + 2] = block[i0 + 2][j0] = xz;
    block[i0 + 1][j0 + 2] = block[i0 + 2][j0 + 1] = yz;
}

template <class V>
[[gnu::always_inline]] inline void put(V* to, const Vector<V>& a) {
    to[0] = a.x, to[1] = a.y, to[2] = a.z;
}

}  // namespace detail

/// Assembles element (a, b), a towards end B. `lambda` is the multiplier at a, middle, b; `before`
/// is given where the bed's friction acts.
template <class V>
inline void assemble_element(const ElementProperties<V>& e, const TrialNode<V>& a,
                             const TrialNode<V>& b, const V (&lambda)[3],
                             const Compliance<V>& material, const Water<V>* water, const Bed& bed,
                             V a0, V a1, ElementSystem<V>& out, const GripBefore<V>& before = {}) {
    const V L = e.L, inverse_L = V(1.0) / L;
    // Scaled slopes: every shape function is a constant.
    const Vector<V> da = L * a.d, db = L * b.d;
    const Vector<V> q[3] = {b.r - a.r, da, db};  // R:8

    // Loads and inertia at the Gauss points.
    const Vector<V> vda = L * a.vd, vdb = L * b.vd, ada = L * a.ad, adb = L * b.ad;
    Vector<V> R[4];
    Symmetric<V> J[10];
    V Jll[6] = {V(0.0), V(0.0), V(0.0), V(0.0), V(0.0), V(0.0)};
    V Rl[3] = {V(0.0), V(0.0), V(0.0)};
#pragma GCC unroll 4
    for (std::size_t g = 0; g < gauss_points; ++g) {
        const V A1(shape.A[g][0]), A2(shape.A[g][1]), A3(shape.A[g][2]), A4(shape.A[g][3]);
        PointMotion3<V> x;
        x.r = A1 * a.r + A2 * da + A3 * b.r + A4 * db;  // R:7
        x.v = A1 * a.v + A2 * vda + A3 * b.v + A4 * vdb;
        x.a = A1 * a.a + A2 * ada + A3 * b.a + A4 * adb;
        x.p =
            V(shape.slope[g][0]) * q[0] + V(shape.slope[g][1]) * q[1] + V(shape.slope[g][2]) * q[2];
        const V length = V(gauss_weight[g]) * L;
        PointLoad<V> load = point_load(e, x, water[g], bed, length, a0, a1);

        if (before.grip != nullptr && any(load.on_bed > V(0.0))) {  // R:34
            const NodeState<V>&na = *before.a, &nb = *before.b;
            const Vector<V> moved =
                x.r - (A1 * na.r + A2 * (L * na.d) + A3 * nb.r + A4 * (L * nb.d));
            const BedFriction<V> friction =
                bed_friction(bed, load.on_bed, x.p, slide_of(bed, moved, before.grip[g]));
            load.f -= friction.force;
            load.S.add(V(1.0), friction.stiffness);
        }
        const Vector<V> f = length * load.f;
        R[0] += A1 * f, R[1] += A2 * f, R[2] += A3 * f, R[3] += A4 * f;
        int n = 0;
#pragma GCC unroll 4
        for (std::size_t i = 0; i < 4; ++i) {
#pragma GCC unroll 4
            for (std::size_t k = i; k < 4; ++k)
                J[n++].add(V(shape.A[g][i] * shape.A[g][k]) * length, load.S);
        }

        // R:6, R:12, R:15: material law at the point
        const V multiplier = V(shape.P[g][0]) * lambda[0] + V(shape.P[g][1]) * lambda[1] +
                             V(shape.P[g][2]) * lambda[2];
        const V strain = min(material.s[g] * multiplier, V(0.5));
        const V inverse = V(1.0) / (V(1.0) - strain);
        const V G = (V(1.0) + material.b[g]) * inverse;
        const V C = G * G * material.s[g] * inverse;
        const V half = V(0.5) * G * G * length;
        int l = 0;
#pragma GCC unroll 3
        for (std::size_t m = 0; m < 3; ++m) {
            Rl[m] -= V(shape.P[g][m]) * half;
#pragma GCC unroll 3
            for (std::size_t k = m; k < 3; ++k)
                Jll[l++] -= V(shape.P[g][m] * shape.P[g][k]) * (C * length);
        }
    }

    // R:9, R:10: tension and bending in the reduced basis
    const V bending = e.B * inverse_L * inverse_L * inverse_L;
    const V bending_rate = e.Db * inverse_L * inverse_L * inverse_L;
    const Vector<V> q_rate[3] = {b.v - a.v, vda, vdb};
    const V l0 = inverse_L * lambda[0], l1 = inverse_L * lambda[1], l2 = inverse_L * lambda[2];
    V k3[3][3];
    Vector<V> p[3], G[3][3];
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& alpha = shape.alpha[i][k];
            const V beta(shape.beta[i][k]);
            const V stiffness =
                V(alpha[0]) * l0 + V(alpha[1]) * l1 + V(alpha[2]) * l2 + beta * bending;
            const V damping = beta * bending_rate;
            p[i] += stiffness * q[k] + damping * q_rate[k];
            k3[i][k] = stiffness + a1 * damping;
#pragma GCC unroll 3
            for (std::size_t m = 0; m < 3; ++m) G[m][i] += (V(alpha[m]) * inverse_L) * q[k];
        }
    }
#pragma GCC unroll 3
    for (std::size_t m = 0; m < 3; ++m)
        Rl[m] += V(0.5) * (dot(q[0], G[m][0]) + dot(q[1], G[m][1]) + dot(q[2], G[m][2]));

    // R:11, R:13, R:14: expansion to the nodes; slope rows and columns times L
    using detail::place;
    using detail::put;
    put(out.Ra, R[0] - p[0]);
    put(out.Ra + 3, L * (R[1] + p[1]));
    put(out.Rb, R[2] + p[0]);
    put(out.Rb + 3, L * (R[3] + p[2]));
    out.Ra[6] = Rl[0];
    out.Rb[6] = Rl[2];
    const V L2 = L * L;
    place(out.aa, 0, 0, J[0], V(1.0), k3[0][0]);
    place(out.aa, 3, 0, J[1], L, -L * k3[0][1]);
    place(out.ab, 0, 0, J[2], V(1.0), -k3[0][0]);
    place(out.ab, 0, 3, J[3], L, -L * k3[0][2]);
    place(out.aa, 3, 3, J[4], L2, L2 * k3[1][1]);
    place(out.ab, 3, 0, J[5], L, L * k3[0][1]);
    place(out.ab, 3, 3, J[6], L2, L2 * k3[1][2]);
    place(out.bb, 0, 0, J[7], V(1.0), k3[0][0]);
    place(out.bb, 3, 0, J[8], L, L * k3[0][2]);
    place(out.bb, 3, 3, J[9], L2, L2 * k3[2][2]);
    const Vector<V> zero;
    V lambda_a_column_b[7];  // row lambda_a against node b, and so on
    put(&out.aa[6][0], zero - G[0][0]);
    put(&out.aa[6][3], L * G[0][1]);
    out.aa[6][6] = Jll[0];
    put(lambda_a_column_b, G[0][0]);
    put(lambda_a_column_b + 3, L * G[0][2]);
    lambda_a_column_b[6] = Jll[2];
    put(&out.bb[6][0], G[2][0]);
    put(&out.bb[6][3], L * G[2][2]);
    out.bb[6][6] = Jll[5];
    V lambda_b_row_a[6];
    put(lambda_b_row_a, zero - G[2][0]);
    put(lambda_b_row_a + 3, L * G[2][1]);
#pragma GCC unroll 7
    for (int i = 0; i < 7; ++i) out.ab[6][i] = lambda_a_column_b[i];
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i) out.ab[i][6] = lambda_b_row_a[i];

    // R:20: condensation of the middle multiplier
    V* c = out.column;
    put(c, zero - G[1][0]);
    put(c + 3, L * G[1][1]);
    c[6] = Jll[1];
    put(c + 7, G[1][0]);
    put(c + 10, L * G[1][2]);
    c[13] = Jll[4];
    out.inverse_pivot = V(1.0) / Jll[3];
    out.R_middle = Rl[1];
    const V R_scaled = Rl[1] * out.inverse_pivot;
#pragma GCC unroll 7
    for (int i = 0; i < 7; ++i) {
        const V ca = c[i] * out.inverse_pivot, cb = c[7 + i] * out.inverse_pivot;
        out.Ra[i] -= c[i] * R_scaled;
        out.Rb[i] -= c[7 + i] * R_scaled;
#pragma GCC unroll 7
        for (int k = 0; k <= i; ++k) {
            out.aa[i][k] -= ca * c[k];
            out.bb[i][k] -= cb * c[7 + k];
        }
#pragma GCC unroll 7
        for (int k = 0; k < 7; ++k) out.ab[i][k] -= ca * c[7 + k];
    }
}

}  // namespace hawser::worker
