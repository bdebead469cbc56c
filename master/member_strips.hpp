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
    double height = 0.0;  ///< rise of the surface per part of the strip that it wets [m]
};

/// Every section of the axis gets wet linearly as the surface passes its vertical extent c = sqrt(1
/// - t_z^2) width (t: axis on world axes); over the strip, whose axis spans a = |t_z| length,
///
///     fraction = 1/a int clamp(1/2 + (eta - z)/c, 0, 1) dz
///
/// exact for an upright cylinder, without a jump for a lying one, and the same however a member is
/// cut.
Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta);

}  // namespace hawser::master
