// Radiation with memory (Cummins 1962) as the hull integrates it: the fitted form in the state
// vector, or the discrete convolution over the platform's steps. Footnote 3 of P:2.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "memory_fit.hpp"
#include "retardation.hpp"

namespace hawser::master {

/// K:10  The memory as damped oscillators driven by the velocity v of the hull, all on body axes:
///
///     x1' = -a x1 + b x2 + 2 v,   x2' = -b x1 - a x2,   load = -sum_p ( first x1 + second x2 )
class FittedMemory {
 public:
    FittedMemory() = default;
    explicit FittedMemory(MemoryFit fit) : fit_(std::move(fit)) {}

    [[nodiscard]] const MemoryFit& fit() const { return fit_; }
    [[nodiscard]] int states() const { return 12 * static_cast<int>(fit_.oscillators.size()); }
    /// @param x  states() numbers: x1 and x2 of each oscillator [m, rad]
    [[nodiscard]] Vec6 load(const double* x) const;
    /// Their rates.
    void add_rates_to(double* rates, const double* x, const Vec6& velocity) const;

 private:
    MemoryFit fit_;
};

/// K:9  The convolution over the velocities of the steps before,
///
///     load(t) = - int_0^T K(tau) v(t - tau) dtau,
///
/// with v between two steps the cubic of their velocities and accelerations, and from the last step
/// to the moment the parabola of v, v' there and v now: the error falls with the third power of D.
/// Weights of all steps are worked out once.
class DiscreteMemory {
 public:
    /// @param D         step of the platform [s]
    /// @param duration  T [s], after which the hull has forgotten
    DiscreteMemory(const Retardation& K, double D, double duration);

    /// The step at time t has been taken: velocity and its rate on body axes.
    void remember(double t, const Vec6& velocity, const Vec6& rate);
    /// @param t  the time of the last step, half a step or a step later
    [[nodiscard]] Vec6 load(double t, const Vec6& velocity) const;

 private:
    /// For a time c D after the last step: of v now, and of v and D v' at each step before.
    struct Weights {
        Mat6 now;
        std::vector<Mat6> velocity, rate;
        std::vector<Mat6> first_velocity, first_rate;  ///< where that step is the first of the run
    };
    static Weights weights(const Retardation& K, double D, int steps, double c);

    double D_;
    Weights half_, whole_;
    std::vector<Vec6> velocity_, rate_;  ///< ring buffers, newest at newest_; rate times D
    std::size_t newest_ = 0, count_ = 0;
    double t_ = 0.0;
};

}  // namespace hawser::master
