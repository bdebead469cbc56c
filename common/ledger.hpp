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

/// Accumulates a ledger over the platform's steps. Components are averaged with trapezoid weights.
/// The momentum side needs no acceleration: with p the linear momentum and L the angular momentum
/// about the moving point O, P:2 integrated over T is
///
///     mean F   = (p(T) - p(0)) / T
///     mean M_O = (L(T) - L(0) + integral of v_O x p dt) / T
///
/// since dL/dt = M_O - v_O x p. Momentum is that of the rigid mass alone: the inertia of the added
/// mass stands among the loads, with radiation.
class Ledger {
 public:
    explicit Ledger(std::vector<std::string> components);

    /// The state at the end of a step, in order of time.
    /// @param t [s]
    /// @param loads one per component, force [N] and moment about O [N.m]
    /// @param momentum linear [N.s] and angular about O [N.m.s] of the rigid mass
    /// @param velocity of O [m/s]
    void add(double t, std::span<const Vec6> loads, const Vec6& momentum, const Vec3& velocity);

    /// Everything added so far; zero rows with fewer than two states.
    [[nodiscard]] LedgerTable table() const;

 private:
    std::vector<std::string> components_;
    std::vector<Vec6> integral_, last_;
    Vec6 first_momentum_ = Vec6::Zero(), last_momentum_ = Vec6::Zero();
    Vec3 turning_ = Vec3::Zero(), last_rate_ = Vec3::Zero();  // integral of v_O x p, last v_O x p
    double first_t_ = 0.0, last_t_ = 0.0;
    int n_ = 0;
};

}  // namespace hawser
