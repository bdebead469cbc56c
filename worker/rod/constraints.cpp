// Constraints along a rod: their laws and places, the point of the rod that they touch, and what
// they add to its element (R:22).
#include <algorithm>
#include <cmath>
#include <tuple>

#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

namespace {

/// Points where a declared constraint touches: one, or those of a pull tube's path, each with the
/// mean direction of the pieces of path beside it as its axis.
std::vector<LineConstraint> contact_points(const LineConstraint& declared) {
    if (declared.type != ConstraintType::pull_tube) return {declared};
    std::vector<LineConstraint> out;
    const std::vector<Vec3>& path = declared.path;
    for (std::size_t i = 0; i < path.size(); ++i) {
        LineConstraint point = declared;
        point.position = path[i];
        Vec3 along = Vec3::Zero();
        if (i > 0) along += (path[i] - path[i - 1]).normalized();
        if (i + 1 < path.size()) along += (path[i + 1] - path[i]).normalized();
        point.axis = along.normalized();
        out.push_back(std::move(point));
    }
    return out;
}

/// Way of a rod's end out of a guide over which the guide's load fades [m].
constexpr double fades_over = 0.1;

bool holds_a_point(ConstraintType type) {
    return type == ConstraintType::ball_joint || type == ConstraintType::flex_joint ||
           type == ConstraintType::clamp;
}

}  // namespace

template <class V>
void RodPack<V>::set_constraints(const Case& input) {
    const auto line_of = [&](int lane) -> const Line& {
        const std::size_t i =
            static_cast<std::size_t>(lane) < lines_.size() ? static_cast<std::size_t>(lane) : 0;
        return input.lines[static_cast<std::size_t>(lines_[i])];
    };
    for (std::size_t c = 0; c < line_of(0).constraints.size(); ++c) {
        const std::size_t first = constraints_.size();
        for (int i = 0; i < lanes; ++i) {
            std::vector<LineConstraint> points = contact_points(line_of(i).constraints[c]);
            if (i == 0) constraints_.resize(first + points.size());
            for (std::size_t k = 0; k < points.size(); ++k) {
                PlacedConstraint<V>& to = constraints_[first + k];
                to.declared = static_cast<int>(c);
                to.cylinders.resize(points[k].cylinders.size());
                const bool tied = points[k].other_line >= 0;
                to.tied = tied;
                to.is_end_a = points[k].is_end && *points[k].arc_length == 0.0;
                to.is_end_b = points[k].is_end && !to.is_end_a;
                to.hull = touched_.place_of(points[k].platform);
                LaneTraits<V>::set(to.on_platform, i, points[k].on_platform && !tied ? 1.0 : 0.0);
                to.at.push_back(std::move(points[k]));
            }
        }
        for (std::size_t k = first; k < constraints_.size(); ++k) set_laws(constraints_[k]);
    }
    // What other rods are tied to: a place of this rod that takes the opposite force
    for (int i = 0; i < lanes; ++i) {
        std::size_t n = static_cast<std::size_t>(std::count_if(
            constraints_.begin(), constraints_.end(), [](const auto& c) { return !c.mirror; }));
        const int its =
            lines_[static_cast<std::size_t>(i) < lines_.size() ? static_cast<std::size_t>(i) : 0];
        for (std::size_t l = 0; l < input.lines.size(); ++l) {
            for (std::size_t k = 0; k < input.lines[l].constraints.size(); ++k) {
                const LineConstraint& tie = input.lines[l].constraints[k];
                if (tie.other_line != its) continue;
                if (i == 0) {
                    constraints_.resize(n + 1);
                    PlacedConstraint<V>& to = constraints_[n];
                    to.declared = -1, to.mirror = true;
                    to.of_line = static_cast<int>(l), to.of_constraint = static_cast<int>(k);
                    to.law = HeldPoint<V>{};
                }
                LineConstraint place{.type = tie.type, .name = tie.name, .on_platform = false};
                if (tie.type != ConstraintType::slider) place.arc_length = tie.other_arc;
                constraints_[n++].at.push_back(std::move(place));
            }
        }
    }
}

template <class V>
void RodPack<V>::set_laws(PlacedConstraint<V>& to) const {
    using T = LaneTraits<V>;
    const auto each = [&](auto value) {
        V v{};
        for (int i = 0; i < lanes; ++i) T::set(v, i, value(i, to.at[static_cast<std::size_t>(i)]));
        return v;
    };
    const auto gather = [&](auto member) {
        return each([&](int, const LineConstraint& at) { return at.*member; });
    };
    using C = LineConstraint;
    const auto tables = [&](auto member) {
        std::array<PiecewiseLinear, static_cast<std::size_t>(lanes)> out;
        for (std::size_t i = 0; i < out.size(); ++i)
            if (!(to.at[i].*member).empty()) out[i] = PiecewiseLinear(to.at[i].*member);
        return out;
    };
    switch (to.at.front().type) {
        case ConstraintType::guide:
        case ConstraintType::pull_tube:
            to.law = Guide<V>{.gap = gather(&C::gap),
                              .stiffness = gather(&C::stiffness),
                              .damping = gather(&C::damping),
                              .friction = gather(&C::friction),
                              .mobilisation = gather(&C::mobilisation),
                              .smoothing = V(contact_smoothing)};
            break;
        case ConstraintType::slider:
            if (to.at.front().gap > 0.0) {
                to.law = Guide<V>{.gap = gather(&C::gap),
                                  .stiffness = gather(&C::stiffness),
                                  .damping = gather(&C::damping),
                                  .friction = V(0.0),
                                  .mobilisation = V(1.0),
                                  .smoothing = V(contact_smoothing)};
            } else {
                to.law =
                    Slider<V>{.stiffness = gather(&C::stiffness), .damping = gather(&C::damping)};
            }
            break;
        case ConstraintType::tensioner:
            to.law = Tensioner<V>{.nominal = gather(&C::nominal_tension),
                                  .stiffness = gather(&C::stiffness),
                                  .damping = gather(&C::damping),
                                  .exponent = gather(&C::exponent),
                                  .column = gather(&C::gas_column),
                                  .stroke_min = gather(&C::stroke_min),
                                  .stroke_max = gather(&C::stroke_max),
                                  .stop_stiffness = V(stop_stiffness),
                                  .friction_force = gather(&C::friction_force),
                                  .mobilisation = gather(&C::mobilisation),
                                  .table = tables(&C::pull)};
            break;
        case ConstraintType::ball_joint:
        case ConstraintType::flex_joint:
        case ConstraintType::clamp: {
            to.law = HeldPoint<V>{};
            if (to.at.front().type == ConstraintType::clamp) to.joint = Clamp<V>{};
            if (to.at.front().type == ConstraintType::flex_joint)
                to.joint = FlexJoint<V>{.stiffness = gather(&C::rotational_stiffness),
                                        .table = tables(&C::rotational_curve)};
            for (int i = 0; i < lanes; ++i) {
                const bool given = to.at[static_cast<std::size_t>(i)].direction.has_value();
                T::set(to.axis_is_static, i,
                       !given && !std::holds_alternative<NoSlopeLaw>(to.joint));
                // without an arc length: statics find which (place_constraints)
                const auto& arc = to.at[static_cast<std::size_t>(i)].arc_length;
                hold_by_element(to, i, arc ? element_at(i, *arc).first : 0);
            }
            break;
        }
    }
}

template <class V>
void RodPack<V>::hold_by_element(PlacedConstraint<V>& to, int lane, int element) const {
    // A joint's point is held by a spring ten times as stiff as the element that it holds, and
    // damped with half of what is critical for that element's mass.
    using T = LaneTraits<V>;
    const LineConstraint& at = to.at[static_cast<std::size_t>(lane)];
    const ElementProperties<V>& p = properties_[static_cast<std::size_t>(element)];
    const double L = T::get(p.L, lane), B = T::get(p.B, lane), EA = T::get(p.K_damper, lane);
    const double K = at.stiffness > 0.0 ? at.stiffness : 10.0 * (EA / L + 12.0 * B / (L * L * L));
    auto& held = std::get<HeldPoint<V>>(to.law);
    T::set(held.stiffness, lane, K);
    T::set(held.damping, lane,
           at.damping > 0.0 ? at.damping : std::sqrt(K * T::get(p.m, lane) * L));
    if (auto* clamp = std::get_if<Clamp<V>>(&to.joint)) T::set(clamp->stiffness, lane, 4e3 * B / L);
}

template <class V>
std::pair<int, double> RodPack<V>::element_at(int lane, double arc_length) const {
    const std::vector<double>& arc = arc_length_[static_cast<std::size_t>(lane)];
    const double target = arc.back() - arc_length;  // from end B
    const auto beyond = std::lower_bound(arc.begin() + 1, arc.end() - 1, target);
    const double low = *(beyond - 1), high = *beyond;
    return {static_cast<int>(beyond - arc.begin()) - 1,
            std::clamp((target - low) / (high - low), 0.0, 1.0)};
}

template <class V>
HullMotion<V> RodPack<V>::hull_motion(V t_before, V t, const MotionSpline& platform) const {
    using T = LaneTraits<V>;
    HullMotion<V> out;
    for (int i = 0; i < lanes; ++i) {
        const auto pose = [](const PlatformMotion& m) {
            return typename HullMotion<V>::Pose{m.position, rotation(m.angles)};
        };
        const auto u = static_cast<std::size_t>(i);
        const bool same = i > 0 && T::get(t, i) == T::get(t, i - 1) &&
                          T::get(t_before, i) == T::get(t_before, i - 1);
        if (same) {
            out.now[u] = out.now[u - 1], out.before[u] = out.before[u - 1];
            set_lane_vector(out.velocity, i, lane_vector(out.velocity, i - 1));
            set_lane_vector(out.spin, i, lane_vector(out.spin, i - 1));
        } else {
            const PlatformMotion m = platform.at(T::get(t, i)).motion;
            out.now[u] = pose(m);
            out.before[u] = pose(platform.at(T::get(t_before, i)).motion);
            if (!static_) {  // at rest nothing has a rate
                set_lane_vector(out.velocity, i, m.velocity);
                set_lane_vector(out.spin, i, angular_velocity(m));
            }
        }
        set_lane_vector(out.origin, i, out.now[u].position);
    }
    return out;
}

template <class V>
Vec3 RodPack<V>::trial_point(int lane, int element, double xi, Vec3* slope) const {
    const TrialNode<V>&a = trial_[static_cast<std::size_t>(element)],
          &b = trial_[static_cast<std::size_t>(element) + 1];
    const double L = LaneTraits<V>::get(properties_[static_cast<std::size_t>(element)].L, lane);
    const auto A = hermite(xi);
    const auto D = reduced_slope(xi);
    const Vec3 ra = lane_vector(a.r, lane), rb = lane_vector(b.r, lane);
    const Vec3 da = L * lane_vector(a.d, lane), db = L * lane_vector(b.d, lane);
    if (slope) *slope = D[0] * (rb - ra) + D[1] * da + D[2] * db;
    return A[0] * ra + A[1] * da + A[2] * rb + A[3] * db;
}

template <class V>
void RodPack<V>::locate(PlacedConstraint<V>& c, int lane, bool search) const {
    using T = LaneTraits<V>;
    const LineConstraint& at = c.at[static_cast<std::size_t>(lane)];
    const int N = elements();
    int element = static_cast<int>(T::get(c.element, lane));
    double xi = T::get(c.xi, lane);
    if (at.arc_length) {
        std::tie(element, xi) = element_at(lane, *at.arc_length);
    } else if (c.mirror) {
        return;  // found by the group: the nearest to the other rod's point
    } else if (search || !holds_a_point(at.type)) {
        const Vec3 X = lane_vector(c.place, lane), k = lane_vector(c.axis, lane);
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
    if (at.arc_length || holds_a_point(at.type)) return;
    double beyond = 0.0;  // of the plane from the rod's end
    if ((element == 0 && xi <= 0.0) || (element + 1 == N && xi >= 1.0))
        beyond = std::abs((trial_point(lane, element, xi, nullptr) - lane_vector(c.place, lane))
                              .dot(lane_vector(c.axis, lane)));
    T::set(c.holds, lane, std::max(0.0, 1.0 - beyond / fades_over));
}

template <class V>
void RodPack<V>::place_constraints(const RodState<V>& before, V t_before, V t,
                                   const MotionSpline& platform, bool search) {
    using T = LaneTraits<V>;
    for (std::size_t k = 0; k < hulls(); ++k)
        hull_[k] = hull_motion(t_before, t, motion_of(static_cast<int>(k), platform));
    const typename HullMotion<V>::Pose earth;
    for (std::size_t n = 0; n < constraints_.size(); ++n) {
        PlacedConstraint<V>& c = constraints_[n];
        const HullMotion<V>& hull = hull_[static_cast<std::size_t>(c.hull)];
        const ConstraintState<V>& was = before.constraints()[n];
        c.element = was.element;
        c.xi = was.xi;
        c.friction = was.friction;
        c.stroke = was.opening;
        for (int i = 0; i < lanes; ++i) {
            const auto u = static_cast<std::size_t>(i);
            const LineConstraint& at = c.at[u];
            const auto& now = at.on_platform ? hull.now[u] : earth;
            const auto& then = at.on_platform ? hull.before[u] : earth;
            set_lane_vector(c.place, i, now.position + now.turned * at.position);
            set_lane_vector(c.axis, i, now.turned * at.axis);
            set_lane_vector(
                c.joint_axis, i,
                now.turned * (at.direction ? Vec3(-*at.direction) : lane_vector(was.axis, i)));
            for (std::size_t k = 0; k < c.cylinders.size(); ++k)
                set_lane_vector(c.cylinders[k], i, now.turned * (at.cylinders[k] - at.position));
            locate(c, i, search);
            if (search && !at.arc_length && holds_a_point(at.type) && !c.mirror)
                hold_by_element(c, i, static_cast<int>(T::get(c.element, i)));
            // Where this material point was along the axis before the step
            const auto e = static_cast<std::size_t>(T::get(c.element, i));
            const NodeState<V>&a = before.nodes()[e], &b = before.nodes()[e + 1];
            const auto A = hermite(T::get(c.xi, i));
            const double L = T::get(properties_[e].L, i);
            const Vec3 r = A[0] * lane_vector(a.r, i) + L * A[1] * lane_vector(a.d, i) +
                           A[2] * lane_vector(b.r, i) + L * A[3] * lane_vector(b.d, i);
            const Vec3 X = then.position + then.turned * at.position;
            T::set(c.slide_start, i, (r - X).dot(then.turned * at.axis));
        }
    }
}

template <class V>
void RodPack<V>::find_points() {
    using T = LaneTraits<V>;
    for (PlacedConstraint<V>& c : constraints_) {
        // the rod's point of each lane: its two nodes side by side
        Vector<V> q[4], rate[4];
        V L{};
        for (int i = 0; i < lanes; ++i) {
            const auto e = static_cast<std::size_t>(T::get(c.element, i));
            const TrialNode<V>&a = trial_[e], &b = trial_[e + 1];
            const auto take = [&](Vector<V>& to, const Vector<V>& from) {
                T::set(to.x, i, T::get(from.x, i)), T::set(to.y, i, T::get(from.y, i));
                T::set(to.z, i, T::get(from.z, i));
            };
            take(q[0], a.r), take(q[1], a.d), take(q[2], b.r), take(q[3], b.d);
            take(rate[0], a.v), take(rate[1], a.vd), take(rate[2], b.v), take(rate[3], b.vd);
            T::set(L, i, T::get(properties_[e].L, i));
        }
        const PointShape<V> at(c.xi, L);
        const auto sum = [](const V(&w)[4], const Vector<V>(&x)[4]) {
            return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
        };
        c.point = sum(at.A, q), c.rate = sum(at.A, rate), c.slope = sum(at.w, q);
    }
}

template <class V>
void RodPack<V>::apply_laws(V a1) {
    for (PlacedConstraint<V>& c : constraints_) {
        if (c.mirror) continue;
        const Vector<V>& r = c.point;
        ConstraintMotion<V>& m = c.motion;
        m.g = r - c.place;
        // against the platform's own point there, or another rod's; the earth stands still
        const HullMotion<V>& hull = hull_[static_cast<std::size_t>(c.hull)];
        m.g_rate = c.rate - c.on_platform * (hull.velocity + cross(hull.spin, r - hull.origin));
        if (c.tied) m.g_rate -= c.place_rate;
        m.k = c.axis;
        m.friction = c.friction;
        m.slide = dot(m.g, m.k) - c.slide_start;
        m.stroke_before = c.stroke;
        m.rubs = V(friction_on_ ? 1.0 : 0.0);
        m.cylinders = c.cylinders;
        c.reading = std::visit([&](const auto& law) { return load(law, m, a1); }, c.law);
        if (hold_part_ != 1.0 && std::holds_alternative<HeldPoint<V>>(c.law)) {
            const V part(hold_part_);
            c.reading.load.force = part * c.reading.load.force;
            Symmetric<V> softer;
            softer.add(part, c.reading.load.stiffness);
            c.reading.load.stiffness = softer;
        }
        if (finds_points_) let_slide(c);
        if (const auto* guide = std::get_if<Guide<V>>(&c.law); guide && guides_closed_)
            c.reading.load.stiffness = closed_stiffness(*guide, m.k);
        c.joint_load =
            std::visit([&](const auto& law) { return load(law, c.slope, c.joint_axis); }, c.joint);
        c.joint_load = select(law_on_, c.joint_load, ConstraintLoad<V>{});
        let_go(c);
    }
}

template <class V>
void RodPack<V>::let_slide(PlacedConstraint<V>& c) const {
    // The point is looked up anew in every iteration, where g.k = 0: a stiffness along k would be
    // that of a force which never comes, and the rod would creep through its place.
    if (c.mirror || !std::holds_alternative<HeldPoint<V>>(c.law)) return;
    V along{};
    for (int i = 0; i < lanes; ++i)
        LaneTraits<V>::set(along, i, c.at[static_cast<std::size_t>(i)].arc_length ? 0.0 : 1.0);
    if (!any(along > V(0.0))) return;
    ConstraintLoad<V>& load = c.reading.load;
    const V Kt = dot(c.axis, load.stiffness * c.axis);
    load.force -= along * dot(load.force, c.axis) * c.axis;
    load.stiffness.add_outer(V(0.0) - along * Kt, c.axis);
}

template <class V>
void RodPack<V>::let_go(PlacedConstraint<V>& c) const {
    const V here(c.element);
    Mask off = c.holds <= V(0.0);
    if (parts_) {
        off = off | (parted_ & c.lets_go);
        // nothing is left of a parted element for a guide to push
        const bool guides = !c.at.front().arc_length && !holds_a_point(c.at.front().type);
        if (guides) off = off | ((dead_ <= here) & (dead_ >= here));
    }
    const Mask partly = c.holds < V(1.0);
    if (any(partly)) {
        ConstraintReading<V>& r = c.reading;
        const V part = select(partly, c.holds, V(1.0));
        r.load.force = part * r.load.force;
        Symmetric<V> softer;
        softer.add(part, r.load.stiffness);
        r.load.stiffness = softer;
        r.load.energy *= part, r.magnitude *= part, r.power *= part;
    }
    if (!any(off)) return;
    c.reading.load = select(off, ConstraintLoad<V>{}, c.reading.load);
    c.joint_load = select(off, ConstraintLoad<V>{}, c.joint_load);
    for (V* x : {&c.reading.magnitude, &c.reading.friction, &c.reading.power})
        *x = select(off, V(0.0), *x);
}

template <class V>
void RodPack<V>::add_constraints(std::size_t e, ElementSystem<V>& out) const {
    const V here(static_cast<double>(e));
    for (const PlacedConstraint<V>& c : constraints_) {
        const Mask mine = (c.element <= here) & (c.element >= here);
        if (!any(mine)) continue;
        const PointShape<V> at(c.xi, properties_[e].L);
        const V on = select(mine, V(1.0), V(0.0));
        V* rows[4] = {out.Ra, out.Ra + 3, out.Rb, out.Rb + 3};
        // R:22, rod rows: those of a point with weights A_i, those of a slope (R:42) with w_i
        const auto add = [&](const ConstraintLoad<V>& load, const V(&weight)[4]) {
            for (int i = 0; i < 4; ++i) {
                const V wi = on * weight[i];
                rows[i][0] -= wi * load.force.x, rows[i][1] -= wi * load.force.y;
                rows[i][2] -= wi * load.force.z;
                for (int k = 0; k < 4; ++k) {
                    if (i >= 2 && k < 2) continue;  // the transpose of ab
                    V(*block)[7] = i >= 2 ? out.bb : k >= 2 ? out.ab : out.aa;
                    const int i0 = 3 * (i % 2), k0 = 3 * (k % 2);
                    for (int p = 0; p < 3; ++p)
                        for (int q = 0; q < 3; ++q)
                            block[i0 + p][k0 + q] += wi * weight[k] * load.stiffness(p, q);
                }
            }
        };
        add(c.reading.load, at.A);
        if (!std::holds_alternative<NoSlopeLaw>(c.joint)) add(c.joint_load, at.w);
    }
}

template <class V>
void RodPack<V>::carry_constraints() {
    // The force at the solution of the linear system: f + Kt sum A_i d_i (x changes by -d)
    using T = LaneTraits<V>;
    for (PlacedConstraint<V>& c : constraints_) {
        Vector<V> turned;
        for (int i = 0; i < lanes; ++i) {
            const auto e = static_cast<std::size_t>(T::get(c.element, i));
            const PointShape<double> at(T::get(c.xi, i), T::get(properties_[e].L, i));
            const V(&da)[7] = correction_[e].x, (&db)[7] = correction_[e + 1].x;
            const auto sum = [&](const double(&w)[4]) {
                Vec3 out;
                for (int p = 0; p < 3; ++p)
                    out[p] = w[0] * T::get(da[p], i) + w[1] * T::get(da[3 + p], i) +
                             w[2] * T::get(db[p], i) + w[3] * T::get(db[3 + p], i);
                return out;
            };
            set_lane_vector(c.moved, i, sum(at.A));
            set_lane_vector(turned, i, sum(at.w));
        }
        c.force = c.reading.load.force + c.reading.load.stiffness * c.moved;
        c.slope_force = c.joint_load.force + c.joint_load.stiffness * turned;
        c.moment = cross(c.slope, c.slope_force);
    }
}

template <class V>
V RodPack<V>::constraint_misfit() const {
    V worst(0.0);
    const auto compare = [&](const Vector<V>& held, const Vector<V>& law) {
        const Vector<V> off = law - held;
        const V allowed =
            V(newton.constraint_force) + V(newton.constraint_part) * sqrt(dot(held, held));
        worst = max(worst, sqrt(dot(off, off)) / allowed);
    };
    for (const PlacedConstraint<V>& c : constraints_) {
        compare(c.force, c.reading.load.force);
        compare(c.slope_force, c.joint_load.force);
    }
    return worst;
}

template void RodPack<Single>::set_constraints(const Case&);
template void RodPack<Single>::place_constraints(const RodState<Single>&, Single, Single,
                                                 const MotionSpline&, bool);
template void RodPack<Single>::find_points();
template void RodPack<Single>::apply_laws(Single);
template void RodPack<Single>::add_constraints(std::size_t, ElementSystem<Single>&) const;
template void RodPack<Single>::carry_constraints();
template Single RodPack<Single>::constraint_misfit() const;
template void RodPack<Quad>::set_constraints(const Case&);
template void RodPack<Quad>::place_constraints(const RodState<Quad>&, Quad, Quad,
                                               const MotionSpline&, bool);
template void RodPack<Quad>::find_points();
template void RodPack<Quad>::apply_laws(Quad);
template void RodPack<Quad>::add_constraints(std::size_t, ElementSystem<Quad>&) const;
template void RodPack<Quad>::carry_constraints();
template Quad RodPack<Quad>::constraint_misfit() const;

}  // namespace hawser::worker
