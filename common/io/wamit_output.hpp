// Writes hydrodynamic coefficients as a set of WAMIT numeric files, the inverse of hydro_file.
#pragma once

#include <filesystem>
#include <vector>

#include "hydro_data.hpp"

namespace hawser::io {

/// STEM.1, .3 and .hst, and what else the data hold of .2 .3fk .3sc .4 .7 .8 .9 .12d .12s, with
/// ULEN 1: frequency as period, limits as PER -1 and 0, headings in degrees, phase in degrees, .hst
/// without weight. rho is data.density. About the reference point of the data, which has to be
/// where the files' origin is. Each file is whole or not there. Throws RunError(ExitCode::io).
/// @return the files
std::vector<std::filesystem::path> write_wamit(const HydroData& data, double gravity,
                                               const std::string& stem);

}  // namespace hawser::io
