// The force inside a rod from the balance of what acts on it, R:47, for results: weight, water,
// bed, inertia, point masses and constraints, from end A down, in every line model that solves for
// them.
#pragma once

#include <array>
#include <vector>

#include "rod/element.hpp"

namespace hawser::worker {

/// A constraint nearer to a node than this part of the element is at the node.
inline constexpr double at_node = 1e-9;

/// R:47. Forces of what is above a section on what is below it [N], on world axes; nodes and
/// elements are counted from end B.
template <class V>
struct SectionForces {
    explicit SectionForces(int elements)
        : below(static_cast<std::size_t>(elements) + 1),
          above(below.size()),
          load(static_cast<std::size_t>(elements) * gauss_points),
          water(load.size()) {}

    /// Just below and just above each node: they differ by a point mass or a constraint there.
    std::vector<Vector<V>> below, above;
    /// Inertia less loads on the piece of every Gauss point [N].
    std::vector<Vector<V>> load;
    /// A constraint inside an element, its place there from end B and its force on the rod.
    struct Jump {
        V element, xi;
        Vector<V> force;
    };
    std::vector<Jump> jumps;
    /// By how much the balance misses the reaction at end B, before it is spread along the rod [N]
    Vector<V> gap;

    std::vector<Water<V>> water;  ///< workspace
};

/// Shares of the Gauss points' loads that lie between a place xi of an element and its end towards
/// A: the integrals of the cubic through them, so that all of them count at xi = 0.
std::array<double, gauss_points> shares_above(double xi);

}  // namespace hawser::worker
