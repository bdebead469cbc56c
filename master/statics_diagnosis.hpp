// Why a line has no static solution: what its ends, its weight and its stiffness say before any
// iteration does.
#pragma once

#include <string>

#include "case/case.hpp"
#include "lines.hpp"

namespace hawser::master {

/// The likeliest cause in one sentence, with the numbers it rests on: ends further apart than the
/// line can stretch, so long that it lies slack, lighter than water, a tensioner weaker than the
/// weight below it, an end under the bed, a stiffness that is out of reason.
/// @param poses  of the platforms when the line failed
std::string static_failure_cause(const Line& line, const Case& input,
                                 const PerPlatform<PlatformMotion>& poses);

}  // namespace hawser::master
