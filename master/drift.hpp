// Wave drift from mean-drift coefficients: the mean, and Newman's signed slow force.
// Newman 1974; the sum holds difference frequencies only. No wave-drift damping, no effect of
// current.
#pragma once

#include "component_table.hpp"
#include "slow_motion.hpp"

namespace hawser::master {

/// Drift about O on world axes [N, N.m], without the ramp.
struct DriftLoad {
    Vec6 mean = Vec6::Zero();  ///< sum_i a_i^2 D_i
    Vec6 slow = Vec6::Zero();  ///< Newman's force of the moment; its mean is `mean`
};

/// Exact sum over all ordered pairs, T_ij = (D_i + D_j)/2, phi_i the phases at the slow position:
///
///     F(t) = sum_ij a_i a_j T_ij cos(phi_i - phi_j)
///          = Re [ (sum_i a_i D_i e^{i phi_i}) conj(sum_j a_j e^{i phi_j}) ]
///
/// The mean of the diagonals makes the double sum a product of two single ones, so it is exact and
/// as cheap as the excitation; sign(D) sqrt(D_i D_j) has no such form where D changes sign.
/// D_i is that of the component's own heading, so crossing and short-crested seas have their exact
/// mean; how the true function falls where two headings part is not known to it.
DriftLoad drift_load(const ComponentTable<Vec6>& table,
                     const std::vector<WaveComponent>& components,
                     const std::vector<Complex>& phases, double yaw);

}  // namespace hawser::master
