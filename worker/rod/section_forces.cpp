#include "rod/section_forces.hpp"

#include "rod/rod_pack.hpp"

namespace hawser::worker {

std::array<double, gauss_points> shares_above(double xi) {
    // The cubic 1 at Gauss point g and 0 at the others, integrated by Gauss's own rule: exact.
    std::array<double, gauss_points> out{};
    for (std::size_t g = 0; g < gauss_points; ++g) {
        for (std::size_t k = 0; k < gauss_points; ++k) {
            const double x = xi + (1.0 - xi) * gauss_xi[k];
            double value = 1.0;
            for (std::size_t j = 0; j < gauss_points; ++j)
                if (j != g) value *= (x - gauss_xi[j]) / (gauss_xi[g] - gauss_xi[j]);
            out[g] += (1.0 - xi) * gauss_weight[k] * value;
        }
        out[g] /= gauss_weight[g];
    }
    return out;
}

template <class V>
void RodPack<V>::section_forces(SectionForces<V>& out) const {
    const std::size_t N = properties_.size();
    const NodeState<V>* node = working_.nodes();
    const Grip<V>* grips = working_.grips();
    const V moves(static_ ? 0.0 : 1.0);  // the rate of a quasi-static shape meets no load
    water_of_state(out);
    out.jumps.clear();
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
        if (constraints_[c].is_end_a || constraints_[c].is_end_b) continue;  // is the reaction
        const ConstraintState<V>& s = working_.constraints()[c];
        out.jumps.push_back({.element = s.element, .xi = s.xi, .force = s.force});
    }
    /// Sum of the constraints of element e with low <= xi < high.
    const auto constraints_between = [&](std::size_t e, double low, double high) {
        Vector<V> sum;
        const V here(static_cast<double>(e));
        for (const auto& jump : out.jumps) {
            const Mask mine = (jump.element <= here) & (jump.element >= here) &
                              (jump.xi >= V(low)) & (jump.xi < V(high));
            sum += select(mine, jump.force, Vector<V>{});
        }
        return sum;
    };
    const auto masses_at = [&](std::size_t n) {
        Vector<V> sum;
        for (const PointMass<V>& mass : masses_) {
            if (mass.node != static_cast<int>(n)) continue;
            const Water<V>& water = out.water[n == 0 ? 0 : n * gauss_points - 1];
            sum += point_mass_load(mass, node[n].r, moves * node[n].v, moves * node[n].a, water,
                                   V(0.0), V(0.0))
                       .f;
        }
        return sum;
    };

    // R:47, from end A
    Vector<V> F = working_.head().force_a;
    V length(0.0);
    for (std::size_t n = N + 1; n-- > 0;) {
        out.above[n] = F;
        F -= masses_at(n);
        if (n < N) F += constraints_between(n, -1.0, at_node);
        if (n > 0) F += constraints_between(n - 1, 1.0 - at_node, 2.0);
        out.below[n] = F;
        if (n == 0) break;

        const std::size_t e = n - 1;
        const ElementProperties<V>& p = properties_[e];
        const NodeState<V>&a = node[e], &b = node[n];
        const V L = p.L;
        length += L;
        Vector<V> sum;
        const auto at = [&](const auto& w, auto of_r, auto of_d) {
            return V(w[0]) * (a.*of_r) + (V(w[1]) * L) * (a.*of_d) + V(w[2]) * (b.*of_r) +
                   (V(w[3]) * L) * (b.*of_d);
        };
        using Node = NodeState<V>;
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const auto& w = shape.A[g];
            const auto& s = shape.slope[g];
            const PointMotion3<V> x{
                .r = at(w, &Node::r, &Node::d),
                .v = moves * at(w, &Node::v, &Node::vd),
                .a = moves * at(w, &Node::a, &Node::ad),
                .p = V(s[0]) * (b.r - a.r) + (V(s[1]) * L) * a.d + (V(s[2]) * L) * b.d};
            const V piece = V(gauss_weight[g]) * L;
            const std::size_t i = e * gauss_points + g;
            PointLoad<V> load = point_load(p, x, out.water[i], bed_, piece, V(0.0), V(0.0));
            if (grips != nullptr && any(load.on_bed > V(0.0)))
                load.f -=
                    bed_friction(bed_, load.on_bed, x.p, slide_of(bed_, Vector<V>{}, grips[i]))
                        .force;
            out.load[i] = piece * load.f;
            sum += out.load[i];
        }
        F -= sum;
        F += constraints_between(e, at_node, 1.0 - at_node);
        if (!parts_) continue;
        const V here(static_cast<double>(e));
        const Mask parted = (dead_ <= here) & (dead_ >= here);
        if (!any(parted)) continue;
        // nothing joins the two nodes: each carries half of the element's loads
        out.below[n] = select(parted, Vector<V>{}, out.below[n]);
        for (std::size_t g = 0; g < gauss_points; ++g) {
            Vector<V>& load = out.load[e * gauss_points + g];
            load = select(parted, Vector<V>{}, load);
        }
        F = select(parted, Vector<V>{} - V(0.5) * sum, F);
    }

    // What the balance misses at end B (the loads are those of the state, the reaction that of the
    // last linear solution) is spread along the rod, so that both ends have their reactions.
    out.gap = F + working_.head().force_b;
    out.gap = select(dead_ >= V(0.0), Vector<V>{}, out.gap);
    V from_a(0.0);
    for (std::size_t n = N + 1; n-- > 0;) {
        const V share = from_a / length;
        out.below[n] -= share * out.gap, out.above[n] -= share * out.gap;
        if (n == 0) break;
        const V piece = properties_[n - 1].L / length;
        for (std::size_t g = 0; g < gauss_points; ++g)
            out.load[(n - 1) * gauss_points + g] += (V(gauss_weight[g]) * piece) * out.gap;
        from_a += properties_[n - 1].L;
    }
}

template void RodPack<Single>::section_forces(SectionForces<Single>&) const;
template void RodPack<Quad>::section_forces(SectionForces<Quad>&) const;

}  // namespace hawser::worker
