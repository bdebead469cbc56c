// What `hawser hydro info` says of a set of hydrodynamic data: as text for people, and whole, as
// JSON, for scripts/plot_hydro.
#pragma once

#include <string>

#include "io/hydro_file.hpp"
#include "io/hydro_options.hpp"
#include "io/json.hpp"

namespace hawser::io {

/// Planes of symmetry that the coefficients show: "round", "xz and yz", "xz", "yz" or "none".
std::string symmetry_shown(const HydroData& data);

std::string hydro_text(const HydroRequest& request, const CheckedHydro& found);

/// Everything: matrices row by row, tables by heading and frequency, complex numbers as {re, im}.
Json hydro_json(const HydroRequest& request, const CheckedHydro& found);

}  // namespace hawser::io
