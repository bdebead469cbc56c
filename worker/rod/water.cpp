// The water at a pack's Gauss points: one clock for all passes, R:19, P:6. Departs from P:5w: a
// sample is made once, from the kept state, and serves as right and then as left end of its
// intervals, so that all passes see the same waves and their history is continuous.
#include <algorithm>
#include <cmath>

#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"
#include "rod/section_forces.hpp"

namespace hawser::worker {

namespace {

constexpr double shelter_margin = 5.0;  // inside the shelter beyond which nothing is sampled [m]

/// Position of a Gauss point of an element between two nodes, R:7, and its velocity.
template <class V, class Node>
Vector<V> point_of(const Node& a, const Node& b, V L, std::size_t g) {
    return V(shape.A[g][0]) * a.r + V(shape.A[g][1]) * (L * a.d) + V(shape.A[g][2]) * b.r +
           V(shape.A[g][3]) * (L * b.d);
}
template <class V, class Node>
Vector<V> velocity_of(const Node& a, const Node& b, V L, std::size_t g) {
    return V(shape.A[g][0]) * a.v + V(shape.A[g][1]) * (L * a.vd) + V(shape.A[g][2]) * b.v +
           V(shape.A[g][3]) * (L * b.vd);
}

}  // namespace

template <class V>
void RodPack<V>::refresh_water(double until, const PlatformMotion& hull) {
    if (!sea_->has_waves() && !sea_->has_current()) return;
    const double t = LaneTraits<V>::get(kept_.head().t, 0);
    // Every sample up to the first grid time at or after `until`, from the kept state.
    const auto last = static_cast<std::int64_t>(std::ceil(until / wave_step_ - 1e-9));
    const auto first = static_cast<std::int64_t>(std::floor(t / wave_step_ + 1e-9));
    const auto slabs = static_cast<std::int64_t>(kept_.slabs());
    const auto sampled = static_cast<std::int64_t>(LaneTraits<V>::get(kept_.head().wave_index, 0));
    if (winds_) pay_out(kept_.head().t);
    for (std::int64_t j = std::max(sampled + 1, first); j <= last; ++j)
        sample_slab(static_cast<double>(j) * wave_step_, static_cast<std::size_t>(j % slabs), hull);
    kept_.head().wave_index = V(static_cast<double>(std::max(sampled, last)));
}

template <class V>
template <class Where, class Needed>
int RodPack<V>::gather_points(Where&& where, Needed&& needed) {
    using Lane = LaneTraits<V>;
    const std::size_t points = kept_.points();
    std::size_t n = 0;
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const Vector<V> x = where(e, g);
            const Mask wanted = needed(e, g);
            for (std::size_t i = 0; i < lines_.size(); ++i) {
                int& slot = slot_[i * points + e * gauss_points + g];
                slot = -1;
                if (!Lane::get(wanted, static_cast<int>(i))) continue;
                slot = static_cast<int>(n);
                xs_[n] = Lane::get(x.x, static_cast<int>(i));
                ys_[n] = Lane::get(x.y, static_cast<int>(i));
                zs_[n] = Lane::get(x.z, static_cast<int>(i));
                ++n;
            }
        }
    }
    return static_cast<int>(n);
}

template <class V>
void RodPack<V>::sample_slab(double T, std::size_t slab, const PlatformMotion& hull) {
    const NodeState<V>* node = kept_.nodes();
    const V ahead = V(T) - kept_.head().t;
    const Vec3 up = rotation(hull.angles).col(2);
    const V origin(up.dot(hull.position)), deep = sheltered_above_ + V(shelter_margin);
    const int n = gather_points(
        [&](std::size_t e, std::size_t g) {
            const V L = properties_[e].L;
            return point_of(node[e], node[e + 1], L, g) +
                   ahead * velocity_of(node[e], node[e + 1], L, g);
        },
        [&](std::size_t e, std::size_t g) {
            if (!shelters_) return used_;
            const V L = properties_[e].L;
            const Vector<V> r = point_of(node[e], node[e + 1], L, g);
            const V height = V(up.x()) * r.x + V(up.y()) * r.y + V(up.z()) * r.z - origin -
                             V(gauss_weight[g]) * L;
            return used_ & (height < deep);
        });
    const WaterKinematics out{.ux = ux_.data(),
                              .uy = uy_.data(),
                              .uz = uz_.data(),
                              .ax = ax_.data(),
                              .ay = ay_.data(),
                              .az = az_.data(),
                              .eta = eta_.data()};
    sea_->sample(T, n, xs_.data(), ys_.data(), zs_.data(), out);
    work_.water_samples += n;
    scatter_water(kept_.water(slab));
}

template <class V>
void RodPack<V>::scatter_water(Water<V>* to) {
    using Lane = LaneTraits<V>;
    const std::size_t points = kept_.points();
    for (int i = 0; i < lanes; ++i) {
        const std::size_t source =
            static_cast<std::size_t>(i) < lines_.size() ? static_cast<std::size_t>(i) : 0;
        for (std::size_t p = 0; p < points; ++p) {
            const int slot = slot_[source * points + p];
            const bool none = slot < 0;
            const auto k = static_cast<std::size_t>(none ? 0 : slot);
            const auto put = [&](V& v, const std::vector<double>& from) {
                Lane::set(v, i, none ? 0.0 : from[k]);
            };
            Water<V>& w = to[p];
            put(w.u.x, ux_), put(w.u.y, uy_), put(w.u.z, uz_);
            put(w.ud.x, ax_), put(w.ud.y, ay_), put(w.ud.z, az_);
            put(w.eta, eta_);
        }
    }
}

template <class V>
template <class Node>
void RodPack<V>::shelter_water(V t, const MotionSpline& platform, bool moves, const Node* nodes,
                               std::vector<Water<V>>& to) const {
    // Where a point lies above `sheltered_above` on the platform the water is the platform's: its
    // velocity and acceleration there (K:5), no wave, no current, calm surface. The section a point
    // stands for crosses the border gradually, like the free surface in R:18.
    Vector<V> origin, up, velocity, spin, acceleration, spin_rate;
    for (int i = 0; i < lanes; ++i) {
        const MotionSpline::Sample now =
            motion_of(place_a_.hull, platform).at(LaneTraits<V>::get(t, i));
        const PlatformMotion& m = now.motion;
        set_lane_vector(origin, i, m.position);
        set_lane_vector(up, i, rotation(m.angles).col(2));
        if (!moves) continue;
        set_lane_vector(velocity, i, m.velocity);
        set_lane_vector(spin, i, angular_velocity(m));
        set_lane_vector(acceleration, i, now.acceleration.position);
        set_lane_vector(spin_rate, i,
                        angular_velocity_matrix(m.angles) * now.acceleration.angles +
                            angular_velocity_matrix_rate(m.angles, m.angle_rates) * m.angle_rates);
    }
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const V L = properties_[e].L;
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const Vector<V> l = point_of(nodes[e], nodes[e + 1], L, g) - origin;
            const V piece = properties_[e].D + V(gauss_weight[g]) * L;
            const V in = min(max(V(0.5) + (dot(l, up) - sheltered_above_) / piece, V(0.0)), V(1.0));
            if (!any(in > V(0.0))) continue;
            Water<V>& w = to[e * gauss_points + g];
            w.u += in * (velocity + cross(spin, l) - w.u);
            w.ud += in * (acceleration + cross(spin_rate, l) + cross(spin, cross(spin, l)) - w.ud);
            w.eta -= in * w.eta;
        }
    }
}

template <class V>
void RodPack<V>::interpolate_water(V t, std::vector<Water<V>>& to) const {
    if (!sea_->has_waves() && !sea_->has_current()) {
        std::fill(to.begin(), to.end(), Water<V>{});
        return;
    }
    using Lane = LaneTraits<V>;
    const auto slabs = static_cast<std::int64_t>(kept_.slabs());
    V fraction{};
    std::array<std::int64_t, static_cast<std::size_t>(lanes)> j{};
    bool together = true;
    for (int i = 0; i < lanes; ++i) {
        const double q = Lane::get(t, i) / wave_step_;
        // A time on the grid belongs to the interval before it: its right end is always there.
        const auto k =
            std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(q - 1e-9)) - 1);
        j[static_cast<std::size_t>(i)] = k;
        Lane::set(fraction, i, q - static_cast<double>(k));
        together = together && k == j[0];
    }
    const auto blend = [&](const Water<V>& left, const Water<V>& right) {
        return Water<V>{.u = left.u + fraction * (right.u - left.u),
                        .ud = left.ud + fraction * (right.ud - left.ud),
                        .eta = left.eta + fraction * (right.eta - left.eta)};
    };
    if (together) {
        const Water<V>* left = working_.water(static_cast<std::size_t>(j[0] % slabs));
        const Water<V>* right = working_.water(static_cast<std::size_t>((j[0] + 1) % slabs));
        for (std::size_t p = 0; p < to.size(); ++p) to[p] = blend(left[p], right[p]);
        return;
    }
    for (int i = 0; i < lanes; ++i) {  // lanes in different intervals: blend for each, take its own
        const auto k = j[static_cast<std::size_t>(i)];
        const Water<V>* left = working_.water(static_cast<std::size_t>(k % slabs));
        const Water<V>* right = working_.water(static_cast<std::size_t>((k + 1) % slabs));
        auto mine = Lane::none();
        Lane::set(mine, i, true);
        for (std::size_t p = 0; p < to.size(); ++p) {
            const Water<V> w = blend(left[p], right[p]);
            to[p].u = select(mine, w.u, to[p].u);
            to[p].ud = select(mine, w.ud, to[p].ud);
            to[p].eta = select(mine, w.eta, to[p].eta);
        }
    }
}

template <class V>
void RodPack<V>::current_only(bool current, V t, const MotionSpline& platform) {
    platform_ = platform;
    current_share_ = current && sea_->has_current() ? 1.0 : 0.0;
    if (current_share_ == 0.0) {
        std::fill(water_.begin(), water_.end(), Water<V>{});
        return;
    }
    const int n = gather_points(
        [&](std::size_t e, std::size_t g) {
            return point_of(trial_[e], trial_[e + 1], properties_[e].L, g);
        },
        [&](std::size_t, std::size_t) { return used_; });
    const WaterKinematics out{.ux = ux_.data(),
                              .uy = uy_.data(),
                              .uz = uz_.data(),
                              .ax = ax_.data(),
                              .ay = ay_.data(),
                              .az = az_.data(),
                              .eta = eta_.data()};
    sea_->sample_current(n, xs_.data(), ys_.data(), zs_.data(), out);
    scatter_water(water_.data());
    if (shelters_) shelter_water(t, platform, false, trial_.data(), water_);
}

template <class V>
void RodPack<V>::water_of_state(SectionForces<V>& out) const {
    // Not what the last step left in its workspace: that of a lane which was done before its
    // neighbours belongs to where it was predicted to go.
    const NodeState<V>* node = working_.nodes();
    const V t = working_.head().t;
    std::vector<Water<V>>& to = out.water;
    if (!static_) {
        interpolate_water(t, to);
        if (shelters_) shelter_water(t, platform_, true, node, to);
        return;
    }
    std::fill(to.begin(), to.end(), Water<V>{});
    if (current_share_ == 0.0) return;
    const V share(current_share_);
    for (int i = 0; i < lanes; ++i) {
        std::array<double, gauss_points> x{}, y{}, z{}, ux{}, uy{}, uz{}, ax{}, ay{}, az{}, eta{};
        const WaterKinematics kinematics{.ux = ux.data(),
                                         .uy = uy.data(),
                                         .uz = uz.data(),
                                         .ax = ax.data(),
                                         .ay = ay.data(),
                                         .az = az.data(),
                                         .eta = eta.data()};
        for (std::size_t e = 0; e < properties_.size(); ++e) {
            for (std::size_t g = 0; g < gauss_points; ++g) {
                const Vec3 r = lane_vector(point_of(node[e], node[e + 1], properties_[e].L, g), i);
                x[g] = r.x(), y[g] = r.y(), z[g] = r.z();
            }
            sea_->sample_current(gauss_points, x.data(), y.data(), z.data(), kinematics);
            for (std::size_t g = 0; g < gauss_points; ++g)
                set_lane_vector(to[e * gauss_points + g].u, i, Vec3(ux[g], uy[g], uz[g]));
        }
    }
    if (shelters_) shelter_water(t, platform_, false, node, to);
    for (Water<V>& w : to) w.u = share * w.u;
}

template void RodPack<Single>::refresh_water(double, const PlatformMotion&);
template void RodPack<Single>::interpolate_water(Single, std::vector<Water<Single>>&) const;
template void RodPack<Single>::shelter_water(Single, const MotionSpline&, bool,
                                             const TrialNode<Single>*,
                                             std::vector<Water<Single>>&) const;
template void RodPack<Single>::water_of_state(SectionForces<Single>&) const;
template void RodPack<Single>::current_only(bool, Single, const MotionSpline&);
template void RodPack<Quad>::refresh_water(double, const PlatformMotion&);
template void RodPack<Quad>::interpolate_water(Quad, std::vector<Water<Quad>>&) const;
template void RodPack<Quad>::shelter_water(Quad, const MotionSpline&, bool, const TrialNode<Quad>*,
                                           std::vector<Water<Quad>>&) const;
template void RodPack<Quad>::water_of_state(SectionForces<Quad>&) const;
template void RodPack<Quad>::current_only(bool, Quad, const MotionSpline&);

}  // namespace hawser::worker
