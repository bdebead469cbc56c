#include "rod/at_rest.hpp"

#include <algorithm>
#include <cmath>

#include "line_mesh.hpp"

namespace hawser::worker {

namespace {

double declination(const Vec3& u) { return std::atan2(std::hypot(u.x(), u.y()), -u.z()); }
double azimuth(const Vec3& u) { return std::atan2(u.y(), u.x()); }

/// Height of the line's underside above the bed at its nodes, from end A [m].
template <class V>
std::vector<double> clearance(const RodPack<V>& pack, int lane, const Case& input, const Line& line,
                              const LineMesh& mesh) {
    const Seabed& bed = input.environment.seabed;
    const double rise = std::tan(bed.slope_angle);
    std::vector<double> out;
    for (int n = 0; n <= mesh.elements(); ++n) {
        const Vec3 r = pack.node_position(lane, n);
        const double along =
            r.x() * std::cos(bed.slope_direction) + r.y() * std::sin(bed.slope_direction);
        const int element = std::min(n, mesh.elements() - 1);
        const int section = mesh.section[static_cast<std::size_t>(element)];
        const int type = line.sections[static_cast<std::size_t>(section)].type;
        const double D = input.line_types[static_cast<std::size_t>(type)].outer_diameter;
        out.push_back(r.z() - 0.5 * D + bed.depth - rise * along);
    }
    return out;
}

}  // namespace

template <class V>
LineAtRest at_rest(const RodPack<V>& pack, int lane, const Case& input) {
    using T = LaneTraits<V>;
    const Line& line =
        input.lines[static_cast<std::size_t>(pack.lines()[static_cast<std::size_t>(lane)])];
    const LineMesh mesh = mesh_of(line);
    const std::vector<double>& s = mesh.arc_length;
    const auto N = static_cast<std::size_t>(mesh.elements());

    LineAtRest out;
    out.tension_a = pack.tension_a(lane);
    out.tension_b = pack.tension_b(lane);
    const Vec3 u_a = pack.direction_a(lane), u_b = pack.direction_b(lane);
    out.declination_a = declination(u_a), out.declination_b = declination(u_b);
    out.azimuth_a = azimuth(u_a), out.azimuth_b = azimuth(u_b);

    for (std::size_t n = 0; n <= N; ++n) {  // R:2
        const std::size_t from_b = N - n;
        const Vector<V>& d = pack.kept().nodes()[from_b].d;
        const double stretch = T::get(sqrt(dot(d, d)), lane);
        const double tension = T::get(pack.kept().lambda()[2 * from_b].now, lane) * stretch;
        if (n == 0 || tension < out.lowest_tension) {
            out.lowest_tension = tension;
            out.lowest_at = s[n];
        }
    }

    const std::vector<double> z = clearance(pack, lane, input, line, mesh);
    for (std::size_t n = 0; n < N; ++n) {
        const double L = s[n + 1] - s[n], za = z[n], zb = z[n + 1];
        if (za > 0.0 && zb > 0.0) continue;
        const double crossing = za * zb < 0.0 ? za / (za - zb) : 0.0;  // where between the nodes
        const double lies = za * zb >= 0.0 ? L : za > 0.0 ? (1.0 - crossing) * L : crossing * L;
        out.grounded += lies;
        if (lies > 0.0 && std::isnan(out.touchdown))
            out.touchdown = s[n] + (za > 0.0 ? crossing * L : 0.0);
    }

    for (int c = 0; c < static_cast<int>(line.constraints.size()); ++c)
        out.constraints.push_back({.force = pack.constraint_force(lane, c),
                                   .magnitude = pack.constraint_magnitude(lane, c),
                                   .opening = pack.constraint_opening(lane, c)});
    return out;
}

template LineAtRest at_rest(const RodPack<Single>&, int, const Case&);
template LineAtRest at_rest(const RodPack<Quad>&, int, const Case&);

}  // namespace hawser::worker
