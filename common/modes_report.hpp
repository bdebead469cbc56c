// What `hawser modes` finds out, as plain values. SI and radians.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "resting_lines.hpp"

namespace hawser {

/// A natural mode of the platform, or of several together, with the lines.
struct CoupledMode {
    double omega_squared = 0.0;   ///< [rad2/s2]; not above zero: nothing holds it, or it falls over
    int platform = 0;             ///< that it is named after
    int motion = 0;               ///< of that, 0 ... 5: the motion that it is named after
    Vec6 shape = Vec6::Zero();    ///< of that, surge ... yaw about O; its main motion is 1
    std::vector<Vec6> all = {};   ///< of several platforms: the part of each, to that scale
    double share = 0.0;           ///< of the kinetic energy that is in that motion
    double line_inertia = 0.0;    ///< share of the kinetic energy that is in the lines
    double line_stiffness = 0.0;  ///< share of the elastic energy that is in the lines
    bool held = false;            ///< by the case: it has no period
    bool converged = true;        ///< false: lines with static stiffness, without inertia
    [[nodiscard]] std::optional<double> period() const {  ///< [s]
        if (omega_squared > 0.0) return 2.0 * M_PI / std::sqrt(omega_squared);
        return std::nullopt;
    }
};

struct LineModes {
    int line = 0;  ///< index in Case::lines
    std::vector<RodMode> modes;
    std::vector<Vec3> position;      ///< of the nodes at rest, from end A [m]
    std::vector<double> arc_length;  ///< of the nodes, from end A [m]
};

struct ModesReport {
    std::vector<std::string> platforms;  ///< their names
    std::vector<PlatformMotion> rest;    ///< where they are in the equilibrium
    std::vector<CoupledMode> coupled;    ///< six per platform; none without one
    std::vector<LineModes> lines;
    std::vector<std::string> warnings;
};

struct ModesRequest {
    int count = 0;            ///< of modes per line; 0: as the case says
    std::string lines = "*";  ///< glob: which lines
};

/// Natural modes about the equilibrium that starts a run. Throws RunError. Defined by master/.
ModesReport find_modes(const Case& input, const ModesRequest& request);

}  // namespace hawser
