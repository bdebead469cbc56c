// The case: environment (case key `environment`). Plain values in SI and radians; all declared
// headings are directions of travel, counter-clockwise from +x seen from above.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hawser {

struct Water {
    double density = 1025.0;   ///< [kg/m3]
    double gravity = 9.80665;  ///< [m/s2]

    bool operator==(const Water&) const = default;
};

struct Seabed {
    double depth = 0.0;               ///< still-water depth at the origin [m]
    double normal_stiffness = 100e3;  ///< force per length of line and penetration [N/m2]
    double damping = 10e3;            ///< force per length of line and normal speed [N.s/m2]
    double slope_angle = 0.0;         ///< [rad]; the bed passes through z = -depth at the origin
    double slope_direction = 0.0;     ///< heading in which the bed rises [rad]
    double friction_axial = 0.3, friction_lateral = 0.5;  ///< Coulomb coefficients, R:34
    double friction_mobilisation = 0.05;                  ///< slide that mobilises them [m]

    bool operator==(const Seabed&) const = default;

    /// z = -depth + tan(angle) (x cos direction + y sin direction) [m].
    [[nodiscard]] double height(double x, double y) const {
        return -depth + std::tan(slope_angle) *
                            (x * std::cos(slope_direction) + y * std::sin(slope_direction));
    }
};

enum class WaveType {
    airy,
    jonswap,
    pierson_moskowitz,
    ochi_hubble,
    torsethaugen,
    white_noise,
    spectrum_file,
    elevation_file,
    components
};
enum class Discretisation { equal_energy, equal_frequency_random };
enum class Stretching { none, vertical, wheeler, extrapolation };

/// Directions of a short-crested sea about the train's heading b0:
/// D(b) = cos^2s((b - b0)/2) / integral, over the whole circle.
struct Spreading {
    double s = 1.0;
    int directions = 10;

    bool operator==(const Spreading&) const = default;
};

/// One of the two humps of an Ochi-Hubble spectrum.
struct SpectrumHump {
    double Hs = 0.0, Tp = 0.0;  ///< [m], [s]
    double lambda = 1.0;        ///< shape [-]; 1: Pierson-Moskowitz

    bool operator==(const SpectrumHump&) const = default;
};

/// A wave component as the user lists it.
struct ListedWave {
    double frequency = 0.0, amplitude = 0.0, phase = 0.0;  ///< [rad/s], [m], [rad]
    std::optional<double> heading = {};                    ///< [rad]; empty: the train's

    bool operator==(const ListedWave&) const = default;
};

struct WaveTrain {
    WaveType type = WaveType::airy;
    double Hs = 0.0, Tp = 0.0;         ///< spectra: significant wave height [m], peak period [s]
    std::optional<double> gamma = {};  ///< jonswap peak enhancement; empty: DNV-RP-C205 rule
    double H = 0.0, T = 0.0;           ///< airy: wave height [m] (twice the amplitude), period [s]
    double phase = 0.0;                ///< airy: leads the crest at the origin [rad]
    double heading = 0.0;              ///< [rad]
    std::uint64_t seed = 0;            ///< spectra
    int components = 100;
    Discretisation discretisation = Discretisation::equal_energy;
    double range_min = 0.5, range_max = 5.0;      ///< frequency range as multiples of the peak
    Stretching stretching = Stretching::wheeler;  ///< one for all trains
    std::optional<Spreading> spreading = {};      ///< empty: long-crested
    std::vector<SpectrumHump> humps = {};         ///< ochi_hubble: two; empty: follow from Hs
    double band_min = 0.0, band_max = 0.0;  ///< white_noise, elevation_file: frequencies [rad/s]
    std::string file = {};                  ///< what `spectrum` or `record` were read from
    bool file_in_hertz = false;             ///< frequencies of a spectrum's file
    /// spectrum_file: frequency [rad/s], density [m2.s], ascending.
    std::vector<std::array<double, 2>> spectrum = {};
    /// elevation_file: time [s], elevation [m], at equal intervals.
    std::vector<std::array<double, 2>> record = {};
    double record_x = 0.0, record_y = 0.0;  ///< where it was measured [m]
    std::vector<ListedWave> list = {};      ///< components

    bool operator==(const WaveTrain&) const = default;
};

struct CurrentPoint {
    double depth = 0.0;                  ///< below mean sea level [m]
    double speed = 0.0;                  ///< [m/s]
    std::optional<double> heading = {};  ///< [rad]; empty: the current's own

    bool operator==(const CurrentPoint&) const = default;
};

struct Current {
    double heading = 0.0;               ///< [rad]
    std::vector<CurrentPoint> profile;  ///< ascending depth; linear between, constant outside

    bool operator==(const Current&) const = default;
};

enum class WindSpectrum { constant, npd, api, kaimal, time_history };

struct Wind {
    WindSpectrum spectrum = WindSpectrum::constant;
    double speed = 0.0;              ///< mean speed [m/s] over `averaging` at `reference_height`
    double averaging = 3600.0;       ///< [s]
    double reference_height = 10.0;  ///< [m]
    double heading = 0.0;            ///< [rad]
    std::uint64_t seed = 0;
    double density = 1.226;             ///< of the air [kg/m3]
    double turbulence_intensity = 0.0;  ///< kaimal: standard deviation of the gusts over the mean
    std::string file = {};              ///< what `history` was read from
    /// time_history: time [s], speed [m/s], ascending; linear between, constant outside.
    std::vector<std::array<double, 2>> history = {};

    bool operator==(const Wind&) const = default;
};

struct Environment {
    Water water;
    Seabed seabed;
    std::vector<WaveTrain> waves;  ///< none: still water; several add up
    std::optional<Current> current;
    std::optional<Wind> wind;

    bool operator==(const Environment&) const = default;
};

}  // namespace hawser
