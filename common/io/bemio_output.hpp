// Writes hydrodynamic coefficients as BEMIO's .h5, the inverse of bemio_set.
#pragma once

#include <filesystem>

#include "hydro_data.hpp"

namespace hawser::io {

/// One body, scaled = 0: added mass over rho, damping over rho w, forces over rho g. Frequencies
/// and headings of all tables in one grid, NaN where a table has no value. A(0) stands beside
/// A(inf) as added_mass/zero_freq. The layout has no place for free motions and for quadratic
/// transfer functions. Depth that is not known is written as infinite. Throws
/// RunError(ExitCode::io).
///
/// @param name  of the body
/// @param cog   z of its centre of gravity [m], for readers that want one
void write_bemio(const HydroData& data, const std::string& name, double cog,
                 const std::filesystem::path& path);

}  // namespace hawser::io
