// From where a run starts: the common equilibrium of platforms and lines under the mean loads, and
// the offset that the case adds to it. Case key `platform.mass: auto`.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "hull.hpp"
#include "joint_equilibrium.hpp"
#include "lines.hpp"
#include "modes_report.hpp"
#include "statics_report.hpp"

namespace hawser::master {

struct StaticStart {
    Poses equilibrium;          ///< of each platform at rest under the mean loads, world axes
    Poses start;                ///< with its `initial` added
    Reply at_rest;              ///< static loads at `equilibrium`
    Reply lines;                ///< static loads at `start`
    Eigen::MatrixXd stiffness;  ///< of platforms and lines at the equilibrium, about each O
    PerPlatform<double> vertical_line_load{};  ///< at the design position in still water, down [N]
    std::vector<Stability> stability;          ///< of each at the equilibrium
    std::vector<CoupledMode> modes;            ///< about it; of platform k from 6 k on
    int iterations = 0;
    std::vector<std::string> notes;  ///< warnings
};

/// Takes away what `initial` adds to the motions that find their own place, of all platforms.
void leave_out_initial(Case& input);

/// Where the platforms are built to be.
Poses designs_of(const Case& input);

/// A hull's mean loads, with its scales: what an equilibrium is found with.
/// @param which  the mean loads; must outlive the result, as the hull must
StaticPlatform platform_at_rest(const Case& input, const Hull& hull, const Statics& which);
std::vector<StaticPlatform> platforms_at_rest(const Case& input, const std::vector<Hull>& hulls,
                                              const Statics& which);

/// Sets masses of `auto`, (acting buoyancy - vertical static line loads at the design positions in
/// still water) / g, and finds the equilibrium. Throws RunError (no_equilibrium).
/// @param hulls  all platforms of the case, in its order
StaticStart static_start(const Case& input, std::vector<Hull>& hulls, Lines& lines);

}  // namespace hawser::master
