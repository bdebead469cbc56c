// The restoring curve: what the lines do to the platform when it is held away from its place.
#pragma once

#include <vector>

#include "hull.hpp"
#include "joint_equilibrium.hpp"
#include "lines.hpp"
#include "statics_report.hpp"

namespace hawser::master {

/// The platform is moved along the heading from its design position, in still water. Of its other
/// motions those that are free (StaticsRequest::free) settle under weight, buoyancy and all lines,
/// the rest stay as at the design position. Other platforms settle in all motions where the curve
/// sums all lines, else they stay too. What holds the platform against the offset acts at its
/// reference point. With e the direction of the offset and q the free motions,
///
///     restoring = -e . sum f,     slope = e . sum S (e + dq/dx),   dq/dx = -K_qq^-1 K_q. e
///
/// S and f of the chosen lines, K of hulls and all lines. A point where a line has no solution, or
/// the platform no equilibrium, ends the curve with the reason; of the first point it is thrown:
/// RunError (no_equilibrium). Throws RunError (input) if no line or no platform is called as asked
/// for.
OffsetCurve offset_curve(const Case& input, const StaticsRequest& request,
                         const std::vector<Hull>& hulls, Lines& lines, const Describe& describe);

}  // namespace hawser::master
