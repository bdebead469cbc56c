// What a wave does to a hull of cylinders: exciting force, motions of the free hull, scattered
// waves and the mean drift they carry away. First order and, in the drift, the mean of second
// order.
#pragma once

#include <optional>
#include <vector>

#include "hydro/cylinder_flow.hpp"

namespace hawser::hydro {

/// Mass of a hull that floats freely, and what damps its heave beside the waves.
struct FreeHull {
    double mass = 0.0;              ///< [kg]
    double cog = 0.0;               ///< z of the centre of gravity [m]
    double gyration = 0.0;          ///< radius of roll and pitch about the centre of gravity [m]
    double heave_added_mass = 0.0;  ///< of heave plates and the like [kg]
    double heave_damping = 0.0;     ///< linear [N.s/m]
};

struct Water {
    double density = 0.0, gravity = 0.0;
};

/// One frequency; a wave that travels towards +x with amplitude 1 m and its crest on the axis.
struct WaveResponse {
    double surge_added_mass = 0.0, heave_added_mass = 0.0, surge_pitch_added_mass = 0.0,
           pitch_added_mass = 0.0;
    double surge_damping = 0.0, heave_damping = 0.0, surge_pitch_damping = 0.0, pitch_damping = 0.0;
    Complex surge_force = 0.0, heave_force = 0.0, pitch_moment = 0.0;  ///< exciting, e^{+i w t}
    Complex surge = 0.0, heave = 0.0, pitch = 0.0;                     ///< of the free hull
    double drift = 0.0;  ///< mean force along the wave [N/m2]
    /// Largest relative difference of the exciting forces from Haskind's relation and of the
    /// damping from the radiated power: rounding, unless something is wrong.
    double haskind_gap = 0.0, energy_gap = 0.0;
};

/// H:9 to H:12.
/// @param w     frequency [rad/s], above zero
/// @param free  null: the hull is fixed
WaveResponse wave_response(CylinderFlow& flow, const Hull& hull, double w, const Water& water,
                           const FreeHull* free);

/// Linear damping that is `fraction` of critical at the heave period of the free hull alone:
///
///     c = 2 fraction sqrt(C33 (m + a + A33(w_n))),   w_n^2 = C33 / (m + a + A33(w_n))
///
/// @return [N.s/m]; 0 for a hull without waterplane
double heave_damping_of(double fraction, CylinderFlow& flow, const Hull& hull, const Water& water,
                        const FreeHull& free);

}  // namespace hawser::hydro
