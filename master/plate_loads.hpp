// Heave plates: drag and added mass along the normal of a thin plate, at its middle. Morison with
// relative velocity. No displacement, no load in the plate's plane; one point speaks for the plate.
#pragma once

#include "case/environment.hpp"
#include "case/platform.hpp"
#include "water_block.hpp"

namespace hawser::master {

/// Loads about O on world axes [N, N.m].
struct PlateLoad {
    Vec6 current = Vec6::Zero();     ///< drag of the hull at rest in still water with the current
    Vec6 rest = Vec6::Zero();        ///< all other load, without -added_mass (x_O'', w')
    Mat6 added_mass = Mat6::Zero();  ///< about O, world axes
};

class PlateLoads {
 public:
    PlateLoads(const std::vector<Plate>& plates, const Water& water);

    /// At time t [s], below the surface of the instant. With the parts along the normal n:
    ///
    ///     F = [ 1/2 rho Cd A |u_n - v_n| (u_n - v_n) + M (a_n - (x_O'' + w' x r + w x (w x r))_n)
    ///     ] n
    PlateLoad load(double t, const Sea& sea, double current_factor, const PlatformMotion& motion,
                   const Mat3& R, const Vec3& w) const;

    /// Drag in the current alone, at rest in still water.
    [[nodiscard]] Vec6 current_load(const Sea& sea, double current_factor,
                                    const PlatformMotion& pose, const Mat3& R) const;

 private:
    std::vector<Plate> plates_;
    double density_;
    mutable WaterBlock block_;  ///< workspace of one call
};

}  // namespace hawser::master
