// Hydrostatics of a hull from flat panels on its wetted surface, to hold other numbers against.
// Sources: Gauss's theorem; Newman, Marine Hydrodynamics (1977) 6.16.
#pragma once

#include <array>
#include <vector>

#include "vector.hpp"

namespace hawser {

/// Four corners, anticlockwise seen from the water; of a triangle one stands twice [m].
using Panel = std::array<Vec3, 4>;

/// With n out of the hull, S the wetted surface and z from its highest corner, which is the
/// waterline of a hull that pierces the surface,
///
///     V = int x n_x dS = int y n_y dS = int z n_z dS
///     V r_B = 1/2 int (x^2 n_x, y^2 n_y, z^2 n_z) dS
///     A, moments of the waterplane = -int (1, x, y, ...) n_z dS
struct PanelHydrostatics {
    Vec3 volumes = Vec3::Zero();             ///< V by x, y and z [m3]
    Vec3 centre_of_buoyancy = Vec3::Zero();  ///< z from the waterline [m]
    Mat3 waterplane = Mat3::Zero();  ///< C'/(rho g) of K:7: (heave, roll, pitch) [m2, m3, m4]
    double waterline = 0.0;          ///< height of the highest corner on the panels' axes [m]
    double draft = 0.0;              ///< from there to the lowest [m]
    int lids = 0;  ///< panels in z = 0, there against irregular frequencies, no part of the hull

    [[nodiscard]] double volume() const { return volumes.mean(); }
    [[nodiscard]] double area() const { return waterplane(0, 0); }
    /// Largest distance of one of the three volumes from their mean, of the mean.
    [[nodiscard]] double gap() const;
};

/// @param yz, xz  planes of symmetry: the panels are a half or a quarter of the hull
PanelHydrostatics panel_hydrostatics(const std::vector<Panel>& panels, bool yz, bool xz);

}  // namespace hawser
