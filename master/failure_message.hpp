// What a failing line says to people: which, where, when, and what to try.
#pragma once

#include <string>

#include "case/case.hpp"
#include "lines.hpp"
#include "status.hpp"

namespace hawser::master {

/// One line without an end, e.g. "scr_gas, t = 31.24 s, stage 3: Newton residual 2.1e+03 N after 30
/// iterations, largest at s = 1583 m; likely cause: ...".
/// @param stage of the Runge-Kutta step, 1 to 4; 0: outside of one
/// @param poses of the platforms when the line failed, statics only
std::string failure_message(const Status& status, const Case& input, int stage,
                            const PerPlatform<PlatformMotion>& poses = {});

/// Largest element CFL number of a line: its axial wave speed sqrt(EA/m) times its step over the
/// length of an element [-].
double largest_cfl(const Line& line, const Case& input);

}  // namespace hawser::master
