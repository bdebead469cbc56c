// What a pass hands to the platform: the load at its end or a fit (P:5), the impulse that rod and
// platform took from each constraint (R:40), and the carry that makes the two agree (R:48).
#include "force_fit.hpp"
#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

namespace {
/// Passes of the paper's step; the platform's first rate is that of the step before.
constexpr int passes_per_step = 4;

/// What four rates of a step D put into the platform's momentum.
template <class Load, class Number>
Load impulse_of_rates(Number D, const Load& first, const std::array<Load, 3>& used) {
    const Number part = D / Number(6.0), two(2.0);
    return part * (first + two * used[0] + two * used[1] + used[2]);
}
}  // namespace

template <class V>
bool RodPack<V>::matches_impulse() const {
    return force_ == ForceFit::impulse_matched && model_ == LineModel::dynamic;
}

template <class V>
void RodPack<V>::begin_handing_over(double t0, double t1, const MotionSpline& platform) {
    ++passes_since_keep_;
    pass_length_ = t1 - t0;
    for (PlacedConstraint<V>& c : constraints_) c.fitted = {};
    for (int i = 0; i < lanes; ++i) {
        const auto u = static_cast<std::size_t>(i);
        for (std::size_t k = 0; k < hulls(); ++k) {
            fitted_[k][u].setZero();
            if (!matches_impulse() || passes_since_keep_ != passes_per_step) continue;
            handed_[k][u].load = wrench_at(i, k, platform, t0);
            handed_[k][u].given.setZero();
        }
    }
}

template <class V>
void RodPack<V>::add_to_fit(int lane, int i, int n, const MotionSpline& platform) {
    const double weight = fit_weight(force_, i, n);
    if (weight == 0.0) return;
    const double t = LaneTraits<V>::get(working_.head().t, lane);
    for (std::size_t k = 0; k < hulls(); ++k)
        fitted_[k][static_cast<std::size_t>(lane)] += weight * wrench_at(lane, k, platform, t);
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
        const Vec3 sum = lane_vector(constraints_[c].fitted, lane) +
                         weight * lane_vector(working_.constraints()[c].force, lane);
        set_lane_vector(constraints_[c].fitted, lane, sum);
    }
}

template <class V>
void RodPack<V>::add_to_given(int lane, double h, const MotionSpline& platform) {
    if (!matches_impulse() || passes_since_keep_ != passes_per_step) return;
    const double t = LaneTraits<V>::get(working_.head().t, lane);
    for (std::size_t k = 0; k < hulls(); ++k) {
        LaneHandedOver& to = handed_[k][static_cast<std::size_t>(lane)];
        const Vec6 now = wrench_at(lane, k, platform, t);
        to.given += 0.5 * h * (to.load + now);
        to.load = now;
    }
}

template <class V>
void RodPack<V>::end_handing_over() {
    const int pass = passes_since_keep_;
    if (pass > passes_per_step) return;  // not the paper's scheme: keep() forgets
    const bool step_ends = pass == passes_per_step;
    const double D = pass <= 2 ? 2.0 * pass_length_ : pass_length_;  // P:3
    const auto stage = static_cast<std::size_t>(pass - 1);
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        PlacedConstraint<V>& c = constraints_[n];
        ConstraintState<V>& s = working_.constraints()[n];
        if (step_ends) s.hull_impulse += impulse_of_rates(V(D), s.hull_force, c.used);
        const ConstraintState<V>& from = step_ends ? s : kept_.constraints()[n];
        if (matches_impulse()) c.fitted += V(1.0 / D) * (from.impulse - from.hull_impulse);
        if (step_ends)
            s.hull_force = c.fitted;
        else
            c.used[stage] = c.fitted;
    }
    if (!matches_impulse()) return;
    for (std::size_t k = 0; k < hulls(); ++k) {
        HandedState<V>& hull = working_.head().handed[k];
        for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
            LaneHandedOver& h = handed_[k][static_cast<std::size_t>(i)];
            Vec6& returned = fitted_[k][static_cast<std::size_t>(i)];
            Vec6 owed = lane_wrench(hull.owed_force, hull.owed_moment, i);
            if (step_ends) {
                const Vec6 first = lane_wrench(hull.hull_force, hull.hull_moment, i);
                owed += h.given - impulse_of_rates(D, first, h.used);
                set_lane_wrench(hull.owed_force, hull.owed_moment, i, owed);
            }
            returned += owed / D;
            if (step_ends)
                set_lane_wrench(hull.hull_force, hull.hull_moment, i, returned);
            else
                h.used[stage] = returned;
        }
    }
}

template <class V>
void RodPack<V>::take_static_load(const PlatformMotion& pose) {
    // the platform's first rate takes it; keep_constraints does the same for each constraint
    RodHead<V>& head = kept_.head();
    const MotionSpline still(0.0, pose, 0.0, pose);
    for (std::size_t k = 0; k < hulls(); ++k) {
        HandedState<V>& hull = head.handed[k];
        hull.owed_force = hull.owed_moment = {};
        for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
            Vec6& load = fitted_[k][static_cast<std::size_t>(i)];
            load = wrench_at(i, k, still, 0.0);
            set_lane_wrench(hull.hull_force, hull.hull_moment, i, load);
        }
    }
    working_.head() = head;
    passes_since_keep_ = 0;
}

template <class V>
Vec6 RodPack<V>::wrench_at(int lane, std::size_t hull, const MotionSpline& platform,
                           double t) const {
    const auto k = static_cast<int>(hull);
    return wrench(lane, motion_of(k, platform).at(t).motion.position, k);
}

template <class V>
void RodPack<V>::take_wrench(int lane, const MotionSpline& platform, double t) {
    for (std::size_t k = 0; k < hulls(); ++k)
        fitted_[k][static_cast<std::size_t>(lane)] = wrench_at(lane, k, platform, t);
}

template <class V>
void RodPack<V>::keep() {
    if (passes_since_keep_ != passes_per_step) {  // nothing is known of the platform's rates
        for (std::size_t k = 0; k < hulls(); ++k) {
            HandedState<V>& hull = working_.head().handed[k];
            hull.owed_force = hull.owed_moment = {};
            for (int i = 0; matches_impulse() && i < static_cast<int>(lines_.size()); ++i)
                set_lane_wrench(hull.hull_force, hull.hull_moment, i,
                                fitted_[k][static_cast<std::size_t>(i)]);
        }
        for (std::size_t n = 0; n < constraints_.size(); ++n) {
            ConstraintState<V>& s = working_.constraints()[n];
            s.impulse = s.hull_impulse = {};
            s.impulse_size = V(0.0);
            s.hull_force = constraints_[n].fitted;
        }
    }
    passes_since_keep_ = 0;
    kept_ = working_;
}

template void RodPack<Single>::begin_handing_over(double, double, const MotionSpline&);
template void RodPack<Single>::add_to_fit(int, int, int, const MotionSpline&);
template void RodPack<Single>::add_to_given(int, double, const MotionSpline&);
template void RodPack<Single>::end_handing_over();
template void RodPack<Single>::take_static_load(const PlatformMotion&);
template void RodPack<Single>::take_wrench(int, const MotionSpline&, double);
template void RodPack<Single>::keep();
template void RodPack<Quad>::begin_handing_over(double, double, const MotionSpline&);
template void RodPack<Quad>::add_to_fit(int, int, int, const MotionSpline&);
template void RodPack<Quad>::add_to_given(int, double, const MotionSpline&);
template void RodPack<Quad>::end_handing_over();
template void RodPack<Quad>::take_static_load(const PlatformMotion&);
template void RodPack<Quad>::take_wrench(int, const MotionSpline&, double);
template void RodPack<Quad>::keep();

}  // namespace hawser::worker
