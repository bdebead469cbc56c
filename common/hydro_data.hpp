// Hydrodynamic coefficients of one rigid hull as the program keeps them, whatever file they came
// from: SI, rad/s, time factor e^{+i w t}, everything about the platform's reference point O.
// First-order and mean-drift data of one body; no quadratic transfer functions.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "vector.hpp"

namespace hawser {

using Complex = std::complex<double>;
using CVec6 = Eigen::Matrix<Complex, 6, 1>;

/// One heading of travel and what belongs to it at every frequency.
template <class Value>
struct HeadingData {
    double heading = 0.0;       ///< direction the wave travels towards, platform axes [rad]
    std::vector<Value> values;  ///< one per frequency
};

/// Values over frequency and heading. Headings ascend; `full_circle` says that the last is followed
/// by the first again, so that any heading can be interpolated. Nothing is ever extrapolated.
template <class Value>
struct WaveTable {
    std::vector<double> frequencies;           ///< ascending [rad/s]
    std::vector<HeadingData<Value>> headings;  ///< ascending in [-pi, 2 pi)
    bool full_circle = false;

    [[nodiscard]] bool empty() const { return headings.empty(); }
};

struct HydroData {
    double density = 0.0;                    ///< that made the files dimensional [kg/m3]
    double displaced_volume = 0.0;           ///< V [m3]
    Vec3 centre_of_buoyancy = Vec3::Zero();  ///< r_B on platform axes [m]

    std::vector<double> frequencies;     ///< of added mass and damping, ascending [rad/s]
    std::vector<Mat6> added_mass;        ///< A(w), per frequency
    std::vector<Mat6> damping;           ///< B(w), per frequency
    std::optional<Mat6> added_mass_0;    ///< A(0)
    std::optional<Mat6> added_mass_inf;  ///< A(inf); for convolution alone

    /// C' of K:7 for (heave, roll, pitch): waterplane terms only, weight and buoyancy taken out
    /// [N/m, N, N.m]
    Mat3 waterplane_stiffness = Mat3::Zero();

    WaveTable<CVec6> excitation;       ///< X(w, b) per metre amplitude, crest at O [N/m, N.m/m]
    WaveTable<Vec6> mean_drift;        ///< D(w, b) per amplitude squared [N/m2, N.m/m2]
    bool drift_is_horizontal = false;  ///< from a .8: heave, roll and pitch drift are zero

    std::vector<std::string> notes;  ///< what the reader worked out or doubts, one sentence each
};

}  // namespace hawser
