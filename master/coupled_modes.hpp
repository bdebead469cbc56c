// Natural modes of the platform - or of several together - with the lines about their common
// equilibrium, undamped: what an engineer looks at before the storm. The lines act with their own
// inertia, R:44.
#pragma once

#include <functional>
#include <vector>

#include "joint_equilibrium.hpp"
#include "modes_report.hpp"

namespace hawser::master {

/// Sum of the lines' dynamic stiffness at an angular frequency, about each O, made symmetric; 6
/// rows and columns per platform.
using LineStiffness = std::function<Eigen::MatrixXd(double omega)>;
/// Asks the lines, which have found their equilibrium at the platforms' poses.
LineStiffness line_stiffness_of(Lines& lines, const Poses& poses, std::size_t platforms);

/// Mass of the platforms with the added mass of an angular frequency, about each O; symmetric,
/// positive definite.
using MassAt = std::function<Eigen::MatrixXd(double omega)>;

/// K:26  Solves [ K + S(w) - w^2 M(w) ] x = 0 for the six modes per platform in which the platforms
/// move. From the modes with the lines' static stiffness each frequency is improved by the linear
/// eigenproblem
///
///     [ K + S(w_n) + w_n^2 m(w_n) ] x = w^2 [ M(w_n) + m(w_n) ] x,     m = -dS/d(w^2)
///
/// taking the mode whose shape is nearest to the last one. m is the lines' inertia in that motion.
/// Where the lines swing by themselves at such frequencies - more than half of the energy is
/// theirs, or there is no end to the improving - all modes from 0.6 to 1.6 of the first frequency
/// are found by counting, and that with most of the platforms' motion is taken.
///
/// @param K  stiffness of the platforms alone about O, made symmetric here
/// @param M  their mass with added mass about O
/// @return   platform by platform, of each in the order surge ... yaw: the motion with the greatest
///           part of the kinetic energy
std::vector<CoupledMode> coupled_modes(const Eigen::MatrixXd& K, const MassAt& M,
                                       const LineStiffness& lines);

}  // namespace hawser::master
