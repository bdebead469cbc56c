// Checks of a case against the hydrodynamic data it names: what they displace, whether they cover
// its waves. Problems are collected, paths are those of the case's keys.
#pragma once

#include "case/case.hpp"
#include "case/problem.hpp"
#include "hydro_data.hpp"

namespace hawser {

/// The water that database and members displace against `displacement` and `mass`, 0.5 % allowed.
/// @param volume  of the database [m3]
void check_displacement(const Case& input, const Platform& platform, double volume,
                        Problems& problems);

/// Draft and radii of gyration against the size of the hull: a mistaken unit shows.
/// @param data  of its database; none: members alone
void check_size(const Case& input, const Platform& platform, const HydroData* data,
                Problems& problems);

/// The platform step against the periods of the waves: less than six steps for more than 5 % of
/// their energy is a warning.
void check_steps_of_waves(const Case& input, Problems& problems);

/// Headings of all waves within those of the data (they are never extrapolated), 99 % of the waves'
/// energy within its frequencies, drift where it is asked for, the water's depth and density.
void check_coverage(const Case& input, const Platform& platform, const HydroData& data,
                    Problems& problems);

}  // namespace hawser
