// Tabulated tension: the spring of a material's first element (R:4) is a table of tension against
// strain, straight between its points and beyond its ends, rising. R:41.
#include "rod/curves.hpp"

#include "rod/rod_pack.hpp"

namespace hawser::worker {

namespace {
constexpr double strain_misfit = 1e-7;  // between the law and its linearisation
}  // namespace

CurvePoint strain_under(const Curve& curve, double c, double load) {
    std::size_t i = 1;
    while (i + 1 < curve.size() && curve[i][1] + c * curve[i][0] < load) ++i;
    const auto &a = curve[i - 1], &b = curve[i];
    const double slope = (b[1] - a[1]) / (b[0] - a[0]);
    return {.strain = a[0] + (load - a[1] - c * a[0]) / (slope + c), .slope = slope};
}

template <class V>
void RodPack<V>::set_curves(const Case& input) {
    using T = LaneTraits<V>;
    curved_.assign(properties_.size(), T::none());
    curve_of_.assign(properties_.size(), {});
    for (auto& row : curve_of_) row.fill(-1);
    for (int i = 0; i < lanes; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const Line& line = input.lines[static_cast<std::size_t>(
            lines_[lane < lines_.size() ? lane : std::size_t{0}])];
        const LineMesh mesh = mesh_of(line);
        for (std::size_t e = 0; e < properties_.size(); ++e) {
            const auto section = static_cast<std::size_t>(mesh.section[properties_.size() - 1 - e]);
            const auto type = static_cast<std::size_t>(line.sections[section].type);
            const Curve& curve = input.line_types[type].EA_curve;
            if (curve.empty()) continue;
            if (curves_.empty() || curves_.back() != curve) curves_.push_back(curve);
            curve_of_[e][lane] = static_cast<int>(curves_.size()) - 1;
            T::set(curved_[e], i, true);
        }
    }
}

template <class V>
auto RodPack<V>::follow_curves(Mask which, const RodState<V>* before, V h) -> Mask {
    using T = LaneTraits<V>;
    const V g(scheme_.g_damper);
    const V ratio((1.0 - scheme_.g_damper) / scheme_.g_damper);
    V misfit(0.0);
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        if (!any(curved_[e] & which)) continue;
        const ElementProperties<V>& p = properties_[e];
        const V c = before ? p.c_damper / (g * h) : V(0.0);
        const V s2 = V(1.0) / (p.K_creep + (before ? p.c_creep * V(2.0) / h : V(0.0)));
        for (std::size_t k = 0; k < gauss_points; ++k) {
            V& s = material_[e].s[k];
            V& b = material_[e].b[k];
            const V l = V(shape.P[k][0]) * lambda_[2 * e] + V(shape.P[k][1]) * lambda_[2 * e + 1] +
                        V(shape.P[k][2]) * lambda_[2 * e + 2];
            const V tension = l * (V(1.0) + b) / (V(1.0) - min(s * l, V(0.5)));
            V load = tension, b2(0.0);
            if (before) {
                const Strain<V>& q = before->strain()[e * gauss_points + k];
                load += c * q.damper + p.c_damper * ratio * q.damper_rate;
                b2 = s2 * p.c_creep * (q.creep * V(2.0) / h + q.creep_rate);
            }
            for (int i = 0; i < lanes; ++i) {
                if (!T::get(curved_[e] & which, i)) continue;
                const int at = curve_of_[e][static_cast<std::size_t>(i)];
                const CurvePoint point = strain_under(curves_[static_cast<std::size_t>(at)],
                                                      T::get(c, i), T::get(load, i));
                const double s1 = 1.0 / (point.slope + T::get(c, i)), Ti = T::get(tension, i);
                const double now = point.strain + T::get(b2, i) + T::get(s2, i) * Ti;
                const double was = T::get(b, i) + T::get(s, i) * Ti;
                T::set(misfit, i, std::max(T::get(misfit, i), std::abs(now - was)));
                T::set(s, i, s1 + T::get(s2, i));
                T::set(b, i, point.strain - s1 * Ti + T::get(b2, i));
            }
        }
    }
    return misfit <= V(strain_misfit);
}

template void RodPack<Single>::set_curves(const Case&);
template Single::Mask RodPack<Single>::follow_curves(Single::Mask, const RodState<Single>*, Single);
template void RodPack<Quad>::set_curves(const Case&);
template Quad::Mask RodPack<Quad>::follow_curves(Quad::Mask, const RodState<Quad>*, Quad);

}  // namespace hawser::worker
