#include "rod/recovered.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::worker {

namespace {

constexpr double degrees = 180.0 / M_PI;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Elements on either side of a point load over which the slope of a chain is smeared.
constexpr int kink_elements = 2;
/// Where the second derivative of a cubic is most exact.
constexpr double best_low = 0.21132486540518711775, best_high = 1.0 - best_low;

template <class V>
void set_section(StressSection<V>& to, int lane, const StressSection<double>& from) {
    using T = LaneTraits<V>;
    T::set(to.area, lane, from.area), T::set(to.inner_radius, lane, from.inner_radius);
    T::set(to.outer_radius, lane, from.outer_radius);
    T::set(to.second_moment, lane, from.second_moment);
    T::set(to.concentration, lane, from.concentration);
    T::set(to.contents_weight, lane, from.contents_weight);
    T::set(to.yield, lane, from.yield), T::set(to.breaking_load, lane, from.breaking_load);
    T::set(to.no_wall, lane, from.no_wall);
}

bool same(const StressSection<double>& a, const StressSection<double>& b) {
    const auto equal = [](double x, double y) {
        return x == y || (std::isnan(x) && std::isnan(y));
    };
    return equal(a.area, b.area) && equal(a.second_moment, b.second_moment) &&
           equal(a.outer_radius, b.outer_radius) && equal(a.yield, b.yield) &&
           equal(a.concentration, b.concentration) && equal(a.breaking_load, b.breaking_load);
}

/// A point of the rod: position, velocity, slope r', r'', moment vector B r'' and its rate along s.
template <class V>
struct RodPoint {
    Vector<V> r, v, d, bend, moment, moment_rate;
    V tension, p_i, p_o, seabed;
    Vector<V> towards;  ///< direction of the line, whatever its length; d but beside point loads
};

/// The quantities that depend on the section.
template <class V>
[[gnu::always_inline]] inline void put_stress(const StressSection<V>& section,
                                              const RodPoint<V>& at, V moment, Recovered<V>& out) {
    const auto put = [&](LineQuantity q, V x) { out[index_of(q)] = x; };
    const V wall = wall_force(section, at.tension, at.p_i, at.p_o);
    const Stresses<V> s = stresses(section, wall, moment, at.p_i, at.p_o);
    put(LineQuantity::wall_tension, wall + section.no_wall);
    put(LineQuantity::axial_stress, s.axial);
    put(LineQuantity::bending_stress, s.bending + (section.area - section.area));
    put(LineQuantity::von_mises_stress, s.von_mises);
    put(LineQuantity::yield_utilisation, s.von_mises / section.yield);
    put(LineQuantity::load_utilisation, at.tension / section.breaking_load);
}

template <class V>
[[gnu::always_inline]] inline void put_shape(const RodPoint<V>& at, bool angles,
                                             Recovered<V>& out) {
    using Q = LineQuantity;
    using T = LaneTraits<V>;
    const auto put = [&](Q q, V x) { out[index_of(q)] = x; };
    const V n2 = dot(at.d, at.d), n = sqrt(n2);
    const V inverse_n3 = V(1.0) / (n2 * n);
    const Vector<V> turn = cross(at.d, at.bend), couple = cross(at.d, at.moment);
    const Vector<V> across = at.moment_rate - (dot(at.moment_rate, at.d) / n2) * at.d;
    put(Q::effective_tension, at.tension);
    put(Q::axial_strain, n - V(1.0));
    put(Q::curvature, sqrt(dot(turn, turn)) * inverse_n3);
    put(Q::bend_moment, sqrt(dot(couple, couple)) * inverse_n3);
    put(Q::shear_force, sqrt(dot(across, across)));
    put(Q::seabed_force, at.seabed);
    put(Q::x, at.r.x), put(Q::y, at.r.y), put(Q::z, at.r.z);
    put(Q::vx, at.v.x), put(Q::vy, at.v.y), put(Q::vz, at.v.z);
    if (!angles) return;
    for (int i = 0; i < T::count; ++i) {  // it points towards end A, the angles are of the opposite
        const double x = -T::get(at.towards.x, i), y = -T::get(at.towards.y, i),
                     z = T::get(at.towards.z, i);
        T::set(out[index_of(Q::declination)], i, degrees * std::atan2(std::hypot(x, y), z));
        T::set(out[index_of(Q::azimuth)], i, degrees * std::atan2(y, x));
    }
}

template <class V>
void choose_larger_stress(Recovered<V>& out, const Recovered<V>& other) {
    constexpr std::size_t vm = index_of(LineQuantity::von_mises_stress);
    // where one side has no stress, the other side's; else the larger
    const auto take = (!(out[vm] >= other[vm])) & (other[vm] <= other[vm]);
    for (const LineQuantity q : {LineQuantity::wall_tension, LineQuantity::axial_stress,
                                 LineQuantity::bending_stress, LineQuantity::von_mises_stress})
        out[index_of(q)] = select(take, other[index_of(q)], out[index_of(q)]);
    for (const LineQuantity q : {LineQuantity::yield_utilisation, LineQuantity::load_utilisation}) {
        const std::size_t k = index_of(q);
        out[k] = select((!(out[k] >= other[k])) & (other[k] <= other[k]), other[k], out[k]);
    }
}

Vector<Single> lane_of(const Vector<Quad>& x, int lane) {
    return {Single(x.x[lane]), Single(x.y[lane]), Single(x.z[lane])};
}
Vector<Single> lane_of(const Vector<Single>& x, int) { return x; }

}  // namespace

template <class V>
Recovery<V>::Recovery(const Case& input, const RodPack<V>& rod)
    : gravity_(input.environment.water.gravity),
      water_density_(input.environment.water.density),
      forces_(rod.elements()),
      has_forces_(rod.model() != LineModel::catenary) {
    using T = LaneTraits<V>;
    const auto N = static_cast<std::size_t>(rod.elements());
    below_.resize(N + 1), above_.resize(N + 1);
    joint_.assign(N + 1, 0);
    contents_weight_.resize(N);
    beside_load_.assign(N, 0);
    bend_.resize(2 * N);
    nodes_.resize(N + 1);
    tensions_.resize(N + 1);
    for (int i = 0; i < T::count; ++i) {
        const std::size_t used =
            static_cast<std::size_t>(i) < rod.lines().size() ? static_cast<std::size_t>(i) : 0;
        const Line& line = input.lines[static_cast<std::size_t>(rod.lines()[used])];
        const std::vector<double>& arc = rod.arc_length(i);
        for (const int from_a : mesh_of(line).attachment_node) {
            const int node = static_cast<int>(N) - from_a;
            const auto first = static_cast<std::size_t>(std::max(0, node - kink_elements));
            for (std::size_t e = first; e < N && static_cast<int>(e) < node + kink_elements; ++e)
                beside_load_[e] = 1;
        }
        T::set(internal_pressure_, i, line.internal_pressure);
        for (std::size_t n = 0; n <= N; ++n) {  // towards end B the section that begins there
            const double s = arc.back() - arc[n];
            const StressSection<double> b = stress_section(input, line, s, true);
            const StressSection<double> a = stress_section(input, line, s, false);
            set_section(below_[n], i, b), set_section(above_[n], i, a);
            if (!same(a, b)) joint_[n] = 1;
            if (n == N) continue;
            const double middle = arc.back() - 0.5 * (arc[n] + arc[n + 1]);
            const double weight = stress_section(input, line, middle, true).contents_weight;
            T::set(contents_weight_[n], i, weight);
            has_contents_ = has_contents_ || weight != 0.0;
        }
    }
}

template <class V>
Vector<V> Recovery<V>::second_derivative(const RodPack<V>& rod, std::size_t e, double xi) const {
    const NodeState<V>&a = rod.state().nodes()[e], &b = rod.state().nodes()[e + 1];
    const V L = rod.properties()[e].L;
    const auto c = reduced_curvature(xi);  // R:8
    return V(1.0) / (L * L) * (V(c[0]) * (b.r - a.r) + (V(c[1]) * L) * a.d + (V(c[2]) * L) * b.d);
}

template <class V>
auto Recovery<V>::pulled(const RodPack<V>& rod, std::size_t element, const Vector<V>& F,
                         const Vector<V>& d) const -> Pulled {
    Pulled out{(V(1.0) / sqrt(dot(d, d))) * dot(F, d), d};
    if (beside_load_[element] == 0) return out;
    const auto chain = rod.properties()[element].B <= V(0.0);
    const V sign = select(out.tension < V(0.0), V(-1.0), V(1.0)), size = sqrt(dot(F, F));
    out.tension = select(chain, sign * size, out.tension);
    out.towards = select(chain & (size > V(0.0)), sign * F, d);
    return out;
}

template <class V>
void Recovery<V>::recover(const RodPack<V>& rod, bool angles) {
    using T = LaneTraits<V>;
    const auto N = static_cast<std::size_t>(rod.elements());
    const NodeState<V>* node = rod.state().nodes();
    const Multiplier<V>* lambda = rod.state().lambda();
    const std::vector<ElementProperties<V>>& element = rod.properties();
    if (has_forces_) rod.section_forces(forces_);
    for (std::size_t e = 0; e < N; ++e) {
        bend_[2 * e] = second_derivative(rod, e, best_low);
        bend_[2 * e + 1] = second_derivative(rod, e, best_high);
    }
    V p_i = internal_pressure_;
    for (std::size_t n = N + 1; n-- > 0;) {  // from end A, for the head of the contents
        RodPoint<V> at;
        at.r = node[n].r, at.v = node[n].v, at.d = at.towards = node[n].d;
        V above = lambda[2 * n].now * sqrt(dot(at.d, at.d)), below = above;  // R:2
        if (has_forces_) {                                                   // R:37
            const Pulled up = pulled(rod, n == N ? N - 1 : n, forces_.above[n], at.d);
            const Pulled down = pulled(rod, n == 0 ? 0 : n - 1, forces_.below[n], at.d);
            above = up.tension, below = down.tension;
            if (n == 0) below = above;  // what is inside the rod
            if (n == N) above = below;
            at.towards = n == 0 ? up.towards : down.towards;
        }
        if (n == N ? rod.held_a() : n == 0 && rod.held_b()) {
            for (int i = 0; i < static_cast<int>(rod.lines().size()); ++i)
                T::set(below, i, n == N ? rod.tension_a(i) : rod.tension_b(i));
            above = below;
        }
        at.tension = below;
        tensions_[n] = {min(above, below), max(above, below)};
        const bool jumps = any((above > below) | (above < below));
        if (n < N && has_contents_) p_i += contents_weight_[n] * (node[n + 1].r.z - at.r.z);
        at.p_i = p_i;
        at.p_o = V(water_density_ * gravity_) * max(V(0.0), -at.r.z);
        const std::size_t near = n == N ? N - 1 : n;  // the element towards end A
        const V D = element[near].D;
        at.seabed = bed_contact(rod.bed(), height_on_bed(rod.bed(), at.r),
                                speed_off_bed(rod.bed(), at.v), D, V(0.0))
                        .force;

        // r'' and B r'' straight between the two points around, i and i + 1
        const bool inside = n > 0 && n < N;
        const std::size_t i = n == 0 ? 0 : 2 * n - (inside ? 1 : 2);
        const std::size_t ea = i / 2, eb = (i + 1) / 2;
        const V La = element[ea].L, Lb = element[eb].L;
        const V before = inside ? V(best_low) * La : n == 0 ? V(-best_low) * La : V(best_high) * La;
        const V apart = inside ? V(best_low) * (La + Lb) : V(best_high - best_low) * La;
        const V x = before / apart;
        const Vector<V> Ma = element[ea].B * bend_[i], Mb = element[eb].B * bend_[i + 1];
        at.bend = bend_[i] + x * (bend_[i + 1] - bend_[i]);
        at.moment = Ma + x * (Mb - Ma);
        at.moment_rate = V(1.0) / apart * (Mb - Ma);
        if (!inside && has_forces_)  // that of the middle, less F there to here
            for (std::size_t g = 0; g < gauss_points; ++g)
                at.moment_rate -= V(upper_half_[g] - (n == 0 ? 1.0 : 0.0)) *
                                  forces_.load[near * gauss_points + g];

        Recovered<V>& out = nodes_[n];
        put_shape(at, angles, out);
        const V moment = out[index_of(LineQuantity::bend_moment)];
        put_stress(below_[n], at, moment, out);
        if (joint_[n] != 0 || jumps) {
            Recovered<V> other;
            at.tension = above;
            put_stress(above_[n], at, moment, other);
            choose_larger_stress(out, other);
        }
    }
}

template <class V>
RodPlace Recovery<V>::place(const Case& input, const RodPack<V>& rod, int lane,
                            double arc_length) const {
    const Line& line =
        input.lines[static_cast<std::size_t>(rod.lines()[static_cast<std::size_t>(lane)])];
    const std::vector<double>& arc = rod.arc_length(lane);
    const double s = std::clamp(arc.back() - arc_length, 0.0, arc.back());  // from end B
    RodPlace p;
    p.lane = lane;
    while (p.element + 1 < rod.elements() && arc[static_cast<std::size_t>(p.element) + 1] <= s)
        ++p.element;
    const auto e = static_cast<std::size_t>(p.element);
    p.xi = (s - arc[e]) / (arc[e + 1] - arc[e]);
    p.end = s <= 0.0 ? -1 : s >= arc.back() ? 1 : 0;
    p.above = shares_above(p.xi);
    set_section(p.section, 0, stress_section(input, line, arc_length, true));
    return p;
}

template <class V>
Vector<Single> Recovery<V>::force_at(const RodPack<V>& rod, const RodPlace& place) const {
    using T = LaneTraits<V>;
    const auto e = static_cast<std::size_t>(place.element);
    const int lane = place.lane;
    if (!has_forces_) {  // lambda r'
        const NodeState<V>&a = rod.state().nodes()[e], &b = rod.state().nodes()[e + 1];
        const auto P = quadratic(place.xi);
        const auto g = reduced_slope(place.xi);
        const double L = T::get(rod.properties()[e].L, lane);
        double lambda = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            lambda += P[k] * T::get(rod.state().lambda()[2 * e + k].now, lane);
        return Single(lambda / L) *
               (Single(g[0]) * lane_of(b.r - a.r, lane) + Single(g[1] * L) * lane_of(a.d, lane) +
                Single(g[2] * L) * lane_of(b.d, lane));
    }
    // R:47; at a node the side towards end B, at end B what is inside the rod
    if (place.xi <= 0.0) return lane_of(e == 0 ? forces_.above[0] : forces_.below[e], lane);
    Vector<Single> F = lane_of(forces_.below[e + 1], lane);
    if (place.xi >= 1.0) return F;
    for (std::size_t g = 0; g < gauss_points; ++g)
        F -= Single(place.above[g]) * lane_of(forces_.load[e * gauss_points + g], lane);
    for (const auto& jump : forces_.jumps) {
        const double xi = T::get(jump.xi, lane);
        if (T::get(jump.element, lane) == static_cast<double>(place.element) && xi >= place.xi &&
            xi < 1.0 - at_node && xi > at_node)
            F += lane_of(jump.force, lane);
    }
    return F;
}

template <class V>
Recovered<Single> Recovery<V>::at(const RodPack<V>& rod, const RodPlace& place) const {
    using T = LaneTraits<V>;
    const auto N = static_cast<std::size_t>(rod.elements());
    const auto e = static_cast<std::size_t>(place.element);
    const int lane = place.lane;
    const NodeState<V>* node = rod.state().nodes();
    const auto length = [&](std::size_t k) { return T::get(rod.properties()[k].L, lane); };
    const auto sum = [&](const auto& f, auto of_r, auto of_d) {
        const double L = length(e);
        return Single(f[0]) * lane_of(node[e].*of_r, lane) +
               Single(L * f[1]) * lane_of(node[e].*of_d, lane) +
               Single(f[2]) * lane_of(node[e + 1].*of_r, lane) +
               Single(L * f[3]) * lane_of(node[e + 1].*of_d, lane);
    };
    using Node = NodeState<V>;
    RodPoint<Single> at;
    at.r = sum(hermite(place.xi), &Node::r, &Node::d);
    at.v = sum(hermite(place.xi), &Node::v, &Node::vd);
    const auto g = reduced_slope(place.xi);
    at.d = Single(1.0 / length(e)) *
           sum(std::array<double, 4>{-g[0], g[1], g[0], g[2]}, &Node::r, &Node::d);
    at.tension = dot(force_at(rod, place), at.d) / sqrt(dot(at.d, at.d));
    at.towards = at.d;
    const std::size_t side = place.xi <= 0.0 && e > 0 ? e - 1 : e;  // of a node towards end B
    if (has_forces_ && beside_load_[side] != 0 && T::get(rod.properties()[side].B, lane) <= 0.0) {
        const Vector<Single> F = force_at(rod, place);
        const Single sign = select(at.tension < Single(0.0), Single(-1.0), Single(1.0)),
                     size = sqrt(dot(F, F));
        at.tension = sign * size;
        if (any(size > Single(0.0))) at.towards = sign * F;
    }
    if (place.end > 0 && rod.held_a()) at.tension = rod.tension_a(lane);
    if (place.end < 0 && rod.held_b()) at.tension = rod.tension_b(lane);
    at.p_i = T::get(internal_pressure_, lane);
    if (has_contents_) {
        for (std::size_t k = N; k-- > e;) {
            const Single low = k == e ? at.r.z : Single(T::get(node[k].r.z, lane));
            at.p_i += Single(T::get(contents_weight_[k], lane)) *
                      (Single(T::get(node[k + 1].r.z, lane)) - low);
        }
    }
    at.p_o = Single(water_density_ * gravity_) * max(Single(0.0), -at.r.z);
    const Single D(T::get(rod.properties()[e].D, lane));
    at.seabed = bed_contact(rod.bed(), height_on_bed(rod.bed(), at.r),
                            speed_off_bed(rod.bed(), at.v), D, Single(0.0))
                    .force;

    // The two points around: of this element, or one of a neighbour
    std::size_t ea = e, eb = e;
    double xa = best_low, xb = best_high;
    if (place.xi < best_low && e > 0) eb = e, xb = best_low, ea = e - 1, xa = best_high;
    if (place.xi > best_high && e + 1 < N) ea = e, xa = best_high, eb = e + 1, xb = best_low;
    // arc lengths counted from the low end of element e
    const double sa = ea < e ? (xa - 1.0) * length(ea) : xa * length(e);
    const double sb = eb > e ? length(e) + xb * length(eb) : xb * length(e);
    const Single apart(sb - sa), x((place.xi * length(e) - sa) / (sb - sa));
    const Vector<Single> ka = lane_of(second_derivative(rod, ea, xa), lane);
    const Vector<Single> kb = lane_of(second_derivative(rod, eb, xb), lane);
    const Vector<Single> Ma = Single(T::get(rod.properties()[ea].B, lane)) * ka;
    const Vector<Single> Mb = Single(T::get(rod.properties()[eb].B, lane)) * kb;
    at.bend = ka + x * (kb - ka);
    at.moment = Ma + x * (Mb - Ma);
    at.moment_rate = Single(1.0) / apart * (Mb - Ma);
    const bool last = ea == eb && (place.xi < best_low || place.xi > best_high);
    if (last && has_forces_)
        for (std::size_t k = 0; k < gauss_points; ++k)
            at.moment_rate -= Single(upper_half_[k] - place.above[k]) *
                              lane_of(forces_.load[e * gauss_points + k], lane);

    Recovered<Single> out;
    put_shape(at, true, out);
    put_stress(place.section, at, out[index_of(LineQuantity::bend_moment)], out);
    return out;
}

template <class V>
Grounding Recovery<V>::grounding(const RodPack<V>& rod, int lane) const {
    using T = LaneTraits<V>;
    constexpr int parts = 4;  // of an element, for the search of the first crossing
    const NodeState<V>* node = rod.state().nodes();
    const std::vector<double>& arc = rod.arc_length(lane);
    Grounding out{.touchdown = nan, .position = Vec3::Constant(nan)};
    const auto point = [&](std::size_t e, double xi) {
        const auto A = hermite(xi);
        const double L = T::get(rod.properties()[e].L, lane);
        const auto get = [&](auto c) {
            return A[0] * T::get(node[e].r.*c, lane) + L * A[1] * T::get(node[e].d.*c, lane) +
                   A[2] * T::get(node[e + 1].r.*c, lane) +
                   L * A[3] * T::get(node[e + 1].d.*c, lane);
        };
        return Vec3(get(&Vector<V>::x), get(&Vector<V>::y), get(&Vector<V>::z));
    };
    const auto penetration = [&](std::size_t e, double xi) {  // of R:33
        const Vec3 from_origin = point(e, xi) - Vec3(0.0, 0.0, rod.bed().z);
        return 0.5 * T::get(rod.properties()[e].D, lane) - rod.bed().normal.dot(from_origin);
    };
    bool touched = false;
    for (auto e = static_cast<std::size_t>(rod.elements()); e-- > 0;) {
        double before = penetration(e, 1.0);
        if (before > 0.0 && !touched) {  // end A itself lies there, or a thicker element begins
            touched = true;
            out.touchdown = arc.back() - arc[e + 1], out.position = point(e, 1.0);
        }
        for (int k = parts; k-- > 0;) {
            const double high = (k + 1.0) / parts, low = k / static_cast<double>(parts);
            const double after = penetration(e, low);
            const double part = (high - low) * (arc[e + 1] - arc[e]);
            if (before > 0.0 && after > 0.0) out.grounded += part;
            if ((before > 0.0) != (after > 0.0)) {
                out.grounded += part * std::max(before, after) / std::abs(after - before);
                if (!touched) {
                    double out_of = high, in = low;
                    for (int i = 0; i < 40; ++i) {
                        const double middle = 0.5 * (out_of + in);
                        (penetration(e, middle) > 0.0 ? in : out_of) = middle;
                    }
                    touched = true;
                    out.touchdown = arc.back() - (arc[e] + in * (arc[e + 1] - arc[e]));
                    out.position = point(e, in);
                }
            }
            before = after;
        }
    }
    // An end that is held at the height of the bed is in contact by half a diameter: no touchdown.
    if (out.grounded < 2.0 * T::get(rod.properties()[0].D, lane))
        out = {.touchdown = nan, .position = Vec3::Constant(nan)};
    return out;
}

template class Recovery<Single>;
template class Recovery<Quad>;

}  // namespace hawser::worker
