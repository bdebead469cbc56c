#include "member_strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::master {

namespace {

/// Radius of the section that meets the surface, at both ends.
std::pair<double, double> radii(const Member& m) {
    const double area_to = m.displaced_area_to.value_or(m.displaced_area);
    if (m.displaced_area > 0.0 || area_to > 0.0)
        return {std::sqrt(m.displaced_area / M_PI), std::sqrt(area_to / M_PI)};
    return {0.5 * m.diameter, 0.5 * m.diameter_to.value_or(m.diameter)};
}

}  // namespace

std::vector<Strip> strips_of(const std::vector<Member>& members, double longest) {
    std::vector<Strip> strips;
    for (std::size_t m = 0; m < members.size(); ++m) {
        const Member& member = members[m];
        const Vec3 along = member.to - member.from;
        const double length = along.norm();
        const int n = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
        const auto [r0, r1] = radii(member);
        const double width = member.diameter, last = member.diameter_to.value_or(width);
        for (int i = 0; i < n; ++i) {
            const double place = (i + 0.5) / n;
            strips.push_back({.middle = member.from + place * along,
                              .axis = along / length,
                              .length = length / n,
                              .radius = r0 + place * (r1 - r0),
                              .taper = (r1 - r0) / length,
                              .width = width + place * (last - width),
                              .width_taper = (last - width) / length,
                              .member = m});
        }
    }
    return strips;
}

namespace {

// Gauss-Legendre on -1 ... 1.
constexpr std::array<std::array<double, 2>, 3> few{
    {{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}}};
constexpr std::array<std::array<double, 2>, 6> many{{{0.1252334085114689, 0.2491470458134028},
                                                     {0.3678314989981802, 0.2334925365383548},
                                                     {0.5873179542866175, 0.2031674267230659},
                                                     {0.7699026741943047, 0.1600783285433462},
                                                     {0.9041172563704749, 0.1069393259953184},
                                                     {0.9815606342467193, 0.0471753363865118}}};

/// Sums over the sections of one strip.
struct Sections {
    const Strip& strip;
    double axis_z, depth, sine;  ///< depth of the middle, sine between axis and vertical
    double length = 0.0, length_moment = 0.0, drag_area = 0.0, volume = 0.0, volume_moment = 0.0,
           up_moment = 0.0, waterplane = 0.0;

    [[nodiscard]] double y(double s) const { return depth - axis_z * s; }
    [[nodiscard]] double r(double s) const { return strip.radius + strip.taper * s; }

    void add(double s, double f, double ds) {
        const double area = M_PI * r(s) * r(s);
        length += f * ds;
        length_moment += f * s * ds;
        drag_area += f * (strip.width + strip.width_taper * s) * ds;
        volume += f * area * ds;
        volume_moment += f * area * s * ds;
    }
    void add_whole(double a, double b) {
        for (const auto& [x, w] : few)
            add(0.5 * (a + b) + 0.5 * (b - a) * x, 1.0, 0.5 * (b - a) * w);
    }
    void add_cut(double a, double b) {  // s = middle + half sin(phi)
        for (const auto& [x, w] : many)
            for (const double side : {-1.0, 1.0}) {
                const double phi = 0.5 * M_PI * side * x;
                const double s = 0.5 * (a + b) + 0.5 * (b - a) * std::sin(phi);
                const double ds = 0.5 * (b - a) * std::cos(phi) * 0.5 * M_PI * w;
                const double radius = r(s), c = radius * sine;
                const double u = c > 0.0 ? std::clamp(y(s) / c, -1.0, 1.0) : 0.0;
                const double root = std::sqrt((1.0 - u) * (1.0 + u));
                add(s, 0.5 + (u * root + std::asin(u)) / M_PI, ds);
                up_moment -= 2.0 / 3.0 * radius * radius * radius * root * root * root * ds;
                waterplane += 2.0 * radius * root * ds / sine;
            }
    }
};

}  // namespace

Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta) {
    constexpr double upright = 1e-7;  // below it the surface cuts one section
    const double half = 0.5 * strip.length;
    const double sine = std::sqrt(std::max(0.0, (1.0 - axis_z) * (1.0 + axis_z)));
    Sections sum{.strip = strip,
                 .axis_z = axis_z,
                 .depth = eta - middle_z,
                 .sine = sine > upright ? sine : 0.0};
    // Where the surface meets the upper and the lower edge of the section: y = c, y = -c.
    std::array<double, 4> at{-half, -half, half, half};
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
        const double side = k == 1 ? sum.sine : -sum.sine;
        const double slope = axis_z + side * strip.taper, there = sum.depth - side * strip.radius;
        const double s = slope != 0.0 ? there / slope : HUGE_VAL;
        at[k] = std::clamp(s, -half, half);
    }
    std::sort(at.begin(), at.end());
    int wet_parts = 0, parts = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(at[k + 1] > at[k])) continue;
        ++parts;
        const double s = 0.5 * (at[k] + at[k + 1]), c = sum.r(s) * sum.sine;
        if (sum.y(s) >= c) {
            sum.add_whole(at[k], at[k + 1]);
            ++wet_parts;
        } else if (sum.y(s) > -c) {
            sum.add_cut(at[k], at[k + 1]);
        }
    }
    if (sum.sine == 0.0 && std::abs(sum.depth) < half) {
        const double radius = sum.r(sum.depth / axis_z);
        sum.waterplane = M_PI * radius * radius / std::abs(axis_z);
    }
    Wetting wet{.length = sum.length,
                .drag_area = sum.drag_area,
                .volume = sum.volume,
                .waterplane = sum.waterplane,
                .whole = wet_parts == parts};
    if (sum.length > 0.0) wet.shift = sum.length_moment / sum.length;
    if (sum.volume > 0.0) {
        wet.along = sum.volume_moment / sum.volume;
        wet.up = sum.up_moment / sum.volume;
    }
    return wet;
}

}  // namespace hawser::master
