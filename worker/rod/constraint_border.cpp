// The constraints' share of a line's static stiffness: border columns and block of R:22, eliminated
// node by node as R:24.
#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"
#include "rod/tie_system.hpp"

namespace hawser::worker {

namespace {

/// L^-1 Z of a node before end A.
template <class V, int n>
Eigen::Matrix<double, n, 3> columns_of(const typename TieSide<V>::Columns& at, int lane,
                                       int first = 0) {
    Eigen::Matrix<double, n, 3> out;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) out(i, k) = LaneTraits<V>::get(at.x[first + i][k], lane);
    return out;
}

}  // namespace

template <class V>
void RodPack<V>::begin_border(int lane, TieBorder<V>& ties, Eigen::Index columns) const {
    const auto m = static_cast<Eigen::Index>(3 * ties.sides.size());
    ties.C.setZero(m, m), ties.G.setZero(m, columns);
    for (std::size_t n = 0; n < properties_.size(); ++n) {
        Eigen::Matrix<double, 7, Eigen::Dynamic> Z(7, m);
        Z.setZero();
        for (std::size_t a = 0; a < ties.sides.size(); ++a)
            if (n >= ties.sides[a]->first)
                Z.template middleCols<3>(static_cast<Eigen::Index>(3 * a)) =
                    columns_of<V, 7>(ties.sides[a]->z[n], lane);
        Eigen::Matrix<double, 7, Eigen::Dynamic> scaled = Z;
        for (int i = 0; i < 7; ++i)
            scaled.row(i) *= LaneTraits<V>::get(factors_[n].inverse_d[i], lane);
        ties.C += Z.transpose() * scaled;
    }
}

template <class V>
template <int n, int columns>
Eigen::Matrix<double, columns, columns> RodPack<V>::border_at_end_a(
    int lane, const Eigen::Matrix<double, n, n>& D, const Eigen::Matrix<double, n, columns>& K,
    TieBorder<V>* ties, const Eigen::Matrix<double, 3, columns>* B) const {
    const Eigen::Matrix<double, n, n> inverse = D.inverse();
    if (ties != nullptr) {
        const auto m = static_cast<Eigen::Index>(3 * ties->sides.size());
        Eigen::Matrix<double, n, Eigen::Dynamic> Z(n, m);
        for (std::size_t a = 0; a < ties->sides.size(); ++a) {
            const auto at = static_cast<Eigen::Index>(3 * a);
            Z.template middleCols<3>(at) = columns_of<V, n>(ties->sides[a]->last, lane, 7 - n);
            if (B == nullptr) continue;
            const Mat3 folded = columns_of<V, 3>(ties->sides[a]->last, lane);
            ties->G.template middleRows<3>(at) -= folded.transpose() * *B;
        }
        ties->C += Z.transpose() * inverse * Z;
        ties->G += Z.transpose() * inverse * K;
    }
    return K.transpose() * inverse * K;
}

template <class V>
template <int columns>
void RodPack<V>::add_border_at_end_b(int lane, const References& reference,
                                     std::vector<Border<columns>>& K,
                                     Eigen::Matrix<double, columns, columns>& M,
                                     TieBorder<V>* ties) const {
    // R:51. As at end A (stiffness_about), only that the elimination starts there: the columns of
    // the removed rows go to what is left of this node and to the next one.
    using T = LaneTraits<V>;
    const int hull = place_b_.hull, turned = 6 * hull + 3;
    Mat3 own;
    Eigen::Matrix<double, 3, 4> D;
    Eigen::Matrix<double, 3, 7> E;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k <= i; ++k) own(i, k) = own(k, i) = T::get(rows_b_.own[i][k], lane);
        for (int k = 0; k < 4; ++k) D(i, k) = T::get(rows_b_.D[i][k], lane);
        for (int k = 0; k < 7; ++k) E(i, k) = T::get(rows_b_.E[i][k], lane);
    }
    const Vec3 lever =
        lane_vector(working_.nodes()[0].r, lane) - reference[static_cast<std::size_t>(hull)];
    const auto B = columns_of_hull<columns>(Mat3::Identity(), -skew(lever), hull);
    const Eigen::Matrix<double, 3, columns> K_r = K[0].template topRows<3>();
    M += B.transpose() * own * B + B.transpose() * K_r + K_r.transpose() * B;
    M.template block<3, 3>(turned, turned) -= skew(force_on_support_b(lane)) * skew(lever);
    K[0].template bottomRows<4>() += D.transpose() * B;
    K[1] += E.transpose() * B;
    for (std::size_t a = 0; ties != nullptr && a < ties->sides.size(); ++a) {
        Mat3 folded;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) folded(i, k) = T::get(ties->sides[a]->reaction[i][k], lane);
        ties->G.template middleRows<3>(static_cast<Eigen::Index>(3 * a)) -= folded.transpose() * B;
    }
}

template <class V>
template <int columns>
auto RodPack<V>::border_of_constraints(int lane, const References& references,
                                       Eigen::Matrix<double, columns, columns>& M,
                                       TieBorder<V>* ties) const -> Border<columns> {
    using T = LaneTraits<V>;
    using Rows = Eigen::Matrix<double, 3, columns>;
    const std::size_t N = properties_.size();
    std::vector<Border<columns>> K(N + 1, Border<columns>::Zero());
    for (const PlacedConstraint<V>& c : constraints_) {
        if (!c.at[static_cast<std::size_t>(lane)].on_platform) continue;
        const auto e = static_cast<std::size_t>(T::get(c.element, lane));
        const double xi = T::get(c.xi, lane), L = T::get(properties_[e].L, lane);
        const auto couple = [&](double a0, double a1, double b0, double b1, const Rows& Q) {
            K[e].template topRows<3>() -= a0 * Q;
            K[e].template middleRows<3>(3) -= a1 * Q;
            K[e + 1].template topRows<3>() -= b0 * Q;
            K[e + 1].template middleRows<3>(3) -= b1 * Q;
        };
        const Mat3 Kt = lane_matrix(c.reading.load.stiffness, lane);
        const int moved = 6 * c.hull, turned = moved + 3;
        const Vec3 lever =
            lane_vector(c.point, lane) - references[static_cast<std::size_t>(c.hull)];
        const Rows B = columns_of_hull<columns>(Mat3::Identity(), -skew(lever), c.hull);
        // The force keeps to the hull's axes: df = -Kt dr + Q dX with Q = Kt B - [0, skew(f)].
        // Departs from R:22, which leaves the turning out.
        const Mat3 F = skew(lane_vector(c.force, lane));
        Rows Q = Kt * B;
        Q.template middleCols<3>(turned) -= F;
        const auto A = hermite(xi);
        couple(A[0], L * A[1], A[2], L * A[3], Q);
        M += B.transpose() * Kt * B;
        M.template block<3, 3>(moved, turned) -= F;
        M.template block<3, 3>(turned, moved) += F;
        M.template block<3, 3>(turned, turned) -= skew(lever) * F;
        if (std::holds_alternative<NoSlopeLaw>(c.joint)) continue;
        // R:21 for a slope, which turns with d x: the same with Bs, and no position
        const Vec3 d = lane_vector(c.slope, lane);
        const Mat3 Ks = lane_matrix(c.joint_load.stiffness, lane);
        const Mat3 Fs = skew(lane_vector(c.slope_force, lane));
        const Rows Bs = columns_of_hull<columns>(Mat3::Zero(), -skew(d), c.hull);
        Q = Ks * Bs;
        Q.template middleCols<3>(turned) -= Fs;
        const auto w = reduced_slope(xi);
        couple(-w[0] / L, w[1], w[0] / L, w[2], Q);
        M += Bs.transpose() * Ks * Bs;
        M.template block<3, 3>(turned, turned) -= skew(d) * Fs;
    }
    if (place_b_.kind == EndKind::platform)
        add_border_at_end_b<columns>(lane, references, K, M, ties);
    if (place_b_.prescribed()) K[0].template topRows<3>().setZero();
    for (std::size_t n = 0; n < N; ++n) {  // R:24
        if (K[n].isZero(0.0)) continue;
        const NodeFactor<V>& f = factors_[n];
        Border<columns> z = K[n], scaled;
        for (int i = 0; i < 7; ++i) {
            for (int k = 0; k < i; ++k) z.row(i) -= T::get(f.L[i][k], lane) * z.row(k);
            scaled.row(i) = T::get(f.inverse_d[i], lane) * z.row(i);
        }
        M -= z.transpose() * scaled;
        for (std::size_t a = 0; ties != nullptr && a < ties->sides.size(); ++a) {
            if (n < ties->sides[a]->first) continue;
            ties->G.template middleRows<3>(static_cast<Eigen::Index>(3 * a)) +=
                columns_of<V, 7>(ties->sides[a]->z[n], lane).transpose() * scaled;
        }
        for (int i = 0; i < 7; ++i)
            for (int k = 0; k < 7; ++k) K[n + 1].row(k) -= T::get(f.Y[i][k], lane) * scaled.row(i);
    }
    return K[N];
}

template void RodPack<Single>::begin_border(int, TieBorder<Single>&, Eigen::Index) const;
template auto RodPack<Single>::border_of_constraints<6>(int, const References&,
                                                        Eigen::Matrix<double, 6, 6>&,
                                                        TieBorder<Single>*) const -> Border<6>;
template auto RodPack<Single>::border_at_end_a<4, 6>(int, const Eigen::Matrix<double, 4, 4>&,
                                                     const Eigen::Matrix<double, 4, 6>&,
                                                     TieBorder<Single>*,
                                                     const Eigen::Matrix<double, 3, 6>*) const
    -> Eigen::Matrix<double, 6, 6>;
template auto RodPack<Single>::border_at_end_a<7, 6>(int, const Eigen::Matrix<double, 7, 7>&,
                                                     const Eigen::Matrix<double, 7, 6>&,
                                                     TieBorder<Single>*,
                                                     const Eigen::Matrix<double, 3, 6>*) const
    -> Eigen::Matrix<double, 6, 6>;
template auto RodPack<Single>::border_of_constraints<12>(int, const References&,
                                                         Eigen::Matrix<double, 12, 12>&,
                                                         TieBorder<Single>*) const -> Border<12>;
template auto RodPack<Single>::border_at_end_a<4, 12>(int, const Eigen::Matrix<double, 4, 4>&,
                                                      const Eigen::Matrix<double, 4, 12>&,
                                                      TieBorder<Single>*,
                                                      const Eigen::Matrix<double, 3, 12>*) const
    -> Eigen::Matrix<double, 12, 12>;
template auto RodPack<Single>::border_at_end_a<7, 12>(int, const Eigen::Matrix<double, 7, 7>&,
                                                      const Eigen::Matrix<double, 7, 12>&,
                                                      TieBorder<Single>*,
                                                      const Eigen::Matrix<double, 3, 12>*) const
    -> Eigen::Matrix<double, 12, 12>;
template void RodPack<Quad>::begin_border(int, TieBorder<Quad>&, Eigen::Index) const;
template auto RodPack<Quad>::border_of_constraints<6>(int, const References&,
                                                      Eigen::Matrix<double, 6, 6>&,
                                                      TieBorder<Quad>*) const -> Border<6>;
template auto RodPack<Quad>::border_at_end_a<4, 6>(int, const Eigen::Matrix<double, 4, 4>&,
                                                   const Eigen::Matrix<double, 4, 6>&,
                                                   TieBorder<Quad>*,
                                                   const Eigen::Matrix<double, 3, 6>*) const
    -> Eigen::Matrix<double, 6, 6>;
template auto RodPack<Quad>::border_at_end_a<7, 6>(int, const Eigen::Matrix<double, 7, 7>&,
                                                   const Eigen::Matrix<double, 7, 6>&,
                                                   TieBorder<Quad>*,
                                                   const Eigen::Matrix<double, 3, 6>*) const
    -> Eigen::Matrix<double, 6, 6>;
template auto RodPack<Quad>::border_of_constraints<12>(int, const References&,
                                                       Eigen::Matrix<double, 12, 12>&,
                                                       TieBorder<Quad>*) const -> Border<12>;
template auto RodPack<Quad>::border_at_end_a<4, 12>(int, const Eigen::Matrix<double, 4, 4>&,
                                                    const Eigen::Matrix<double, 4, 12>&,
                                                    TieBorder<Quad>*,
                                                    const Eigen::Matrix<double, 3, 12>*) const
    -> Eigen::Matrix<double, 12, 12>;
template auto RodPack<Quad>::border_at_end_a<7, 12>(int, const Eigen::Matrix<double, 7, 7>&,
                                                    const Eigen::Matrix<double, 7, 12>&,
                                                    TieBorder<Quad>*,
                                                    const Eigen::Matrix<double, 3, 12>*) const
    -> Eigen::Matrix<double, 12, 12>;

}  // namespace hawser::worker
