// Quasi-static lines (README.md of worker, "Line models"): the same rods, nodes and constraints
// with a = v = 0. A pass is one static solution at its end: current drag alone, no waves; what
// remembers goes on, the creep of a rope by one step R:4 of the pass's length, the friction springs
// by the way slid in it.
#include <algorithm>
#include <array>

#include "rod/lane_access.hpp"
#include "rod/rod_group.hpp"

namespace hawser::worker {

namespace {
constexpr double longest_correction = 50.0;  // [m]
constexpr int whole_corrections = 10;        // then halves: contacts that come and go
}  // namespace

template <class V>
void RodPack<V>::start_still(Mask from_prediction, V ahead) {
    // The kept shape, moved on at the rate of its last pass if no hull leads it; the others where
    // they stopped.
    const NodeState<V>* node = kept_.nodes();
    const Multiplier<V>* lambda = kept_.lambda();
    const V stretch = ahead / kept_.head().h;
    const V moves = constraints_.empty() ? ahead : V(0.0);
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const TrialNode<V>& good = reached_[n];
        const Vector<V> r = node[n].r + moves * node[n].v, d = node[n].d + moves * node[n].vd;
        trial_[n] = {.r = select(from_prediction, r, good.r),
                     .d = select(from_prediction, d, good.d),
                     .v = {},
                     .vd = {},
                     .a = {},
                     .ad = {}};
    }
    for (std::size_t i = 0; i < lambda_.size(); ++i)
        lambda_[i] =
            select(from_prediction, lambda[i].now + stretch * (lambda[i].now - lambda[i].before),
                   reached_lambda_[i]);
}

template <class V>
void RodPack<V>::carry_with_hull(int lane, const PlatformMotion& from, const PlatformMotion& to) {
    // A rod in guides goes where the hull goes: as far down as the hull holds it, and in proportion
    // to the height from there to end B. Along itself it stays, there it slides. From anywhere else
    // Newton's iteration would have to find the guides that touch it anew.
    using T = LaneTraits<V>;
    const auto& arc = arc_length_[static_cast<std::size_t>(lane)];  // from end B
    double lowest = arc.back();
    bool held = false;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
        if (!constraints_[c].at[static_cast<std::size_t>(lane)].on_platform) continue;
        if (constraints_[c].hull != leading_hull()) continue;
        const auto e = static_cast<std::size_t>(T::get(kept_.constraints()[c].element, lane));
        lowest = std::min(lowest, arc[e]);
        held = true;
    }
    if (!held || lowest <= 0.0) return;
    const Mat3 turn = rotation(to.angles) * rotation(from.angles).transpose();
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const Vec3 r = lane_vector(trial_[n].r, lane), d = lane_vector(trial_[n].d, lane);
        const Vec3 along = d.normalized();
        Vec3 moved = to.position + turn * (r - from.position) - r;
        moved -= moved.dot(along) * along;
        const double part = std::min(1.0, arc[n] / lowest);
        set_lane_vector(trial_[n].r, lane, r + part * moved);
        Vec3 slope = d + part * (turn * d - d);
        if (arc[n] < lowest) slope += moved / lowest;
        set_lane_vector(trial_[n].d, lane, slope);
    }
}

template <class V>
void RodPack<V>::current_at(double t, const MotionSpline& platform) {
    const double factor = sea_->current_factor(t);
    current_only(factor > 0.0, V(t), platform);
    if (factor == 1.0) return;
    current_share_ *= factor;
    for (Water<V>& w : water_) w.u = V(factor) * w.u;
}

template <class V>
void RodPack<V>::begin_still_attempt(V t, const MotionSpline& platform) {
    end_a_ = end_values(place_a_, kept_.head().axis_a, t, platform);
    end_b_ = end_values(place_b_, kept_.head().axis_b, t, platform);
    if (place_a_.prescribed()) trial_.back().r = end_a_.position;
    if (place_b_.prescribed()) trial_.front().r = end_b_.position;
    friction_on_ = true;
}

template <class V>
auto RodGroup<V>::still_attempt(Mask wanted, double t0, double t1, V t,
                                const MotionSpline& platform) -> Mask {
    for (RodPack<V>& p : packs_) p.begin_still_attempt(t, platform);
    Mask iterating = wanted, solved = LaneTraits<V>::none();
    const NewtonControl& newton = packs_.front().newton;
    for (int i = 0; i < newton.still_iterations && any(iterating); ++i) {
        Mask fits = wanted;
        for (RodPack<V>& p : packs_) {
            // the first correction brings every point to within centimetres of its place
            if (i < 2) p.current_at(t1, platform);
            if (!p.curves_.empty()) fits = fits & p.follow_curves(iterating, &p.kept_, V(t1 - t0));
        }
        place(&RodPack<V>::kept_, V(t0), t, platform, false);
        evaluate(V(0.0));
        solve(V(0.0), V(0.0));
        const V part(i < whole_corrections ? 1.0 : 0.5);
        Mask sound = iterating, done = iterating;
        for (RodPack<V>& p : packs_) {
            V correction, finite;
            p.update_trial(iterating, V(0.0), V(0.0), part, V(longest_correction), correction,
                           finite);
            RodHead<V>& head = p.working_.head();
            head.force_a = select(iterating, p.reaction_a_, head.force_a);
            head.force_b = select(iterating, p.reaction_b_, head.force_b);
            head.moment_a = select(iterating, p.moment_a_, head.moment_a);
            head.moment_b = select(iterating, p.moment_b_, head.moment_b);
            sound = sound & (finite <= V(0.0));
            done = done & (correction <= V(newton.still_tolerance));
        }
        evaluate(V(0.0));
        for (RodPack<V>& p : packs_)
            if (!p.constraints_.empty()) p.settle_constraints(iterating);
        done = done & sound & fits;
        solved = solved | done;
        iterating = sound & !done;
    }
    return solved;
}

template <class V>
void RodPack<V>::begin_still_pass(double t0, double t1, const MotionSpline& platform) {
    static_ = true;
    working_ = kept_;
    begin_handing_over(t0, t1, platform);
    ++work_.passes;
    ++work_.steps;
    work_.rod_time += t1 - t0;
    parted_ = released_ = LaneTraits<V>::none(), dead_ = V(-1.0);
    if (winds_) pay_out(V(t1));
    prepare_material(kept_, V(t1 - t0));
    const NodeState<V>* before = kept_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n)
        reached_[n] = {.r = before[n].r, .d = before[n].d, .v = {}, .vd = {}, .a = {}, .ad = {}};
    for (std::size_t i = 0; i < lambda_.size(); ++i) reached_lambda_[i] = kept_.lambda()[i].now;
}

template <class V>
void RodPack<V>::reach(Mask good) {
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        reached_[n].r = select(good, trial_[n].r, reached_[n].r);
        reached_[n].d = select(good, trial_[n].d, reached_[n].d);
    }
    for (std::size_t i = 0; i < lambda_.size(); ++i)
        reached_lambda_[i] = select(good, lambda_[i], reached_lambda_[i]);
}

template <class V>
void RodPack<V>::end_still_pass(Mask solved, double t0, double t1, const MotionSpline& platform) {
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        trial_[n].r = reached_[n].r, trial_[n].d = reached_[n].d;
        trial_[n].v = trial_[n].vd = trial_[n].a = trial_[n].ad = Vector<V>{};
    }
    for (std::size_t i = 0; i < lambda_.size(); ++i) lambda_[i] = reached_lambda_[i];
    const double H = t1 - t0;
    accept(solved, V(H), V(t1));
    const NodeState<V>* before = kept_.nodes();
    NodeState<V>* after = working_.nodes();
    const V per_time(1.0 / H);
    for (std::size_t n = 0; n < trial_.size(); ++n) {  // the rate at which the shape changes
        after[n].v = select(solved, per_time * (after[n].r - before[n].r), after[n].v);
        after[n].vd = select(solved, per_time * (after[n].d - before[n].d), after[n].vd);
    }
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) take_wrench(i, platform, t1);
    for (std::size_t c = 0; c < constraints_.size(); ++c)
        constraints_[c].fitted = working_.constraints()[c].force;
    end_handing_over();
}

template <class V>
Status RodGroup<V>::still_pass(double t0, double t1, const MotionSpline& platform) {
    using T = LaneTraits<V>;
    for (RodPack<V>& p : packs_) p.begin_still_pass(t0, t1, platform);
    const double H = t1 - t0;

    // Straight to t1 as a rule; a lane that fails goes there in parts of the platform's way, which
    // lead Newton's iteration and leave no other trace.
    struct Walk {
        double reached = 0.0, part = 1.0;
        int tried = 0;
    };
    std::array<Walk, static_cast<std::size_t>(lanes)> walk;
    Mask active = used(), solved = T::none(), fresh = used();
    Status failed;
    const int lines = static_cast<int>(packs_.front().lines_.size());
    while (any(active)) {
        V t(t1);
        for (int i = 0; i < lines; ++i) {
            const Walk& w = walk[static_cast<std::size_t>(i)];
            const double q = w.reached + w.part;
            T::set(t, i, q < 1.0 ? t0 + q * H : t1);
        }
        for (RodPack<V>& p : packs_) {
            p.start_still(fresh, V(H));
            for (int i = 0; i < lines && !p.constraints_.empty(); ++i)
                if (T::get(active, i)) {
                    const MotionSpline& hull = p.motion_of(p.leading_hull(), platform);
                    p.carry_with_hull(
                        i, hull.at(t0 + walk[static_cast<std::size_t>(i)].reached * H).motion,
                        hull.at(T::get(t, i)).motion);
                }
        }
        const Mask found = still_attempt(active, t0, t1, t, platform);
        Mask untrue = T::none();
        for (const RodPack<V>& p : packs_) untrue = untrue | (found & p.false_equilibria());
        const Mask good = found & !untrue;
        for (RodPack<V>& p : packs_) {
            p.reach(good);
            p.keep_constraints(good, V(H), p.kept_, p.working_);
        }
        fresh = T::none();
        for (int i = 0; i < lines; ++i) {
            if (!T::get(active, i)) continue;
            Walk& w = walk[static_cast<std::size_t>(i)];
            ++w.tried;
            if (T::get(good, i)) {
                w.reached += w.part;
                if (w.reached >= 1.0) {
                    T::set(solved, i, true);
                    T::set(active, i, false);
                }
            } else if (w.tried < packs_.front().newton.still_parts) {
                if (w.tried > 1) w.part *= 0.5;  // once again from the kept shape itself
            } else {
                Mask bad = T::none();
                T::set(bad, i, true);
                const Status its = status_of(bad,
                                             T::get(untrue, i) ? Status::Code::false_equilibrium
                                                               : Status::Code::no_equilibrium,
                                             T::get(t, i));
                if (failed.ok() || its.line < failed.line) failed = its;
                T::set(active, i, false);
            }
        }
    }
    for (RodPack<V>& p : packs_) p.end_still_pass(solved, t0, t1, platform);
    return failed;
}

template auto RodGroup<Single>::still_pass(double, double, const MotionSpline&) -> Status;
template auto RodGroup<Quad>::still_pass(double, double, const MotionSpline&) -> Status;

}  // namespace hawser::worker
