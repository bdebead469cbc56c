// The platform as the time loop sees it: all hull loads, the equation of motion K:4 and its state.
// Composes the load components of this folder; each is a file of its own. Limits: README.md.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "applied_force.hpp"
#include "case/case.hpp"
#include "current_load.hpp"
#include "drift.hpp"
#include "environment/sea.hpp"
#include "excitation.hpp"
#include "held_motions.hpp"
#include "hydrostatics.hpp"
#include "member_loads.hpp"
#include "plate_loads.hpp"
#include "pose.hpp"
#include "prescribed_motion.hpp"
#include "radiation.hpp"
#include "radiation_memory.hpp"
#include "rigid_body.hpp"
#include "second_order.hpp"
#include "state.hpp"
#include "wave_phases.hpp"
#include "wind_load.hpp"

namespace hawser::master {

/// Components of the load on the platform, in the order of the results.
enum class Load : int {
    wave1,        ///< first-order excitation of the database
    drift,        ///< mean and slow drift
    wave2,        ///< sum-frequency force of full QTFs
    radiation,    ///< -A_w (x_O'', w') - B_w (x_O', w) of the database, or with memory K:9, K:10
    hydrostatic,  ///< buoyancy of database and members, waterplane terms
    weight,
    members,  ///< Morison load of members beside `current`, with the inertia of their added mass
    plates,   ///< heave plates beside `current`, with the inertia of their added mass
    current,  ///< drag of members and plates at rest in the current alone; current_coefficients
    wind,
    damping,    ///< the user's
    stiffness,  ///< the user's
    forces,     ///< the user's
    holding,    ///< what holds or leads motions that do not follow from the loads
    lines,
};
constexpr int load_count = 15;
constexpr std::array<std::string_view, load_count> load_names = {
    "wave1",   "drift", "wave2",   "radiation", "hydrostatic", "weight",  "members", "plates",
    "current", "wind",  "damping", "stiffness", "forces",      "holding", "lines"};

/// Loads about O on world axes [N, N.m] by component, and the added mass that is wet at the moment.
struct HullLoads {
    std::array<Vec6, load_count> by;
    Mat6 member_added_mass = Mat6::Zero(), plate_added_mass = Mat6::Zero();

    HullLoads() { by.fill(Vec6::Zero()); }
    Vec6& operator[](Load l) { return by[static_cast<std::size_t>(l)]; }
    const Vec6& operator[](Load l) const { return by[static_cast<std::size_t>(l)]; }
    [[nodiscard]] Vec6 total() const {
        Vec6 sum = Vec6::Zero();
        for (const Vec6& load : by) sum += load;
        return sum;
    }
};

/// Not for use by several threads at once: the loads share workspaces.
class Hull {
 public:
    /// @param data   coefficients of the platform's database; null for a platform without one
    /// @param which  of several platforms in the case
    /// Throws RunError (input) where the case asks for what the data do not hold.
    Hull(const Case& c, const HydroData* data, int which = 0);

    /// Mass [kg]; with radii of gyration in the case the inertia follows it. Until it is called,
    /// a platform of mass `auto` weighs what floats at the design draft.
    void set_mass(double mass);
    [[nodiscard]] bool mass_is_auto() const { return mass_is_auto_; }
    [[nodiscard]] double mass() const { return body_.mass; }
    /// Buoyancy at the design draft in still water: rho g (V + displaced volume of members) [N].
    [[nodiscard]] double acting_buoyancy() const;

    /// Every load but lines and radiation, at time t [s].
    [[nodiscard]] HullLoads loads(double t, const State& state) const;

    /// ds/dt: the equation of motion K:4 for (x_O'', w'), K:3 for q'', K:8 for the filter. Puts
    /// `lines` [N, N.m] and the radiation into `loads`, and the inertia of the added mass of
    /// members and plates into theirs, so that loads.total() is the rate of momentum of the rigid
    /// mass.
    ///
    /// @param loads         as given by loads() for the same t and state
    /// @param acceleration  if not null: second derivatives of the six motions [m/s2, rad/s2]
    /// Throws RunError (diverged) above 80 deg of pitch or where a number is not finite.
    State rate(double t, const State& state, HullLoads& loads, const Vec6& lines,
               Vec6* acceleration = nullptr) const;

    /// Motions that do not follow from the loads, K:20.
    [[nodiscard]] const Held& held() const { return held_; }
    /// Where they are at time t [s], on world axes; at rest unless the motion is prescribed.
    [[nodiscard]] LedMotion held_at(double t) const;
    /// The state with these motions in their place.
    [[nodiscard]] State led(double t, State s) const;

    /// Mean loads on the platform at rest, lines apart: weight, buoyancy and those of `which`.
    [[nodiscard]] Vec6 static_load(const PlatformMotion& pose, const Statics& which) const;
    /// -d(static_load)/d(position, rotation vector) [N/m ...], by central differences.
    [[nodiscard]] Mat6 static_stiffness(const PlatformMotion& pose, const Statics& which) const;

    /// Mass with all added mass that is wet at rest, about O on world axes [kg, kg.m, kg.m2]; of a
    /// database with memory the added mass at `frequency` [rad/s], or at its nearest.
    [[nodiscard]] Mat6 static_mass(const PlatformMotion& pose, double frequency = 0.0) const;

    /// The step to this state has been taken; acceleration: second derivatives of the six motions.
    /// The discrete memory K:9 keeps it.
    void remember(double t, const State& state, const Vec6& acceleration);

    /// State of the start: motion as given, the filter K:8 at rest at the equilibrium.
    [[nodiscard]] State start(const PlatformMotion& equilibrium,
                              const PlatformMotion& with_initial) const;

    /// Momentum of the rigid mass and its angular momentum about O [kg.m/s, kg.m2/s].
    [[nodiscard]] Vec6 momentum(const State& state) const;
    /// d(momentum)/dt = loads.total() - momentum_transport(): O moves (rigid_body.hpp).
    [[nodiscard]] Vec6 momentum_transport(const State& state) const;

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Where it is built to be, on world axes: motions that are held or led, and the user's
    /// stiffness, count from there.
    [[nodiscard]] PlatformMotion design() const { return {.position = design_}; }
    [[nodiscard]] const Sea& sea() const { return sea_; }
    [[nodiscard]] const Radiation& radiation() const { return radiation_; }
    /// The fitted memory; without oscillators where there is none.
    [[nodiscard]] const MemoryFit& memory() const { return fitted_.fit(); }
    [[nodiscard]] const RigidBody& body() const { return body_; }
    [[nodiscard]] double slow_cutoff() const { return cutoff_; }

 private:
    Hull(const Case& c, const Platform& p, const HydroData* data);

    [[nodiscard]] PlatformMotion from_design(PlatformMotion pose) const {
        pose.position -= design_;
        return pose;
    }
    [[nodiscard]] double mean_factor(bool in_statics, double r) const {
        return in_statics ? 1.0 : r;  // a mean load that the statics left out is ramped
    }

    std::string name_;
    Vec3 design_;
    Statics statics_;
    double ramp_;
    Sea sea_;
    RigidBody body_;
    std::optional<Vec3> radii_;
    bool mass_is_auto_ = false;
    Buoyancy buoyancy_;
    Radiation radiation_;
    HydroData radiation_data_;      ///< with memory: added mass over frequency ...
    Mat6 infinite_ = Mat6::Zero();  ///< ... and at the infinite one
    FittedMemory fitted_;
    std::optional<DiscreteMemory> discrete_;
    Drift drift_ = Drift::none;
    WavePhase wave_phase_ = WavePhase::slow;
    double cutoff_ = 0.0;
    ComponentTable<CVec6> excitation_;
    ComponentTable<Vec6> mean_drift_;
    QuadraticLoad differences_, sums_;
    MemberLoads members_;
    PlateLoads plates_;
    WindLoad wind_;
    Mat6 linear_damping_, quadratic_damping_, stiffness_;
    bool stiffness_acts_, stiffness_turns_;
    CurrentLoad current_load_;
    AppliedForces forces_;
    Held held_;
    PlatformMotion place_;  ///< of held motions
    std::optional<PrescribedPath> path_;
    WavePhases wave_phases_;
    mutable std::vector<Complex> phases_, slow_phases_;  ///< workspaces of one call
};

}  // namespace hawser::master
