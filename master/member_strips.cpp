#include "member_strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lanes.hpp"
#include "vector_math.hpp"

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

using Batch = Lanes<4>;

/// Gauss-Legendre with 12 points over an angle phi of -pi/2 ... pi/2: sin(phi), and the weight for
/// the integral over sin(phi).
struct Angles {
    std::array<Batch, 3> sine, weight;

    Angles() {
        constexpr std::array<std::array<double, 2>, 6> gauss{
            {{0.1252334085114689, 0.2491470458134028},
             {0.3678314989981802, 0.2334925365383548},
             {0.5873179542866175, 0.2031674267230659},
             {0.7699026741943047, 0.1600783285433462},
             {0.9041172563704749, 0.1069393259953184},
             {0.9815606342467193, 0.0471753363865118}}};
        for (std::size_t k = 0; k < 12; ++k) {
            const auto& [x, w] = gauss[k / 2];
            const double phi = (k % 2 == 0 ? -0.5 : 0.5) * M_PI * x;
            const int lane = static_cast<int>(k % 4);
            sine[k / 4].set(lane, std::sin(phi));
            weight[k / 4].set(lane, 0.5 * M_PI * w * std::cos(phi));
        }
    }
};
const Angles angles;

/// Coefficients of asin x = sum_n c_n x^(2n+1), c_n = (2n)!/(4^n n!^2 (2n+1)).
consteval std::array<double, 17> arc_sine_series() {
    std::array<double, 17> c{};
    double binomial = 1.0;  // (2n)!/(4^n n!^2)
    for (int n = 0; n < 17; ++n) {
        c[static_cast<std::size_t>(n)] = binomial / (2 * n + 1);
        binomial *= (2 * n + 1.0) / (2 * n + 2.0);
    }
    return c;
}

/// asin u, root = sqrt(1 - u^2): four times that of a quarter of the angle, which is at most pi/8.
/// The series then ends at 1e-16.
Batch arc_sine(Batch u, Batch root) {
    constexpr std::array<double, 17> c = arc_sine_series();
    const Batch half_cosine = sqrt(Batch(0.5) * (Batch(1.0) + root));
    const Batch half_sine = u / (Batch(2.0) * half_cosine);
    const Batch x = half_sine / sqrt(Batch(2.0) * (Batch(1.0) + half_cosine));
    const Batch q = x * x;
    Batch series = c.back();
    for (std::size_t n = c.size() - 1; n-- > 0;) series = series * q + Batch(c[n]);
    return Batch(4.0) * x * series;
}

/// Sums over the sections of one strip.
struct Sections {
    const Strip& strip;
    double axis_z, depth, sine;  ///< depth of the middle, sine between axis and vertical
    double length = 0.0, length_moment = 0.0, drag_area = 0.0, volume = 0.0, volume_moment = 0.0,
           up_moment = 0.0, waterplane = 0.0;

    [[nodiscard]] double y(double s) const { return depth - axis_z * s; }
    [[nodiscard]] double r(double s) const { return strip.radius + strip.taper * s; }

    void add_whole(double a, double b) {
        add_from_middle(b, 1.0);
        add_from_middle(a, -1.0);
    }
    void add_cut(double a, double b) {  // s = middle + half sin(phi)
        Batch l, l1, d, v, v1, up, plane;
        for (std::size_t k = 0; k < angles.sine.size(); ++k) {
            const Batch s = Batch(0.5 * (a + b)) + Batch(0.5 * (b - a)) * angles.sine[k];
            const Batch ds = Batch(0.5 * (b - a)) * angles.weight[k];
            const Batch radius = Batch(strip.radius) + Batch(strip.taper) * s;
            const Batch c = radius * Batch(sine), y = Batch(depth) - Batch(axis_z) * s;
            const Batch u =
                select(c > Batch(0.0), max(Batch(-1.0), min(Batch(1.0), y / c)), Batch(0.0));
            const Batch root = sqrt((Batch(1.0) - u) * (Batch(1.0) + u));
            const Batch f = Batch(0.5) + Batch(1.0 / M_PI) * (u * root + arc_sine(u, root));
            const Batch wet = f * ds, area = Batch(M_PI) * radius * radius;
            l += wet;
            l1 += wet * s;
            d += wet * (Batch(strip.width) + Batch(strip.width_taper) * s);
            v += wet * area;
            v1 += wet * area * s;
            const Batch chord = radius * root;
            up += chord * chord * chord * ds;
            plane += chord * ds;
        }
        length += sum(l);
        length_moment += sum(l1);
        drag_area += sum(d);
        volume += sum(v);
        volume_moment += sum(v1);
        up_moment -= 2.0 / 3.0 * sum(up);
        waterplane += 2.0 / sine * sum(plane);
    }

    /// Adds the integrals over whole sections from the strip's middle to s, times `sign`.
    void add_from_middle(double s, double sign) {
        const double a0 = M_PI * strip.radius * strip.radius,
                     a1 = 2.0 * M_PI * strip.radius * strip.taper,
                     a2 = M_PI * strip.taper * strip.taper;  // area = a0 + a1 s + a2 s^2
        length += sign * s;
        length_moment += sign * s * s / 2;
        drag_area += sign * s * (strip.width + s * strip.width_taper / 2);
        volume += sign * s * (a0 + s * (a1 / 2 + s * a2 / 3));
        volume_moment += sign * s * s * (a0 / 2 + s * (a1 / 3 + s * a2 / 4));
    }
};

Wetting whole_strip(const Strip& strip) {
    const double half = 0.5 * strip.length;
    Sections sum{.strip = strip, .axis_z = 0.0, .depth = 0.0, .sine = 0.0};
    sum.add_whole(-half, half);
    return {.length = strip.length,
            .drag_area = sum.drag_area,
            .volume = sum.volume,
            .along = sum.volume > 0.0 ? sum.volume_moment / sum.volume : 0.0,
            .whole = true};
}

}  // namespace

Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta) {
    constexpr double upright = 1e-7;  // below it the surface cuts one section
    const double half = 0.5 * strip.length;
    const double sine = std::sqrt(std::max(0.0, (1.0 - axis_z) * (1.0 + axis_z)));
    Sections sum{.strip = strip,
                 .axis_z = axis_z,
                 .depth = eta - middle_z,
                 .sine = sine > upright ? sine : 0.0};
    // Most strips are far from the surface: y >= c or y <= -c at both ends, so everywhere.
    if (sum.depth >= sum.sine * strip.radius + half * std::abs(axis_z + sum.sine * strip.taper))
        return whole_strip(strip);
    if (sum.depth <= -sum.sine * strip.radius - half * std::abs(axis_z - sum.sine * strip.taper))
        return {};
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
