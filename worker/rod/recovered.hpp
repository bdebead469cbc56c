// What a rod's working state says about the rod itself, R:37 and R:38: tension, curvature, moment,
// stress, seabed force at its nodes and at places along it; where it meets the bed. Nothing of it
// feeds back. Static pressures: the water's below z = 0, the contents' below end A.
#pragma once

#include <array>
#include <vector>

#include "line_quantities.hpp"
#include "rod/rod_pack.hpp"
#include "rod/section_forces.hpp"
#include "rod/stress.hpp"

namespace hawser::worker {

/// Every quantity of LineQuantity at one point, in its result unit; NaN where it has no meaning.
template <class V>
using Recovered = std::array<V, n_line_quantities>;

/// A place along one rod of a pack, looked up once.
struct RodPlace {
    int lane = 0;
    int element = 0;  ///< from end B
    double xi = 0.0;  ///< in the element, from end B
    int end = 0;      ///< 1: end A, -1: end B, 0: between; end tensions are those of the reaction
    std::array<double, gauss_points> above{};  ///< shares of the element's loads above it, R:47
    StressSection<Single> section;
};

/// The bed along one rod.
struct Grounding {
    double touchdown;       ///< arc length from end A at which it first touches [m]; NaN: nowhere
    Vec3 position;          ///< there, world axes [m]
    double grounded = 0.0;  ///< length in contact [m]
};

template <class V>
class Recovery {
 public:
    Recovery(const Case& input, const RodPack<V>& rod);

    /// All quantities at all nodes in the rod's working state. Angles only if `angles`: they are
    /// the costly ones.
    ///
    ///     T_eff = F.r'/|r'| with F of R:47,  kappa = |r' x r''|/|r'|^3,  M = B kappa,
    ///     shear = |(B r'')'| across r'
    ///
    /// Catenaries have T_eff = lambda |r'|, exact at their nodes. r'' runs straight between the
    /// points xi = 1/2 -+ 1/(2 sqrt 3) of the elements, where it is most exact; at the ends it is
    /// continued from the last two, and the shear with the loads on the half element there. At held
    /// ends the tension is that of the reaction. At a point mass or a constraint the tension jumps:
    /// a node's is that of the side towards end B. Where it jumps or two sections meet, the stress
    /// is that of the side which has the larger one.
    void recover(const RodPack<V>& rod, bool angles = true);
    /// Of node n from end A, as of the last `recover`.
    [[nodiscard]] const Recovered<V>& node(int n) const {
        return nodes_[nodes_.size() - 1 - static_cast<std::size_t>(n)];
    }
    [[nodiscard]] int nodes() const { return static_cast<int>(nodes_.size()); }
    /// Least and greatest effective tension at node n from end A: they differ where it jumps [N].
    [[nodiscard]] const std::array<V, 2>& tensions(int n) const {
        return tensions_[tensions_.size() - 1 - static_cast<std::size_t>(n)];
    }

    /// @param arc_length  from end A [m]
    [[nodiscard]] RodPlace place(const Case& input, const RodPack<V>& rod, int lane,
                                 double arc_length) const;
    /// The same between nodes, in the state of the last `recover`. Of two sides the one towards
    /// end B.
    [[nodiscard]] Recovered<Single> at(const RodPack<V>& rod, const RodPlace& place) const;

    /// Where the rod first comes nearer to the bed than its radius, on its own cubic between nodes:
    /// it moves steadily with the rod. Contact over less than two diameters, at an end that is held
    /// at the height of the bed, is none.
    [[nodiscard]] Grounding grounding(const RodPack<V>& rod, int lane) const;

 private:
    struct Around;  ///< surroundings of a point, recovered.cpp
    /// R:37, R:50: effective tension for the force F where the slope is d, and the direction of the
    /// line there, which beside a point load on an element without bending stiffness is that of F.
    struct Pulled {
        V tension;
        Vector<V> towards;
    };
    [[nodiscard]] Pulled pulled(const RodPack<V>& rod, std::size_t element, const Vector<V>& F,
                                const Vector<V>& d) const;
    [[nodiscard]] Vector<Single> force_at(const RodPack<V>& rod, const RodPlace& place) const;
    [[nodiscard]] Vector<V> second_derivative(const RodPack<V>& rod, std::size_t element,
                                              double xi) const;

    double gravity_, water_density_;
    V internal_pressure_{};
    std::array<double, gauss_points> upper_half_ = shares_above(0.5);
    std::vector<char> beside_load_;  ///< is the element next to a point mass, or next but one?
    /// Of each node, towards end B and towards end A; equal but at joints of sections.
    std::vector<StressSection<V>> below_, above_;
    std::vector<char> joint_;         ///< does any lane's section change at this node?
    std::vector<V> contents_weight_;  ///< of each element [N/m3]
    bool has_contents_ = false;
    std::vector<Vector<V>> bend_;  ///< r'' at the two points of each element [1/m]
    std::vector<Recovered<V>> nodes_;
    std::vector<std::array<V, 2>> tensions_;
    SectionForces<V> forces_;
    bool has_forces_;  ///< catenaries have closed forms instead
};

}  // namespace hawser::worker
