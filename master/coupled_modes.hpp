// Natural modes of the platform with its lines about their common equilibrium, undamped: what an
// engineer looks at before the storm. The lines act with their own inertia, R:44.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "lines.hpp"
#include "modes_report.hpp"

namespace hawser::master {

/// Sum of the lines' dynamic stiffness at an angular frequency, about O, made symmetric.
using LineStiffness = std::function<Mat6(double omega)>;
/// Asks the lines, which have found their equilibrium at the platform's pose.
LineStiffness line_stiffness_of(Lines& lines, const PlatformMotion& pose);

/// Mass of the platform with the added mass of an angular frequency, about O; symmetric, positive
/// definite.
using MassAt = std::function<Mat6(double omega)>;

/// Solves [ K + S(w) - w^2 M(w) ] x = 0 for the six modes in which the platform moves. From the
/// modes with the lines' static stiffness each frequency is improved by the linear eigenproblem
///
///     [ K + S(w_n) + w_n^2 m(w_n) ] x = w^2 [ M(w_n) + m(w_n) ] x,     m = -dS/d(w^2)
///
/// taking the mode whose shape is nearest to the last one. m is the lines' inertia in that motion.
///
/// @param K  stiffness of the platform alone about O, made symmetric here
/// @param M  its mass with added mass about O
/// @return   in the order surge ... yaw of the motion with the greatest part of the kinetic energy
std::array<CoupledMode, 6> coupled_modes(const Mat6& K, const MassAt& M,
                                         const LineStiffness& lines);

}  // namespace hawser::master
