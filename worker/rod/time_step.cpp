// Time steps and passes of rods, R:27 to R:29, with the halving of steps that fail: what a pack
// does by itself, and the clocks of its group.
#include <algorithm>
#include <array>
#include <cmath>

#include "rod/lane_access.hpp"
#include "rod/rod_group.hpp"

namespace hawser::worker {

template <class V>
void RodPack<V>::prepare_material(const RodState<V>& s, V h) {
    const V g(scheme_.g_damper);
    const V ratio((1.0 - scheme_.g_damper) / scheme_.g_damper);
    const V inverse_gh = V(1.0) / (g * h), inverse_half_h = V(2.0) / h;
    const Strain<V>* strain = s.strain();
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const ElementProperties<V>& p = properties_[e];
        // R:4 for the damper (weight g) and the creep element (weight 1/2)
        const V s1 = V(1.0) / (p.K_damper + p.c_damper * inverse_gh);
        const V s2 = V(1.0) / (p.K_creep + p.c_creep * inverse_half_h);
        for (std::size_t k = 0; k < gauss_points; ++k) {
            material_[e].s[k] = s1 + s2;
            const Strain<V>& q = strain[e * gauss_points + k];
            material_[e].b[k] = s1 * p.c_damper * (q.damper * inverse_gh + ratio * q.damper_rate) +
                                s2 * p.c_creep * (q.creep * inverse_half_h + q.creep_rate);
        }
    }
}

template <class V>
void RodPack<V>::predict(const RodState<V>& s, V h) {
    // Section 5.1: a1 = a0, A1 from the average, x and v from the formulas; lambda along its last
    // slope, R:29.
    const V from_a(1.0 / (1.0 - scheme_.am)), from_A(-scheme_.am / (1.0 - scheme_.am));
    const V half_less(0.5 - scheme_.beta), beta(scheme_.beta), gamma(scheme_.gamma);
    const NodeState<V>* node = s.nodes();
    const V h2 = h * h;
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const NodeState<V>& x = node[n];
        const Vector<V> A = from_a * x.a + from_A * x.A, Ad = from_a * x.ad + from_A * x.Ad;
        TrialNode<V>& y = trial_[n];
        y.r = x.r + h * x.v + h2 * (half_less * x.A + beta * A);
        y.d = x.d + h * x.vd + h2 * (half_less * x.Ad + beta * Ad);
        y.v = x.v + h * ((V(1.0) - gamma) * x.A + gamma * A);
        y.vd = x.vd + h * ((V(1.0) - gamma) * x.Ad + gamma * Ad);
        y.a = x.a;
        y.ad = x.ad;
    }
    const V stretch = h / s.head().h;
    const Multiplier<V>* lambda = s.lambda();
    for (std::size_t i = 0; i < lambda_.size(); ++i)
        lambda_[i] = lambda[i].now + stretch * (lambda[i].now - lambda[i].before);
}

template <class V>
void RodPack<V>::drag_grips(Mask accepted) {
    // R:34: the springs' places change at the end of a step only. From the values before accept()
    // overwrites them.
    Grip<V>* grip = working_.grips();
    const NodeState<V>* node = working_.nodes();
    for (std::size_t e = 0; e < properties_.size(); ++e, grip += gauss_points) {
        const TrialNode<V>&a = trial_[e], &b = trial_[e + 1];
        const NodeState<V>&na = node[e], &nb = node[e + 1];
        const V L = properties_[e].L;
        // A cubic is not below the lower of its ends less 4/27 of its end slopes.
        const V lowest =
            min(height_on_bed(bed_, a.r), height_on_bed(bed_, b.r)) -
            V(4.0 / 27.0) * L * (abs(speed_off_bed(bed_, a.d)) + abs(speed_off_bed(bed_, b.d)));
        if (!any(lowest < V(bed_.z) + V(0.5) * properties_[e].D)) {
            for (std::size_t g = 0; g < gauss_points; ++g) {
                grip[g].uphill = select(accepted, V(0.0), grip[g].uphill);
                grip[g].level = select(accepted, V(0.0), grip[g].level);
            }
            continue;
        }
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const V A1(shape.A[g][0]), A2 = V(shape.A[g][1]) * L, A3(shape.A[g][2]),
                                       A4 = V(shape.A[g][3]) * L;
            const Vector<V> r = A1 * a.r + A2 * a.d + A3 * b.r + A4 * b.d;
            const Vector<V> v = A1 * a.v + A2 * a.vd + A3 * b.v + A4 * b.vd;
            const BedContact<V> contact = bed_contact(
                bed_, height_on_bed(bed_, r), speed_off_bed(bed_, v), properties_[e].D, V(0.0));
            const Mask touches = contact.force > V(0.0);
            Vector<V> moved;
            if (any(touches)) moved = r - (A1 * na.r + A2 * na.d + A3 * nb.r + A4 * nb.d);
            const Slide<V> s = slide_of(bed_, moved, grip[g]);
            grip[g].uphill =
                select(accepted, select(touches, s.q * s.uphill, V(0.0)), grip[g].uphill);
            grip[g].level = select(accepted, select(touches, s.q * s.level, V(0.0)), grip[g].level);
        }
    }
}

template <class V>
void RodPack<V>::accept(Mask accepted, V h, V t_new) {
    RodState<V>& s = working_;
    if (s.grips() != nullptr && friction_on_) drag_grips(accepted);
    const V from_new((1.0 - scheme_.af) / (1.0 - scheme_.am));
    const V from_a(scheme_.af / (1.0 - scheme_.am)), from_A(-scheme_.am / (1.0 - scheme_.am));
    NodeState<V>* node = s.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        NodeState<V>& x = node[n];
        const TrialNode<V>& y = trial_[n];
        x.A = select(accepted, from_new * y.a + from_a * x.a + from_A * x.A, x.A);
        x.Ad = select(accepted, from_new * y.ad + from_a * x.ad + from_A * x.Ad, x.Ad);
        x.r = select(accepted, y.r, x.r), x.d = select(accepted, y.d, x.d);
        x.v = select(accepted, y.v, x.v), x.vd = select(accepted, y.vd, x.vd);
        x.a = select(accepted, y.a, x.a), x.ad = select(accepted, y.ad, x.ad);
    }
    Multiplier<V>* lambda = s.lambda();
    for (std::size_t i = 0; i < lambda_.size(); ++i) {
        lambda[i].before = select(accepted, lambda[i].now, lambda[i].before);
        lambda[i].now = select(accepted, lambda_[i], lambda[i].now);
    }
    if (has_strain_) {  // R:4 with the tension of the new state
        const V g(scheme_.g_damper);
        const V ratio((1.0 - scheme_.g_damper) / scheme_.g_damper);
        const V inverse_gh = V(1.0) / (g * h), inverse_half_h = V(2.0) / h;
        Strain<V>* strain = s.strain();
        for (std::size_t e = 0; e < properties_.size(); ++e) {
            const ElementProperties<V>& p = properties_[e];
            const V s1 = V(1.0) / (p.K_damper + p.c_damper * inverse_gh);
            const V s2 = V(1.0) / (p.K_creep + p.c_creep * inverse_half_h);
            for (std::size_t k = 0; k < gauss_points; ++k) {
                Strain<V>& q = strain[e * gauss_points + k];
                const V l = V(shape.P[k][0]) * lambda_[2 * e] +
                            V(shape.P[k][1]) * lambda_[2 * e + 1] +
                            V(shape.P[k][2]) * lambda_[2 * e + 2];
                const V T = l * (V(1.0) + material_[e].b[k]) /
                            (V(1.0) - min(material_[e].s[k] * l, V(0.5)));
                V e1 = s1 * (p.c_damper * (q.damper * inverse_gh + ratio * q.damper_rate) + T);
                const V e2 = s2 * (p.c_creep * (q.creep * inverse_half_h + q.creep_rate) + T);
                if (!curves_.empty())  // R:41: what is left beside the creep
                    e1 = select(curved_[e], material_[e].b[k] + material_[e].s[k] * T - e2, e1);
                const V r1 = (e1 - q.damper) * inverse_gh - ratio * q.damper_rate;
                const V r2 = (e2 - q.creep) * inverse_half_h - q.creep_rate;
                q.damper = select(accepted, e1, q.damper);
                q.damper_rate = select(accepted, r1, q.damper_rate);
                q.creep = select(accepted, e2, q.creep);
                q.creep_rate = select(accepted, r2, q.creep_rate);
            }
        }
    }
    s.head().t = select(accepted, t_new, s.head().t);
    s.head().h = select(accepted, h, s.head().h);
}

template <class V>
void RodPack<V>::begin_pass(double t0, double t1, const MotionSpline& platform, V h) {
    static_ = false;
    platform_ = platform;
    const double sampled = LaneTraits<V>::get(kept_.head().wave_index, 0);
    if (sampled < 0.0 || (sampled + 1e-9) * wave_step_ < t0 + platform_step_)
        refresh_water(t0 + platform_step_, motion_of(place_a_.hull, platform).at(t0).motion);
    working_ = kept_;  // always from the kept state
    begin_handing_over(t0, t1, platform);
    ++work_.passes;
    work_.rod_time += t1 - t0;
    // on a change of step A <- a + (h/h_old)(A - a)
    const V ratio = h / working_.head().h;
    NodeState<V>* node = working_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        node[n].A = node[n].a + ratio * (node[n].A - node[n].a);
        node[n].Ad = node[n].ad + ratio * (node[n].Ad - node[n].ad);
    }
}

template <class V>
void RodPack<V>::begin_step(Mask active, V h, V t_new, const MotionSpline& platform) {
    ++work_.steps;
    if (winds_) pay_out(t_new);
    if (parts_) part(t_new);
    prepare_material(working_, h);
    interpolate_water(t_new, water_);
    predict(working_, h);
    end_a_ = end_values(place_a_, working_.head().axis_a, t_new, platform);
    end_b_ = end_values(place_b_, working_.head().axis_b, t_new, platform);
    const auto put = [](Mask free, TrialNode<V>& node, const EndValues<V>& end) {
        node.r = select(free, node.r, end.position);
        node.v = select(free, node.v, end.velocity);
        node.a = select(free, node.a, end.acceleration);
    };
    if (place_a_.prescribed()) put(released_, trial_.back(), end_a_);
    if (place_b_.prescribed()) put(LaneTraits<V>::none(), trial_.front(), end_b_);
    if (shelters_) shelter_water(t_new, platform, true, trial_.data(), water_);
    if (!curves_.empty()) (void)follow_curves(active, &working_, h);
    friction_on_ = true;
    const RodHead<V>& head = working_.head();
    found_force_a_ = head.force_a, found_force_b_ = head.force_b;
    found_moment_a_ = head.moment_a, found_moment_b_ = head.moment_b;
}

template <class V>
void RodPack<V>::correct(Mask iterating, V a0, V a1) {
    update_trial(iterating, a0, a1, V(1.0), V(1e30), correction_size_, correction_finite_);
    found_force_a_ = select(iterating, reaction_a_, found_force_a_);
    found_force_b_ = select(iterating, reaction_b_, found_force_b_);
    found_moment_a_ = select(iterating, moment_a_, found_moment_a_);
    found_moment_b_ = select(iterating, moment_b_, found_moment_b_);
}

template <class V>
void RodPack<V>::judge(int iteration, V h, Mask iterating, Mask& sound, Mask& converged) {
    sound = sound & (correction_finite_ <= V(0.0));
    converged = converged & sound & (correction_size_ <= V(newton.tolerance));
    if (!constraints_.empty()) {
        settle_constraints(iterating);
        if (iteration + 1 < newton.constraint_iterations)
            converged = converged & (constraint_misfit() <= V(1.0));
    }
    if (!curves_.empty()) {
        const Mask fits = follow_curves(iterating, &working_, h);
        if (iteration + 1 < newton.max_iterations) converged = converged & fits;
    }
}

template <class V>
void RodPack<V>::end_step(Mask accepted, V h, V t_new) {
    RodHead<V>& head = working_.head();
    head.force_a = select(accepted, found_force_a_, head.force_a);
    head.force_b = select(accepted, found_force_b_, head.force_b);
    head.moment_a = select(accepted, found_moment_a_, head.moment_a);
    head.moment_b = select(accepted, found_moment_b_, head.moment_b);
    keep_constraints(accepted, h, working_, working_);
    accept(accepted, h, t_new);
}

template <class V>
void RodPack<V>::restart_rates(int lane) {
    using T = LaneTraits<V>;
    NodeState<V>* node = working_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const auto reset = [&](V& A, const V& a) { T::set(A, lane, T::get(a, lane)); };
        reset(node[n].A.x, node[n].a.x), reset(node[n].A.y, node[n].a.y);
        reset(node[n].A.z, node[n].a.z), reset(node[n].Ad.x, node[n].ad.x);
        reset(node[n].Ad.y, node[n].ad.y), reset(node[n].Ad.z, node[n].ad.z);
    }
}

template <class V>
auto RodGroup<V>::attempt_step(Mask active, V h, V t_new, const MotionSpline& platform) -> Mask {
    const TimeScheme& scheme = packs_.front().scheme_;
    const V a0 = scheme.a0(h), a1 = scheme.a1(h);
    for (RodPack<V>& p : packs_) p.begin_step(active, h, t_new, platform);
    place(&RodPack<V>::working_, packs_.front().working_.head().t, t_new, platform, false);
    evaluate(a1);

    Mask iterating = active, accepted = LaneTraits<V>::none();
    const int most = packs_.front().newton.max_iterations;
    for (int i = 0; i < most && any(iterating); ++i) {
        solve(a0, a1);
        for (RodPack<V>& p : packs_) p.correct(iterating, a0, a1);
        evaluate(a1);
        Mask sound = iterating, converged = iterating;
        for (RodPack<V>& p : packs_) p.judge(i, h, iterating, sound, converged);
        converged = converged & sound;
        accepted = accepted | converged;
        iterating = sound & !converged;
    }
    for (RodPack<V>& p : packs_) p.end_step(accepted, h, t_new);
    return accepted;
}

template <class V>
Status RodGroup<V>::dynamic_pass(double t0, double t1, const MotionSpline& platform) {
    using T = LaneTraits<V>;
    // R:28: equal steps, each lane its own, a bundle the shortest of its members'
    const double H = t1 - t0;
    struct Clock {
        double base = 0.0, h = 0.0;
        int done = 0, steps = 0, halvings = 0, coarse = 0;
    };
    std::array<Clock, static_cast<std::size_t>(lanes)> clock;
    V h{}, t_new{};
    Mask active = used();
    for (int i = 0; i < lanes; ++i) {
        double longest = T::get(packs_.front().line_step_, i);
        for (const RodPack<V>& p : packs_.subspan(1))
            longest = std::min(longest, T::get(p.line_step_, i));
        Clock& c = clock[static_cast<std::size_t>(i)];
        c.steps = c.coarse = std::max(1, static_cast<int>(std::ceil(H / longest - 1e-9)));
        c.h = H / c.steps;
        c.base = t0;
        T::set(h, i, c.h);
    }
    for (RodPack<V>& p : packs_) {
        p.begin_pass(t0, t1, platform, h);
        for (int i = 0; i < lanes; ++i)
            p.add_to_fit(i, 0, clock[static_cast<std::size_t>(i)].coarse, platform);
    }
    const int lines = static_cast<int>(packs_.front().lines_.size());
    Status failed;
    while (any(active)) {
        for (int i = 0; i < lanes; ++i) {  // an idle lane goes with the first
            const Clock& c = clock[static_cast<std::size_t>(i < lines ? i : 0)];
            const bool last = c.done + 1 >= c.steps;
            T::set(t_new, i, last ? t1 : c.base + (c.done + 1) * c.h);
            T::set(h, i, c.h);
        }
        const Mask accepted = attempt_step(active, h, t_new, platform);
        for (int i = 0; i < lanes; ++i) {
            if (!T::get(active, i)) continue;
            Clock& c = clock[static_cast<std::size_t>(i)];
            if (T::get(accepted, i)) {
                ++c.done;
                for (RodPack<V>& p : packs_) p.add_to_given(i, c.h, platform);
                const double q =
                    (T::get(t_new, i) - t0) / H * c.coarse;  // halved steps do not count
                if (std::abs(q - std::round(q)) < 1e-6)
                    for (RodPack<V>& p : packs_)
                        p.add_to_fit(i, static_cast<int>(std::round(q)), c.coarse, platform);
                if (c.done >= c.steps) T::set(active, i, false);
                continue;
            }
            // 5.4: halve the step for what is left of the pass, restart with A = a
            if (++c.halvings > packs_.front().newton.max_halvings) {
                Mask bad = T::none();
                T::set(bad, i, true);
                const Status its = status_of(bad, Status::Code::not_converged, T::get(t_new, i));
                if (failed.ok() || its.line < failed.line) failed = its;
                T::set(active, i, false);  // frozen; its neighbours go on
                continue;
            }
            c.base += c.done * c.h;
            c.steps = 2 * (c.steps - c.done);
            c.done = 0;
            c.h *= 0.5;
            for (RodPack<V>& p : packs_) p.restart_rates(i);
        }
    }
    for (RodPack<V>& p : packs_) p.end_handing_over();
    return failed;
}

template <class V>
Status RodPack<V>::pass(double t0, double t1, const MotionSpline& platform) {
    return RodGroup<V>(std::span(this, 1)).pass(t0, t1, platform);
}

template Status RodPack<Single>::pass(double, double, const MotionSpline&);
template void RodPack<Single>::accept(Single::Mask, Single, Single);
template void RodPack<Single>::prepare_material(const RodState<Single>&, Single);
template auto RodGroup<Single>::dynamic_pass(double, double, const MotionSpline&) -> Status;
template Status RodPack<Quad>::pass(double, double, const MotionSpline&);
template void RodPack<Quad>::accept(Quad::Mask, Quad, Quad);
template void RodPack<Quad>::prepare_material(const RodState<Quad>&, Quad);
template auto RodGroup<Quad>::dynamic_pass(double, double, const MotionSpline&) -> Status;

}  // namespace hawser::worker
