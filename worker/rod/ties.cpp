// Rods tied to each other: where the ties act, their loads on both rods, and their part in the
// linear system, R:46.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rod/lane_access.hpp"
#include "rod/rod_group.hpp"

namespace hawser::worker {

template <class V>
void RodGroup<V>::find_ties() {
    for (std::size_t p = 0; p < packs_.size(); ++p) {
        for (std::size_t n = 0; n < packs_[p].constraints_.size(); ++n) {
            const PlacedConstraint<V>& c = packs_[p].constraints_[n];
            if (!c.tied) continue;
            Tie tie{.pack = p, .constraint = n};
            bool found = false;
            for (std::size_t q = 0; q < packs_.size() && !found; ++q) {
                if (packs_[q].lines_.front() != c.at.front().other_line) continue;
                for (std::size_t m = 0; m < packs_[q].constraints_.size() && !found; ++m) {
                    const PlacedConstraint<V>& mirror = packs_[q].constraints_[m];
                    if (!mirror.mirror || mirror.of_line != packs_[p].lines_.front() ||
                        mirror.of_constraint != c.declared)
                        continue;
                    tie.other_pack = q, tie.mirror = m;
                    found = true;
                }
            }
            if (!found) throw std::logic_error("a tied rod without the rod that it is tied to");
            ties_.push_back(tie);
        }
    }
    if (ties_.empty()) return;
    system_.resize(ties_.size());
    for (const Tie& tie : ties_) {
        for (const auto& [pack, constraint] :
             {std::pair{tie.pack, tie.constraint}, {tie.other_pack, tie.mirror}}) {
            TieSide<V>& side = sides_.emplace_back();
            side.pack = pack, side.constraint = constraint;
            side.z.resize(packs_[pack].properties_.size());
        }
    }
}

namespace {

/// Point of a rod, and its slope, between two nodes given by position and slope.
template <class Node>
Vec3 point_between(const Node& a, const Node& b, int lane, double xi, double L, Vec3* slope) {
    const auto A = hermite(xi);
    const auto D = reduced_slope(xi);
    const Vec3 ra = lane_vector(a.r, lane), rb = lane_vector(b.r, lane);
    const Vec3 da = L * lane_vector(a.d, lane), db = L * lane_vector(b.d, lane);
    if (slope) *slope = D[0] * (rb - ra) + D[1] * da + D[2] * db;
    return A[0] * ra + A[1] * da + A[2] * rb + A[3] * db;
}

}  // namespace

template <class V>
Vec3 RodPack<V>::kept_point(int lane, double arc_length) const {
    const auto [e, xi] = element_at(lane, arc_length);
    const auto u = static_cast<std::size_t>(e);
    return point_between(kept_.nodes()[u], kept_.nodes()[u + 1], lane, xi,
                         LaneTraits<V>::get(properties_[u].L, lane), nullptr);
}

template <class V>
void RodPack<V>::locate_nearest(PlacedConstraint<V>& c, int lane, const Vec3& to,
                                bool search) const {
    using T = LaneTraits<V>;
    const int N = elements();
    int element = static_cast<int>(T::get(c.element, lane));
    double xi = T::get(c.xi, lane);
    if (search) {
        double nearest = 1e300;
        for (int e = 0; e < N; ++e)
            for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const double distance = (trial_point(lane, e, x, nullptr) - to).squaredNorm();
                if (distance < nearest) nearest = distance, element = e, xi = x;
            }
    }
    for (int i = 0; i < 20; ++i) {  // (to - r).r' = 0
        Vec3 slope;
        const Vec3 off = to - trial_point(lane, element, xi, &slope);
        const double move = off.dot(slope) / slope.squaredNorm();  // slope = dr/dxi
        xi += move;
        if (xi < 0.0 && element > 0) {
            --element, xi = 1.0;
        } else if (xi > 1.0 && element + 1 < N) {
            ++element, xi = 0.0;
        } else {
            xi = std::clamp(xi, 0.0, 1.0);
            if (std::abs(move) < 1e-12) break;
        }
    }
    T::set(c.element, lane, element);
    T::set(c.xi, lane, xi);
}

template <class V>
void RodGroup<V>::place_ties(State before, bool search) {
    using T = LaneTraits<V>;
    for (const Tie& tie : ties_) {
        RodPack<V>&rod = packs_[tie.pack], &other = packs_[tie.other_pack];
        PlacedConstraint<V>& c = rod.constraints_[tie.constraint];
        PlacedConstraint<V>& mirror = other.constraints_[tie.mirror];
        for (int i = 0; i < lanes; ++i) {
            const auto u = static_cast<std::size_t>(i);
            const auto point = [&](const RodPack<V>& p, const PlacedConstraint<V>& at,
                                   Vec3* slope) {
                const auto e = static_cast<std::size_t>(T::get(at.element, i));
                const NodeState<V>* node = (p.*before).nodes();
                return point_between(node[e], node[e + 1], i, T::get(at.xi, i),
                                     T::get(p.properties_[e].L, i), slope);
            };
            if (!mirror.at[u].arc_length) {
                const Vec3 to = rod.trial_point(i, static_cast<int>(T::get(c.element, i)),
                                                T::get(c.xi, i), nullptr);
                other.locate_nearest(mirror, i, to, search);
            }
            // Where this material point was along the other rod before the step
            Vec3 slope;
            const Vec3 X = point(other, mirror, &slope);
            T::set(c.slide_start, i, (point(rod, c, nullptr) - X).dot(slope.normalized()));
        }
    }
}

template <class V>
void RodGroup<V>::follow_ties() {
    for (const Tie& tie : ties_) {
        PlacedConstraint<V>& c = packs_[tie.pack].constraints_[tie.constraint];
        const PlacedConstraint<V>& mirror = packs_[tie.other_pack].constraints_[tie.mirror];
        c.place = mirror.point;
        c.place_rate = mirror.rate;
        c.axis = (V(1.0) / sqrt(dot(mirror.slope, mirror.slope))) * mirror.slope;
    }
}

template <class V>
void RodGroup<V>::answer_ties() {
    for (const Tie& tie : ties_) {
        const PlacedConstraint<V>& c = packs_[tie.pack].constraints_[tie.constraint];
        PlacedConstraint<V>& mirror = packs_[tie.other_pack].constraints_[tie.mirror];
        mirror.reading.load.force = Vector<V>{} - c.reading.load.force;
        mirror.reading.load.stiffness = c.reading.load.stiffness;
    }
}

template <class V>
void RodGroup<V>::carry_ties() {
    // The force at the solution of the linear system: f + Kt (u_i - u_j)
    for (const Tie& tie : ties_) {
        RodPack<V>& rod = packs_[tie.pack];
        PlacedConstraint<V>& c = rod.constraints_[tie.constraint];
        PlacedConstraint<V>& mirror = packs_[tie.other_pack].constraints_[tie.mirror];
        c.force -= c.reading.load.stiffness * mirror.moved;
        mirror.force = Vector<V>{} - c.force;
        if (c.is_end_a) rod.reaction_a_ = c.force;
        if (c.is_end_b) rod.reaction_b_ = c.force;
    }
}

namespace {

/// Q with K = Q Q^T of a symmetric K >= 0 of any rank, by Cholesky with the largest pivot first.
template <class V>
void root_of(const Symmetric<V>& K, V (&Q)[3][3]) {
    using T = LaneTraits<V>;
    for (auto& row : Q)
        for (V& x : row) x = V(0.0);
    for (int lane = 0; lane < T::count; ++lane) {
        Mat3 A = lane_matrix(K, lane);
        const double least = 1e-13 * A.trace();
        for (int k = 0; k < 3; ++k) {
            Eigen::Index p = 0;
            const double pivot = A.diagonal().maxCoeff(&p);
            if (!(pivot > least)) break;
            const Vec3 column = A.col(p) / std::sqrt(pivot);
            for (int i = 0; i < 3; ++i) T::set(Q[i][k], lane, column[i]);
            A -= column * column.transpose();
            A.row(p).setZero(), A.col(p).setZero();
        }
    }
}

}  // namespace

template <class V>
void RodPack<V>::reduce_side(TieSide<V>& side) const {
    using T = LaneTraits<V>;
    const PlacedConstraint<V>& c = constraints_[side.constraint];
    const std::size_t N = properties_.size();
    root_of(c.reading.load.stiffness, side.Q);
    side.first = N;
    for (int i = 0; i < lanes; ++i)
        side.first = std::min(side.first, static_cast<std::size_t>(T::get(c.element, i)));
    typename TieSide<V>::Columns b, next;
    for (auto& row : b.x)
        for (V& x : row) x = V(0.0);
    for (auto& row : side.reaction)
        for (V& x : row) x = V(0.0);
    next = b;
    for (std::size_t n = side.first; n <= N; ++n) {
        // Z at this node: the first half of its own element's weights, the second of the one before
        const auto add = [&](std::size_t e, int first) {
            const V here(static_cast<double>(e));
            const Mask mine = (c.element <= here) & (c.element >= here);
            if (!any(mine)) return;
            const PointShape<V> at(c.xi, properties_[e].L);
            for (int half = 0; half < 2; ++half) {
                const V A = select(mine, at.A[first + half], V(0.0));
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k) b.x[3 * half + i][k] += A * side.Q[i][k];
            }
        };
        if (n > side.first) add(n - 1, 2);
        if (n < N) add(n, 0);
        if (n == 0 && place_b_.prescribed()) {
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 3; ++k) side.reaction[i][k] = b.x[i][k], b.x[i][k] = V(0.0);
        }
        if (n == N) break;
        const NodeFactor<V>& f = factors_[n];
        V(&z)[7][3] = side.z[n].x;
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 7; ++i) {
                V s = b.x[i][k];
                for (int j = 0; j < i; ++j) s -= f.L[i][j] * z[j][k];
                z[i][k] = s;
            }
            V scaled[7];
            for (int i = 0; i < 7; ++i) scaled[i] = f.inverse_d[i] * z[i][k];
            for (int i = 0; i < 7; ++i) {
                V s(0.0);
                for (int j = 0; j < 7; ++j) s -= f.Y[j][i] * scaled[j];
                next.x[i][k] = s;
            }
        }
        b = next;
    }
    side.last = b;
}

template <class V>
void RodPack<V>::last_rows(const V* column, int stride, V (&z)[7]) const {
    // L^-1 of the node at end A; rows that are not solved for are 0
    V b[7];
    for (int i = 0; i < 7; ++i) b[i] = column[i * stride], z[i] = V(0.0);
    if (place_a_.prescribed() && any(released_)) {
        for (int i = 0; i < 3; ++i) b[i] = select(released_, b[i], V(0.0));
        forward<7>(last_.L, b, z);
    } else if (place_a_.prescribed()) {
        forward<4>(last_.L, b + 3, z);
    } else {
        forward<7>(last_.L, b, z);
    }
}

template <class V>
void RodGroup<V>::couple() {
    for (TieSide<V>& side : sides_) packs_[side.pack].reduce_side(side);
    for (std::size_t a = 0; a < sides_.size(); ++a) {
        const TieSide<V>& left = sides_[a];
        const RodPack<V>& rod = packs_[left.pack];
        const int last = rod.place_a_.prescribed() && !any(rod.released_) ? 4 : 7;
        // weighted columns at the node of end A
        V w[3][7], z[7];
        for (int i = 0; i < 3; ++i) {
            rod.last_rows(&left.last.x[0][i], 3, w[i]);
            for (int k = 0; k < last; ++k) w[i][k] = w[i][k] * rod.last_.inverse_d[k];
        }
        V sum[3] = {V(0.0), V(0.0), V(0.0)};
        for (std::size_t n = left.first; n < left.z.size(); ++n) {
            const NodeFactor<V>& f = rod.factors_[n];
            for (int k = 0; k < 7; ++k) {
                const V q = f.inverse_d[k] * f.z[k];
                for (int i = 0; i < 3; ++i) sum[i] += left.z[n].x[k][i] * q;
            }
        }
        rod.last_rows(rod.last_R_, 1, z);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < last; ++k) sum[i] += w[i][k] * z[k];
            system_.x0(3 * a + static_cast<std::size_t>(i)) = sum[i];
        }
        for (std::size_t b = 0; b <= a; ++b) {
            const TieSide<V>& right = sides_[b];
            if (right.pack != left.pack) continue;
            V C[3][3] = {};
            for (std::size_t n = std::max(left.first, right.first); n < left.z.size(); ++n) {
                const NodeFactor<V>& f = rod.factors_[n];
                for (int k = 0; k < 7; ++k)
                    for (int i = 0; i < 3; ++i) {
                        const V q = f.inverse_d[k] * left.z[n].x[k][i];
                        for (int j = 0; j < 3; ++j) C[i][j] += q * right.z[n].x[k][j];
                    }
            }
            for (int j = 0; j < 3; ++j) {
                rod.last_rows(&right.last.x[0][j], 3, z);
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < last; ++k) C[i][j] += w[i][k] * z[k];
            }
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    system_.C(3 * a + i, 3 * b + j) = system_.C(3 * b + j, 3 * a + i) = C[i][j];
        }
    }
    system_.solve();
    // R += Z x' in every rod, as far as its elimination has carried R
    for (std::size_t a = 0; a < sides_.size(); ++a) {
        const TieSide<V>& side = sides_[a];
        RodPack<V>& rod = packs_[side.pack];
        const V x[3] = {system_.x(3 * a), system_.x(3 * a + 1), system_.x(3 * a + 2)};
        const auto sum = [&](const V(&row)[3]) {
            return row[0] * x[0] + row[1] * x[1] + row[2] * x[2];
        };
        for (std::size_t n = side.first; n < side.z.size(); ++n)
            for (int k = 0; k < 7; ++k) rod.factors_[n].z[k] += sum(side.z[n].x[k]);
        for (int k = 0; k < 7; ++k) rod.last_R_[k] += sum(side.last.x[k]);
        for (int k = 0; k < 3; ++k) rod.rows_b_.R[k] += sum(side.reaction[k]);
    }
}

template <class V>
template <int m>
Eigen::Matrix<double, m, m> RodGroup<V>::stiffness_about(std::size_t p, int lane,
                                                         const std::array<Vec3, 2>& reference) {
    if (ties_.empty()) return packs_[p].template stiffness_about<m>(lane, reference, nullptr);
    const auto n = static_cast<Eigen::Index>(3 * sides_.size());
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n), G = Eigen::MatrixXd::Zero(n, m);
    Eigen::Matrix<double, m, m> own = Eigen::Matrix<double, m, m>::Zero();
    for (std::size_t q = 0; q < packs_.size(); ++q) {
        TieBorder<V> border;
        for (const TieSide<V>& side : sides_)
            if (side.pack == q) border.sides.push_back(&side);
        const Eigen::Matrix<double, m, m> S =
            packs_[q].template stiffness_about<m>(lane, reference, &border);
        if (q == p) own = S;
        Eigen::Index row = 0, left = 0;
        for (std::size_t a = 0; a < sides_.size(); ++a) {
            if (sides_[a].pack != q) continue;
            row = static_cast<Eigen::Index>(3 * a);
            G.middleRows<3>(row) = border.G.template middleRows<3>(left);
            Eigen::Index right = 0;
            for (std::size_t b = 0; b < sides_.size(); ++b) {
                if (sides_[b].pack != q) continue;
                H.block<3, 3>(row, static_cast<Eigen::Index>(3 * b)) -=
                    border.C.template block<3, 3>(left, right);
                right += 3;
            }
            left += 3;
        }
    }
    for (Eigen::Index a = 0; a < n; ++a) H(a, (a / 3) % 2 == 0 ? a + 3 : a - 3) += 1.0;
    const Eigen::MatrixXd x = H.partialPivLu().solve(G);
    for (std::size_t a = 0; a < sides_.size(); ++a) {
        if (sides_[a].pack != p) continue;
        const auto row = static_cast<Eigen::Index>(3 * a);
        own -= G.middleRows<3>(row).transpose() * x.middleRows<3>(row);
    }
    return own;
}

template void RodPack<Single>::last_rows(const Single*, int, Single (&)[7]) const;
template void RodPack<Quad>::last_rows(const Quad*, int, Quad (&)[7]) const;
template Vec3 RodPack<Single>::kept_point(int, double) const;
template Vec3 RodPack<Quad>::kept_point(int, double) const;
template void RodGroup<Single>::find_ties();
template void RodGroup<Single>::place_ties(State, bool);
template void RodGroup<Single>::follow_ties();
template void RodGroup<Single>::answer_ties();
template void RodGroup<Single>::couple();
template void RodGroup<Single>::carry_ties();
template Mat6 RodGroup<Single>::stiffness_about<6>(std::size_t, int, const std::array<Vec3, 2>&);
template Mat12 RodGroup<Single>::stiffness_about<12>(std::size_t, int, const std::array<Vec3, 2>&);
template void RodGroup<Quad>::find_ties();
template void RodGroup<Quad>::place_ties(State, bool);
template void RodGroup<Quad>::follow_ties();
template void RodGroup<Quad>::answer_ties();
template void RodGroup<Quad>::couple();
template void RodGroup<Quad>::carry_ties();
template Mat6 RodGroup<Quad>::stiffness_about<6>(std::size_t, int, const std::array<Vec3, 2>&);
template Mat12 RodGroup<Quad>::stiffness_about<12>(std::size_t, int, const std::array<Vec3, 2>&);

}  // namespace hawser::worker
