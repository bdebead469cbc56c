// Metacentric heights and the signs of the stiffness: does the platform stand?
#pragma once

#include "hull.hpp"
#include "statics_report.hpp"

namespace hawser::master {

/// Metacentric height of the hull alone in roll (0) or pitch (1), upright at the design draft [m]:
///
///     GM = z_B + BM - z_G = (K_hull + m g z_G)/(rho g V) - z_G
///
/// with the hull's own stiffness about O in that direction. Zero without buoyancy.
double hull_GM(const Hull& hull, int axis, double gravity);

/// @param K  stiffness of platform and lines about O at the equilibrium
/// @param length  lever that makes rotations lengths [m]
/// A direction counts as without stiffness below 1e-9 of the stiffest, as in the equilibrium.
Stability stability_of(const Hull& hull, double gravity, const Mat6& K, double length);

/// One sentence for each thing that should worry; empty if it stands.
std::vector<std::string> stability_warnings(const Stability& stability, const std::string& name);

}  // namespace hawser::master
