// Morison loads and buoyancy of the hull's members, strip by strip up to the surface of the
// instant. Morison with relative velocity; Froude-Krylov and added mass where the member displaces
// water and has inertia. No torsion, no slope of the surface, no interaction between members.
#pragma once

#include "case/environment.hpp"
#include "member_strips.hpp"
#include "water_block.hpp"

namespace hawser::master {

/// Loads about O on world axes [N, N.m].
struct MemberLoad {
    Vec6 buoyancy = Vec6::Zero();    ///< rho g of the wet displaced volume, upwards
    Vec6 current = Vec6::Zero();     ///< drag of the hull at rest in still water with the current
    Vec6 rest = Vec6::Zero();        ///< all other Morison load, without -added_mass (x_O'', w')
    Mat6 added_mass = Mat6::Zero();  ///< about O, world axes
};

class MemberLoads {
 public:
    MemberLoads(const std::vector<Member>& members, const Water& water);

    /// At time t [s]. Per strip of wet length l, with u, a the water's velocity and acceleration,
    /// v the strip's velocity, n and t the parts across and along the axis:
    ///
    ///     drag           1/2 rho D l (Cd |(u-v)_n| (u-v)_n + Cd_axial |(u-v)_t| (u-v)_t)
    ///     Froude-Krylov  rho A l a,   diffraction  rho Ca A l a_n
    ///     added mass     -rho Ca A l (x_O'' + w' x r + w x (w x r))_n
    ///     piercing       d(rho Ca A l)/dt (u - v)_n                        P:2 footnote 4
    ///     end faces      1/2 rho Cd_end pi D^2/4 |(u-v)_t| (u-v)_t
    ///                    + rho Ca_end 2/3 pi r^3 (a - x_O'' ...)_t
    ///     flooded        -rho A l (x_O'' + w' x r + w x (w x r)), and no buoyancy
    ///
    /// and along the axis with Ca_axial as across it with Ca. A l is the wet volume K:24. The
    /// footnote's velocity is taken against the water. Froude-Krylov along the axis is the pressure
    /// on end faces and taper, by Gauss' theorem.
    ///
    /// @param current_factor  0 .. 1: part of the current that acts
    /// @param R, w            attitude and angular velocity of the motion
    MemberLoad load(double t, const Sea& sea, double current_factor, const PlatformMotion& motion,
                    const Mat3& R, const Vec3& w) const;

    /// Buoyancy and current drag at rest in still water, for the equilibrium.
    MemberLoad static_load(const Sea& sea, double current_factor, const PlatformMotion& pose,
                           const Mat3& R) const;

    /// Volume below mean sea level at the design position [m3].
    [[nodiscard]] double design_volume() const;

 private:
    struct Face {
        Vec3 place = Vec3::Zero(), axis = Vec3::UnitZ();  ///< body axes
        double drag = 0.0;                                ///< 1/2 rho Cd pi D^2/4 [kg/m]
        double added_mass = 0.0;                          ///< along the axis [kg]
        std::size_t member = 0;
    };
    [[nodiscard]] Vec3 water_velocity(std::size_t i, const Member& m, const Sea& sea,
                                      double current_factor, bool current_alone) const;
    void add_current_to(MemberLoad& load, const Sea& sea, double current_factor,
                        const PlatformMotion& pose, const Mat3& R, bool with_buoyancy) const;

    std::vector<Member> members_;
    std::vector<Strip> strips_;
    std::vector<Face> faces_;
    double density_, gravity_;
    mutable WaterBlock block_;  ///< strips, then faces: workspace of one call
};

}  // namespace hawser::master
