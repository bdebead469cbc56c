// The options of `hawser hydro info` and `hydro convert` as they stand on the command line, and as
// a request: which files, what they do not tell.
#pragma once

#include <string>
#include <vector>

#include "case/environment.hpp"
#include "case/platform.hpp"

namespace hawser::io {

struct HydroOptions {
    std::vector<std::string> files;
    std::string format, rho, g, ulen, volume, centre_of_buoyancy, depth, body, period_column,
        limits, symmetry, reference_point, phase_origin, mass, cog;
    bool includes_weight = false;
};

struct HydroRequest {
    HydroDatabase database;
    Water water;
    double depth = 0.0;                ///< [m]; 0: not known, infinity: deep
    std::optional<double> mass;        ///< of the platform, for its metacentric height [kg]
    double cog = 0.0;                  ///< z of its centre of gravity [m]
    std::vector<std::string> assumed;  ///< what was chosen for the user
};

/// Adds every problem, one sentence each, to `problems`. Looks at the files' names and whether they
/// are there, not into them.
HydroRequest hydro_request(const HydroOptions& options, std::vector<std::string>& problems);

}  // namespace hawser::io
