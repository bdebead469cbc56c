// The case: the platform (case key `platform`). SI and radians; positions on platform axes
// (x forward, y to port, z up, origin at the reference point O on the design waterline).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frames.hpp"

namespace hawser {

enum class HydroFormat { wamit, hams, capytaine, nemoh, bemio };
/// What the first column of WAMIT's files holds: T, w, K L with K = w^2/g, or k L.
enum class PeriodColumn { period, frequency, deep_wavenumber, wavenumber, automatic };
/// Which rows of a .1 are the limits: PER < 0 zero and PER = 0 infinite frequency (WAMIT), or the
/// other way round (HAMS).
enum class HydroLimits { wamit, reversed };

/// Hydrodynamic coefficients from a diffraction program (case-key `hydrodynamics.database`).
struct HydroDatabase {
    HydroFormat format = HydroFormat::wamit;
    std::string path;         ///< stem of the files (wamit, hams), file, or folder (nemoh)
    std::optional<int> body;  ///< which of several bodies, from 1
    double ulen = 1.0;        ///< WAMIT's length unit [m]
    // Empty: the files tell it (capytaine, nemoh, bemio).
    std::optional<double> rho;               ///< density that makes the files dimensional [kg/m3]
    std::optional<double> displaced_volume;  ///< [m3]
    std::optional<Vec3> centre_of_buoyancy;  ///< on platform axes [m]
    bool includes_weight = false;            ///< does the .hst contain -m g z_G?
    double included_mass = 0.0;              ///< [kg], with includes_weight
    double included_z = 0.0;                 ///< [m], with includes_weight
    Vec3 reference_point = Vec3::Zero();     ///< the files' moment origin on platform axes [m]
    bool estimate_infinite = false;          ///< A(inf) by Ogilvie's relation if the files lack it
    std::vector<double> phase_origin;        ///< where O stood in the files' global axes, x y [m]
    std::optional<PeriodColumn> period_column;  ///< empty: period
    std::optional<HydroLimits> limits;          ///< empty: as the format has them
    std::vector<std::string> symmetry;  ///< planes of the hull: xz, yz; headings are mirrored

    bool operator==(const HydroDatabase&) const = default;
};

/// Constant 6x6 matrices about O for a platform with no database. SI, radians.
struct HydroMatrix {
    Mat6 added_mass = Mat6::Zero();
    Mat6 damping = Mat6::Zero();
    Mat6 stiffness = Mat6::Zero();  ///< waterplane stiffness; only rows heave, roll, pitch act

    bool operator==(const HydroMatrix&) const = default;
};

/// Radiation with memory instead of constant matrices (case key `added_mass.convolution`).
struct RadiationMemoryKeys {
    enum class Form { fitted, discrete } form = Form::fitted;
    double duration = 60.0;    ///< after which the hull has forgotten a motion, discrete form [s]
    std::optional<int> order;  ///< oscillators of the fit; empty: as many as it takes

    bool operator==(const RadiationMemoryKeys&) const = default;
};

enum class Drift { none, mean, newman, full_qtf };
enum class WavePhase { slow, instantaneous };

struct Hydrodynamics {
    std::optional<HydroDatabase> database;
    std::optional<HydroMatrix> matrix;
    std::optional<double> added_mass_frequency;  ///< [rad/s]; empty (auto): the spectral peak
    std::optional<RadiationMemoryKeys> memory;   ///< empty: constant added mass and damping
    Drift drift = Drift::none;
    std::optional<WavePhase> wave_phase;  ///< empty: slow
    std::optional<double> slow_cutoff;    ///< [rad/s]; empty: a quarter of the spectral peak

    bool operator==(const Hydrodynamics&) const = default;
};

/// A cylinder of the hull between two points (Morison).
struct Member {
    std::string name;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< [m]
    double diameter = 0.0;                        ///< drag width, at `from` [m]
    std::optional<double> diameter_to = {};       ///< at `to`, tapered between; empty: the same
    double Cd = 0.0, axial_Cd = 0.0;              ///< both on diameter x wetted length
    double end_Cd_from = 0.0, end_Cd_to = 0.0;    ///< on pi D^2/4
    bool inertia = true;                          ///< Froude-Krylov, added mass and buoyancy act
    double displaced_area = 0.0;  ///< section that displaces water [m2] (resolved default)
    std::optional<double> displaced_area_to = {};  ///< at `to`; empty: the same
    double Ca = 1.0;                               ///< added mass coefficient on displaced_area
    double axial_Ca = 0.0;                      ///< of its skin along the axis, on displaced_area
    double end_Ca_from = 0.0, end_Ca_to = 0.0;  ///< of the end faces on 2/3 pi r^3, along the axis
    bool flooded = false;  ///< free-flooding: the water inside moves with it and carries nothing
    bool waves_in_drag = true;
    bool current = true;

    bool operator==(const Member&) const = default;
};

/// A heave plate: drag and added mass along its normal.
struct Plate {
    std::string name;
    Vec3 position = Vec3::Zero();  ///< [m]
    Vec3 normal = Vec3::UnitZ();   ///< unit vector
    double area = 0.0, Cd = 0.0;   ///< [m2], [-]
    double added_mass = 0.0;       ///< along the normal [kg]

    bool operator==(const Plate&) const = default;
};

/// Rows of heading [rad], Cx, Cy, Cyaw. The heading is that towards which the flow goes, against
/// the platform's own: 0 on the stern, 90 deg towards port, 180 deg on the bow (OCIMF's).
using HeadingTable = std::vector<std::array<double, 4>>;

struct WindArea {
    double area = 0.0, centre_height = 0.0, Cs = 1.0;  ///< [m2], above O [m], [-]
    std::optional<double> side_area = {};              ///< of Cy and Cyaw [m2]; empty: as area
    double length = 0.0;                               ///< of Cyaw [m]
    HeadingTable coefficients = {};                    ///< instead of Cs

    bool operator==(const WindArea&) const = default;
};

/// Load of a current on the whole hull by coefficients on draft x length (OCIMF's form).
struct CurrentCoefficients {
    double draft = 0.0, length = 0.0;  ///< [m]
    std::optional<double> depth = {};  ///< at which it acts, of that current [m]; empty: draft/2
    HeadingTable coefficients = {};

    bool operator==(const CurrentCoefficients&) const = default;
};

/// Rows of a file: time [s] and six columns, surge ... yaw.
using SixSeries = std::vector<std::array<double, 7>>;

/// A force and a moment given by the user, constant or in time.
struct AppliedForce {
    std::string name;
    std::optional<Vec3> force = {}, moment = {};     ///< [N], [N.m]
    Vec3 position = Vec3::Zero();                    ///< where it acts, platform axes [m]
    bool on_platform_axes = false;                   ///< else on the world's
    std::vector<std::array<double, 2>> factor = {};  ///< time [s], factor; straight between
    std::optional<double> period = {};               ///< times cos(2 pi t/period + phase)
    double phase = 0.0;                              ///< [rad]
    std::string path = {};                           ///< file instead of force and moment
    SixSeries rows = {};                             ///< what it holds [s, N, N.m]

    bool operator==(const AppliedForce&) const = default;
};

/// x(t) = mean + ramp(t) amplitude sin(2 pi t/period + phase) [m or rad].
struct HarmonicMotion {
    double mean = 0.0, amplitude = 0.0, period = 1.0, phase = 0.0;

    bool operator==(const HarmonicMotion&) const = default;
};

/// The platform goes as told, whatever the loads.
struct PrescribedMotion {
    std::array<std::optional<HarmonicMotion>, 6> harmonic = {};
    std::string path = {};  ///< file instead of them
    SixSeries rows = {};    ///< what it holds [s, m, rad]

    bool operator==(const PrescribedMotion&) const = default;
};

struct Platform {
    std::string name = "platform";
    std::optional<double> mass;          ///< [kg]; empty: auto, floats at its design draft
    std::optional<double> displacement;  ///< [kg], only compared
    std::optional<double> draft;         ///< keel below O [m]; empty: lowest member
    Vec3 centre_of_gravity = Vec3::Zero();
    Vec3 radii_of_gyration = Vec3::Zero();  ///< about the centre of gravity [m]
    std::optional<Mat3> inertia;            ///< about the centre of gravity [kg.m2], instead
    Vec3 position = Vec3::Zero();           ///< of O as designed, on world axes, z = 0 [m]
    std::string key_path = "platform";      ///< of its keys in the case file, for messages
    PlatformMotion initial;                 ///< added to the static position
    Hydrodynamics hydrodynamics;
    std::vector<Member> members;
    std::vector<Plate> plates;  ///< one entry per plate (a list of z is expanded)
    std::optional<WindArea> wind;
    Mat6 linear_damping = Mat6::Zero();     ///< about O on axes that turn with yaw [SI, rad]
    Mat6 quadratic_damping = Mat6::Zero();  ///< F_i = -sum_j B_ij |v_j| v_j
    Mat6 stiffness = Mat6::Zero();          ///< the user's, about the design position
    bool stiffness_turns = false;           ///< on axes that turn with yaw; else the world's
    std::optional<CurrentCoefficients> current_coefficients;
    std::vector<AppliedForce> forces;
    std::array<bool, 6> fixed{};  ///< motions that are held where `initial` puts them
    std::optional<PrescribedMotion> prescribed;

    /// Motions that do not follow from the loads.
    [[nodiscard]] std::array<bool, 6> held() const {
        std::array<bool, 6> all{};
        all.fill(true);
        return prescribed ? all : fixed;
    }

    bool operator==(const Platform&) const = default;
};

}  // namespace hawser
