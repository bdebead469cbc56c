// The options of `hawser hydro cylinder` as they stand on the command line, and as a request.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hydro/cylinder_data.hpp"

namespace hawser::io {

struct CylinderOptions {
    std::string depth, frequencies, headings = "0", rho = "1025", g = "9.80665", tolerance;
    std::vector<std::string> parts;
    std::string mass, cog, gyration, heave_added_mass, heave_damping;  ///< empty: not given
    std::string out;
};

/// Adds every problem, one sentence each, to `problems`.
hydro::CylinderRequest cylinder_request(const CylinderOptions& options,
                                        std::vector<std::string>& problems);

}  // namespace hawser::io
