// The load ledger: what pushed the platform, component by component, against what its momentum says
// must have pushed it. The two sides come from different data, so their difference tests a run.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "vector.hpp"

namespace hawser {

/// Means over a time T; forces [N], moments about the moving O [N.m], world axes.
struct LedgerTable {
    std::vector<std::string> components;
    std::vector<Vec6> mean;        ///< of each component
    Vec6 sum = Vec6::Zero();       ///< of the means
    Vec6 momentum = Vec6::Zero();  ///< mean of mass x acceleration, from the change of momentum
    Vec6 residual = Vec6::Zero();  ///< sum - momentum
    double from = 0.0, to = 0.0;   ///< [s]

    /// The largest component of a motion (surge 0 ... yaw 5); weight and hydrostatic count as one.
    [[nodiscard]] double largest(int motion) const;
    /// |residual| over the largest component; 0 where nothing acts.
    [[nodiscard]] double residual_fraction(int motion) const;
    /// Does anything act in a motion? Loads of a millionth of those in the other forces (moments)
    /// are rounding.
    [[nodiscard]] bool is_loaded(int motion) const;
};
/// A residual_fraction that a reader should know of.
inline constexpr double large_residual = 0.005;

/// Accumulates a ledger from the evaluations that moved the platform. Each load counts for the time
/// that the integration scheme lets it act, D/6, D/3, D/3 and D/6 in P:3, so that the means are
/// those of what really pushed. The momentum side needs no acceleration: with p the linear momentum
/// and L the angular momentum about the moving point O, P:2 integrated over T is
///
///     mean F   = (p(T) - p(0)) / T
///     mean M_O = (L(T) - L(0) + integral of v_O x p dt) / T
///
/// since dL/dt = M_O - v_O x p. Momentum is that of the rigid mass alone: the inertia of the added
/// mass stands among the loads, with radiation. What is left over is rounding where momentum is
/// linear in the state and of order D^4 where the body turns.
class Ledger {
 public:
    explicit Ledger(std::vector<std::string> components);

    /// The state between two steps; takes in what acted since the one before.
    /// @param t [s], rising
    /// @param momentum linear [N.s] and angular about O [N.m.s] of the rigid mass
    void at_step(double t, const Vec6& momentum);
    /// What acts in the step that has begun, an evaluation of it. A step that is never closed by
    /// at_step() does not count.
    /// @param duration  weight of the evaluation times the step [s]
    /// @param loads     one per component, force [N] and moment about O [N.m]
    /// @param momentum  as above, at this evaluation
    /// @param velocity  of O [m/s]
    void act(double duration, std::span<const Vec6> loads, const Vec6& momentum,
             const Vec3& velocity);

    /// All whole steps so far; zero rows before the first of them.
    [[nodiscard]] LedgerTable table() const;

 private:
    std::vector<std::string> components_;
    std::vector<Vec6> integral_, step_;  // of whole steps, of the step that has begun
    Vec6 first_momentum_ = Vec6::Zero(), last_momentum_ = Vec6::Zero();
    Vec3 turning_ = Vec3::Zero(), step_turning_ = Vec3::Zero();  // integrals of v_O x p
    double first_t_ = 0.0, last_t_ = 0.0;
    int n_ = 0;
};

}  // namespace hawser
