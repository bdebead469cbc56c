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
    enum class Verdict { fine, doubtful, wrong };
    enum class About { radiation, excitation, stiffness };
    Verdict verdict = Verdict::fine;
    About about = About::radiation;
    std::string what;      ///< "Haskind, heave"
    std::string sentence;  ///< what was found, and for the doubtful what to do
};

/// All checks that the data allow, in a fixed order.
std::vector<HydroCheck> check_hydro(const HydroData& data);

/// How far damping and excitation are from Haskind's relation
///
///     B_ii = k / (8 pi rho g c_g) int_0^2pi |X_i(b)|^2 db
///
/// as sum |B_ii - that| over sum B_ii, the larger of surge and heave. None if there is no damping,
/// no depth-free reading or not enough headings: a full turn, or any one for a hull that is round
/// by its added mass.
std::optional<double> haskind_misfit(const HydroData& data);

}  // namespace hawser
