#include "statics_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "line_weight.hpp"

namespace hawser::master {

namespace {

const LineType& type_of(const Section& section, const Case& input) {
    return input.line_types[static_cast<std::size_t>(section.type)];
}

Vec3 place_of(const LineEnd& end, const PerPlatform<PlatformMotion>& poses) {
    if (end.kind != EndKind::platform) return end.position;
    const PlatformMotion& pose = poses[static_cast<std::size_t>(end.platform)];
    return pose.position + rotation(pose.angles) * end.position;
}

double static_stiffness(const LineType& type) {
    return type.viscoelastic ? type.viscoelastic->EA_static : type.EA;
}

/// A stiffness that no equilibrium can be found with, beside the line's weight in air.
std::optional<std::string> unreasonable_stiffness(const Line& line, const Case& input) {
    double weight = 0.0;
    for (const Section& section : line.sections)
        weight += type_of(section, input).mass * input.environment.water.gravity * section.length;
    for (const Section& section : line.sections) {
        const LineType& type = type_of(section, input);
        const double EA = static_stiffness(type);
        if (EA < 2.0 * weight)
            return fmt::format(
                "EA = {:.3g} N of {}: under the line's own weight of {:.3g} N the strain at its "
                "top would be {:.2g}",
                EA, type.name, weight, weight / EA);
        const double straight = std::cbrt(type.EI * line.length() / weight);  // (EI/w)^(1/3)
        if (straight > line.length())
            return fmt::format(
                "EI = {:.3g} N.m2 of {}: a beam so stiff stays straight over {:.3g} m", type.EI,
                type.name, straight);
    }
    return std::nullopt;
}

double longest_element(const Line& line) {
    double longest = 0.0;
    for (const Section& s : line.sections)
        longest = std::max(longest, s.length / std::max(1, s.elements));
    return longest;
}

std::optional<std::string> weak_tensioner(const Line& line, const Case& input) {
    std::string names;
    double pull = 0.0, from = 0.0;
    int count = 0;
    for (const LineConstraint& c : line.constraints) {
        if (c.type != ConstraintType::tensioner) continue;
        const double arc = c.arc_length.value_or(0.0);
        from = count++ > 0 ? std::min(from, arc) : arc;
        names += (names.empty() ? "" : " and ") + c.name;
        pull += c.nominal_tension;
    }
    const double weight = submerged_weight(line, input, from);
    if (count == 0 || pull > weight) return std::nullopt;
    return fmt::format(
        "{} {} with {:.4g} kN at stroke 0, the riser below weighs {:.4g} kN in "
        "water: it would stand in compression at its foot",
        names, count > 1 ? "pull together" : "pulls", pull / 1e3, weight / 1e3);
}

std::optional<std::string> floating_part(const Line& line, const Case& input) {
    const Water& water = input.environment.water;
    const double total = submerged_weight(line, input, 0.0);
    if (total <= 0.0) return fmt::format("it is lighter than water: {:.4g} kN in all", total / 1e3);
    for (const Section& section : line.sections) {
        const LineType& type = type_of(section, input);
        const double w = (type.mass - water.density * type.displaced_area) * water.gravity;
        if (w < 0.0)
            return fmt::format("{} floats with {:.4g} N/m, a section of {:.4g} m", type.name, -w,
                               section.length);
    }
    return std::nullopt;
}

/// A platform of the line that left its place before the line failed.
std::optional<std::string> strayed_platform(const Line& line, const Case& input,
                                            const PerPlatform<PlatformMotion>& poses) {
    for (const LineEnd* end : {&line.end_a, &line.end_b}) {
        if (end->kind != EndKind::platform) continue;
        const PlatformMotion& pose = poses[static_cast<std::size_t>(end->platform)];
        const double away = (pose.position - input.design_of(end->platform).position).norm();
        const double turned = pose.angles.norm();
        if (away <= 0.05 * input.environment.seabed.depth && turned <= 0.2) continue;
        return fmt::format(
            "{} had gone {:.3g} m and turned {:.3g} deg from its design position: "
            "look at its balance first, at mass, stiffness and the pull of all lines",
            input.platform_count() > 1 ? input.platform_at(end->platform).name : "the platform",
            away, turned * 180.0 / M_PI);
    }
    return std::nullopt;
}

}  // namespace

std::string static_failure_cause(const Line& line, const Case& input,
                                 const PerPlatform<PlatformMotion>& poses) {
    const Vec3 a = place_of(line.end_a, poses), b = place_of(line.end_b, poses);
    const double length = line.length();
    if (auto cause = unreasonable_stiffness(line, input)) return *cause;
    const auto stands = [](const LineEnd& end) {
        return end.kind != EndKind::free && end.kind != EndKind::line;
    };
    const bool ends_held = stands(line.end_a) && stands(line.end_b);
    for (const auto& [end, at, name] :
         {std::tuple(&line.end_a, a, "A"), std::tuple(&line.end_b, b, "B")}) {
        const double below = input.environment.seabed.height(at.x(), at.y()) - at.z();
        if (stands(*end) && below > 0.5)
            return fmt::format("end {} lies {:.4g} m below the seabed", name, below);
    }
    if (ends_held) {
        const double chord = (a - b).norm();
        double compliance = 0.0, breaks = HUGE_VAL;
        for (const Section& s : line.sections) {
            compliance += s.length / static_stiffness(type_of(s, input));
            breaks = std::min(breaks, type_of(s, input).breaking_load.value_or(HUGE_VAL));
        }
        const double tension = (chord - length) / compliance;
        // a taut line is always shorter than its chord
        if (chord > length + greatest_stretch(line, input) || tension > breaks) {
            return fmt::format(
                "anchor out of reach: the ends are {:.5g} m apart and the line is {:.5g} m long; "
                "to stretch so far takes {:.3g} kN",
                chord, length, tension / 1e3);
        }
    }
    if (auto cause = weak_tensioner(line, input)) return *cause;
    if (auto cause = floating_part(line, input)) return *cause;
    if (ends_held) {
        const Vec3 span = b - a;
        const double across = std::hypot(span.x(), span.y()), down = std::abs(span.z());
        const Vec3& lower = a.z() < b.z() ? a : b;
        const double hangs = lower.z() - 0.5 * (length - down);  // a loop without width
        const bool clear = hangs > input.environment.seabed.height(lower.x(), lower.y());
        const bool narrow = length - down > 2.0 * across;  // deeper than wide
        if (narrow && clear)
            return fmt::format(
                "it hangs in a loop {:.4g} m deep between ends {:.4g} m apart: at its bottom it "
                "turns within about {:.3g} m, which elements of {:.3g} m cannot follow; make them "
                "shorter there",
                0.5 * (length - down), across, 0.5 * across, longest_element(line));
        if (length > across + down && !clear)
            return fmt::format(
                "so long that it lies slack: {:.5g} m of line for {:.5g} m across and {:.5g} m "
                "down, and nothing says where the rest lies; shorten it to less than {:.5g} m or "
                "move its end B further out",
                length, across, down, across + down);
    }
    for (const auto& [free, held, at] :
         {std::tuple(&line.end_b, &line.end_a, a), std::tuple(&line.end_a, &line.end_b, b)}) {
        if (free->kind != EndKind::free || !stands(*held)) continue;
        const double water = at.z() - input.environment.seabed.height(at.x(), at.y());
        if (length > water)
            return fmt::format(
                "one end is free and the line is {:.5g} m long, where the held end is {:.5g} m "
                "above the bed: nothing says where the rest lies; hold that end or shorten the "
                "line",
                length, water);
    }
    if (auto cause = strayed_platform(line, input, poses)) return *cause;
    int elements = 0;
    for (const Section& s : line.sections) elements += s.elements;
    if (elements < 10)
        return fmt::format(
            "{} elements of up to {:.4g} m may not follow how it hangs; give it 20 or more",
            elements, longest_element(line));
    return "none of reach, weight and stiffness shows it; look at guides and joints, or at "
           "elements "
           "too long for how the line bends";
}

}  // namespace hawser::master
