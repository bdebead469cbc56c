// Vertical cylinders on one axis and the water around them, cut into columns at the cylinders'
// radii: what the matched eigenfunctions are written on. Source: Garrett 1971; Yeung 1981.
#pragma once

#include <string>
#include <vector>

namespace hawser::hydro {

/// A solid vertical cylinder on the axis.
struct Part {
    double radius = 0.0;  ///< [m], above zero
    double top = 0.0;     ///< z of its upper face, zero is the water surface [m]
    double bottom = 0.0;  ///< z of its lower face [m]
};

struct Hull {
    double depth = 0.0;  ///< of the water [m]
    std::vector<Part> parts;
};

/// Everything that is wrong with a hull, one sentence each; empty: nothing.
std::vector<std::string> problems_of(const Hull& hull);

/// Interval of height [m].
struct Span {
    double low = 0.0, high = 0.0;
    [[nodiscard]] double length() const { return high - low; }
    [[nodiscard]] bool operator==(const Span&) const = default;
};

/// A ring of water between two radii, with one floor and one ceiling.
struct Column {
    Span z;
    double inner = 0.0;          ///< radius where it begins; 0: the axis [m]
    double outer = 0.0;          ///< radius where it ends; 0: it goes to infinity [m]
    bool surface = false;        ///< the ceiling is the free surface
    bool moving_top = false;     ///< the ceiling is the hull's
    bool moving_bottom = false;  ///< the floor is the hull's, not the seabed
    std::vector<Span> walls;     ///< the hull on the inner radius
    int opening = -1;            ///< index of the opening on the outer radius; -1: none
    int first_opening = 0;       ///< those on the inner radius are numbered in a row
    int openings = 0;
};

/// Where the water of a column (on its outer radius) meets a higher one.
struct Opening {
    enum class End { both_edges, mirrored, surface };
    double radius = 0.0;
    Span z;
    /// both_edges: an edge of the hull above and below. mirrored: one edge; at `centre` a flat
    /// floor or ceiling goes on across. surface: one edge; the free surface goes on across.
    End end = End::both_edges;
    double centre = 0.0;    ///< z about which the velocity is developed [m]
    double half = 0.0;      ///< from the centre to an edge [m]
    double edge_gap = 0.0;  ///< length that the flow about the edge must resolve [m]
};

/// Columns and openings of a hull; the last column is the one that goes to infinity.
struct Partition {
    std::vector<Column> columns;
    std::vector<Opening> openings;
};
Partition partition_of(const Hull& hull);

/// Volume, centre and waterplane of the wetted hull.
struct Buoyancy {
    double volume = 0.0;             ///< V [m3]
    double centre = 0.0;             ///< z_B [m]
    double waterplane = 0.0;         ///< area [m2]
    double waterplane_moment = 0.0;  ///< second moment of area about a diameter [m4]
};
Buoyancy buoyancy_of(const Hull& hull);

}  // namespace hawser::hydro
