// From where a run starts: the common equilibrium of platform and lines under the mean loads, and
// the offset that the case adds to it. Case key `platform.mass: auto`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "equilibrium.hpp"
#include "hull.hpp"
#include "lines.hpp"
#include "modes_report.hpp"
#include "statics_report.hpp"

namespace hawser::master {

struct StaticStart {
    PlatformMotion equilibrium;        ///< at rest under the mean loads
    PlatformMotion start;              ///< with `platform.initial` added
    Reply at_rest;                     ///< static loads at `equilibrium`
    Reply lines;                       ///< static loads at `start`
    Mat6 stiffness = Mat6::Zero();     ///< of platform and lines at the equilibrium, about O
    double vertical_line_load = 0.0;   ///< at the design position in still water, downwards [N]
    Stability stability;               ///< at the equilibrium
    std::array<CoupledMode, 6> modes;  ///< about it
    int iterations = 0;
    std::vector<std::string> notes;  ///< warnings
};

/// Takes away what `initial` adds to the motions that find their own place.
void leave_out_initial(Platform& platform);

/// The hull's mean loads, with its scales: what an equilibrium is found with.
/// @param which  the mean loads; must outlive the result, as the hull must
StaticPlatform platform_at_rest(const Case& input, const Hull& hull, const Statics& which);

/// Sets a mass of `auto`, (acting buoyancy - vertical static line loads at the design position in
/// still water) / g, and finds the equilibrium. Throws RunError (no_equilibrium).
StaticStart static_start(const Case& input, Hull& hull, Lines& lines);

}  // namespace hawser::master
