// The water at a pack's Gauss points: one clock for all passes, R:19, P:6. Departs from P:5w: a
// sample is made once, from the kept state, and serves as right and then as left end of its
// intervals, so that all passes see the same waves and their history is continuous.
#include <algorithm>
#include <cmath>

#include "rod/rod_pack.hpp"

namespace hawser::worker {

template <class V>
void RodPack<V>::refresh_water(double until) {
    if (!sea_->has_waves() && !sea_->has_current()) return;
    const double t = LaneTraits<V>::get(kept_.head().t, 0);
    // Every sample up to the first grid time at or after `until`, from the kept state.
    const auto last = static_cast<std::int64_t>(std::ceil(until / wave_step_ - 1e-9));
    const auto first = static_cast<std::int64_t>(std::floor(t / wave_step_ + 1e-9));
    const auto slabs = static_cast<std::int64_t>(kept_.slabs());
    const auto sampled = static_cast<std::int64_t>(LaneTraits<V>::get(kept_.head().wave_index, 0));
    for (std::int64_t j = std::max(sampled + 1, first); j <= last; ++j)
        sample_slab(static_cast<double>(j) * wave_step_, static_cast<std::size_t>(j % slabs));
    kept_.head().wave_index = V(static_cast<double>(std::max(sampled, last)));
}

template <class V>
void RodPack<V>::sample_slab(double T, std::size_t slab) {
    using Lane = LaneTraits<V>;
    const std::size_t points = kept_.points();
    const auto used = lines_.size();
    const NodeState<V>* node = kept_.nodes();
    const V ahead = V(T) - kept_.head().t;
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const NodeState<V>&a = node[e], &b = node[e + 1];
        const V L = properties_[e].L;
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const V A1(shape.A[g][0]), A2(shape.A[g][1]), A3(shape.A[g][2]), A4(shape.A[g][3]);
            const Vector<V> r = A1 * a.r + A2 * (L * a.d) + A3 * b.r + A4 * (L * b.d);
            const Vector<V> v = A1 * a.v + A2 * (L * a.vd) + A3 * b.v + A4 * (L * b.vd);
            const Vector<V> x = r + ahead * v;
            for (std::size_t i = 0; i < used; ++i) {
                const std::size_t k = i * points + e * gauss_points + g;
                xs_[k] = Lane::get(x.x, static_cast<int>(i));
                ys_[k] = Lane::get(x.y, static_cast<int>(i));
                zs_[k] = Lane::get(x.z, static_cast<int>(i));
            }
        }
    }
    const WaterKinematics out{.ux = ux_.data(),
                              .uy = uy_.data(),
                              .uz = uz_.data(),
                              .ax = ax_.data(),
                              .ay = ay_.data(),
                              .az = az_.data(),
                              .eta = eta_.data()};
    const auto n = static_cast<int>(used * points);
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
            const std::size_t k = source * points + p;
            Water<V>& w = to[p];
            Lane::set(w.u.x, i, ux_[k]), Lane::set(w.u.y, i, uy_[k]);
            Lane::set(w.u.z, i, uz_[k]), Lane::set(w.ud.x, i, ax_[k]);
            Lane::set(w.ud.y, i, ay_[k]), Lane::set(w.ud.z, i, az_[k]);
            Lane::set(w.eta, i, eta_[k]);
        }
    }
}

template <class V>
void RodPack<V>::interpolate_water(V t) {
    if (!sea_->has_waves() && !sea_->has_current()) {
        std::fill(water_.begin(), water_.end(), Water<V>{});
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
        for (std::size_t p = 0; p < water_.size(); ++p) water_[p] = blend(left[p], right[p]);
        return;
    }
    for (int i = 0; i < lanes; ++i) {  // lanes in different intervals: blend for each, take its own
        const auto k = j[static_cast<std::size_t>(i)];
        const Water<V>* left = working_.water(static_cast<std::size_t>(k % slabs));
        const Water<V>* right = working_.water(static_cast<std::size_t>((k + 1) % slabs));
        auto mine = Lane::none();
        Lane::set(mine, i, true);
        for (std::size_t p = 0; p < water_.size(); ++p) {
            const Water<V> w = blend(left[p], right[p]);
            water_[p].u = select(mine, w.u, water_[p].u);
            water_[p].ud = select(mine, w.ud, water_[p].ud);
            water_[p].eta = select(mine, w.eta, water_[p].eta);
        }
    }
}

template <class V>
void RodPack<V>::current_only(bool current) {
    if (!current || !sea_->has_current()) {
        std::fill(water_.begin(), water_.end(), Water<V>{});
        return;
    }
    using Lane = LaneTraits<V>;
    const std::size_t points = kept_.points();
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const TrialNode<V>&a = trial_[e], &b = trial_[e + 1];
        const V L = properties_[e].L;
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const Vector<V> x = V(shape.A[g][0]) * a.r + V(shape.A[g][1]) * (L * a.d) +
                                V(shape.A[g][2]) * b.r + V(shape.A[g][3]) * (L * b.d);
            for (std::size_t i = 0; i < lines_.size(); ++i) {
                const std::size_t k = i * points + e * gauss_points + g;
                xs_[k] = Lane::get(x.x, static_cast<int>(i));
                ys_[k] = Lane::get(x.y, static_cast<int>(i));
                zs_[k] = Lane::get(x.z, static_cast<int>(i));
            }
        }
    }
    const WaterKinematics out{.ux = ux_.data(),
                              .uy = uy_.data(),
                              .uz = uz_.data(),
                              .ax = ax_.data(),
                              .ay = ay_.data(),
                              .az = az_.data(),
                              .eta = eta_.data()};
    sea_->sample_current(static_cast<int>(lines_.size() * points), xs_.data(), ys_.data(),
                         zs_.data(), out);
    scatter_water(water_.data());
}

template void RodPack<Single>::refresh_water(double);
template void RodPack<Single>::interpolate_water(Single);
template void RodPack<Single>::current_only(bool);
template void RodPack<Quad>::refresh_water(double);
template void RodPack<Quad>::interpolate_water(Quad);
template void RodPack<Quad>::current_only(bool);

}  // namespace hawser::worker
