#include "force_fit.hpp"

namespace hawser {

double fit_weight(ForceFit fit, int i, int n) {
    if (fit == ForceFit::instantaneous || fit == ForceFit::impulse_matched)
        return i == n ? 1.0 : 0.0;
    const double N = n, x = i - 0.5 * N;
    double w = 1.0 / (N + 1.0) + 6.0 * x / ((N + 1.0) * (N + 2.0));
    if (fit == ForceFit::quadratic_fit)
        w += 30.0 * (x * x - N * (N + 2.0) / 12.0) / ((N + 1.0) * (N + 2.0) * (N + 3.0));
    return w;
}

}  // namespace hawser
