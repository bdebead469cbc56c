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
void RodPack<V>::begin_border(int lane, TieBorder<V>& ties) const {
    const auto m = static_cast<Eigen::Index>(3 * ties.sides.size());
    ties.C.setZero(m, m), ties.G.setZero(m, 6);
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
template <int n>
Mat6 RodPack<V>::border_at_end_a(int lane, const Eigen::Matrix<double, n, n>& D,
                                 const Eigen::Matrix<double, n, 6>& K, TieBorder<V>* ties,
                                 const Eigen::Matrix<double, 3, 6>* B) const {
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
auto RodPack<V>::border_of_constraints(int lane, const Vec3& reference, Mat6& M,
                                       TieBorder<V>* ties) const -> Border {
    using T = LaneTraits<V>;
    const std::size_t N = properties_.size();
    std::vector<Border> K(N + 1, Border::Zero());
    for (const PlacedConstraint<V>& c : constraints_) {
        if (!c.at[static_cast<std::size_t>(lane)].on_platform) continue;
        const auto e = static_cast<std::size_t>(T::get(c.element, lane));
        const double xi = T::get(c.xi, lane), L = T::get(properties_[e].L, lane);
        const auto couple = [&](double a0, double a1, double b0, double b1,
                                const Eigen::Matrix<double, 3, 6>& Q) {
            K[e].template topRows<3>() -= a0 * Q;
            K[e].template middleRows<3>(3) -= a1 * Q;
            K[e + 1].template topRows<3>() -= b0 * Q;
            K[e + 1].template middleRows<3>(3) -= b1 * Q;
        };
        const Mat3 Kt = lane_matrix(c.reading.load.stiffness, lane);
        const Vec3 lever = lane_vector(c.point, lane) - reference;
        Eigen::Matrix<double, 3, 6> B;
        B << Mat3::Identity(), -skew(lever);
        // The force keeps to the hull's axes: df = -Kt dr + Q dX with Q = Kt B - [0, skew(f)].
        // Departs from R:22, which leaves the turning out.
        const Mat3 F = skew(lane_vector(c.force, lane));
        Eigen::Matrix<double, 3, 6> Q = Kt * B;
        Q.template rightCols<3>() -= F;
        const auto A = hermite(xi);
        couple(A[0], L * A[1], A[2], L * A[3], Q);
        M += B.transpose() * Kt * B;
        M.topRightCorner<3, 3>() -= F;
        M.bottomLeftCorner<3, 3>() += F;
        M.bottomRightCorner<3, 3>() -= skew(lever) * F;
        if (std::holds_alternative<NoSlopeLaw>(c.joint)) continue;
        // R:21 for a slope, which turns with d x: the same with Bs, and no position
        const Vec3 d = lane_vector(c.slope, lane);
        const Mat3 Ks = lane_matrix(c.joint_load.stiffness, lane);
        const Mat3 Fs = skew(lane_vector(c.slope_force, lane));
        Eigen::Matrix<double, 3, 6> Bs;
        Bs << Mat3::Zero(), -skew(d);
        Q = Ks * Bs;
        Q.template rightCols<3>() -= Fs;
        const auto w = reduced_slope(xi);
        couple(-w[0] / L, w[1], w[0] / L, w[2], Q);
        M += Bs.transpose() * Ks * Bs;
        M.bottomRightCorner<3, 3>() -= skew(d) * Fs;
    }
    if (place_b_.prescribed()) K[0].template topRows<3>().setZero();
    for (std::size_t n = 0; n < N; ++n) {  // R:24
        if (K[n].isZero(0.0)) continue;
        const NodeFactor<V>& f = factors_[n];
        Border z = K[n], scaled;
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

template RodPack<Single>::Border RodPack<Single>::border_of_constraints(int, const Vec3&, Mat6&,
                                                                        TieBorder<Single>*) const;
template void RodPack<Single>::begin_border(int, TieBorder<Single>&) const;
template Mat6 RodPack<Single>::border_at_end_a<4>(int, const Eigen::Matrix<double, 4, 4>&,
                                                  const Eigen::Matrix<double, 4, 6>&,
                                                  TieBorder<Single>*,
                                                  const Eigen::Matrix<double, 3, 6>*) const;
template Mat6 RodPack<Single>::border_at_end_a<7>(int, const Eigen::Matrix<double, 7, 7>&,
                                                  const Eigen::Matrix<double, 7, 6>&,
                                                  TieBorder<Single>*,
                                                  const Eigen::Matrix<double, 3, 6>*) const;
template RodPack<Quad>::Border RodPack<Quad>::border_of_constraints(int, const Vec3&, Mat6&,
                                                                    TieBorder<Quad>*) const;
template void RodPack<Quad>::begin_border(int, TieBorder<Quad>&) const;
template Mat6 RodPack<Quad>::border_at_end_a<4>(int, const Eigen::Matrix<double, 4, 4>&,
                                                const Eigen::Matrix<double, 4, 6>&,
                                                TieBorder<Quad>*,
                                                const Eigen::Matrix<double, 3, 6>*) const;
template Mat6 RodPack<Quad>::border_at_end_a<7>(int, const Eigen::Matrix<double, 7, 7>&,
                                                const Eigen::Matrix<double, 7, 6>&,
                                                TieBorder<Quad>*,
                                                const Eigen::Matrix<double, 3, 6>*) const;

}  // namespace hawser::worker
