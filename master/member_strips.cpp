#include "member_strips.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::master {

std::vector<Strip> strips_of(const std::vector<Member>& members, double longest) {
    std::vector<Strip> strips;
    for (std::size_t m = 0; m < members.size(); ++m) {
        const Member& member = members[m];
        const Vec3 along = member.to - member.from;
        const double length = along.norm();
        const int n = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
        // A drag width may be far wider than what displaces water: the surface meets the latter.
        const double width = member.displaced_area > 0.0
                                 ? std::sqrt(4.0 * member.displaced_area / M_PI)
                                 : member.diameter;
        for (int i = 0; i < n; ++i)
            strips.push_back({.middle = member.from + (i + 0.5) / n * along,
                              .axis = along / length,
                              .length = length / n,
                              .width = width,
                              .member = m});
    }
    return strips;
}

Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta) {
    const double along = std::abs(axis_z) * strip.length;
    const double h = along + std::sqrt(std::max(0.0, 1.0 - axis_z * axis_z)) * strip.width;
    const double f = std::clamp((eta - middle_z) / h + 0.5, 0.0, 1.0);
    // The dry part is taken off the upper end, as far as the strip is upright.
    const double shift = -std::copysign(0.5 * (1.0 - f) * strip.length * along / h, axis_z);
    return {f, shift, h};
}

}  // namespace hawser::master
