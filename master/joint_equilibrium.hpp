// Where several platforms rest together under their mean loads, with lines between them: Newton's
// method on all their coordinates at once. Tangent of the lines: R:25.
#pragma once

#include <vector>

#include "equilibrium.hpp"

namespace hawser::master {

struct JointEquilibrium {
    Poses pose;
    Reply lines;  ///< at those poses, with stiffness
    int iterations = 0;
};

/// First of the six rows of platform k among those of all.
[[nodiscard]] inline Eigen::Index row_of(std::size_t k) { return static_cast<Eigen::Index>(6 * k); }

/// Adds, in line order, the stiffness of the lines for the motions of all platforms to K, which has
/// 6 rows and columns for each [N/m, N, N.m].
void add_lines_stiffness(const Reply& lines, Eigen::MatrixXd& K);

/// What makes platforms of all sizes alike: rotations as lengths, loads as parts of the platform's
/// own. Coordinates over these.
[[nodiscard]] Eigen::VectorXd scales_of(const std::vector<StaticPlatform>& platforms);

/// What may move, K:20: the projections of all platforms as blocks on the diagonal.
[[nodiscard]] Eigen::MatrixXd free_projection(const std::vector<StaticPlatform>& platforms,
                                              const Poses& poses);

/// K:25  Solves load_k(pose_k) + sum of the lines' wrenches on k = 0 for all platforms k together:
///
///     (K + sum S) dX = load + sum f,     K = diag(K_1, K_2 ...),     pose_k <- pose_k moved by
///     dX_k
///
/// S has the parts between the platforms that a line joins. The ends of the iteration, what nothing
/// holds, motions that are held and lines that fail on the way are treated as in find_equilibrium,
/// which does the work where there is one platform.
/// Throws RunError (no_equilibrium) that names the platform furthest from balance.
JointEquilibrium find_joint_equilibrium(const std::vector<StaticPlatform>& platforms, Lines& lines,
                                        const Poses& start, bool current,
                                        const NewtonLimits& limits, const Describe& describe);

}  // namespace hawser::master
