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

namespace {

// Wet part of the section whose centre is y below the surface, c its vertical extent; its integral
// over y from far above the water, and that of y times it.
struct Section {
    double c;
    [[nodiscard]] double wet(double y) const {
        return c > 0.0 ? std::clamp(0.5 + y / c, 0.0, 1.0) : (y > 0.0 ? 1.0 : 0.0);
    }
    [[nodiscard]] double integral(double y) const {
        if (y <= -0.5 * c) return 0.0;
        return y >= 0.5 * c ? y : (y + 0.5 * c) * (y + 0.5 * c) / (2.0 * c);
    }
    [[nodiscard]] double moment(double y) const {
        if (y <= -0.5 * c) return 0.0;
        return y >= 0.5 * c ? 0.5 * y * y - c * c / 24.0
                            : y * y * (0.25 + y / (3.0 * c)) - c * c / 48.0;
    }
};

}  // namespace

Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta) {
    const double a = std::abs(axis_z) * strip.length;
    const Section section{std::sqrt(std::max(0.0, 1.0 - axis_z * axis_z)) * strip.width};
    const double depth = eta - middle_z;
    if (a <= 1e-6 * section.c)  // lies: the integrals' difference would be of rounding
        return {section.wet(depth), 0.0, section.c};
    const double low = depth + 0.5 * a, high = depth - 0.5 * a;
    if (high >= 0.5 * section.c) return {1.0, 0.0, a};
    const double wet = section.integral(low) - section.integral(high);
    if (!(wet > 0.0)) return {0.0, 0.0, a};
    const double up = depth - (section.moment(low) - section.moment(high)) / wet;
    const double rate = section.wet(low) - section.wet(high);  // of the wet length, per depth
    return {std::min(1.0, wet / a), up / axis_z, a / rate};
}

}  // namespace hawser::master
