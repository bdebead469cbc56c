// Hydrodynamic coefficients of one rigid hull as the program keeps them, whatever file they came
// from: SI, rad/s, time factor e^{+i w t}, everything about the platform's reference point O.
// First order, mean drift and quadratic transfer functions of one body.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "vector.hpp"

namespace hawser {

using Complex = std::complex<double>;
using CVec6 = Eigen::Matrix<Complex, 6, 1>;
using CMat6 = Eigen::Matrix<Complex, 6, 6>;

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

/// One pair of headings of a quadratic transfer function.
struct QtfPair {
    double heading_1 = 0.0, heading_2 = 0.0;  ///< of the waves of row m and column n [rad]
    std::vector<CVec6> values;                ///< Q(w_m, w_n) at m N + n [N/m2, N.m/m2]
    std::vector<char> given;                  ///< 1 where there is a value; it is zero elsewhere
};

/// Second-order force per product of two amplitudes, all ordered pairs of frequencies:
///
///     difference: F(t) = Re sum_m sum_n A_m A_n* Q(w_m, w_n) e^{i (w_m - w_n) t}
///     sum:        F(t) = Re sum_m sum_n A_m A_n  Q(w_m, w_n) e^{i (w_m + w_n) t}
///
/// Q(w_n, w_m, b_n, b_m) is the conjugate of Q(w_m, w_n, b_m, b_n) for differences, equal for sums.
struct Qtf {
    std::vector<double> frequencies;  ///< N of them, ascending [rad/s]
    std::vector<QtfPair> pairs;       ///< ascending in heading_1, then heading_2

    [[nodiscard]] bool empty() const { return pairs.empty(); }
};

/// How mean drift was worked out: momentum in the far field (.8; surge, sway and yaw alone),
/// pressure on the hull (.9), or a control surface (.7).
enum class DriftMethod { momentum, pressure, control_surface };

struct MeanDrift {
    DriftMethod method = DriftMethod::momentum;
    WaveTable<Vec6> table;
};

/// What the reader doubts, and the line of a file that shows it; 0: the file as a whole.
struct HydroDoubt {
    std::string file;
    int line = 0;
    std::string sentence;
};

struct HydroData {
    std::string source;    ///< "WAMIT", "Capytaine" ... with the file or stem
    double gravity = 0.0;  ///< that made the files dimensional [m/s2]
    double depth = 0.0;    ///< of the water [m]; 0: not known, infinity: deep

    double density = 0.0;                    ///< that made the files dimensional [kg/m3]
    double displaced_volume = 0.0;           ///< V [m3]; 0: not known
    Vec3 centre_of_buoyancy = Vec3::Zero();  ///< r_B on platform axes [m]

    std::vector<double> frequencies;     ///< of added mass and damping, ascending [rad/s]
    std::vector<Mat6> added_mass;        ///< A(w), per frequency
    std::vector<Mat6> damping;           ///< B(w), per frequency
    std::optional<Mat6> added_mass_0;    ///< A(0)
    std::optional<Mat6> added_mass_inf;  ///< A(inf); for convolution alone

    /// C' of K:7 for (heave, roll, pitch): waterplane terms only, weight and buoyancy taken out
    /// [N/m, N, N.m]
    Mat3 waterplane_stiffness = Mat3::Zero();

    /// C of buoyancy and waterplane about O, weight taken out; none without a hydrostatic file
    std::optional<Mat6> buoyancy_stiffness;
    Mat6 weight_stiffness = Mat6::Zero();  ///< what the files held of -m g z_G

    WaveTable<CVec6> excitation;  ///< X(w, b) per metre amplitude, crest at O [N/m, N.m/m]
    WaveTable<CVec6> haskind;     ///< the same by Haskind's relation (.2 beside a .3)
    WaveTable<CVec6> froude_krylov, scattering;  ///< its parts, where the files give them
    WaveTable<CVec6> motion;     ///< free motion of O per metre amplitude [m/m, rad/m]
    WaveTable<Vec6> mean_drift;  ///< D(w, b) per amplitude squared [N/m2, N.m/m2]
    DriftMethod drift_method = DriftMethod::momentum;
    bool drift_is_horizontal = false;    ///< from a .8: heave, roll and pitch drift are zero
    bool drift_is_of_qtf = false;        ///< no file of it: the diagonal of the difference QTF
    std::vector<MeanDrift> other_drift;  ///< the same by other methods, where the files have it
    Qtf difference, sum;

    std::vector<std::string> notes;  ///< what the reader worked out, one sentence each
    std::vector<HydroDoubt> doubts;
};

}  // namespace hawser
