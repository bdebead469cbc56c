// Packs whose rods are tied to each other, lane by lane, and are advanced together: rod i of every
// pack of a group belongs to bundle i, whose members take the same steps, halve them together and
// fail together. A rod that is tied to nothing is a bundle of one. No allocation in a step.
#pragma once

#include <span>
#include <vector>

#include "rod/rod_pack.hpp"
#include "rod/tie_system.hpp"

namespace hawser::worker {

template <class V>
class RodGroup {
 public:
    using Mask = typename LaneTraits<V>::Mask;
    static constexpr int lanes = LaneTraits<V>::count;

    /// @param packs  all that are tied to each other; they stay where they are
    explicit RodGroup(std::span<RodPack<V>> packs);

    /// Static solution with the platform at `pose`, in the kept states, see RodPack.
    Status equilibrium(const PlatformMotion& pose, bool current);
    /// One pass of all rods, see RodPack.
    Status pass(double t0, double t1, const MotionSpline& platform);
    void keep() {
        for (RodPack<V>& p : packs_) p.keep();
    }
    /// Linear harmonic motion about the last static solution, R:44.
    void swing(double omega);
    /// -d(wrench)/d(position, rotation vector) of a lane of pack p, with all that it is tied to.
    [[nodiscard]] Mat6 stiffness(std::size_t p, int lane, const Vec3& reference) {
        return stiffness_about<6>(p, lane, {reference, Vec3::Zero()});
    }
    /// The same of rods that touch two platforms.
    [[nodiscard]] Mat12 stiffness_between(std::size_t p, int lane, const Vec3& first,
                                          const Vec3& second) {
        return stiffness_about<12>(p, lane, {first, second});
    }
    /// Motion or pose of the second platform, before a pass or a static solution.
    void follow_second(const MotionSpline& platform) {
        for (RodPack<V>& p : packs_) p.follow_second(platform);
    }
    void hold_second(const PlatformMotion& pose) {
        PlatformMotion at = pose;
        at.velocity.setZero();
        at.angle_rates.setZero();
        follow_second(MotionSpline(0.0, at, 0.0, at));
    }

    [[nodiscard]] const std::span<RodPack<V>>& packs() const { return packs_; }

 private:
    using State = RodState<V> RodPack<V>::*;

    // rod_group.cpp
    /// Where constraints and ties act in a step from state `before`.
    void place(State before, V t_before, V t, const MotionSpline& platform, bool search);
    /// Loads of all constraints and ties at the trial values.
    void evaluate(V a1);
    /// One linear system of all rods, R:24, R:26, ties R:46.
    void solve(V a0, V a1);
    /// The lowest line of `bad` lanes, of its bundle the one with the largest correction.
    [[nodiscard]] Status status_of(Mask bad, Status::Code code, double t) const;
    [[nodiscard]] Mask used() const { return packs_.front().used_; }

    // time_step.cpp
    Mask attempt_step(Mask active, V h, V t_new, const MotionSpline& platform);
    Status dynamic_pass(double t0, double t1, const MotionSpline& platform);

    // quasi_static.cpp
    Status still_pass(double t0, double t1, const MotionSpline& platform);
    Mask still_attempt(Mask wanted, double t0, double t1, V t, const MotionSpline& platform);

    // statics.cpp
    Status find_equilibrium(const PlatformMotion& pose, bool current);
    /// Shapes to start from, of the lanes that have none; tied ends after what they are tied to.
    Mask guess(Mask wanted, const PlatformMotion& pose);
    Mask static_newton(const PlatformMotion& pose, bool current, Mask wanted, double part = 1.0);
    Status false_equilibrium() const;

    // ties.cpp
    void find_ties();
    void place_ties(State before, bool search);
    void follow_ties();
    void answer_ties();
    void couple();
    void carry_ties();
    template <int n>
    Eigen::Matrix<double, n, n> stiffness_about(std::size_t p, int lane,
                                                const std::array<Vec3, 2>& reference);

    std::span<RodPack<V>> packs_;
    std::vector<Tie> ties_;
    std::vector<TieSide<V>> sides_;  ///< two of each tie
    TieSystem<V> system_;
};

}  // namespace hawser::worker
