#include "rod/at_rest.hpp"

#include <algorithm>
#include <cmath>

#include "line_mesh.hpp"
#include "line_quantities.hpp"
#include "rod/recovered.hpp"

namespace hawser::worker {

namespace {

double declination(const Vec3& u) { return std::atan2(std::hypot(u.x(), u.y()), -u.z()); }
double azimuth(const Vec3& u) { return std::atan2(u.y(), u.x()); }

}  // namespace

template <class V>
LineAtRest at_rest(const RodPack<V>& pack, int lane, const Case& input) {
    using T = LaneTraits<V>;
    const Line& line =
        input.lines[static_cast<std::size_t>(pack.lines()[static_cast<std::size_t>(lane)])];
    const LineMesh mesh = mesh_of(line);
    const std::vector<double>& s = mesh.arc_length;

    LineAtRest out;
    out.tension_a = pack.tension_a(lane);
    out.tension_b = pack.tension_b(lane);
    const Vec3 u_a = pack.direction_a(lane), u_b = pack.direction_b(lane);
    out.declination_a = declination(u_a), out.declination_b = declination(u_b);
    out.azimuth_a = azimuth(u_a), out.azimuth_b = azimuth(u_b);

    Recovery<V> recovery(input, pack);
    recovery.recover(pack, false);
    for (int n = 0; n <= mesh.elements(); ++n) {
        const double tension = T::get(recovery.tensions(n)[0], lane);
        if (n > 0 && tension >= out.lowest_tension) continue;
        out.lowest_tension = tension;
        out.lowest_at = s[static_cast<std::size_t>(n)];
    }

    const auto greatest = [&](LineQuantity quantity) {
        Extreme found;
        for (int n = 0; n <= mesh.elements(); ++n) {
            const double x = T::get(recovery.node(n)[index_of(quantity)], lane);
            if (x > found.value || (std::isnan(found.value) && !std::isnan(x)))
                found = {x, s[static_cast<std::size_t>(n)]};
        }
        return found;
    };
    out.tension = greatest(LineQuantity::effective_tension);
    out.von_mises = greatest(LineQuantity::von_mises_stress);
    out.bending = greatest(LineQuantity::bending_stress);
    out.curvature = greatest(LineQuantity::curvature);
    out.yield = greatest(LineQuantity::yield_utilisation);
    out.breaking_load = greatest(LineQuantity::load_utilisation);
    const Grounding bed = recovery.grounding(pack, lane);
    out.grounded = bed.grounded;
    out.touchdown = bed.touchdown;
    out.arc_length = s;
    for (int n = 0; n <= mesh.elements(); ++n) out.position.push_back(pack.node_position(lane, n));
    for (int c = 0; c < static_cast<int>(line.constraints.size()); ++c)
        out.constraints.push_back({.force = pack.constraint_force(lane, c),
                                   .magnitude = pack.constraint_magnitude(lane, c),
                                   .opening = pack.constraint_opening(lane, c)});
    return out;
}

template LineAtRest at_rest(const RodPack<Single>&, int, const Case&);
template LineAtRest at_rest(const RodPack<Quad>&, int, const Case&);

}  // namespace hawser::worker
