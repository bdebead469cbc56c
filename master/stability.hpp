// Metacentric heights and the signs of the stiffness: does the platform stand?
#pragma once

#include <vector>

#include "hull.hpp"
#include "joint_equilibrium.hpp"
#include "statics_report.hpp"

namespace hawser::master {

/// Metacentric height of the hull alone in roll (0) or pitch (1), upright at the design draft [m]:
///
///     GM = z_B + BM - z_G = (K_hull + m g z_G)/(rho g V) - z_G
///
/// with the hull's own stiffness about O in that direction. Zero without buoyancy.
double hull_GM(const Hull& hull, int axis, double gravity);

/// Of each platform: heights with its own part of K, the others held; motions without or with
/// negative stiffness of all together, each with the platform that has the greatest part in it.
/// @param K        stiffness of platforms and lines about each O at the equilibrium, 6 rows and
///                 columns per platform
/// @param at_rest  the platforms, for their scales
/// A direction counts as without stiffness below 1e-9 of the stiffest, as in the equilibrium.
std::vector<Stability> stability_of(const std::vector<Hull>& hulls, double gravity,
                                    const Eigen::MatrixXd& K,
                                    const std::vector<StaticPlatform>& at_rest);

/// One sentence for each thing that should worry; empty if it stands.
std::vector<std::string> stability_warnings(const Stability& stability, const std::string& name);

}  // namespace hawser::master
