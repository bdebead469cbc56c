// Time scheme of the rods: generalised-alpha for constrained systems, R:27. Its undamped member is
// the one-step Adams-Moulton (trapezoidal) rule of the paper.
#pragma once

#include "case/analysis.hpp"

namespace hawser::worker {

/// Constants of R:27.
///
///     (1-am) A1 + am A0 = (1-af) a1 + af a0
///     x1 = x0 + h v0 + h^2 [(1/2-beta) A0 + beta A1],   v1 = v0 + h [(1-gamma) A0 + gamma A1]
struct TimeScheme {
    double am = 0.0, af = 0.0, gamma = 0.5, beta = 0.25;
    double g_damper = 0.5;  ///< weight g of R:4 for structural damping: 1/(1 + rho_inf)

    explicit TimeScheme(const RodScheme& scheme) {
        if (scheme.type == RodSchemeType::adams_moulton) return;
        const double rho = scheme.spectral_radius;
        am = (2 * rho - 1) / (rho + 1);
        af = rho / (rho + 1);
        gamma = 0.5 + af - am;
        beta = (gamma + 0.5) * (gamma + 0.5) / 4;
        g_damper = 1 / (1 + rho);
    }
    /// Does it keep a sawtooth for ever? (adams_moulton, spectral radius 1)
    [[nodiscard]] bool undamped() const { return g_damper <= 0.5; }
    /// da/dx [1/s2] of one step of length h.
    template <class V>
    [[nodiscard]] V a0(V h) const {
        return V((1 - am) / ((1 - af) * beta)) / (h * h);
    }
    /// dv/dx [1/s] of one step of length h.
    template <class V>
    [[nodiscard]] V a1(V h) const {
        return V(gamma / beta) / h;
    }
};

}  // namespace hawser::worker
