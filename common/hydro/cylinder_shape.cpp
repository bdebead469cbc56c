#include "hydro/cylinder_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::hydro {
namespace {

std::vector<Span> joined(std::vector<Span> spans) {
    std::sort(spans.begin(), spans.end(), [](Span a, Span b) { return a.low < b.low; });
    std::vector<Span> out;
    for (const Span s : spans) {
        if (!out.empty() && s.low <= out.back().high)
            out.back().high = std::max(out.back().high, s.high);
        else
            out.push_back(s);
    }
    return out;
}

std::vector<Span> rest_of(Span whole, const std::vector<Span>& taken) {
    std::vector<Span> out;
    double low = whole.low;
    for (const Span s : taken) {
        if (s.low > low) out.push_back({low, s.low});
        low = std::max(low, s.high);
    }
    if (whole.high > low) out.push_back({low, whole.high});
    return out;
}

// Water of the ring between two neighbouring radii.
std::vector<Span> water_beyond(const Hull& hull, double radius) {
    std::vector<Span> solid;
    for (const Part& p : hull.parts)
        if (p.radius > radius) solid.push_back({p.bottom, p.top});
    return rest_of({-hull.depth, 0.0}, joined(solid));
}

std::vector<double> radii_of(const Hull& hull) {
    std::vector<double> radii;
    for (const Part& p : hull.parts) radii.push_back(p.radius);
    std::sort(radii.begin(), radii.end());
    radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
    return radii;
}

Opening opening_between(const Column& small, const Column& large) {
    Opening o;
    o.radius = small.outer;
    o.z = small.z;
    const bool edge_above = small.z.high<large.z.high, edge_below = small.z.low> large.z.low;
    o.half = o.z.length();
    if (edge_above && edge_below) {
        o.end = Opening::End::both_edges;
        o.half = 0.5 * o.z.length();
        o.centre = 0.5 * (o.z.low + o.z.high);
    } else if (edge_above) {
        o.end = Opening::End::mirrored;
        o.centre = o.z.low;
    } else {
        o.end = small.surface ? Opening::End::surface : Opening::End::mirrored;
        o.centre = o.z.high;
    }
    // The nearest other edge or corner: along the wall, or at the column's other radius.
    double gap = std::min(o.half, small.outer - small.inner);
    for (const Span w : large.walls)
        if (w.low == o.z.high || w.high == o.z.low) gap = std::min(gap, w.length());
    o.edge_gap = gap;
    return o;
}

}  // namespace

std::vector<std::string> problems_of(const Hull& hull) {
    std::vector<std::string> out;
    if (!(hull.depth > 0.0) || !std::isfinite(hull.depth))
        out.push_back(fmt::format("depth: expected above zero; got {:g} m", hull.depth));
    if (hull.parts.empty()) out.emplace_back("part: expected at least one");
    for (std::size_t i = 0; i < hull.parts.size(); ++i) {
        const Part& p = hull.parts[i];
        const std::string name = fmt::format("part {:g},{:g},{:g}", p.radius, p.top, p.bottom);
        if (!(p.radius > 0.0)) out.push_back(name + ": expected a radius above zero");
        if (!(p.bottom < p.top))
            out.push_back(name + ": expected radius, top, bottom with the bottom below the top");
        if (p.top > 0.0)
            out.push_back(name + ": the top is above the water; give the wetted part, top 0");
        if (hull.depth > 0.0 && p.bottom < -hull.depth)
            out.push_back(
                fmt::format("{}: the bottom is below the seabed at {:g} m", name, -hull.depth));
        for (std::size_t j = 0; j < i; ++j)
            if (p.bottom < hull.parts[j].top && hull.parts[j].bottom < p.top)
                out.push_back(fmt::format("{}: overlaps part {:g},{:g},{:g}", name,
                                          hull.parts[j].radius, hull.parts[j].top,
                                          hull.parts[j].bottom));
    }
    if (!out.empty()) return out;
    // The numbers of eigenfunctions grow with the depth over the smallest detail.
    constexpr double finest = 1e-3;
    for (const Opening& o : partition_of(hull).openings)
        if (o.edge_gap < finest * hull.depth)
            out.push_back(
                fmt::format("part: a detail of {:.3g} m at radius {:g} m, {:g} to {:g} m, is finer "
                            "than a thousandth of the depth, too fine for the sums",
                            o.edge_gap, o.radius, o.z.low, o.z.high));
    return out;
}

Partition partition_of(const Hull& hull) {
    Partition p;
    const std::vector<double> radii = radii_of(hull);
    std::vector<int> ring;  // columns of the ring before, by their index
    double inner = 0.0;
    for (std::size_t i = 0; i <= radii.size(); ++i) {
        std::vector<int> next;
        for (const Span z : water_beyond(hull, inner)) {
            std::vector<int> inside;
            int same = -1;
            for (const int c : ring) {
                const Column& small = p.columns[static_cast<std::size_t>(c)];
                if (small.z == z) same = c;
                if (small.z.low >= z.low && small.z.high <= z.high) inside.push_back(c);
            }
            if (same >= 0) {  // goes on unchanged
                p.columns[static_cast<std::size_t>(same)].outer = 0.0;
                next.push_back(same);
                continue;
            }
            Column large;
            large.z = z;
            large.inner = inner;
            large.surface = z.high == 0.0;
            large.moving_top = !large.surface;
            large.moving_bottom = z.low > -hull.depth;
            std::vector<Span> open;
            open.reserve(inside.size());
            for (const int c : inside) open.push_back(p.columns[static_cast<std::size_t>(c)].z);
            if (inner > 0.0) large.walls = rest_of(z, joined(open));
            large.first_opening = static_cast<int>(p.openings.size());
            large.openings = static_cast<int>(inside.size());
            for (const int c : inside) {
                Column& small = p.columns[static_cast<std::size_t>(c)];
                small.opening = static_cast<int>(p.openings.size());
                p.openings.push_back(opening_between(small, large));
            }
            next.push_back(static_cast<int>(p.columns.size()));
            p.columns.push_back(large);
        }
        if (i == radii.size()) break;
        for (const int c : next) p.columns[static_cast<std::size_t>(c)].outer = radii[i];
        ring = next;
        inner = radii[i];
    }
    return p;
}

Buoyancy buoyancy_of(const Hull& hull) {
    Buoyancy b;
    double moment = 0.0;
    for (const Part& p : hull.parts) {
        const double area = M_PI * p.radius * p.radius, volume = area * (p.top - p.bottom);
        b.volume += volume;
        moment += volume * 0.5 * (p.top + p.bottom);
        if (p.top < 0.0) continue;
        b.waterplane = area;
        b.waterplane_moment = 0.25 * area * p.radius * p.radius;
    }
    b.centre = moment / b.volume;
    return b;
}

}  // namespace hawser::hydro
