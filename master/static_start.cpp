#include "static_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "paper_rate.hpp"
#include "stability.hpp"

namespace hawser::master {

StaticStart static_start(const Case& input, Hull& hull, Lines& lines) {
    const Platform& platform = *input.platform;
    const Statics& statics = input.analysis.statics;
    const double g = input.environment.water.gravity;
    const auto describe = [&](const Status& s) { return failure_message(s, input, 0); };

    StaticStart out;
    const Reply design = lines_at(lines, PlatformMotion{}, false, describe);
    out.vertical_line_load = -total_wrench(design)[2];
    const double floats = hull.acting_buoyancy() - out.vertical_line_load;
    if (hull.mass_is_auto()) {
        if (floats <= 0.0)
            throw RunError(ExitCode::no_equilibrium,
                           fmt::format("{}: the lines pull {:.4g} kN downwards and the buoyancy is "
                                       "{:.4g} kN: nothing is left for the platform's own mass",
                                       platform.name, out.vertical_line_load / 1e3,
                                       hull.acting_buoyancy() / 1e3));
        hull.set_mass(floats / g);
    } else if (hull.acting_buoyancy() > 0.0 &&
               std::abs(hull.mass() * g - floats) > 0.005 * hull.acting_buoyancy()) {
        out.notes.push_back(fmt::format(
            "{}: weight {:.4g} kN and line loads {:.4g} kN do not balance the buoyancy of {:.4g} "
            "kN at the design draft; it will float elsewhere (platform.mass: auto would fit)",
            platform.name, hull.mass() * g / 1e3, out.vertical_line_load / 1e3,
            hull.acting_buoyancy() / 1e3));
    }

    const double radius = std::sqrt(hull.body().inertia.trace() / (3.0 * hull.mass()));
    const StaticPlatform body{
        .name = platform.name,
        .load = [&](const PlatformMotion& pose) { return hull.static_load(pose, statics); },
        .stiffness =
            [&](const PlatformMotion& pose) { return hull.static_stiffness(pose, statics); },
        .force = std::max(hull.mass() * g, hull.acting_buoyancy()),
        .length = std::max(1.0, radius)};
    NewtonLimits limits;
    limits.tolerance = statics.tolerance;
    limits.max_iterations = statics.max_iterations;
    Equilibrium rest =
        find_equilibrium(body, lines, PlatformMotion{}, statics.current, limits, describe);

    out.equilibrium = out.start = rest.pose;
    out.iterations = rest.iterations;
    out.stiffness = body.stiffness(rest.pose);
    for (const LineLoad& line : rest.lines.lines) out.stiffness += line.stiffness;
    out.stability = stability_of(hull, g, out.stiffness, body.length);
    for (std::string& warning : stability_warnings(out.stability, platform.name))
        out.notes.push_back(std::move(warning));
    out.start.position += platform.initial.position;
    out.start.angles += platform.initial.angles;
    out.lines = std::move(rest.lines);
    // The lines follow to the offset in steps as short as Newton's.
    const double moves = std::max(platform.initial.position.norm() / limits.longest_step,
                                  platform.initial.angles.norm() / limits.widest_turn);
    const int n = static_cast<int>(std::ceil(moves));
    for (int i = 1; i <= n; ++i) {
        PlatformMotion pose = out.start;
        if (i < n) {
            pose.position = rest.pose.position + platform.initial.position * i / n;
            pose.angles = rest.pose.angles + platform.initial.angles * i / n;
        }
        out.lines = lines_at(lines, pose, statics.current, describe);
    }
    out.start.velocity = platform.initial.velocity;
    out.start.angle_rates = platform.initial.angle_rates;
    return out;
}

}  // namespace hawser::master
