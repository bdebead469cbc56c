// What changes in a line with time: a line that parts (LineFailure), line paid out by a winch
// (Winch). Both are functions of the time of the step alone, so that every pass and every restart
// from a kept state finds the same line.
#include <algorithm>
#include <cmath>

#include "rod/rod_pack.hpp"

namespace hawser::worker {

namespace {

constexpr double never = 1e300;
constexpr double orphan_damping = 10.0;     // of a slope that no stiffness holds any more [1/s]
constexpr double orphan_compliance = 1e-6;  // of an element that has parted, of its own

/// Value at x, straight between the points, constant beyond them.
double value_at(const Curve& curve, double x) {
    if (curve.empty()) return 0.0;
    if (x <= curve.front()[0]) return curve.front()[1];
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const auto &a = curve[i - 1], &b = curve[i];
        if (x <= b[0]) return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    }
    return curve.back()[1];
}

}  // namespace

template <class V>
void RodPack<V>::set_changes(const Case& input) {
    using T = LaneTraits<V>;
    const int N = elements();
    full_length_.clear();
    for (const ElementProperties<V>& p : properties_) full_length_.push_back(p.L);
    parting_time_ = V(never), parting_element_ = V(-1.0), dead_ = V(-1.0);
    parted_ = lets_go_a_ = released_ = T::none();
    winch_.resize(static_cast<std::size_t>(lanes));
    for (int i = 0; i < lanes; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const Line& line = input.lines[static_cast<std::size_t>(
            lines_[lane < lines_.size() ? lane : std::size_t{0}])];
        if (line.fail) {
            const std::vector<double>& arc = arc_length_[lane];  // from end B
            const double place = arc.back() - line.fail->arc_length;
            const auto nearest = [&](double s) {
                int node = 0;
                for (int n = 0; n <= N; ++n)
                    if (std::abs(arc[static_cast<std::size_t>(n)] - s) <
                        std::abs(arc[static_cast<std::size_t>(node)] - s))
                        node = n;
                return node;
            };
            const int node = nearest(place);
            parts_ = true;
            T::set(parting_time_, i, line.fail->time);
            // What holds the rod at end A lets go with it; a tensioner's ring anywhere.
            for (PlacedConstraint<V>& c : constraints_) {
                const LineConstraint& at = c.at[lane];
                if (c.mirror || !at.arc_length) continue;
                const bool held_here = nearest(arc.back() - *at.arc_length) == node;
                const bool its = node == N || at.type == ConstraintType::tensioner;
                if (held_here && its) T::set(c.lets_go, i, true);
            }
            // towards end A from the node; at end A itself the platform lets go
            if (node == N) {
                T::set(lets_go_a_, i, true);
            } else {
                T::set(parting_element_, i, node);
            }
        }
        if (line.winch) {
            winds_ = true;
            winch_[lane] = {.paid_out = line.winch->paid_out,
                            .section = line.sections.front().length,
                            .elements = line.sections.front().elements};
        }
    }
    if (winds_) pay_out(V(0.0));
}

template <class V>
void RodPack<V>::pay_out(V t) {
    using T = LaneTraits<V>;
    for (int i = 0; i < lanes; ++i) {
        const WoundLine& winch = winch_[static_cast<std::size_t>(i)];
        if (winch.elements == 0) continue;
        const double factor = 1.0 + value_at(winch.paid_out, T::get(t, i)) / winch.section;
        for (int e = elements() - winch.elements; e < elements(); ++e) {
            const auto k = static_cast<std::size_t>(e);
            T::set(properties_[k].L, i, factor * T::get(full_length_[k], i));
        }
    }
}

template <class V>
void RodPack<V>::part(V t) {
    parted_ = t > parting_time_;
    released_ = parted_ & lets_go_a_;
    dead_ = select(parted_, parting_element_, V(-1.0));
}

template <class V>
void RodPack<V>::part_element(std::size_t e, V a0, V a1) {
    using detail::place;
    using detail::put;
    const V here(static_cast<double>(e));
    const Mask mine = (dead_ <= here) & (dead_ >= here);
    if (!any(mine)) return;
    // Half of its mass and loads on either node; nothing joins the two. The slope and the
    // multiplier of a node that is left alone come to rest.
    const ElementProperties<V>& p = properties_[e];
    const V half(V(0.5) * p.L), c = V(orphan_compliance) * p.L / p.K_damper;
    const V turns = (p.m + p.ma) * p.L * p.L * p.L * V(1.0 / 105.0);
    ElementSystem<V> cut{};
    const auto lump = [&](const TrialNode<V>& x, const Water<V>& water, const V& lambda,
                          V(&D)[7][7], V(&R)[7]) {
        const PointLoad<V> load = point_load(p, {.r = x.r, .v = x.v, .a = x.a, .p = p.L * x.d},
                                             water, bed_, half, a0, a1);
        put(R, half * load.f);
        place(D, 0, 0, load.S, half, V(0.0));
        put(R + 3, turns * x.ad + (V(orphan_damping) * turns) * x.vd);
        place(D, 3, 3, Symmetric<V>{}, V(0.0), (a0 + V(orphan_damping) * a1) * turns);
        R[6] = -(c * lambda);
        D[6][6] = -c;
    };
    lump(trial_[e], water_[e * gauss_points], lambda_[2 * e], cut.aa, cut.Ra);
    lump(trial_[e + 1], water_[e * gauss_points + gauss_points - 1], lambda_[2 * e + 2], cut.bb,
         cut.Rb);
    cut.inverse_pivot = V(-1.0) / c;
    cut.R_middle = -(c * lambda_[2 * e + 1]);

    ElementSystem<V>& to = element_;
    for (int i = 0; i < 7; ++i) {
        to.Ra[i] = select(mine, cut.Ra[i], to.Ra[i]);
        to.Rb[i] = select(mine, cut.Rb[i], to.Rb[i]);
        for (int k = 0; k < 7; ++k) {
            to.ab[i][k] = select(mine, V(0.0), to.ab[i][k]);
            if (k > i) continue;
            to.aa[i][k] = select(mine, cut.aa[i][k], to.aa[i][k]);
            to.bb[i][k] = select(mine, cut.bb[i][k], to.bb[i][k]);
        }
    }
    for (V& x : to.column) x = select(mine, V(0.0), x);
    to.inverse_pivot = select(mine, cut.inverse_pivot, to.inverse_pivot);
    to.R_middle = select(mine, cut.R_middle, to.R_middle);
}

template void RodPack<Single>::set_changes(const Case&);
template void RodPack<Single>::pay_out(Single);
template void RodPack<Single>::part(Single);
template void RodPack<Single>::part_element(std::size_t, Single, Single);
template void RodPack<Quad>::set_changes(const Case&);
template void RodPack<Quad>::pay_out(Quad);
template void RodPack<Quad>::part(Quad);
template void RodPack<Quad>::part_element(std::size_t, Quad, Quad);

}  // namespace hawser::worker
