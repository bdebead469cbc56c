#include "static_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "coupled_modes.hpp"
#include "failure_message.hpp"
#include "motion_names.hpp"
#include "paper_rate.hpp"
#include "stability.hpp"

namespace hawser::master {

namespace {

double draft_of(const Platform& platform) {
    double draft = platform.draft.value_or(0.0);
    for (const Member& member : platform.members)
        draft = std::max({draft, -member.from.z(), -member.to.z()});
    return draft;
}

/// A given mass so far above the buoyancy that the hull alone would go down by a quarter of its
/// draft: said before any line is looked at.
void refuse_if_it_sinks(const Platform& platform, const Hull& hull, double g, double stiffness) {
    const double buoyancy = hull.acting_buoyancy(), weight = hull.mass() * g;
    const double draft = draft_of(platform);
    if (buoyancy <= 0.0 || draft <= 0.0) return;
    const double sinks = weight - buoyancy;
    if (sinks <= 0.25 * draft * std::max(stiffness, 0.0) || sinks <= 0.005 * buoyancy) return;
    throw RunError(
        ExitCode::no_equilibrium,
        fmt::format("{}: weight {:.4g} kN (mass {:.4g} t) is more than the buoyancy of {:.4g} kN "
                    "can carry: without any line it would sink by more than a quarter of its "
                    "draft; look at platform.mass and its unit (platform.mass: auto would fit)",
                    platform.name, weight / 1e3, hull.mass() / 1e3, buoyancy / 1e3));
}

/// What is wrong with the hull itself is said before the failure that it led to.
std::string with_cause_in_the_hull(const std::string& failure, const std::string& unbalanced,
                                   const Platform& platform, const Hull& hull, double g) {
    std::string out;
    if (!unbalanced.empty()) out += unbalanced + "; so it ends with: ";
    const double roll = hull_GM(hull, 0, g), pitch = hull_GM(hull, 1, g);
    if (std::min(roll, pitch) < 0.0)
        out += fmt::format(
            "{}: GM of the hull alone is negative (roll {:.2f} m, pitch {:.2f} m), "
            "it does not stand upright; so it ends with: ",
            platform.name, roll, pitch);
    return out + failure;
}

}  // namespace

void leave_out_initial(Platform& platform) {
    PlatformMotion none;
    platform.initial =
        with_held(none, platform.initial, platform.fixed);  // there held motions stay
}

StaticPlatform platform_at_rest(const Case& input, const Hull& hull, const Statics& which) {
    const double radius = std::sqrt(hull.body().inertia.trace() / (3.0 * hull.mass()));
    const double weight = hull.mass() * input.environment.water.gravity;
    return {.name = input.platform->name,
            .load = [h = &hull,
                     w = &which](const PlatformMotion& pose) { return h->static_load(pose, *w); },
            .stiffness = [h = &hull, w = &which](
                             const PlatformMotion& pose) { return h->static_stiffness(pose, *w); },
            .force = std::max(weight, hull.acting_buoyancy()),
            .length = std::max(1.0, radius),
            .held = hull.held()};
}

StaticStart static_start(const Case& input, Hull& hull, Lines& lines) {
    const Platform& platform = *input.platform;
    const Statics& statics = input.analysis.statics;
    const double g = input.environment.water.gravity;
    const auto describe = [&](const Status& s, const PlatformMotion& pose) {
        return failure_message(s, input, 0, pose);
    };

    StaticStart out;
    // Weight against buoyancy comes first: a platform that does not float drags a line along until
    // that one fails and has the blame.
    const double stiffness = hull.static_stiffness(PlatformMotion{}, statics)(2, 2);
    const Held& held = hull.held();
    const bool heaves = !held[2];
    if (!hull.mass_is_auto() && heaves) refuse_if_it_sinks(platform, hull, g, stiffness);
    const Reply design = lines_at(lines, PlatformMotion{}, false, describe);
    out.vertical_line_load = -total_wrench(design)[2];
    const double floats = hull.acting_buoyancy() - out.vertical_line_load;
    std::string unbalanced;
    if (hull.mass_is_auto()) {
        if (floats <= 0.0)
            throw RunError(ExitCode::no_equilibrium,
                           fmt::format("{}: the lines pull {:.4g} kN downwards and the buoyancy is "
                                       "{:.4g} kN: nothing is left for the platform's own mass",
                                       platform.name, out.vertical_line_load / 1e3,
                                       hull.acting_buoyancy() / 1e3));
        hull.set_mass(floats / g);
    } else if (heaves && hull.acting_buoyancy() > 0.0 &&
               std::abs(hull.mass() * g - floats) > 0.005 * hull.acting_buoyancy()) {
        double restoring = stiffness;
        for (const LineLoad& line : design.lines) restoring += line.stiffness(2, 2);
        const double heave = restoring > 0.0 ? (floats - hull.mass() * g) / restoring : HUGE_VAL;
        unbalanced = fmt::format(
            "{}: weight {:.4g} kN and line loads {:.4g} kN do not balance the buoyancy of {:.4g} "
            "kN at the design draft; it will float elsewhere, about {:+.3g} m in heave "
            "(platform.mass: auto would fit)",
            platform.name, hull.mass() * g / 1e3, out.vertical_line_load / 1e3,
            hull.acting_buoyancy() / 1e3, heave);
        const double draft = draft_of(platform);
        if (draft > 0.0 && std::abs(heave) > 0.25 * draft)
            throw RunError(ExitCode::no_equilibrium,
                           unbalanced +
                               ": more than a quarter of its draft; look at "
                               "platform.mass and its unit");
        out.notes.push_back(unbalanced);
    }

    const StaticPlatform body = platform_at_rest(input, hull, statics);
    NewtonLimits limits;
    // The lines follow to another place in steps as short as Newton's.
    const auto walked = [&](const PlatformMotion& from,
                            const PlatformMotion& to) -> std::optional<Reply> {
        const Vec3 dx = to.position - from.position, turn = to.angles - from.angles;
        const int n = static_cast<int>(std::ceil(
            std::max(dx.norm() / limits.longest_step, turn.norm() / limits.widest_turn) - 1e-9));
        std::optional<Reply> reply;
        for (int i = 1; i <= n; ++i) {
            PlatformMotion pose = to;
            if (i < n) {
                pose.position = from.position + dx * i / n;
                pose.angles = from.angles + turn * i / n;
            }
            reply = lines_at(lines, pose, statics.current, describe);
        }
        return reply;
    };
    limits.tolerance = statics.tolerance;
    limits.max_iterations = statics.max_iterations;
    Equilibrium rest;
    try {
        const LedMotion led = hull.held_at(0.0);
        const PlatformMotion begin =
            with_held({}, {.position = led.motion.position, .angles = led.motion.angles}, held);
        walked({}, begin);
        rest = find_equilibrium(body, lines, begin, statics.current, limits, describe);
    } catch (const RunError& error) {
        throw RunError(error.code(),
                       with_cause_in_the_hull(error.what(), unbalanced, platform, hull, g));
    }

    out.equilibrium = out.start = rest.pose;
    out.iterations = rest.iterations;
    const Mat6 free = any(held) ? free_projection(rest.pose.angles, held) : Mat6(Mat6::Identity());
    const Mat6 hull_stiffness = free * body.stiffness(rest.pose) * free;
    out.stiffness = hull_stiffness;
    for (const LineLoad& line : rest.lines.lines) out.stiffness += free * line.stiffness * free;
    // Guides with a gap are open at rest, where nothing tells the gap from its absence: stability
    // and periods take them as closed (R:49 of worker/README.md).
    const LineStiffness swinging = line_stiffness_of(lines, rest.pose);
    const LineStiffness of_lines = [&](double w) { return Mat6(free * swinging(w) * free); };
    out.stability = stability_of(hull, g, hull_stiffness + of_lines(0.0), body.length);
    std::erase_if(out.stability.unheld, [&](const std::string& name) {
        for (std::size_t i = 0; i < 6; ++i)
            if (held[i] && name == motion_names[i]) return true;
        return false;
    });
    for (std::string& warning : stability_warnings(out.stability, platform.name))
        out.notes.push_back(std::move(warning));
    // What is held moves by itself, without stiffness: a mode without period.
    out.modes = coupled_modes(
        hull_stiffness,
        [&](double w) -> Mat6 {
            if (!any(held)) return hull.static_mass(rest.pose, w);
            return free * hull.static_mass(rest.pose, w) * free +
                   std::max(1.0, hull.mass()) * (Mat6::Identity() - free);
        },
        of_lines);
    for (CoupledMode& mode : out.modes)
        mode.held = mode.omega_squared == 0.0 && held[static_cast<std::size_t>(mode.motion)];
    for (const CoupledMode& mode : out.modes)
        if (!mode.converged)
            out.notes.push_back(fmt::format(
                "{}: the natural period in {} lies where lines swing by themselves and was not "
                "found; that of the static stiffness is told",
                platform.name, motion_names[static_cast<std::size_t>(mode.motion)]));
    PlatformMotion added = with_held(platform.initial, {}, held);
    out.start.position += added.position;
    out.start.angles += added.angles;
    out.at_rest = out.lines = std::move(rest.lines);
    if (const auto reply = walked(rest.pose, out.start)) out.lines = *reply;
    out.start.velocity = added.velocity;
    out.start.angle_rates = added.angle_rates;
    out.start = with_held(out.start, hull.held_at(0.0).motion, held);
    return out;
}

}  // namespace hawser::master
