// A table of tension against strain, straight between its points and beyond its ends: R:41.
#pragma once

#include "case/lines.hpp"

namespace hawser::worker {

struct CurvePoint {
    double strain = 0.0;  ///< [-]
    double slope = 0.0;   ///< of the table there [N]
};

/// Strain e at which F(e) + c e = load, F the table, which rises. R:41.
/// @param c  of the damper beside it in a time step, c/(g h) [N]; 0 in statics
CurvePoint strain_under(const Curve& curve, double c, double load);

}  // namespace hawser::worker
