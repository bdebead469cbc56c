// The linear system of a pack: assembly fused with the elimination from end B to end A, then the
// back-substitution: R:20, R:23, R:24, R:26. Here J d = R and the unknowns change by -d. Between
// the two a group adds what the rods' ties carry (ties.cpp).
#include "rod/rod_pack.hpp"

namespace hawser::worker {

template <class V>
PointLoad<V> RodPack<V>::point_mass_load(const PointMass<V>& mass, const Vector<V>& r,
                                         const Vector<V>& v, const Vector<V>& a,
                                         const Water<V>& water, V a0, V a1) const {
    const V W = immersion(water.eta, r.z, mass.height, V(0.0));
    const V g(gravity_);
    const Vector<V> vr = water.u - v;
    const V speed = sqrt(dot(vr, vr) + V(1e-12));
    const V drag = W * mass.drag * speed, added = W * mass.added;
    PointLoad<V> load;
    load.f = mass.mass * a + added * (a - water.ud) - (W * mass.displaced) * water.ud - drag * vr;
    load.f.z += (mass.mass - W * mass.displaced) * g;
    load.S = Symmetric<V>::scaled_identity(a0 * (mass.mass + added) + a1 * drag);
    load.S.add_outer(a1 * W * mass.drag / speed, vr);
    // what floats has a waterplane: -dW/dz = 1/height
    const Mask pierces = (W > V(0.0)) & (W < V(1.0));
    load.S.add_outer(select(pierces, mass.displaced * g / mass.height, V(0.0)),
                     {V(0.0), V(0.0), V(1.0)});
    return load;
}

template <class V>
void RodPack<V>::add_point_mass(const PointMass<V>& mass, V a0, V a1, V (&D)[7][7],
                                V (&R)[7]) const {
    const auto n = static_cast<std::size_t>(mass.node);
    const TrialNode<V>& x = trial_[n];
    const Water<V>& water = water_[n == 0 ? 0 : n * gauss_points - 1];  // the nearest Gauss point
    const PointLoad<V> load = point_mass_load(mass, x.r, x.v, x.a, water, a0, a1);
    R[0] += load.f.x, R[1] += load.f.y, R[2] += load.f.z;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) D[i][k] += load.S(i, k);
}

namespace {

template <class V>
Symmetric<V> scaled(V factor, const Symmetric<V>& S) {
    Symmetric<V> out;
    out.add(factor, S);
    return out;
}

}  // namespace

template <class V>
void RodPack<V>::add_slope_law(const SlopeLaw<V>& law, const TrialNode<V>& node,
                               const Vector<V>& axis, V (&D)[7][7], V (&R)[7],
                               ConstraintLoad<V>& out, Mask on) const {
    if (std::holds_alternative<NoSlopeLaw>(law)) {
        out = {};
        return;
    }
    out = std::visit([&](const auto& l) { return load(l, node.d, axis); }, law);
    const Mask acts = on & law_on_;
    out = select(acts, out, ConstraintLoad<V>{});
    R[3] -= out.force.x, R[4] -= out.force.y, R[5] -= out.force.z;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) D[3 + i][3 + k] += out.stiffness(i, k);
}

namespace {

/// Moment of a joint on the rod, r' x f, with f carried to the solution of the linear system.
template <class V>
Vector<V> joint_moment(const TrialNode<V>& node, const ConstraintLoad<V>& joint, const V (&d)[7]) {
    return cross(node.d, joint.force + joint.stiffness * Vector<V>{d[3], d[4], d[5]});
}

/// The first three rows up to the diagonal. Apart from reduce(), so that where it is not needed the
/// compiler makes the same instructions, and bits, of the elimination as without it.
template <class V>
[[gnu::noinline]] void copy_rows(const V (&D)[7][7], V (&to)[3][3]) {
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) to[i][k] = D[i][k];
}

}  // namespace

template <class V>
void RodPack<V>::reduce(V a0, V a1) {
    const std::size_t N = properties_.size();
    ++work_.solves;
    auto mass = masses_.begin();
    V D[7][7]{}, R[7]{}, D_next[7][7], R_next[7];

    // Unrolled, lest the compiler should copy rows in pieces that no vector load can take up.
    for (std::size_t e = 0; e < N; ++e) {
        const V lambda[3] = {lambda_[2 * e], lambda_[2 * e + 1], lambda_[2 * e + 2]};
        ElementSystem<V>& element = element_;
        assemble_element(properties_[e], trial_[e], trial_[e + 1], lambda, material_[e],
                         &water_[e * gauss_points], bed_, a0, a1, element, grip_before(e));
        if (parts_) part_element(e, a0, a1);
        if (!constraints_.empty()) add_constraints(e, element);
        Middle& middle = middles_[e];
#pragma GCC unroll 14
        for (int i = 0; i < 14; ++i) middle.column[i] = element.column[i];
        middle.inverse_pivot = element.inverse_pivot;
        middle.R = element.R_middle;
#pragma GCC unroll 7
        for (int i = 0; i < 7; ++i) {
            R[i] += element.Ra[i];
            R_next[i] = element.Rb[i];
#pragma GCC unroll 7
            for (int k = 0; k <= i; ++k) {
                D[i][k] += element.aa[i][k];
                D_next[i][k] = element.bb[i][k];
            }
        }
        for (; mass != masses_.end() && mass->node == static_cast<int>(e); ++mass)
            add_point_mass(*mass, a0, a1, D, R);
        if (e == 0) {
            add_slope_law(law_b_, trial_[0], end_b_.axis, D, R, slope_load_b_,
                          !LaneTraits<V>::none());
            if (place_b_.kind == EndKind::platform) copy_rows(D, rows_b_.own);
            if (place_b_.prescribed()) {  // the removed rows are the reaction
                for (int i = 0; i < 3; ++i) {
                    rows_b_.R[i] = R[i];
                    R[i] = V(0.0);
                    for (int k = 0; k < 4; ++k) {
                        rows_b_.D[i][k] = D[3 + k][i];
                        D[3 + k][i] = V(0.0);
                    }
                    for (int k = 0; k < 7; ++k) {
                        rows_b_.E[i][k] = element.ab[i][k];
                        element.ab[i][k] = V(0.0);
                    }
                    for (int k = 0; k < i; ++k) D[i][k] = V(0.0);
                    D[i][i] = V(1.0);
                }
            }
        }
        eliminate(D, R, element.ab, factors_[e], D_next, R_next);
#pragma GCC unroll 7
        for (int i = 0; i < 7; ++i) {
            R[i] = R_next[i];
#pragma GCC unroll 7
            for (int k = 0; k <= i; ++k) D[i][k] = D_next[i][k];
        }
    }
    for (; mass != masses_.end(); ++mass) add_point_mass(*mass, a0, a1, D, R);
    const V held_a = select(released_, V(0.0), V(1.0));
    add_slope_law(law_a_, trial_[N], end_a_.axis, D, R, slope_load_a_, !released_);
    if (place_a_.sprung()) {
        const Vector<V> g = trial_[N].r - end_a_.position, g_rate = trial_[N].v - end_a_.velocity;
        spring_load_a_ =
            std::visit([&](const auto& l) { return load(l, g, g_rate, a1); }, spring_a_);
        if (parts_) {
            spring_load_a_.force = held_a * spring_load_a_.force;
            spring_load_a_.stiffness = scaled(held_a, spring_load_a_.stiffness);
        }
        R[0] -= spring_load_a_.force.x, R[1] -= spring_load_a_.force.y;
        R[2] -= spring_load_a_.force.z;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k <= i; ++k) D[i][k] += spring_load_a_.stiffness(i, k);
    }
    for (int i = 0; i < 7; ++i) {
        last_R_[i] = R[i];
        for (int k = 0; k <= i; ++k) last_D_[i][k] = last_D_[k][i] = D[i][k];
    }
    if (place_a_.prescribed() && any(released_)) {
        // Some lanes' platform end has let go: their node is free, the others' rows are folded into
        // the reaction.
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 4; ++k) D[3 + k][i] = select(released_, D[3 + k][i], V(0.0));
            for (int k = 0; k < i; ++k) D[i][k] = select(released_, D[i][k], V(0.0));
            D[i][i] = select(released_, D[i][i], V(1.0));
        }
        factor<0, 7>(D, last_.L, last_.inverse_d);
    } else if (place_a_.prescribed()) {
        factor<3, 4>(D, last_.L, last_.inverse_d);
    } else {
        factor<0, 7>(D, last_.L, last_.inverse_d);
    }
}

template <class V>
void RodPack<V>::back_substitute() {
    const std::size_t N = properties_.size();
    const V(&L)[7][7] = last_.L;
    const V(&inverse_d)[7] = last_.inverse_d;
    V z[7];
    V(&d)[7] = correction_[N].x;
    if (place_a_.prescribed() && any(released_)) {
        V R[7];
        for (int i = 0; i < 7; ++i)
            R[i] = i < 3 ? select(released_, last_R_[i], V(0.0)) : last_R_[i];
        forward<7>(L, R, z);
        for (int i = 0; i < 7; ++i) z[i] = inverse_d[i] * z[i];
        backward<7>(L, z, d);
        V f[3];
        for (int i = 0; i < 3; ++i) {
            f[i] = last_R_[i];
            for (int k = 3; k < 7; ++k) f[i] -= last_D_[k][i] * d[k];
            f[i] = select(released_, V(0.0), f[i]);
        }
        reaction_a_ = {f[0], f[1], f[2]};
    } else if (place_a_.prescribed()) {
        forward<4>(L, last_R_ + 3, z);
        for (int i = 0; i < 4; ++i) z[i] = inverse_d[i] * z[i];
        backward<4>(L, z, d + 3);
        V f[3];
        for (int i = 0; i < 3; ++i) {  // R:23 with dX = 0: the reduced residual is the reaction
            d[i] = V(0.0);
            f[i] = last_R_[i];
            for (int k = 3; k < 7; ++k) f[i] -= last_D_[k][i] * d[k];
        }
        reaction_a_ = {f[0], f[1], f[2]};
    } else {
        forward<7>(L, last_R_, z);
        for (int i = 0; i < 7; ++i) z[i] = inverse_d[i] * z[i];
        backward<7>(L, z, d);
        reaction_a_ = spring_load_a_.force + spring_load_a_.stiffness * Vector<V>{d[0], d[1], d[2]};
    }
    moment_a_ = joint_moment(trial_[N], slope_load_a_, d);

    for (std::size_t n = N; n-- > 0;) {
        substitute(factors_[n], correction_[n + 1].x, correction_[n].x);
        const Middle& middle = middles_[n];
        V s = middle.R;
        for (int i = 0; i < 7; ++i)
            s -= middle.column[i] * correction_[n].x[i] +
                 middle.column[7 + i] * correction_[n + 1].x[i];
        lambda_correction_[n] = s * middle.inverse_pivot;
    }
    if (!constraints_.empty()) carry_constraints();
    moment_b_ = joint_moment(trial_[0], slope_load_b_, correction_[0].x);
    reaction_b_ = {};
    if (place_b_.prescribed()) {
        V f[3];
        for (int i = 0; i < 3; ++i) {
            f[i] = rows_b_.R[i];
            for (int k = 0; k < 4; ++k) f[i] -= rows_b_.D[i][k] * correction_[0].x[3 + k];
            for (int k = 0; k < 7; ++k) f[i] -= rows_b_.E[i][k] * correction_[1].x[k];
        }
        reaction_b_ = {f[0], f[1], f[2]};
    }
}

template <class V>
void RodPack<V>::update_trial(Mask iterating, V a0, V a1, V part, V limit, V& correction,
                              V& finite) {
    const std::size_t N = properties_.size();
    correction = V(0.0);
    V sum(0.0);
    for (std::size_t n = 0; n <= N; ++n) {
        const V(&d)[7] = correction_[n].x;
        correction = max(correction, max(abs(d[0]), max(abs(d[1]), abs(d[2]))));
        sum += d[0] + d[1] + d[2];
    }
    finite = sum - sum;  // 0, or NaN
    // A step beyond the limit is shortened as a whole; frozen lanes do not move.
    const V scale = select(iterating, min(part, limit / max(correction, V(1e-30))), V(0.0));
    const V c0 = scale * a0, c1 = scale * a1;
    for (std::size_t n = 0; n <= N; ++n) {
        const V(&d)[7] = correction_[n].x;
        TrialNode<V>& x = trial_[n];
        const Vector<V> dr = select(iterating, Vector<V>{d[0], d[1], d[2]}, Vector<V>{});
        const Vector<V> dd = select(iterating, Vector<V>{d[3], d[4], d[5]}, Vector<V>{});
        x.r -= scale * dr, x.d -= scale * dd;
        x.v -= c1 * dr, x.vd -= c1 * dd;
        x.a -= c0 * dr, x.ad -= c0 * dd;
        lambda_[2 * n] -= scale * select(iterating, d[6], V(0.0));
        if (n < N) lambda_[2 * n + 1] -= scale * select(iterating, lambda_correction_[n], V(0.0));
    }
}

template PointLoad<Single> RodPack<Single>::point_mass_load(
    const PointMass<Single>&, const Vector<Single>&, const Vector<Single>&, const Vector<Single>&,
    const Water<Single>&, Single, Single) const;
template void RodPack<Single>::add_point_mass(const PointMass<Single>&, Single, Single,
                                              Single (&)[7][7], Single (&)[7]) const;
template void RodPack<Single>::add_slope_law(const SlopeLaw<Single>&, const TrialNode<Single>&,
                                             const Vector<Single>&, Single (&)[7][7], Single (&)[7],
                                             ConstraintLoad<Single>&, Single::Mask) const;
template void RodPack<Single>::reduce(Single, Single);
template void RodPack<Single>::back_substitute();
template void RodPack<Single>::update_trial(Single::Mask, Single, Single, Single, Single, Single&,
                                            Single&);
template PointLoad<Quad> RodPack<Quad>::point_mass_load(const PointMass<Quad>&, const Vector<Quad>&,
                                                        const Vector<Quad>&, const Vector<Quad>&,
                                                        const Water<Quad>&, Quad, Quad) const;
template void RodPack<Quad>::add_point_mass(const PointMass<Quad>&, Quad, Quad, Quad (&)[7][7],
                                            Quad (&)[7]) const;
template void RodPack<Quad>::add_slope_law(const SlopeLaw<Quad>&, const TrialNode<Quad>&,
                                           const Vector<Quad>&, Quad (&)[7][7], Quad (&)[7],
                                           ConstraintLoad<Quad>&, Quad::Mask) const;
template void RodPack<Quad>::reduce(Quad, Quad);
template void RodPack<Quad>::back_substitute();
template void RodPack<Quad>::update_trial(Quad::Mask, Quad, Quad, Quad, Quad, Quad&, Quad&);

}  // namespace hawser::worker
