// The case: how it is computed (case key `analysis`).
#pragma once

#include <optional>

namespace hawser {

enum class RodSchemeType { generalised_alpha, adams_moulton };

struct RodScheme {
    RodSchemeType type = RodSchemeType::generalised_alpha;
    double spectral_radius = 0.8;

    bool operator==(const RodScheme&) const = default;
};

/// dynamic: rods in motion. quasi_static: the same rods, speed and acceleration zero. catenary:
/// elastic catenary between the ends.
enum class LineModel { dynamic, quasi_static, catenary };

/// What a pass returns of a line's load: its last value, a fit over the pass (P:5), or the last
/// value and what the platform is owed of the load's impulse (R:48).
enum class ForceFit { instantaneous, linear_fit, quadratic_fit, impulse_matched };

struct Statics {
    bool current = true, wind_mean = true,
         drift_mean = true;  ///< mean loads in the static solution
    double tolerance = 1e-6;
    int max_iterations = 200;

    bool operator==(const Statics&) const = default;
};

struct Dynamics {
    double duration = 0.0;         ///< ramp included [s]
    double ramp = 100.0;           ///< [s]
    double statistics_from = 0.0;  ///< [s] (resolved default: max(ramp, min(600, duration/2)))
    double platform_step = 0.5;    ///< D [s]
    double line_step = 0.02;       ///< upper bound of the rod step [s]
    double wave_step = 0.25;       ///< renewal of wave kinematics on lines [s]
    double depth_filter = 1.0;     ///< wavelengths down to which a component is seen; 0: no filter
    RodScheme rod_scheme;
    ForceFit force = ForceFit::impulse_matched;
    LineModel line_model = LineModel::dynamic;

    bool operator==(const Dynamics&) const = default;
};

struct Analysis {
    Statics statics;
    Dynamics dynamics;
    int modes = 20;  ///< natural periods asked for

    bool operator==(const Analysis&) const = default;
};

}  // namespace hawser
