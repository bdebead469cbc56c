// Forces and moments given by the user, constant or in time (case key `platform.forces`).
#pragma once

#include <vector>

#include "case/platform.hpp"
#include "frames.hpp"

namespace hawser::master {

class AppliedForces {
 public:
    /// @param ramp  of the run [s]: brings in harmonic forces
    AppliedForces(const std::vector<AppliedForce>& forces, double ramp)
        : forces_(forces), ramp_(ramp) {}

    /// Sum of f(t) (F, M + r x F) about O on world axes [N, N.m], r = R position. f: the factor's
    /// rows with straight lines between, or r(t) cos(2 pi t/period + phase), or 1; of a file its
    /// rows with straight lines between. F and M turn with R where they are on platform axes.
    [[nodiscard]] Vec6 load(double t, const Mat3& R) const;

    /// What the static start holds: load(0) without the harmonic ones.
    [[nodiscard]] Vec6 static_load(const Mat3& R) const;

 private:
    std::vector<AppliedForce> forces_;
    double ramp_;
};

}  // namespace hawser::master
