#include "rod/catenary.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::worker {

namespace {

/// Plane march from B to A: x horizontal towards A, z up, V vertical tension.
struct March {
    const std::vector<CatenaryElement>& elements;
    double z_b;
    bool on_bed;

    struct End {
        double x, z, V;
    };

    /// Ends of all elements for horizontal tension H and parameter u: u >= 0 (or no bed) is the
    /// vertical tension at B; u < 0 with a bed means that a length -u lies on it.
    template <class Visit>
    End run(double H, double u, Visit visit) const {
        double grounded = on_bed && u < 0.0 ? -u : 0.0;
        End p{0.0, z_b, grounded > 0.0 ? 0.0 : u};
        visit(p);
        for (const CatenaryElement& e : elements) {
            const double lying = std::min(grounded, e.length);
            grounded -= lying;
            p.x += lying * (1.0 + H / e.EA);
            const double L = e.length - lying;
            if (L > 0.0) advance(e, H, L, p);
            p.V += e.point_weight;
            visit(p);
        }
        return p;
    }

 private:
    /// One elastic catenary piece (Irvine): dx = (H/w)(asinh(V2/H) - asinh(V1/H)) + H L/EA, and so
    /// on.
    static void advance(const CatenaryElement& e, double H, double L, End& p) {
        const double w = p.z < 0.0 ? e.weight_wet : e.weight_dry;
        const double V2 = p.V + w * L;
        const double T1 = std::hypot(H, p.V), T2 = std::hypot(H, V2);
        if (std::abs(w) * L > 1e-9 * (T1 + T2)) {
            p.x += H / w * (std::asinh(V2 / H) - std::asinh(p.V / H));
            p.z += (T2 - T1) / w;
        } else {
            p.x += H / T1 * L;
            p.z += p.V / T1 * L;
        }
        p.x += H * L / e.EA;
        p.z += (p.V + V2) / 2 * L / e.EA;
        p.V = V2;
    }
};

/// Root of a growing function between lo and hi; a fixed number of halvings, so the same bits
/// always.
template <class F>
double bisect(double lo, double hi, F f) {
    for (int i = 0; i < 200 && lo < hi; ++i) {
        const double mid = 0.5 * (lo + hi);
        if (mid <= lo || mid >= hi) break;
        (f(mid) < 0.0 ? lo : hi) = mid;
    }
    return 0.5 * (lo + hi);
}

}  // namespace

Catenary solve_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                        bool on_bed) {
    double length = 0.0, weight = 0.0, EA = 0.0;
    for (const CatenaryElement& e : elements) {
        length += e.length;
        weight += std::abs(e.weight_wet) * e.length + std::abs(e.point_weight);
        EA = std::max(EA, e.EA);
    }
    const double scale = weight + 1.0;
    const double span = std::hypot(a.x() - b.x(), a.y() - b.y());
    const double tiny_span = 1e-6 * length;  // a vertical line: any direction will do
    const Vec3 towards = span > tiny_span
                             ? Vec3((a.x() - b.x()) / span, (a.y() - b.y()) / span, 0.0)
                             : Vec3::UnitX();
    const March march{elements, b.z(), on_bed};
    const auto nothing = [](const March::End&) {};

    // Height of end A grows with u: bracket, then bisect.
    const auto u_for = [&](double H) {
        const auto miss = [&](double u) { return march.run(H, u, nothing).z - a.z(); };
        double lo = on_bed ? -length : -scale, hi = scale;
        for (int i = 0; i < 60 && miss(hi) < 0.0; ++i) hi *= 2.0;
        for (int i = 0; i < 60 && !on_bed && miss(lo) > 0.0; ++i) lo *= 2.0;
        return bisect(lo, hi, miss);
    };
    const auto span_miss = [&](double log_H) {
        const double H = std::exp(log_H);
        return march.run(H, u_for(H), nothing).x - std::max(span, tiny_span);
    };
    double lo = std::log(1e-7 * scale), hi = std::log(scale);
    for (int i = 0; i < 60 && span_miss(hi) < 0.0; ++i) hi += 1.0;

    Catenary result;
    const double H = std::exp(bisect(lo, hi, span_miss));
    const double u = u_for(H);
    result.horizontal = H;
    result.grounded = on_bed && u < 0.0 ? -u : 0.0;
    double V_below = on_bed ? std::max(u, 0.0) : u;
    std::size_t n = 0;
    const March::End end = march.run(H, u, [&](const March::End& p) {
        // a node's tangent and tension are those just below what hangs on it
        const double V = n == 0 ? V_below : p.V - elements[n - 1].point_weight;
        const double T = std::hypot(H, V);
        result.nodes.push_back({.position = b + p.x * towards + Vec3(0, 0, p.z - b.z()),
                                .tangent = H / T * towards + V / T * Vec3::UnitZ(),
                                .tension = T});
        ++n;
    });
    result.vertical_a = end.V - elements.back().point_weight;
    result.found = std::abs(end.x - std::max(span, tiny_span)) < 1e-3 * length &&
                   std::abs(end.z - a.z()) < 1e-3 * length;
    return result;
}

Catenary hang_freely(const std::vector<CatenaryElement>& elements, const Vec3& a) {
    Catenary result;
    result.found = true;
    double length = 0.0;
    for (const CatenaryElement& e : elements) length += e.length;
    double T = 0.0, z = a.z() - length;
    result.nodes.push_back(
        {.position = {a.x(), a.y(), z}, .tangent = Vec3::UnitZ(), .tension = 0.0});
    for (const CatenaryElement& e : elements) {
        const double w = z < 0.0 ? e.weight_wet : e.weight_dry;
        z += e.length;
        T += w * e.length;
        result.nodes.push_back(
            {.position = {a.x(), a.y(), z}, .tangent = Vec3::UnitZ(), .tension = T});
        T += e.point_weight;
    }
    result.vertical_a = T - elements.back().point_weight;
    return result;
}

}  // namespace hawser::worker
