// The constraints' share of a line's static stiffness: border columns and block of R:22, eliminated
// node by node as R:24.
#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

template <class V>
auto RodPack<V>::border_of_constraints(int lane, const Vec3& reference, Mat6& M) const -> Border {
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
        for (int i = 0; i < 7; ++i)
            for (int k = 0; k < 7; ++k) K[n + 1].row(k) -= T::get(f.Y[i][k], lane) * scaled.row(i);
    }
    return K[N];
}

template RodPack<Single>::Border RodPack<Single>::border_of_constraints(int, const Vec3&,
                                                                        Mat6&) const;
template RodPack<Quad>::Border RodPack<Quad>::border_of_constraints(int, const Vec3&, Mat6&) const;

}  // namespace hawser::worker
