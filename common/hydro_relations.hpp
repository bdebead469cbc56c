// Relations between the hydrodynamic coefficients of one hull that hold for every linear solution.
// Sources: Newman, Marine Hydrodynamics (1977) 6.16-6.18 (Haskind's relation); Ogilvie 1964
// (added mass and damping as transforms of one another).
#pragma once

#include <optional>
#include <vector>

#include "hydro_data.hpp"

namespace hawser {

/// How far the hull reaches [m]: the edge of the cube of its volume or the diameter of the disc
/// with its waterplane's second moments, whichever is more; without a volume that of its
/// waterplane's area. 0: not known.
double hull_size(const HydroData& data);

/// Length of a wave [m]. @param depth  0: deep water
double wavelength(const HydroData& data, double omega, double depth);

/// Place of a frequency in an ascending list, to the digits of a file; none if it is not there.
std::optional<std::size_t> place_of(const std::vector<double>& frequencies, double omega);

/// Damping as the excitation tells it, at the frequencies that both have:
///
///     B_ij = k / (8 pi rho g c_g) int_0^2pi X_i X_j* db
///
/// by the trapezoidal rule over a full turn of headings; of a hull that is round, any heading tells
/// the others. `depth` decides over k and the group speed c_g.
struct HaskindDamping {
    std::vector<std::size_t> at;  ///< places among the frequencies of the damping
    std::vector<CMat6> integral;  ///< over the turn [(N/m)^2, ...]
    bool by_roundness = false;    ///< headings were filled in as those of a round hull
    bool by_one_heading = false;  ///< and nothing but symmetric added mass says that it is round

    [[nodiscard]] CMat6 damping(const HydroData& data, std::size_t i, double depth) const;
};
std::optional<HaskindDamping> haskind_damping(const HydroData& data);

/// Added mass at infinite frequency as every frequency tells it,
///
///     A(inf) = A(w) - 2/pi PV int_0^inf B(u) / (u^2 - w^2) du
///
/// with B linear between the frequencies and falling with u^-3 beyond the last. One per frequency
/// [kg, kg.m, kg.m2]; the last tenth of the range feels what is cut off.
std::vector<double> infinite_by_ogilvie(const HydroData& data, int mode);

}  // namespace hawser
