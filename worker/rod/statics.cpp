// Static start of a pack: catenary guess, Newton with a0 = a1 = 0, checks that reject false
// equilibria.
#include <algorithm>
#include <cmath>
#include <optional>

#include "rod/catenary.hpp"
#include "rod/lane_access.hpp"
#include "rod/rod_group.hpp"

namespace hawser::worker {

namespace {

constexpr double static_tolerance = 1e-9;  // nodal position correction [m]
constexpr int static_iterations = 100;
// Parts of each correction where whole ones fail: R:17 has no derivative of drag in the slope, so
// that the iteration overshoots on a lightly loaded line that lies down in the stream.
constexpr double careful_parts[] = {0.5, 0.2};
/// Stiffness of held points along a rod, as a part of the whole, on the way to them.
constexpr double held_parts[] = {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0};
/// In place of such a part: where Newton's iteration loses its way, the rod is followed as in slow
/// motion through a stiff fluid, (J + ease M) d = R, which ends at an equilibrium that is stable.
/// The ease fades while corrections are short.
constexpr double eased = 0.0;
constexpr double first_ease = 10.0, last_ease = 1e-6;  // [1/s2]
constexpr double ease_shrinks = 0.7, ease_grows = 4.0;
constexpr double eased_step = 2.0;  // longer corrections are held back more [m]
constexpr int eased_iterations = 600;
constexpr double static_step_limit = 50.0;  // [m]
constexpr double most_sag = 6.0;  // w L^3/EI up to which a clamped beam is thought to stand out
constexpr double move_per_increment = 5.0;  // of the platform between two static solutions [m]
constexpr double turn_lever = 100.0;        // metres of motion that a radian of rotation counts as

}  // namespace

template <class V>
auto RodPack<V>::guess_lane(int lane, const PlatformMotion& pose, const Vec3& a,
                            const std::optional<Vec3>& b) -> Mask {
    using T = LaneTraits<V>;
    const std::vector<CatenaryElement> elements = catenary_elements(lane);
    if (!place_a_.held() && b) {
        for (const PlacedConstraint<V>& c : constraints_) {
            if (std::holds_alternative<Tensioner<V>>(c.law))
                return guess_under_tension(lane, c.at[static_cast<std::size_t>(lane)], pose, *b,
                                           elements);
        }
    }
    const bool on_bed = place_b_.end[static_cast<std::size_t>(lane)].kind == EndKind::anchor;
    Mask found = LaneTraits<V>::none();
    if (!b && stands_out(lane, elements)) {
        const EndValues<V> end =
            end_values(place_a_, kept_.head().axis_a, V(0.0), MotionSpline(0.0, pose, 0.0, pose));
        guess_straight(lane, a, lane_vector(end.axis, lane), elements);
        T::set(found, lane, true);
        return found;
    }
    Catenary shape_found = b ? solve_catenary(elements, *b, a, on_bed) : hang_freely(elements, a);
    if (!shape_found.found && b) {
        // Weights that change at the water line from element to element leave gaps between the
        // catenaries of a light line, and its ends may fall into one. Wet all along it has none,
        // and is start enough.
        std::vector<CatenaryElement> wet = elements;
        for (CatenaryElement& e : wet) e.weight_dry = e.weight_wet;
        shape_found = solve_catenary(wet, *b, a, on_bed);
    }
    if (!shape_found.found) return found;
    T::set(found, lane, true);
    start_from(lane, shape_found.nodes);
    return found;
}

template <class V>
bool RodPack<V>::stands_out(int lane, const std::vector<CatenaryElement>& elements) const {
    using T = LaneTraits<V>;
    const LineEnd& end = place_a_.end[static_cast<std::size_t>(lane)];
    if (end.joint != Joint::clamped || !end.direction) return false;
    double length = 0.0, weight = 0.0, moment = 0.0, bend = HUGE_VAL;
    for (std::size_t e = elements.size(); e-- > 0;) {  // from the clamp
        const CatenaryElement& piece = elements[e];
        moment += std::abs(piece.point_weight) * (length + piece.length);
        length += piece.length;
        weight += std::max(std::abs(piece.weight_wet), std::abs(piece.weight_dry)) * piece.length;
        bend = std::min(bend, T::get(properties_[e].B, lane));
    }
    return length * (weight * length + moment) < most_sag * bend;
}

template <class V>
void RodPack<V>::guess_straight(int lane, const Vec3& a, const Vec3& axis,
                                const std::vector<CatenaryElement>& elements) {
    std::vector<CatenaryNode> nodes{{.position = a, .tangent = axis}};  // from end A, then turned
    for (std::size_t e = elements.size(); e-- > 0;)
        nodes.push_back(
            {.position = nodes.back().position - elements[e].length * axis, .tangent = axis});
    std::reverse(nodes.begin(), nodes.end());
    double T = 0.0;
    for (std::size_t n = 1; n < nodes.size(); ++n) {
        const CatenaryElement& piece = elements[n - 1];
        T += piece.weight_wet * piece.length * axis.z();
        nodes[n].tension = T;
        T += piece.point_weight * axis.z();
    }
    start_from(lane, nodes);
}

template <class V>
auto RodPack<V>::guess_under_tension(int lane, const LineConstraint& tensioner,
                                     const PlatformMotion& pose, const Vec3& foot,
                                     const std::vector<CatenaryElement>& elements) -> Mask {
    // A riser that hangs in its tensioner: straight from its foot, the tension less the weight
    // below
    const bool on_second = touched_.place_of(tensioner.platform) == 1;
    const PlatformMotion its = on_second ? second_.at(0.0).motion : pose;
    const Vec3 top = tensioner.on_platform
                         ? Vec3(its.position + rotation(its.angles) * tensioner.position)
                         : tensioner.position;
    double length = 0.0, T = tensioner.nominal_tension;
    for (const CatenaryElement& e : elements) {
        length += e.length;
        T -= e.weight_wet * e.length + e.point_weight;
    }
    const Vec3 u = (top - foot).normalized();
    const double stretch = (top - foot).norm() / length;
    std::vector<CatenaryNode> nodes{{.position = foot, .tangent = u, .tension = T}};
    double s = 0.0;
    for (const CatenaryElement& e : elements) {
        s += e.length;
        T += e.weight_wet * e.length + e.point_weight;
        nodes.push_back({.position = foot + stretch * s * u, .tangent = u, .tension = T});
    }
    start_from(lane, nodes);
    Mask found = LaneTraits<V>::none();
    LaneTraits<V>::set(found, lane, true);
    return found;
}

template <class V>
void RodPack<V>::set_guess(int lane, const std::vector<CatenaryNode>& nodes) {
    start_from(lane, nodes);
    LaneTraits<V>::set(guessed_, lane, true);
}

template <class V>
void RodPack<V>::start_from(int lane, const std::vector<CatenaryNode>& nodes) {
    using T = LaneTraits<V>;
    double strongest = 1.0;
    for (const CatenaryNode& c : nodes) strongest = std::max(strongest, std::abs(c.tension));
    const double floor = 1e-6 * strongest;  // a start without any tension would be singular
    NodeState<V>* node = kept_.nodes();
    Multiplier<V>* lambda = kept_.lambda();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const CatenaryNode& c = nodes[n];
        set_lane_vector(node[n].r, lane, c.position);
        set_lane_vector(node[n].d, lane, c.tangent);
        const auto raised = [&](double tension) {
            return std::abs(tension) < floor ? floor : tension;
        };
        T::set(lambda[2 * n].now, lane, raised(c.tension));
        if (n > 0)
            T::set(lambda[2 * n - 1].now, lane, raised(0.5 * (c.tension + nodes[n - 1].tension)));
    }
}

template <class V>
std::vector<CatenaryNode> RodPack<V>::found_shape(int lane) const {
    using T = LaneTraits<V>;
    std::vector<CatenaryNode> nodes;
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const NodeState<V>& x = working_.nodes()[n];
        nodes.push_back({.position = lane_vector(x.r, lane),
                         .tangent = lane_vector(x.d, lane),
                         .tension = T::get(working_.lambda()[2 * n].now, lane)});
    }
    return nodes;
}

template <class V>
void RodPack<V>::begin_statics(const MotionSpline& still, Mask wanted) {
    static_ = true;
    friction_on_ = false;
    parted_ = released_ = LaneTraits<V>::none(), dead_ = V(-1.0);  // a line is whole at rest
    if (winds_) pay_out(kept_.head().t);
    const NodeState<V>* node = kept_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n)
        trial_[n] = {.r = node[n].r, .d = node[n].d, .v = {}, .vd = {}, .a = {}, .ad = {}};
    for (std::size_t i = 0; i < lambda_.size(); ++i) lambda_[i] = kept_.lambda()[i].now;
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        // a lane that is at rest already keeps where it stands on its tension table
        const Mask anew = wanted | !used_;
        const V mean = V(1.0) / properties_[e].K_damper + V(1.0) / properties_[e].K_creep;
        for (V& s : material_[e].s) s = select(anew, mean, s);
        for (V& b : material_[e].b) b = select(anew, V(0.0), b);
    }
    end_a_ = end_values(place_a_, kept_.head().axis_a, V(0.0), still);
    end_b_ = end_values(place_b_, kept_.head().axis_b, V(0.0), still);
    if (place_a_.prescribed()) trial_.back().r = end_a_.position;
    if (place_b_.prescribed()) trial_.front().r = end_b_.position;
}

template <class V>
void RodPack<V>::end_statics(Mask solved) {
    // What was found becomes the kept state of the lanes that were wanted.
    NodeState<V>* to = kept_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        to[n].r = select(solved, trial_[n].r, to[n].r);
        to[n].d = select(solved, trial_[n].d, to[n].d);
    }
    for (std::size_t i = 0; i < lambda_.size(); ++i) {
        Multiplier<V>& l = kept_.lambda()[i];
        l.now = l.before = select(solved, lambda_[i], l.now);
    }
}

template <class V>
auto RodGroup<V>::static_newton(const PlatformMotion& pose, bool current, Mask wanted, double part)
    -> Mask {
    const MotionSpline still(0.0, pose, 0.0, pose);
    const V now(0.0);
    for (RodPack<V>& p : packs_) p.begin_statics(still, wanted);

    Mask iterating = wanted, solved = LaneTraits<V>::none();
    V polish(0.0);  // two more iterations after the position test settle lambda
    const bool is_eased = part == eased;
    if (is_eased) part = 1.0;
    V ease(is_eased ? first_ease : 0.0);
    const double most = is_eased ? eased_iterations : static_iterations / part;
    for (int i = 0; i < most && any(iterating); ++i) {
        for (RodPack<V>& p : packs_) {
            p.current_only(current, now, still);
            if (!p.curves_.empty()) (void)p.follow_curves(iterating, nullptr, V(1.0));
        }
        place(&RodPack<V>::kept_, now, now, still, true);
        for (RodPack<V>& p : packs_) p.finds_points_ = true;
        evaluate(V(0.0));
        for (RodPack<V>& p : packs_) p.finds_points_ = false;
        solve(ease, V(0.0));
        Mask sound = iterating, close = iterating;
        V longest(0.0);
        for (RodPack<V>& p : packs_) {
            V correction, finite;
            p.update_trial(iterating, V(0.0), V(0.0), V(part), V(static_step_limit), correction,
                           finite);
            RodHead<V>& head = p.kept_.head();
            head.force_a = select(iterating, p.reaction_a_, head.force_a);
            head.force_b = select(iterating, p.reaction_b_, head.force_b);
            head.moment_a = select(iterating, p.moment_a_, head.moment_a);
            head.moment_b = select(iterating, p.moment_b_, head.moment_b);
            p.settle_constraints(iterating);
            sound = sound & (finite <= V(0.0));
            close = close & (correction <= V(static_tolerance));
            longest = max(longest, correction);
        }
        if (is_eased) {
            const V more = max(V(ease_grows) * ease, V(last_ease));
            ease = select(longest > V(eased_step), more, V(ease_shrinks) * ease);
            ease = select(ease < V(last_ease), V(0.0), ease);
        }
        polish = select(sound & close, polish + V(1.0), V(0.0));
        const Mask done = sound & (polish >= V(3.0));
        solved = solved | done;
        iterating = sound & !done;
    }
    for (RodPack<V>& p : packs_) {
        p.keep_constraints(solved, V(0.0), p.kept_, p.kept_);
        p.current_only(current, now, still);
    }
    place(&RodPack<V>::kept_, now, now, still, true);
    evaluate(V(0.0));
    solve(V(0.0), V(0.0));  // the stiffness of every lane at what it has found
    for (RodPack<V>& p : packs_) p.end_statics(solved);
    return solved;
}

template <class V>
auto RodPack<V>::false_equilibria() const -> Mask {
    // Newton finds any equilibrium. Accept it only if the rod is in tension or stands the
    // compression, does not fold inside an element, and is neither stretched nor squeezed beyond
    // reason.
    Mask bad = LaneTraits<V>::none(), squeezed = bad, crushed = bad;
    const std::vector<TrialNode<V>>& node = trial_;
    V strongest(0.0);
    for (std::size_t i = 0; i < lambda_.size(); ++i) strongest = max(strongest, abs(lambda_[i]));
    // At a point mass a chain has a kink, which its slope there cannot follow.
    const auto kinked = [&](std::size_t n) {
        Mask out = LaneTraits<V>::none();
        if (n == 0 || n >= properties_.size()) return out;
        for (const PointMass<V>& mass : masses_)
            if (mass.node == static_cast<int>(n))
                out = (properties_[n - 1].B <= V(0.0)) & (properties_[n].B <= V(0.0));
        return out;
    };
    for (std::size_t n = 0; n < trial_.size(); ++n) {
        const V d2 = dot(node[n].d, node[n].d);
        const Mask off = (d2 < V(0.9 * 0.9)) | (d2 > V(1.2 * 1.2));
        bad = bad | (off & !kinked(n));
        crushed = crushed | ((d2 < V(0.99 * 0.99)) & !kinked(n));  // no material stands that
    }
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        // Beside a kink the chord tells: it is shorter than the element, but no fold.
        const Mask beside = kinked(e) | kinked(e + 1);
        const Vector<V> chord = node[e + 1].r - node[e].r;
        const V L = properties_[e].L, straight = dot(chord, chord) / (L * L);
        const Mask curled = (straight < V(0.8 * 0.8)) | (straight > V(1.2 * 1.2));
        const Mask folded = dot(node[e].d, node[e + 1].d) <= V(0.0);
        bad = bad | (folded & !beside) | (curled & beside);
        // lambda = T - B kappa^2: bending alone makes it negative
        const Vector<V> turn = node[e + 1].d - node[e].d;
        const V bending = properties_[e].B * dot(turn, turn) / (L * L);
        for (std::size_t i = 2 * e; i < 2 * e + 3; ++i)
            squeezed =
                squeezed | ((lambda_[i] < V(-0.01) * strongest - V(3.0) * bending) & !beside);
    }
    const bool tied = std::any_of(constraints_.begin(), constraints_.end(),
                                  [](const PlacedConstraint<V>& c) { return c.tied; });
    if (!any(squeezed)) return bad & used_;
    if (!static_ || tied) return (bad | squeezed) & used_;
    // A direction of negative stiffness shows in the inertia of the last solution's tangent, in the
    // sense of Sylvester: at a minimum each node's multiplier gives one negative pivot, no more.
    V negative(0.0);
    const auto count = [&](const V* inverse_d, int n) {
        for (int i = 0; i < n; ++i) negative += select(inverse_d[i] < V(0.0), V(1.0), V(0.0));
    };
    for (const NodeFactor<V>& f : factors_) count(f.inverse_d, 7);
    V L[7][7], inverse_d[7];
    if (place_a_.prescribed()) {
        factor<3, 4>(last_D_, L, inverse_d);
        count(inverse_d, 4);
    } else {
        factor<0, 7>(last_D_, L, inverse_d);
        count(inverse_d, 7);
    }
    const Mask unstable = negative > V(static_cast<double>(trial_.size()));
    return (bad | (squeezed & (unstable | crushed))) & used_;
}

template <class V>
void RodPack<V>::finish_statics(Mask good) {
    // At rest: strains of the material elements from the tension, R:4 with c = 0.
    Strain<V>* strain = kept_.strain();
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const ElementProperties<V>& p = properties_[e];
        const V s = V(1.0) / p.K_damper + V(1.0) / p.K_creep;
        for (std::size_t k = 0; k < gauss_points; ++k) {
            const Multiplier<V>* l = kept_.lambda() + 2 * e;
            const V lambda = V(shape.P[k][0]) * l[0].now + V(shape.P[k][1]) * l[1].now +
                             V(shape.P[k][2]) * l[2].now;
            V T = lambda / (V(1.0) - s * lambda);
            V spring = T / p.K_damper;
            if (!curves_.empty()) {  // R:41
                const Compliance<V>& law = material_[e];
                const V Tc = lambda * (V(1.0) + law.b[k]) / (V(1.0) - law.s[k] * lambda);
                T = select(curved_[e], Tc, T);
                spring = select(curved_[e], law.b[k] + law.s[k] * T - T / p.K_creep, spring);
            }
            Strain<V>& q = strain[e * gauss_points + k];
            q.damper = select(good, spring, q.damper);
            q.creep = select(good, T / p.K_creep, q.creep);
            q.damper_rate = q.creep_rate = V(0.0);
        }
    }
    NodeState<V>* node = kept_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n)
        node[n].v = node[n].vd = node[n].a = node[n].ad = node[n].A = node[n].Ad = Vector<V>{};
    kept_.head().t = V(0.0);
    kept_.head().h = line_step_;
    kept_.head().wave_index = V(-1.0);
    if (Grip<V>* grip = kept_.grips()) std::fill(grip, grip + kept_.points(), Grip<V>{});
    working_ = kept_;
}

template <class V>
void RodPack<V>::take_axes() {
    const auto tangent = [](const Vector<V>& d) { return (V(1.0) / sqrt(dot(d, d))) * d; };
    RodHead<V>& head = kept_.head();
    head.axis_a =
        select(axis_is_static_a_, tangent(kept_.nodes()[trial_.size() - 1].d), head.axis_a);
    head.axis_b = select(axis_is_static_b_, tangent(kept_.nodes()[0].d), head.axis_b);
    take_joint_axes(kept_);
}

template <class V>
Status RodPack<V>::equilibrium(const PlatformMotion& pose, bool current) {
    return RodGroup<V>(std::span(this, 1)).equilibrium(pose, current);
}

template <class V>
Status RodGroup<V>::equilibrium(const PlatformMotion& pose, bool current) {
    if (packs_.front().model_ == LineModel::catenary) return packs_.front().hang_at(pose);
    std::vector<RodState<V>> before;  // a failure leaves everything as it was
    for (const RodPack<V>& p : packs_) before.push_back(p.kept_);
    const bool started = packs_.front().started_;
    Status status = find_equilibrium(pose, current);
    if (status.ok()) return status;
    for (std::size_t p = 0; p < packs_.size(); ++p) {
        packs_[p].kept_ = std::move(before[p]);
        packs_[p].started_ = started;
    }
    return status;
}

template <class V>
Status RodGroup<V>::false_equilibrium() const {
    Status first;
    for (const RodPack<V>& p : packs_) {
        const Mask bad = p.false_equilibria();
        if (!any(bad)) continue;
        const Status its = p.status_of(bad, Status::Code::false_equilibrium, 0.0);
        if (first.ok() || its.line < first.line) first = its;
    }
    return first;
}

namespace {

/// A rope that meets others in a knot.
struct Reach {
    Vec3 from;
    double length;
};

/// Where ropes that meet would be held: below the middle of their ends, drawn back in turn by each
/// that is too short.
Vec3 knot_of(const std::vector<Reach>& ropes) {
    Vec3 x = Vec3::Zero();
    double longest = 0.0;
    for (const Reach& rope : ropes) {
        x += rope.from / static_cast<double>(ropes.size());
        longest = std::max(longest, rope.length);
    }
    x.z() -= longest;
    for (int i = 0; i < 300; ++i)
        for (const Reach& rope : ropes) {
            const Vec3 off = x - rope.from;
            const double beyond = off.norm() - rope.length;
            if (beyond > 0.0) x -= 0.5 * beyond * off.normalized();
        }
    return x;
}

}  // namespace

template <class V>
auto RodGroup<V>::guess(Mask wanted, const PlatformMotion& pose) -> Mask {
    using T = LaneTraits<V>;
    const MotionSpline still(0.0, pose, 0.0, pose);
    const auto count = static_cast<int>(packs_.front().lines_.size());
    std::vector<EndValues<V>> a, b;
    std::vector<Mask> has;
    for (const RodPack<V>& p : packs_) {
        a.push_back(p.end_values(p.place_a_, p.kept_.head().axis_a, V(0.0), still));
        b.push_back(p.end_values(p.place_b_, p.kept_.head().axis_b, V(0.0), still));
        has.push_back(p.guessed_);
    }
    const auto length = [&](std::size_t n, int lane) {
        return packs_[n].arc_length_[static_cast<std::size_t>(lane)].back();
    };
    /// Whether a line's end stands somewhere, or waits for another line.
    const auto stands = [](const auto& place) { return place.held() && !place.on_line(); };
    /// Ropes that are tied to the free end B of line n, and itself.
    const auto meeting = [&](std::size_t n, int lane) {
        std::vector<Reach> ropes;
        if (packs_[n].place_b_.held() || !stands(packs_[n].place_a_)) return ropes;
        ropes.push_back({lane_vector(a[n].position, lane), length(n, lane)});
        for (const Tie& tie : ties_) {
            const PlacedConstraint<V>& c = packs_[tie.pack].constraints_[tie.constraint];
            const LineConstraint& at = c.at[static_cast<std::size_t>(lane)];
            if (tie.other_pack != n || !at.is_end || at.other_arc < length(n, lane)) continue;
            const RodPack<V>& rope = packs_[tie.pack];
            if (c.is_end_b && stands(rope.place_a_))
                ropes.push_back({lane_vector(a[tie.pack].position, lane), length(tie.pack, lane)});
            if (c.is_end_a && stands(rope.place_b_))
                ropes.push_back({lane_vector(b[tie.pack].position, lane), length(tie.pack, lane)});
        }
        return ropes;
    };
    // An end on another line waits for that line's shape.
    for (std::size_t round = 0; round < packs_.size(); ++round) {
        for (std::size_t n = 0; n < packs_.size(); ++n) {
            RodPack<V>& p = packs_[n];
            for (int i = 0; i < count; ++i) {
                if (!T::get(wanted, i) || T::get(has[n], i)) continue;
                Vec3 end_a = lane_vector(a[n].position, i);
                std::optional<Vec3> end_b;
                if (p.place_b_.held()) end_b = lane_vector(b[n].position, i);
                bool known = true;
                for (const Tie& tie : ties_) {
                    const PlacedConstraint<V>& c = p.constraints_[tie.constraint];
                    if (tie.pack != n || !(c.is_end_a || c.is_end_b)) continue;
                    known = known && T::get(has[tie.other_pack], i);
                    if (!known) break;
                    const Vec3 there = packs_[tie.other_pack].kept_point(
                        i, c.at[static_cast<std::size_t>(i)].other_arc);
                    (c.is_end_b ? end_b.emplace() : end_a) = there;
                }
                if (!known) continue;
                if (const std::vector<Reach> ropes = meeting(n, i); ropes.size() > 1)
                    end_b = knot_of(ropes);
                if (end_b && (p.place_a_.on_line() || p.place_b_.on_line())) {
                    // no longer than it is: the tie closes the gap
                    const Vec3 span = *end_b - end_a;
                    const double part = std::min(1.0, length(n, i) / span.norm());
                    if (p.place_b_.on_line())
                        end_b = end_a + part * span;
                    else
                        end_a = *end_b - part * span;
                }
                has[n] = has[n] | p.guess_lane(i, pose, end_a, end_b);
            }
        }
    }
    Mask all = wanted;
    for (const Mask& its : has) all = all & its;
    return all;
}

template <class V>
Status RodGroup<V>::find_equilibrium(const PlatformMotion& pose, bool current) {
    const auto everything_of = [&](Mask done) { return used() & !done; };
    const auto unsolved = [&](Mask done) {
        return status_of(everything_of(done), Status::Code::no_equilibrium, 0.0);
    };
    // Lanes without a solution, or with one that nobody wants, once more: from the catenary, eased.
    const auto relaxed = [&](const PlatformMotion& at, bool in_current, Mask solved) {
        Mask lost = everything_of(solved);
        for (const RodPack<V>& p : packs_) lost = lost | p.false_equilibria();
        if (!any(lost)) return solved;
        for (RodPack<V>& p : packs_) p.guessed_ = LaneTraits<V>::none();
        guess(lost, at);
        return (solved & !lost) | static_newton(at, in_current, lost, eased);
    };
    if (!packs_.front().started_) {
        // The first solution is that of the design position in still water, from the catenary; axes
        // of joints that follow the static tangent are taken from it.
        const PlatformMotion design = packs_.front().design_;
        const Mask guessed = guess(used(), design);
        for (RodPack<V>& p : packs_) p.copy_idle_lanes();
        if (any(everything_of(guessed))) return unsolved(guessed);
        bool held = false;
        for (RodPack<V>& p : packs_) {
            p.law_on_ = !(p.axis_is_static_a_ | p.axis_is_static_b_ | p.static_joint_axes());
            held = held || std::any_of(p.constraints_.begin(), p.constraints_.end(),
                                       [](const PlacedConstraint<V>& c) {
                                           return c.tied ||
                                                  std::holds_alternative<HeldPoint<V>>(c.law);
                                       });
        }
        Mask solved = static_newton(design, false, used());
        // A tie-off far from the catenary draws the line there by and by.
        const Mask far = everything_of(solved);
        if (any(far) && held) {
            guess(far, design);
            Mask drawn = far;
            for (const double part : held_parts) {
                for (RodPack<V>& p : packs_) p.hold_part_ = part;
                drawn = static_newton(design, false, drawn);
            }
            for (RodPack<V>& p : packs_) p.hold_part_ = 1.0;
            solved = solved | drawn;
        }
        solved = relaxed(design, false, solved);
        for (RodPack<V>& p : packs_) p.law_on_ = !LaneTraits<V>::none();
        if (any(everything_of(solved))) return unsolved(solved);
        for (RodPack<V>& p : packs_) p.take_axes();
        if (Status untrue = false_equilibrium(); !untrue.ok()) return untrue;
        for (RodPack<V>& p : packs_) {
            p.set_pose(design);
            p.started_ = true;
        }
    }
    // Walk to the pose asked for in increments that depend on the platform's move alone.
    const PlatformMotion from = packs_.front().last_pose();
    const double move =
        (pose.position - from.position).norm() + turn_lever * (pose.angles - from.angles).norm();
    const int increments = std::max(1, static_cast<int>(std::ceil(move / move_per_increment)));
    for (int k = 1; k <= increments; ++k) {
        const double q = static_cast<double>(k) / increments;
        PlatformMotion at = pose;
        at.velocity.setZero();
        at.angle_rates.setZero();
        if (k < increments) {
            at.position = from.position + q * (pose.position - from.position);
            at.angles = from.angles + q * (pose.angles - from.angles);
        }
        Mask solved = static_newton(at, current, used());
        for (const double part : careful_parts) {  // once more from the catenary
            const Mask again = everything_of(solved);
            if (!any(again)) break;
            for (RodPack<V>& p : packs_) p.guessed_ = LaneTraits<V>::none();
            guess(again, at);
            solved = solved | static_newton(at, current, again, part);
        }
        solved = relaxed(at, current, solved);
        if (any(everything_of(solved))) return unsolved(solved);
    }
    if (Status untrue = false_equilibrium(); !untrue.ok()) return untrue;
    for (RodPack<V>& p : packs_) {
        p.set_pose(pose);
        p.finish_statics(used());
        p.take_static_load(pose);
    }
    return {};
}

template <class V>
void RodPack<V>::set_pose(const PlatformMotion& pose) {
    const auto all = [](const Vec3& x) { return Vector<V>{x.x(), x.y(), x.z()}; };
    kept_.head().pose_position = all(pose.position);
    kept_.head().pose_angles = all(pose.angles);
}

template <class V>
PlatformMotion RodPack<V>::last_pose() const {
    using T = LaneTraits<V>;
    const auto first = [](const Vector<V>& x) {
        return Vec3(T::get(x.x, 0), T::get(x.y, 0), T::get(x.z, 0));
    };
    PlatformMotion pose;
    pose.position = first(kept_.head().pose_position);
    pose.angles = first(kept_.head().pose_angles);
    return pose;
}

template <class V>
void RodPack<V>::copy_idle_lanes() {
    using T = LaneTraits<V>;
    V* block = kept_.values();
    for (std::size_t k = 0; k < kept_.block().size(); ++k)
        for (int i = static_cast<int>(lines_.size()); i < lanes; ++i)
            T::set(block[k], i, T::get(block[k], 0));
}

template <class V>
Status RodPack<V>::status_of(Mask bad, Status::Code code, double t) const {
    using T = LaneTraits<V>;
    Status status;
    status.code = code;
    status.t = t;
    status.iterations =
        code == Status::Code::not_converged ? newton.max_iterations : static_iterations;
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
        if (!T::get(bad, i)) continue;
        status.line = lines_[static_cast<std::size_t>(i)];
        double largest = -1.0;
        for (std::size_t n = 0; n < trial_.size(); ++n) {
            double size = 0.0;
            for (int c = 0; c < 3; ++c)
                size = std::max(size, std::abs(T::get(correction_[n].x[c], i)));
            if (!std::isfinite(T::get(correction_[n].x[0], i)))
                status.code = Status::Code::not_finite;
            if (size > largest) {
                largest = size;
                const auto& arc = arc_length_[static_cast<std::size_t>(i)];
                status.arc_length = arc.back() - arc[n];
            }
        }
        status.residual = largest;
        break;
    }
    return status;
}

template Status RodPack<Single>::equilibrium(const PlatformMotion&, bool);
template Status RodGroup<Single>::equilibrium(const PlatformMotion&, bool);
template auto RodPack<Single>::false_equilibria() const -> Single::Mask;
template std::vector<CatenaryNode> RodPack<Single>::found_shape(int) const;
template PlatformMotion RodPack<Single>::last_pose() const;
template void RodPack<Single>::set_guess(int, const std::vector<CatenaryNode>&);
template Status RodPack<Single>::status_of(Single::Mask, Status::Code, double) const;
template Status RodPack<Quad>::equilibrium(const PlatformMotion&, bool);
template Status RodGroup<Quad>::equilibrium(const PlatformMotion&, bool);
template auto RodPack<Quad>::false_equilibria() const -> Quad::Mask;
template std::vector<CatenaryNode> RodPack<Quad>::found_shape(int) const;
template PlatformMotion RodPack<Quad>::last_pose() const;
template void RodPack<Quad>::set_guess(int, const std::vector<CatenaryNode>&);
template Status RodPack<Quad>::status_of(Quad::Mask, Status::Code, double) const;

}  // namespace hawser::worker
