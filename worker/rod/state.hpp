// Everything a rod remembers between steps, for all lanes of a pack, in one contiguous block.
// Saving for a stage and keeping are copies of it. Nodes are
// counted from end B (seabed) to end A (platform): the way the elimination runs.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rod/shape.hpp"
#include "rod/vector3.hpp"

namespace hawser::worker {

/// One node: position, slope r' = dr/ds (s from B to A), their rates and the auxiliary acceleration
/// A of R:27.
template <class V>
struct NodeState {
    Vector<V> r, d, v, vd, a, ad, A, Ad;
};

/// lambda at a node or an element middle, now and one step before (R:29) [N].
template <class V>
struct Multiplier {
    V now{}, before{};
};

/// Strains and rates of the two Kelvin-Voigt elements at a Gauss point, R:4.
template <class V>
struct Strain {
    V damper{}, damper_rate{}, creep{}, creep_rate{};
};

/// Deflection of the seabed's friction spring at a Gauss point, on the axes of the bed's plane,
/// R:34 [m].
template <class V>
struct Grip {
    V uphill{}, level{};
};

/// Water at a Gauss point at one grid time: velocity, wave acceleration, elevation above it; R:19.
template <class V>
struct Water {
    Vector<V> u, ud;
    V eta{};
};

/// A contact point of a constraint along the rod: where it touches, what it remembers, its load on
/// the rod and what it reports.
template <class V>
struct ConstraintState {
    V element{}, xi{};         ///< element from end B and place in it
    V friction{};              ///< deflection of the friction spring, R:34 [m]
    Vector<V> axis;            ///< of a joint on its own frame, from B to A
    Vector<V> force, point;    ///< on the rod [N], and where [m]
    Vector<V> moment;          ///< of a joint on the rod [N.m]
    V magnitude{}, opening{};  ///< normal force or tension [N]; gap left or stroke [m]
    V slip{};                  ///< slide of the rod along the axis since the start [m]
    V energy{};                ///< stored [J]
    V power{}, dissipated{};   ///< taken by dampers and friction [W], and since the start [J]
    // R:40
    Vector<V> impulse, hull_impulse;  ///< of the rod's steps; of the hull's four rates [N.s]
    V impulse_size{};                 ///< sum of h |f| [N.s]
    Vector<V> hull_force;             ///< on the rod as the hull's last rate took it [N]
};

/// R:48: load on a hull as its last rate took it [N, N.m], impulse still owed [N.s, N.m.s].
template <class V>
struct HandedState {
    Vector<V> hull_force, hull_moment, owed_force, owed_moment;
};

/// What belongs to the rod as a whole.
template <class V>
struct RodHead {
    V t{}, h{};                    ///< time of the state, step that led to it [s]
    Vector<V> force_a, force_b;    ///< force of the supports on the rod at its ends [N]
    Vector<V> moment_a, moment_b;  ///< moment of the joints at the ends on the rod [N.m]
    Vector<V> axis_a, axis_b;      ///< slope-constraint axes, from B to A, on their own frame
    Vector<V> pose_position, pose_angles;  ///< of the (first) platform at the last static solution
    std::array<HandedState<V>, 2> handed;  ///< to the one or two platforms of the rod
    V wave_index{};                        ///< last grid time j of R:19 sampled; none: -1
};

template <class V>
class RodState {
 public:
    RodState() = default;
    /// @param grips  room for the friction springs of the seabed
    RodState(int elements, int constraints, int water_slabs, bool grips = false)
        : elements_(static_cast<std::size_t>(elements)),
          constraints_(static_cast<std::size_t>(constraints)),
          slabs_(static_cast<std::size_t>(water_slabs)),
          grips_(grips ? points() : 0),
          block_(water_start() + slabs_ * points() * (sizeof(Water<V>) / sizeof(V))) {
        head().wave_index = V(-1.0);
    }

    RodHead<V>& head() { return *at<RodHead<V>>(0); }
    const RodHead<V>& head() const { return *at<const RodHead<V>>(0); }
    NodeState<V>* nodes() { return at<NodeState<V>>(node_start()); }
    const NodeState<V>* nodes() const { return at<const NodeState<V>>(node_start()); }
    /// lambda: entry 2n is node n, entry 2e + 1 the middle of element e.
    Multiplier<V>* lambda() { return at<Multiplier<V>>(lambda_start()); }
    const Multiplier<V>* lambda() const { return at<const Multiplier<V>>(lambda_start()); }
    Strain<V>* strain() { return at<Strain<V>>(strain_start()); }
    const Strain<V>* strain() const { return at<const Strain<V>>(strain_start()); }
    ConstraintState<V>* constraints() { return at<ConstraintState<V>>(constraint_start()); }
    const ConstraintState<V>* constraints() const {
        return at<const ConstraintState<V>>(constraint_start());
    }
    /// Friction springs of all Gauss points; null without friction.
    Grip<V>* grips() { return grips_ == 0 ? nullptr : at<Grip<V>>(grip_start()); }
    const Grip<V>* grips() const { return grips_ == 0 ? nullptr : at<const Grip<V>>(grip_start()); }
    Water<V>* water(std::size_t slab) { return at<Water<V>>(water_start()) + slab * points(); }
    const Water<V>* water(std::size_t slab) const {
        return at<const Water<V>>(water_start()) + slab * points();
    }

    [[nodiscard]] std::size_t elements() const { return elements_; }
    [[nodiscard]] std::size_t points() const { return elements_ * gauss_points; }
    [[nodiscard]] std::size_t slabs() const { return slabs_; }
    [[nodiscard]] const std::vector<V>& block() const { return block_; }
    V* values() { return block_.data(); }

 private:
    static constexpr std::size_t count(std::size_t bytes) { return bytes / sizeof(V); }
    std::size_t node_start() const { return count(sizeof(RodHead<V>)); }
    std::size_t lambda_start() const {
        return node_start() + (elements_ + 1) * count(sizeof(NodeState<V>));
    }
    std::size_t strain_start() const {
        return lambda_start() + (2 * elements_ + 1) * count(sizeof(Multiplier<V>));
    }
    std::size_t constraint_start() const {
        return strain_start() + points() * count(sizeof(Strain<V>));
    }
    std::size_t grip_start() const {
        return constraint_start() + constraints_ * count(sizeof(ConstraintState<V>));
    }
    std::size_t water_start() const { return grip_start() + grips_ * count(sizeof(Grip<V>)); }
    template <class T>
    T* at(std::size_t i) {
        return reinterpret_cast<T*>(block_.data() + i);
    }
    template <class T>
    T* at(std::size_t i) const {
        return reinterpret_cast<T*>(block_.data() + i);
    }

    std::size_t elements_ = 0, constraints_ = 0, slabs_ = 0, grips_ = 0;
    std::vector<V> block_;
};

}  // namespace hawser::worker
