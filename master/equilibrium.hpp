// Where platform and lines rest together under the mean loads: Newton's method on the platform's
// six coordinates with the lines' own reactions and stiffness. Tangent of the lines: R:25.
#pragma once

#include <functional>
#include <string>

#include "held_motions.hpp"
#include "lines.hpp"

namespace hawser::master {

/// What the equilibrium needs of the platform.
struct StaticPlatform {
    std::string name = {};
    std::function<Vec6(const PlatformMotion&)> load = {};  ///< all but the lines [N, N.m about O]
    std::function<Mat6(const PlatformMotion&)> stiffness =
        {};              ///< -d(load)/d(position, rotation vector)
    double force = 1.0;  ///< scale of its loads, e.g. the weight [N]
    double length =
        1.0;  ///< lever arm that makes its rotations lengths, e.g. radius of gyration [m]
    /// Orthogonal projection of (displacement, rotation vector) on what may move; the rest is held
    Mat6 free = Mat6::Identity();
    /// Motions that stay where the start has them, K:20; `free` must be the identity with them.
    Held held{};
};

struct NewtonLimits {
    double tolerance = 1e-6;  ///< correction [m, rad]; load out of balance per `force`, `length`
    int max_iterations = 200;
    double longest_step = 5.0;  ///< [m] in one iteration
    double widest_turn = 0.05;  ///< [rad] in one iteration
};

struct Equilibrium {
    PlatformMotion pose;
    Reply lines;  ///< at that pose, with stiffness
    int iterations = 0;
    double force = 0.0, moment = 0.0;  ///< out of balance [N, N.m]
};

using Poses = PerPlatform<PlatformMotion>;
/// Words for a line that failed with the platforms at their poses.
using Describe = std::function<std::string(const Status&, const Poses&)>;

/// For the only platform of a case. Solves load(pose) + sum of the lines' wrenches = 0:
///
///     (K + sum S) dX = load + sum f,     pose <- pose moved by dX
///
/// until the correction and what is out of balance are both within the tolerance. A direction in
/// which nothing holds the platform, or one that is not free, keeps its place. A line that fails at
/// the new pose is tried again at half the step.
/// @param current  with (true) or without current on the lines
/// @param describe words for a failing line
/// Throws RunError (no_equilibrium) with the reason.
Equilibrium find_equilibrium(const StaticPlatform& platform, Lines& lines,
                             const PlatformMotion& start, bool current, const NewtonLimits& limits,
                             const Describe& describe);

/// What the lines answer with the platforms held at their poses; its status may tell of a line that
/// has no equilibrium there.
const Reply& ask_equilibrium(Lines& lines, const Poses& poses, bool current);
/// The lines' static loads with the platforms held at their poses. Throws RunError
/// (no_equilibrium).
Reply lines_at(Lines& lines, const Poses& poses, bool current, const Describe& describe);

}  // namespace hawser::master
