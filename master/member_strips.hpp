// Members of the hull cut into strips, and what of a strip is in the water: exact for a truncated
// cone cut by a plane surface. K:24
#pragma once

#include <vector>

#include "case/platform.hpp"

namespace hawser::master {

/// One strip of a member: a truncated cone. Axis points from `from` to `to`; body axes.
struct Strip {
    Vec3 middle = Vec3::Zero();  ///< [m]
    Vec3 axis = Vec3::UnitZ();   ///< unit vector
    double length = 0.0;         ///< [m]
    double radius = 0.0;         ///< of the section that meets the surface, at the middle [m]
    double taper = 0.0;          ///< its growth per length along the axis
    double width = 0.0;          ///< drag width at the middle [m]
    double width_taper = 0.0;    ///< its growth per length
    std::size_t member = 0;      ///< its index
};

/// Every member in equal strips of at most `longest` [m]. A drag width may be far wider than what
/// displaces water: the surface meets the latter, where there is one.
std::vector<Strip> strips_of(const std::vector<Member>& members, double longest);

/// The wet part of a strip under a surface at height eta.
struct Wetting {
    double length = 0.0;      ///< int f ds, f the wet part of the section [m]
    double shift = 0.0;       ///< its middle, from the strip's middle along the axis [m]
    double drag_area = 0.0;   ///< int width f ds [m2]
    double volume = 0.0;      ///< int pi r^2 f ds [m3]
    double along = 0.0;       ///< centre of that volume, from the strip's middle along the axis [m]
    double up = 0.0;          ///< ... and across the axis, upwards [m]; not above 0
    double waterplane = 0.0;  ///< d(volume)/d(eta): the section in the surface [m2]
    bool whole = false;       ///< all of it is wet
};

/// K:24. Section s of the axis has its centre y(s) = eta - z(s) below the surface and the half
/// height c = r sqrt(1 - t_z^2); with u = y/c between -1 and 1
///
///     f = 1/2 + (u sqrt(1 - u^2) + asin u)/pi,     int_wet h dA = -2/3 r^3 (1 - u^2)^(3/2)
///
/// h: height across the axis. Integrated in closed form over the part where u is beyond 1, and over
/// that between by Gauss' rule in an angle that takes away the roots at its ends: to 1e-9 of the
/// whole. So a member has the second moment of its own waterplane, and is the same however it is
/// cut.
Wetting wetting(const Strip& strip, double axis_z, double middle_z, double eta);

}  // namespace hawser::master
