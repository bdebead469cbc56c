// The restoring curve: what the lines do to the platform when it is held away from its place.
#pragma once

#include "equilibrium.hpp"
#include "lines.hpp"
#include "statics_report.hpp"

namespace hawser::master {

/// The platform is displaced along the heading, its other modes as at the design position, in still
/// water. Throws RunError (no_equilibrium) where a line has no solution; (input) if no line is
/// called as asked for.
OffsetCurve offset_curve(const Case& input, const StaticsRequest& request, Lines& lines,
                         const Describe& describe);

}  // namespace hawser::master
