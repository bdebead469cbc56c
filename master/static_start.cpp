#include "static_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
        fmt::format(
            "{0}: weight {1:.4g} kN (mass {2:.4g} t) is more than the buoyancy of {3:.4g} kN "
            "can carry: without any line it would sink by more than a quarter of its "
            "draft; look at {4} and its unit ({4}: auto would fit)",
            platform.name, weight / 1e3, hull.mass() / 1e3, buoyancy / 1e3,
            platform.key_path + ".mass"));
}

/// Weight against buoyancy comes first: a platform that does not float drags a line along until
/// that one fails and has the blame.
void refuse_what_sinks(const Case& input, const std::vector<Hull>& hulls) {
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const Hull& hull = hulls[k];
        const double stiffness = hull.static_stiffness(hull.design(), input.analysis.statics)(2, 2);
        if (!hull.mass_is_auto() && !hull.held()[2])
            refuse_if_it_sinks(input.platform_at(static_cast<int>(k)), hull,
                               input.environment.water.gravity, stiffness);
    }
}

/// Gives platform k its mass where that is auto; else compares it with the lines' pull and the
/// buoyancy.
/// @param design  the lines' loads at the design positions in still water
/// @return what does not balance; empty: all does
std::string balance(const Case& input, std::size_t k, Hull& hull, const Reply& design,
                    double line_load) {
    const Platform& platform = input.platform_at(static_cast<int>(k));
    const double g = input.environment.water.gravity;
    const double floats = hull.acting_buoyancy() - line_load;
    if (hull.mass_is_auto()) {
        if (floats <= 0.0)
            throw RunError(
                ExitCode::no_equilibrium,
                fmt::format("{}: the lines pull {:.4g} kN downwards and the buoyancy is "
                            "{:.4g} kN: nothing is left for the platform's own mass",
                            platform.name, line_load / 1e3, hull.acting_buoyancy() / 1e3));
        hull.set_mass(floats / g);
        return "";
    }
    if (hull.held()[2] || hull.acting_buoyancy() <= 0.0 ||
        std::abs(hull.mass() * g - floats) <= 0.005 * hull.acting_buoyancy())
        return "";
    double restoring = hull.static_stiffness(hull.design(), input.analysis.statics)(2, 2);
    for (const LineLoad& line : design.lines)
        if (const Mat6* part = line.stiffness_of(static_cast<int>(k), static_cast<int>(k)))
            restoring += (*part)(2, 2);
    const double heave = restoring > 0.0 ? (floats - hull.mass() * g) / restoring : HUGE_VAL;
    std::string unbalanced = fmt::format(
        "{}: weight {:.4g} kN and line loads {:.4g} kN do not balance the buoyancy of {:.4g} "
        "kN at the design draft; it will float elsewhere, about {:+.3g} m in heave "
        "({}.mass: auto would fit)",
        platform.name, hull.mass() * g / 1e3, line_load / 1e3, hull.acting_buoyancy() / 1e3, heave,
        platform.key_path);
    const double draft = draft_of(platform);
    if (draft > 0.0 && std::abs(heave) > 0.25 * draft)
        throw RunError(ExitCode::no_equilibrium,
                       fmt::format("{}: more than a quarter of its draft; look at {}.mass and its "
                                   "unit",
                                   unbalanced, platform.key_path));
    return unbalanced;
}

/// What is wrong with a hull itself is said before the failure that it led to.
std::string with_cause_in_the_hulls(const std::string& failure,
                                    const std::vector<std::string>& unbalanced,
                                    const std::vector<Hull>& hulls, double g) {
    std::string out;
    for (const std::string& what : unbalanced) out += what + "; so it ends with: ";
    for (const Hull& hull : hulls) {
        const double roll = hull_GM(hull, 0, g), pitch = hull_GM(hull, 1, g);
        if (std::min(roll, pitch) < 0.0)
            out += fmt::format(
                "{}: GM of the hull alone is negative (roll {:.2f} m, pitch {:.2f} m), "
                "it does not stand upright; so it ends with: ",
                hull.name(), roll, pitch);
    }
    return out + failure;
}

/// The lines follow to other places of the platforms in steps as short as Newton's; none where no
/// platform moves.
std::optional<Reply> walked(Lines& lines, const Poses& from, const Poses& to, bool current,
                            const Describe& describe) {
    const NewtonLimits limits;
    int n = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
        const Vec3 dx = to[k].position - from[k].position, turn = to[k].angles - from[k].angles;
        n = std::max(n, static_cast<int>(std::ceil(std::max(dx.norm() / limits.longest_step,
                                                            turn.norm() / limits.widest_turn) -
                                                   1e-9)));
    }
    std::optional<Reply> reply;
    for (int i = 1; i <= n; ++i) {
        Poses poses;
        for (std::size_t k = 0; k < from.size(); ++k) {
            poses[k] = {.position = to[k].position, .angles = to[k].angles};
            if (i == n) continue;
            const Vec3 dx = to[k].position - from[k].position, turn = to[k].angles - from[k].angles;
            poses[k].position = from[k].position + dx * i / n;
            poses[k].angles = from[k].angles + turn * i / n;
        }
        reply = lines_at(lines, poses, current, describe);
    }
    return reply;
}

/// Rests the platforms with the lines, from their design positions.
JointEquilibrium rest_of(const Case& input, const std::vector<Hull>& hulls,
                         const std::vector<StaticPlatform>& bodies, Lines& lines,
                         const Describe& describe) {
    const Statics& statics = input.analysis.statics;
    NewtonLimits limits;
    limits.tolerance = statics.tolerance;
    limits.max_iterations = statics.max_iterations;
    const Poses design = designs_of(input);
    Poses begin = design;
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const LedMotion led = hulls[k].held_at(0.0);
        begin[k] =
            with_held(design[k], {.position = led.motion.position, .angles = led.motion.angles},
                      hulls[k].held());
    }
    walked(lines, design, begin, statics.current, describe);
    return find_joint_equilibrium(bodies, lines, begin, statics.current, limits, describe);
}

/// Stability and natural modes about the equilibrium. Guides with a gap are open at rest, where
/// nothing tells the gap from its absence: both take them as closed (R:49 of worker/README.md).
void look_about(const Case& input, const std::vector<Hull>& hulls,
                const std::vector<StaticPlatform>& bodies, Lines& lines, StaticStart& out) {
    const Eigen::MatrixXd free = free_projection(bodies, out.equilibrium);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(free.rows(), free.cols());
    for (std::size_t k = 0; k < hulls.size(); ++k)
        K.block<6, 6>(row_of(k), row_of(k)) = bodies[k].stiffness(out.equilibrium[k]);
    K = free * K * free;
    Eigen::MatrixXd of_the_lines = Eigen::MatrixXd::Zero(free.rows(), free.cols());
    add_lines_stiffness(out.at_rest, of_the_lines);
    out.stiffness = K + free * of_the_lines * free;
    const LineStiffness swinging = line_stiffness_of(lines, out.equilibrium, hulls.size());
    const LineStiffness of_lines = [&](double w) {
        return Eigen::MatrixXd(free * swinging(w) * free);
    };
    const auto is_held = [&](std::size_t k, std::size_t motion) { return hulls[k].held()[motion]; };

    out.stability = stability_of(hulls, input.environment.water.gravity, K + of_lines(0.0), bodies);
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        std::erase_if(out.stability[k].unheld, [&](const std::string& name) {
            for (std::size_t i = 0; i < 6; ++i)
                if (is_held(k, i) && name == motion_names[i]) return true;
            return false;
        });
        for (std::string& warning : stability_warnings(out.stability[k], hulls[k].name()))
            out.notes.push_back(std::move(warning));
    }
    // What is held moves by itself, without stiffness: a mode without period.
    const auto mass = [&](double w) {
        Eigen::MatrixXd M = Eigen::MatrixXd::Zero(free.rows(), free.cols());
        for (std::size_t k = 0; k < hulls.size(); ++k) {
            const Mat6 F = free.block<6, 6>(row_of(k), row_of(k));
            M.block<6, 6>(row_of(k), row_of(k)) =
                F * hulls[k].static_mass(out.equilibrium[k], w) * F +
                std::max(1.0, hulls[k].mass()) * (Mat6::Identity() - F);
        }
        return M;
    };
    out.modes = coupled_modes(K, mass, of_lines);
    for (CoupledMode& mode : out.modes) {
        const auto k = static_cast<std::size_t>(mode.platform);
        const auto motion = static_cast<std::size_t>(mode.motion);
        mode.held = mode.omega_squared == 0.0 && is_held(k, motion);
        if (!mode.converged)
            out.notes.push_back(fmt::format(
                "{}: the natural period in {} lies where lines swing by themselves and was not "
                "found; that of the static stiffness is told",
                hulls[k].name(), motion_names[motion]));
    }
}

/// A poor fit of the memory of radiation makes other periods and damping than the data say.
void look_at_memory(const std::vector<Hull>& hulls, StaticStart& out) {
    constexpr double poor = 0.05;
    for (const Hull& hull : hulls) {
        const MemoryFit& fit = hull.memory();
        if (fit.oscillators.empty() || fit.rms_error <= poor) continue;
        const auto name = [](int motion) { return motion_names[static_cast<std::size_t>(motion)]; };
        out.notes.push_back(fmt::format(
            "{}: the oscillators miss the database's radiation by {:.2g} % rms, most {} at {:.4g} "
            "rad/s: a frequency there may be an irregular one of the program that made the data "
            "(scripts/plot_hydro draws it); added_mass: {{convolution: {{form: discrete}}}} takes "
            "damping alone",
            hull.name(), 100 * fit.rms_error,
            fit.worst_row == fit.worst_column
                ? fmt::format("in {}", name(fit.worst_row))
                : fmt::format("between {} and {}", name(fit.worst_row), name(fit.worst_column)),
            fit.worst_frequency));
    }
}

/// The Runge-Kutta step takes from an oscillation the part (w D)^5 / 288 of critical damping and
/// has no bound beyond w D = 2.83: a natural period shorter than six steps is told.
void look_at_step(const Case& input, const std::vector<Hull>& hulls, StaticStart& out) {
    const double D = input.analysis.dynamics.platform_step;
    for (const CoupledMode& mode : out.modes) {
        const std::optional<double> period = mode.period();
        if (mode.held || !period || *period >= 6.0 * D) continue;
        const double wD = 2 * M_PI * D / *period;
        out.notes.push_back(fmt::format(
            "{}: the platform step of {:.4g} s is long for the natural period in {} of {:.4g} s: "
            "{}; expected a sixth of it at most",
            hulls[static_cast<std::size_t>(mode.platform)].name(), D,
            motion_names[static_cast<std::size_t>(mode.motion)], *period,
            wD > 2.8 ? std::string("a run would be unstable")
                     : fmt::format("the scheme adds {:.2g} % of critical damping",
                                   100 * std::pow(wD, 5) / 288)));
    }
}

/// Adds what `initial` says to the motions that are not held.
Poses with_initial(const Case& input, const std::vector<Hull>& hulls, const Poses& rest) {
    Poses out = rest;
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const PlatformMotion added =
            with_held(input.platform_at(static_cast<int>(k)).initial, {}, hulls[k].held());
        out[k].position += added.position;
        out[k].angles += added.angles;
        out[k].velocity = added.velocity;
        out[k].angle_rates = added.angle_rates;
    }
    return out;
}

}  // namespace

void leave_out_initial(Case& input) {
    const PlatformMotion none;
    const auto leave_out = [&](Platform& platform) {
        platform.initial =
            with_held(none, platform.initial, platform.fixed);  // there held motions stay
    };
    if (input.platform) leave_out(*input.platform);
    for (Platform& platform : input.further_platforms) leave_out(platform);
}

Poses designs_of(const Case& input) {
    Poses out;
    for (int k = 0; k < input.platform_count(); ++k)
        out[static_cast<std::size_t>(k)] = input.design_of(k);
    return out;
}

StaticPlatform platform_at_rest(const Case& input, const Hull& hull, const Statics& which) {
    const double radius = std::sqrt(hull.body().inertia.trace() / (3.0 * hull.mass()));
    const double weight = hull.mass() * input.environment.water.gravity;
    return {.name = hull.name(),
            .load = [h = &hull,
                     w = &which](const PlatformMotion& pose) { return h->static_load(pose, *w); },
            .stiffness = [h = &hull, w = &which](
                             const PlatformMotion& pose) { return h->static_stiffness(pose, *w); },
            .force = std::max(weight, hull.acting_buoyancy()),
            .length = std::max(1.0, radius),
            .held = hull.held()};
}

std::vector<StaticPlatform> platforms_at_rest(const Case& input, const std::vector<Hull>& hulls,
                                              const Statics& which) {
    std::vector<StaticPlatform> out;
    out.reserve(hulls.size());
    for (const Hull& hull : hulls) out.push_back(platform_at_rest(input, hull, which));
    return out;
}

StaticStart static_start(const Case& input, std::vector<Hull>& hulls, Lines& lines) {
    const Statics& statics = input.analysis.statics;
    const double g = input.environment.water.gravity;
    const auto describe = [&](const Status& s, const Poses& poses) {
        return failure_message(s, input, 0, poses);
    };

    StaticStart out;
    refuse_what_sinks(input, hulls);
    const Reply design = lines_at(lines, designs_of(input), false, describe);
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        out.vertical_line_load[k] = -total_wrench(design, static_cast<int>(k))[2];
        std::string unbalanced = balance(input, k, hulls[k], design, out.vertical_line_load[k]);
        if (!unbalanced.empty()) out.notes.push_back(std::move(unbalanced));
    }

    const std::vector<StaticPlatform> bodies = platforms_at_rest(input, hulls, statics);
    JointEquilibrium rest;
    try {
        rest = rest_of(input, hulls, bodies, lines, describe);
    } catch (const RunError& error) {
        throw RunError(error.code(), with_cause_in_the_hulls(error.what(), out.notes, hulls, g));
    }
    out.equilibrium = rest.pose;
    out.at_rest = rest.lines;
    out.iterations = rest.iterations;
    look_about(input, hulls, bodies, lines, out);
    look_at_step(input, hulls, out);
    look_at_memory(hulls, out);

    out.start = with_initial(input, hulls, rest.pose);
    out.lines = std::move(rest.lines);
    if (const auto reply = walked(lines, rest.pose, out.start, statics.current, describe))
        out.lines = *reply;
    for (std::size_t k = 0; k < hulls.size(); ++k)
        out.start[k] = with_held(out.start[k], hulls[k].held_at(0.0).motion, hulls[k].held());
    return out;
}

}  // namespace hawser::master
