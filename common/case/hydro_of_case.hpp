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

/// Headings of all waves within those of the data (they are never extrapolated), 99 % of the waves'
/// energy within its frequencies, drift where it is asked for, the water's depth and density.
void check_coverage(const Case& input, const Platform& platform, const HydroData& data,
                    Problems& problems);

}  // namespace hawser
