// Where several platforms rest together under their mean loads, with lines between them: Newton's
// method on all their coordinates at once. Tangent of the lines: R:25.
#pragma once

#include <vector>

#include "equilibrium.hpp"

namespace hawser::master {

struct JointEquilibrium {
    PerPlatform<PlatformMotion> pose;
    Reply lines;  ///< at those poses, with stiffness
    int iterations = 0;
};

/// Words for a line that failed with the platforms at their poses.
using DescribeJoint = std::function<std::string(const Status&, const PerPlatform<PlatformMotion>&)>;

/// Stiffness of the lines for the motions of all platforms, 6 rows and columns each [N/m, N, N.m].
[[nodiscard]] Eigen::MatrixXd lines_stiffness(const Reply& lines, std::size_t platforms);

/// Solves load_k(pose_k) + sum of the lines' wrenches on k = 0 for all platforms k together:
///
///     (K + sum S) dX = load + sum f,     K = diag(K_1, K_2 ...),     pose_k <- pose_k moved by
///     dX_k
///
/// S has the parts between the platforms that a line joins. The ends of the iteration, what nothing
/// holds and lines that fail on the way are treated as in find_equilibrium.
/// Throws RunError (no_equilibrium) that names the platform furthest from balance.
JointEquilibrium find_joint_equilibrium(const std::vector<StaticPlatform>& platforms, Lines& lines,
                                        const PerPlatform<PlatformMotion>& start, bool current,
                                        const NewtonLimits& limits, const DescribeJoint& describe);

/// The lines' static loads with the platforms held at their poses. Throws RunError
/// (no_equilibrium).
Reply lines_at(Lines& lines, const PerPlatform<PlatformMotion>& poses, bool current,
               const DescribeJoint& describe);

}  // namespace hawser::master
