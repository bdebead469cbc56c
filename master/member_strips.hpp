// Members of the hull cut into strips, and how much of a strip is in the water.
#pragma once

#include <vector>

#include "case/platform.hpp"

namespace hawser::master {

/// One strip of a member. Axis points from `from` to `to`; body axes.
struct Strip {
    Vec3 middle = Vec3::Zero();  ///< [m]
    Vec3 axis = Vec3::UnitZ();   ///< unit vector
    double length = 0.0;         ///< [m]
    double width = 0.0;          ///< of the cylinder that pierces the surface [m]
    std::size_t member = 0;      ///< its index
};

/// Every member in equal strips of at most `longest` [m].
std::vector<Strip> strips_of(const std::vector<Member>& members, double longest);

/// The wet part of a strip under a surface at height eta.
struct Wetting {
    double fraction = 0.0;  ///< 0 dry .. 1 submerged
    double shift = 0.0;   ///< from the strip's middle to the middle of its wet part, along axis [m]
    double height = 0.0;  ///< vertical extent over which the fraction runs from 0 to 1 [m]
};

/// The strip reaches h/2 = (|t_z| length + sqrt(1 - t_z^2) width)/2 above and below its middle
/// (t: axis on world axes); the wet fraction grows linearly over that height,
///
///     fraction = clamp((eta - z + h/2)/h, 0, 1)
///
/// exact for an upright cylinder, and without a jump for a lying one.
Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta);

}  // namespace hawser::master
