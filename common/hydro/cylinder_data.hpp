// Hydrodynamic coefficients of vertical cylinders on one axis over frequency and heading, as the
// program keeps those of any hull, with an estimate of what the truncated sums leave out.
#pragma once

#include <functional>
#include <optional>

#include "hydro/cylinder_waves.hpp"
#include "hydro_data.hpp"

namespace hawser::hydro {

struct CylinderRequest {
    Hull hull;
    std::vector<double> frequencies;  ///< ascending, above zero [rad/s]
    std::vector<double> headings;     ///< ascending [rad]
    Water water{1025.0, 9.80665};
    std::optional<FreeHull> free;         ///< without: the drift is that of the fixed hull
    double heave_damping_fraction = 0.0;  ///< of critical; becomes free->heave_damping
    double tolerance = 2e-4;              ///< of the truncation error
};

struct CylinderData {
    HydroData data;
    Buoyancy buoyancy;
    double truncation_error = 0.0;  ///< relative; change when the numbers of functions were doubled
    bool within_tolerance = true;
    int functions = 0, outer_modes = 0;
    double haskind_gap = 0.0, energy_gap = 0.0;  ///< largest of all frequencies
    double heave_damping = 0.0;                  ///< added to the free hull's waves [N.s/m]
    double zero_frequency = 0.0;                 ///< at which A(0) was computed [rad/s]
};

/// H:13 for the truncation. `progress`, if set, is told the part done, 0 to 1.
CylinderData cylinder_data(const CylinderRequest& request,
                           const std::function<void(double)>& progress = {});

}  // namespace hawser::hydro
