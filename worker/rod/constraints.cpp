// Constraints along a rod: where they touch, what they add to an element, and the load they end
// with (R:22).
#include <algorithm>
#include <cmath>

#include "rod/rod_pack.hpp"

namespace hawser::worker {

namespace {

/// A_i(xi) of r_a, r'_a, r_b, r'_b, the slopes with their length L.
template <class V>
struct PointShape {
    V a[4];
    PointShape(V x, V L) {
        const V x2 = x * x, x3 = x2 * x;
        a[0] = V(1.0) - V(3.0) * x2 + V(2.0) * x3;
        a[1] = L * (x - V(2.0) * x2 + x3);
        a[2] = V(3.0) * x2 - V(2.0) * x3;
        a[3] = L * (x3 - x2);
    }
};

}  // namespace

template <class V>
void RodPack<V>::set_constraints(const Case& input) {
    using T = LaneTraits<V>;
    const auto line_of = [&](int lane) -> const Line& {
        const std::size_t i =
            static_cast<std::size_t>(lane) < lines_.size() ? static_cast<std::size_t>(lane) : 0;
        return input.lines[static_cast<std::size_t>(lines_[i])];
    };
    constraints_.resize(line_of(0).constraints.size());
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
        PlacedConstraint<V>& to = constraints_[c];
        for (int i = 0; i < lanes; ++i) to.at.push_back(line_of(i).constraints[c]);
        const auto gather = [&](auto member) {
            V v{};
            for (int i = 0; i < lanes; ++i)
                T::set(v, i, to.at[static_cast<std::size_t>(i)].*member);
            return v;
        };
        using C = LineConstraint;
        switch (to.at.front().type) {
            case ConstraintType::guide:
                to.law = Guide<V>{.gap = gather(&C::gap),
                                  .stiffness = gather(&C::stiffness),
                                  .damping = gather(&C::damping),
                                  .friction = gather(&C::friction),
                                  .mobilisation = gather(&C::mobilisation),
                                  .smoothing = V(contact_smoothing)};
                break;
            case ConstraintType::ball_joint:
            case ConstraintType::flex_joint:
            case ConstraintType::clamp:
            case ConstraintType::pull_tube:
            case ConstraintType::slider:
                to.law =
                    Slider<V>{.stiffness = gather(&C::stiffness), .damping = gather(&C::damping)};
                break;
            case ConstraintType::tensioner:
                to.law = Tensioner<V>{.nominal = gather(&C::nominal_tension),
                                      .stiffness = gather(&C::stiffness),
                                      .damping = gather(&C::damping),
                                      .exponent = gather(&C::exponent),
                                      .column = gather(&C::gas_column),
                                      .stroke_min = gather(&C::stroke_min),
                                      .stroke_max = gather(&C::stroke_max),
                                      .stop_stiffness = V(stop_stiffness)};
                break;
        }
    }
}

template <class V>
HullMotion<V> RodPack<V>::hull_motion(V t, const MotionSpline& platform) const {
    using T = LaneTraits<V>;
    HullMotion<V> out;
    for (int i = 0; i < lanes; ++i) {
        const PlatformMotion m = platform.at(T::get(t, i)).motion;
        const Vec3 w = static_ ? Vec3::Zero() : angular_velocity(m);  // at rest nothing has a rate
        const auto put = [&](Vector<V>& to, const Vec3& x) {
            T::set(to.x, i, x.x()), T::set(to.y, i, x.y()), T::set(to.z, i, x.z());
        };
        put(out.origin, m.position), put(out.spin, w);
        put(out.velocity, static_ ? Vec3::Zero() : m.velocity);
    }
    return out;
}

template <class V>
Vec3 RodPack<V>::trial_point(int lane, int element, double xi, Vec3* slope) const {
    using T = LaneTraits<V>;
    const TrialNode<V>&a = trial_[static_cast<std::size_t>(element)],
          &b = trial_[static_cast<std::size_t>(element) + 1];
    const double L = T::get(properties_[static_cast<std::size_t>(element)].L, lane);
    const auto vec = [&](const Vector<V>& x) {
        return Vec3(T::get(x.x, lane), T::get(x.y, lane), T::get(x.z, lane));
    };
    const auto A = hermite(xi);
    const auto D = reduced_slope(xi);
    if (slope) *slope = D[0] * (vec(b.r) - vec(a.r)) + L * D[1] * vec(a.d) + L * D[2] * vec(b.d);
    return A[0] * vec(a.r) + L * A[1] * vec(a.d) + A[2] * vec(b.r) + L * A[3] * vec(b.d);
}

template <class V>
void RodPack<V>::locate(PlacedConstraint<V>& c, int lane, bool search) const {
    using T = LaneTraits<V>;
    const LineConstraint& at = c.at[static_cast<std::size_t>(lane)];
    const int N = elements();
    int element = static_cast<int>(T::get(c.element, lane));
    double xi = T::get(c.xi, lane);
    if (at.arc_length) {  // a material point, counted from end A
        const auto& arc = arc_length_[static_cast<std::size_t>(lane)];
        const double target = arc.back() - *at.arc_length;  // from end B
        element = 0;
        while (element + 1 < N && arc[static_cast<std::size_t>(element) + 1] < target) ++element;
        const double low = arc[static_cast<std::size_t>(element)],
                     high = arc[static_cast<std::size_t>(element) + 1];
        xi = std::clamp((target - low) / (high - low), 0.0, 1.0);
    } else {
        const auto lane_of = [&](const Vector<V>& x) {
            return Vec3(T::get(x.x, lane), T::get(x.y, lane), T::get(x.z, lane));
        };
        const Vec3 X = lane_of(c.place), k = lane_of(c.axis);
        if (search) {  // the crossing of the plane that lies nearest to the place
            double nearest = 1e300;
            for (int e = 0; e < N; ++e) {
                const double f0 = (trial_point(lane, e, 0.0, nullptr) - X).dot(k);
                const double f1 = (trial_point(lane, e, 1.0, nullptr) - X).dot(k);
                if (f0 * f1 > 0.0 || f0 == f1) continue;
                const double x = f0 / (f0 - f1);
                const double distance = (trial_point(lane, e, x, nullptr) - X).norm();
                if (distance < nearest) nearest = distance, element = e, xi = x;
            }
        }
        for (int i = 0; i < 20; ++i) {
            Vec3 slope;
            const double f = (trial_point(lane, element, xi, &slope) - X).dot(k),
                         rate = slope.dot(k);
            if (std::abs(rate) < 1e-9) break;
            xi -= f / rate;
            if (xi < 0.0 && element > 0) {
                --element, xi = 1.0;
            } else if (xi > 1.0 && element + 1 < N) {
                ++element, xi = 0.0;
            } else {
                xi = std::clamp(xi, 0.0, 1.0);
                if (std::abs(f) < 1e-10) break;
            }
        }
    }
    T::set(c.element, lane, element);
    T::set(c.xi, lane, xi);
}

template <class V>
void RodPack<V>::place_constraints(const RodState<V>& before, V t_before, V t,
                                   const MotionSpline& platform, bool search) {
    using T = LaneTraits<V>;
    hull_ = hull_motion(t, platform);
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        PlacedConstraint<V>& c = constraints_[n];
        c.element = before.constraints()[n].element;
        c.xi = before.constraints()[n].xi;
        c.friction = before.constraints()[n].friction;
        for (int i = 0; i < lanes; ++i) {
            const LineConstraint& at = c.at[static_cast<std::size_t>(i)];
            const auto put = [&](Vector<V>& to, const Vec3& x) {
                T::set(to.x, i, x.x()), T::set(to.y, i, x.y()), T::set(to.z, i, x.z());
            };
            Vec3 X = at.position, k = at.axis, X0 = X, k0 = k;
            if (at.on_platform) {
                const PlatformMotion now = platform.at(T::get(t, i)).motion,
                                     then = platform.at(T::get(t_before, i)).motion;
                const Mat3 R = rotation(now.angles), R0 = rotation(then.angles);
                X = now.position + R * at.position, k = R * at.axis;
                X0 = then.position + R0 * at.position, k0 = R0 * at.axis;
            }
            put(c.place, X), put(c.axis, k);
            locate(c, i, search);
            // Where this material point was along the axis before the step
            const auto e = static_cast<std::size_t>(T::get(c.element, i));
            const NodeState<V>&a = before.nodes()[e], &b = before.nodes()[e + 1];
            const auto vec = [&](const Vector<V>& x) {
                return Vec3(T::get(x.x, i), T::get(x.y, i), T::get(x.z, i));
            };
            const auto A = hermite(T::get(c.xi, i));
            const double L = T::get(properties_[e].L, i);
            const Vec3 r0 =
                A[0] * vec(a.r) + L * A[1] * vec(a.d) + A[2] * vec(b.r) + L * A[3] * vec(b.d);
            T::set(c.slide_start, i, (r0 - X0).dot(k0));
        }
    }
}

template <class V>
void RodPack<V>::add_constraints(std::size_t e, V a1, ElementSystem<V>& out) {
    const V here(static_cast<double>(e));
    for (PlacedConstraint<V>& c : constraints_) {
        const Mask mine = (c.element <= here) & (c.element >= here);
        if (!any(mine)) continue;
        const TrialNode<V>&a = trial_[e], &b = trial_[e + 1];
        const PointShape<V> A(c.xi, properties_[e].L);
        const Vector<V> r = A.a[0] * a.r + A.a[1] * a.d + A.a[2] * b.r + A.a[3] * b.d;
        const Vector<V> v = A.a[0] * a.v + A.a[1] * a.vd + A.a[2] * b.v + A.a[3] * b.vd;
        ConstraintMotion<V> motion;
        motion.g = r - c.place;
        motion.k = c.axis;
        motion.friction = c.friction;
        // against the hull's own point there; a place on the earth stands still
        V moving(0.0);
        for (int i = 0; i < lanes; ++i)
            LaneTraits<V>::set(moving, i,
                               c.at[static_cast<std::size_t>(i)].on_platform ? 1.0 : 0.0);
        motion.g_rate = v - moving * (hull_.velocity + cross(hull_.spin, r - hull_.origin));
        motion.slide = dot(motion.g, motion.k) - c.slide_start;
        motion.rubs = V(friction_on_ ? 1.0 : 0.0);
        ConstraintReading<V> reading =
            std::visit([&](const auto& law) { return load(law, motion, a1); }, c.law);
        const V on = select(mine, V(1.0), V(0.0));
        // R:22, rod rows
        const Vector<V> f = on * reading.load.force;
        const Symmetric<V>& S = reading.load.stiffness;
        V* rows[4] = {out.Ra, out.Ra + 3, out.Rb, out.Rb + 3};
        for (int i = 0; i < 4; ++i) {
            rows[i][0] -= A.a[i] * f.x, rows[i][1] -= A.a[i] * f.y, rows[i][2] -= A.a[i] * f.z;
            for (int k = 0; k < 4; ++k) {
                const V weight = on * A.a[i] * A.a[k];
                const int i0 = 3 * (i % 2), k0 = 3 * (k % 2);
                V(*block)[7] = i < 2 && k < 2 ? out.aa : i < 2 ? out.ab : k < 2 ? nullptr : out.bb;
                if (block == nullptr) continue;  // the transpose of ab
                for (int p = 0; p < 3; ++p)
                    for (int q = 0; q < 3; ++q) block[i0 + p][k0 + q] += weight * S(p, q);
            }
        }
        c.reading.load.force = select(mine, reading.load.force, c.reading.load.force);
        c.reading.load.stiffness.xx = select(mine, S.xx, c.reading.load.stiffness.xx);
        c.reading.load.stiffness.yy = select(mine, S.yy, c.reading.load.stiffness.yy);
        c.reading.load.stiffness.zz = select(mine, S.zz, c.reading.load.stiffness.zz);
        c.reading.load.stiffness.xy = select(mine, S.xy, c.reading.load.stiffness.xy);
        c.reading.load.stiffness.xz = select(mine, S.xz, c.reading.load.stiffness.xz);
        c.reading.load.stiffness.yz = select(mine, S.yz, c.reading.load.stiffness.yz);
        c.reading.magnitude = select(mine, reading.magnitude, c.reading.magnitude);
        c.reading.opening = select(mine, reading.opening, c.reading.opening);
        c.reading.friction = select(mine, reading.friction, c.reading.friction);
        c.point = select(mine, r, c.point);
    }
}

template <class V>
void RodPack<V>::carry_constraints() {
    // The force at the solution of the linear system: f + Kt sum A_i d_i (x changes by -d)
    using T = LaneTraits<V>;
    for (PlacedConstraint<V>& c : constraints_) {
        Vector<V> moved;
        for (int i = 0; i < lanes; ++i) {
            const auto e = static_cast<std::size_t>(T::get(c.element, i));
            const auto A = hermite(T::get(c.xi, i));
            const double L = T::get(properties_[e].L, i);
            const auto sum = [&](int p) {
                const V(&da)[7] = correction_[e].x, (&db)[7] = correction_[e + 1].x;
                return A[0] * T::get(da[p], i) + L * A[1] * T::get(da[3 + p], i) +
                       A[2] * T::get(db[p], i) + L * A[3] * T::get(db[3 + p], i);
            };
            T::set(moved.x, i, sum(0)), T::set(moved.y, i, sum(1)), T::set(moved.z, i, sum(2));
        }
        c.force = c.reading.load.force + c.reading.load.stiffness * moved;
    }
}

template <class V>
auto RodPack<V>::border_of_constraints(int lane, const Vec3& reference, Mat6& M) const -> Border {
    using T = LaneTraits<V>;
    const std::size_t N = properties_.size();
    std::vector<Border> K(N + 1, Border::Zero());
    const auto vec = [&](const Vector<V>& x) {
        return Vec3(T::get(x.x, lane), T::get(x.y, lane), T::get(x.z, lane));
    };
    for (const PlacedConstraint<V>& c : constraints_) {
        if (!c.at[static_cast<std::size_t>(lane)].on_platform) continue;
        const auto e = static_cast<std::size_t>(T::get(c.element, lane));
        const auto A = hermite(T::get(c.xi, lane));
        const double L = T::get(properties_[e].L, lane);
        Mat3 Kt;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) Kt(i, k) = T::get(c.reading.load.stiffness(i, k), lane);
        const Vec3 lever = vec(c.point) - reference;
        Eigen::Matrix<double, 3, 6> B;
        B << Mat3::Identity(), -skew(lever);
        // The force keeps to the hull's axes: df = -Kt dr + Q dX with Q = Kt B - [0, skew(f)].
        // Departs from R:22, which leaves the turning out.
        const Mat3 F = skew(vec(c.force));
        Eigen::Matrix<double, 3, 6> Q = Kt * B;
        Q.template rightCols<3>() -= F;
        K[e].template topRows<3>() -= A[0] * Q;
        K[e].template middleRows<3>(3) -= L * A[1] * Q;
        K[e + 1].template topRows<3>() -= A[2] * Q;
        K[e + 1].template middleRows<3>(3) -= L * A[3] * Q;
        M += B.transpose() * Kt * B;
        M.topRightCorner<3, 3>() -= F;
        M.bottomLeftCorner<3, 3>() += F;
        M.bottomRightCorner<3, 3>() -= skew(lever) * F;
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

template <class V>
void RodPack<V>::settle_constraints(Mask iterating) {
    // What a lane found in its own last iteration; later ones are its neighbours'.
    for (PlacedConstraint<V>& c : constraints_) {
        ConstraintState<V>& to = c.settled;
        to.element = select(iterating, c.element, to.element);
        to.xi = select(iterating, c.xi, to.xi);
        to.friction =
            select(iterating, V(friction_on_ ? 1.0 : 0.0) * c.reading.friction, to.friction);
        to.force = select(iterating, c.force, to.force);
        to.point = select(iterating, c.point, to.point);
        to.magnitude = select(iterating, c.reading.magnitude, to.magnitude);
        to.opening = select(iterating, c.reading.opening, to.opening);
    }
}

template <class V>
void RodPack<V>::keep_constraints(Mask accepted, RodState<V>& s) {
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        const ConstraintState<V>& c = constraints_[n].settled;
        ConstraintState<V>& to = s.constraints()[n];
        to.element = select(accepted, c.element, to.element);
        to.xi = select(accepted, c.xi, to.xi);
        to.friction = select(accepted, c.friction, to.friction);
        to.force = select(accepted, c.force, to.force);
        to.point = select(accepted, c.point, to.point);
        to.magnitude = select(accepted, c.magnitude, to.magnitude);
        to.opening = select(accepted, c.opening, to.opening);
    }
}

template <class V>
Vec3 RodPack<V>::constraint_force(int lane, int c) const {
    using T = LaneTraits<V>;
    const Vector<V>& f = working_.constraints()[c].force;
    return {T::get(f.x, lane), T::get(f.y, lane), T::get(f.z, lane)};
}
template <class V>
double RodPack<V>::constraint_magnitude(int lane, int c) const {
    return LaneTraits<V>::get(working_.constraints()[c].magnitude, lane);
}
template <class V>
double RodPack<V>::constraint_opening(int lane, int c) const {
    return LaneTraits<V>::get(working_.constraints()[c].opening, lane);
}

template void RodPack<Single>::set_constraints(const Case&);
template void RodPack<Single>::place_constraints(const RodState<Single>&, Single, Single,
                                                 const MotionSpline&, bool);
template void RodPack<Single>::add_constraints(std::size_t, Single, ElementSystem<Single>&);
template void RodPack<Single>::carry_constraints();
template RodPack<Single>::Border RodPack<Single>::border_of_constraints(int, const Vec3&,
                                                                        Mat6&) const;
template void RodPack<Single>::settle_constraints(Single::Mask);
template void RodPack<Single>::keep_constraints(Single::Mask, RodState<Single>&);
template Vec3 RodPack<Single>::constraint_force(int, int) const;
template double RodPack<Single>::constraint_magnitude(int, int) const;
template double RodPack<Single>::constraint_opening(int, int) const;
template void RodPack<Quad>::set_constraints(const Case&);
template void RodPack<Quad>::place_constraints(const RodState<Quad>&, Quad, Quad,
                                               const MotionSpline&, bool);
template void RodPack<Quad>::add_constraints(std::size_t, Quad, ElementSystem<Quad>&);
template void RodPack<Quad>::carry_constraints();
template RodPack<Quad>::Border RodPack<Quad>::border_of_constraints(int, const Vec3&, Mat6&) const;
template void RodPack<Quad>::settle_constraints(Quad::Mask);
template void RodPack<Quad>::keep_constraints(Quad::Mask, RodState<Quad>&);
template Vec3 RodPack<Quad>::constraint_force(int, int) const;
template double RodPack<Quad>::constraint_magnitude(int, int) const;
template double RodPack<Quad>::constraint_opening(int, int) const;

}  // namespace hawser::worker
