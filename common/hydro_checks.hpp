// Whether hydrodynamic coefficients can be those of one hull: relations that hold for every linear
// solution, whatever program made it. Sources: Newman, Marine Hydrodynamics (1977) 6.16-6.18 (with
// Haskind's relation and the long-wave limits); Ogilvie 1964.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro_data.hpp"

namespace hawser {

struct HydroCheck {
    /// remark: worth knowing, but no sign of wrong data.
    enum class Verdict { fine, remark, doubtful, wrong };
    enum class About { radiation, excitation, stiffness, drift, second_order };
    Verdict verdict = Verdict::fine;
    About about = About::radiation;
    std::string what;            ///< "Haskind, heave"
    std::string sentence;        ///< what was found, and for the doubtful what to do
    double frequency = 0.0;      ///< where it shows most [rad/s]; 0: nowhere in particular
    int mode = -1;               ///< 0 .. 5, or none
    std::optional<double> size;  ///< the figure, relative: 0 is perfect
};

/// All checks that the data allow, in a fixed order.
std::vector<HydroCheck> check_hydro(const HydroData& data);

/// How far damping and excitation are from Haskind's relation (hydro_relations.hpp): sum |B_ii -
/// that| over sum B_ii in waves longer than half the hull, the larger of surge and heave. None
/// without damping or without a full turn of headings.
std::optional<double> haskind_misfit(const HydroData& data);

}  // namespace hawser
