// The force a pass returns: the value at its end, or a least-squares fit of the sub-step history
// evaluated there (P:4, P:5: "force fit").
#pragma once

#include "case/analysis.hpp"

namespace hawser {

/// Weight of the i-th of n + 1 equally spaced values (0: start of the pass, n: its end) in the
/// force returned, f = sum_i w_i f_i. The fit includes the start value and is evaluated at the end.
/// With x = i - n/2 the discrete orthogonal polynomials give
///
///     instantaneous   w = 1 at i = n, else 0; so does impulse_matched, whose carry comes on top
///     linear_fit      w = 1/(n+1) + 6 x / ((n+1)(n+2))
///     quadratic_fit   w = linear + 30 [x^2 - n(n+2)/12] / ((n+1)(n+2)(n+3))
///
/// No history is stored: add w_i f_i as the pass goes. The weights sum to 1; a fit of degree d is
/// exact for polynomials up to d. With fewer than d + 1 values it passes through them.
/// @param n sub-steps of the pass, at least 1
[[nodiscard]] double fit_weight(ForceFit fit, int i, int n);

}  // namespace hawser
