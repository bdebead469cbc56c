// Validation rows C: waves, current and wind against values worked out from the published formulas
// by other programs. Tolerances are half a unit of the last digit given.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "environment/current.hpp"
#include "environment/dispersion.hpp"
#include "environment/npd.hpp"
#include "environment/spectra.hpp"
#include "environment/wave_components.hpp"
#include "environment/wind.hpp"
#include "validation/row.hpp"

namespace hawser {
namespace {

TEST(ValidationC, Waves) {
    const Jonswap sea{.Hs = 15.2, .wp = 2.0 * std::numbers::pi / 15.6, .gamma = 2.4};
    validate({"C.jonswap", "S(0.3 rad/s) [m2.s]", 10.0985, sea.density(0.3), 5e-5, false});
    validate({"C.jonswap", "S(peak) [m2.s]", 92.2904, sea.density(sea.wp), 5e-5, false});
    validate({"C.jonswap", "S(0.5 rad/s) [m2.s]", 27.5472, sea.density(0.5), 5e-5, false});
    validate({"C.jonswap", "S(0.8 rad/s) [m2.s]", 4.0065, sea.density(0.8), 5e-5, false});
    for (const Discretisation discretisation :
         {Discretisation::equal_energy, Discretisation::equal_frequency_random}) {
        const bool equal_energy = discretisation == Discretisation::equal_energy;
        double m0 = 0.0;
        for (const WaveComponent& c : wave_components({.type = WaveType::jonswap,
                                      .Hs = 15.2,
                                      .Tp = 15.6,
                                      .gamma = 2.4,
                                      .seed = 1,
                                      .discretisation = discretisation},
                                                      1500.0, 9.80665))
            m0 += 0.5 * c.amplitude * c.amplitude;
        validate({"C.jonswap",
                  equal_energy ? "4 sqrt(m0), equal energy [m]" : "4 sqrt(m0), equal bins [m]",
                  15.2, 4.0 * std::sqrt(m0), 1e-12});
    }
    constexpr double g = 9.80665;
    validate(
        {"C.dispersion", "k, 0.4 rad/s, 50 m", 0.02091387, wave_number(0.4, 50.0, g), 5e-9, false});
    validate({"C.dispersion", "k, 0.4 rad/s, 1500 m", 0.01631546, wave_number(0.4, 1500.0, g), 5e-9,
              false});
    validate({"C.dispersion", "k, 0.1 rad/s, 1500 m", 0.00109825, wave_number(0.1, 1500.0, g), 5e-9,
              false});
    validate(
        {"C.dispersion", "k, 0.6 rad/s, 20 m", 0.04883818, wave_number(0.6, 20.0, g), 5e-9, false});
}

TEST(ValidationC, WindAndCurrent) {
    const NpdWind npd{.U0 = 45.0138};
    validate({"C.npd", "U(20 m) [m/s]", 49.992, npd.mean(20.0), 5e-4, false});
    validate({"C.npd", "U(30 m) [m/s]", 52.903, npd.mean(30.0), 5e-4, false});
    validate({"C.npd", "U(50 m) [m/s]", 56.572, npd.mean(50.0), 5e-4, false});
    validate({"C.npd", "U(100 m) [m/s]", 61.550, npd.mean(100.0), 5e-4, false});
    validate({"C.npd", "Iu(10 m)", 0.17614, npd.turbulence_intensity(10.0), 5e-6, false});
    validate(
        {"C.npd", "S(10 m, 0.01 Hz) [m2/s]", 865.71, npd.gust_density(10.0, 0.01), 5e-3, false});
    validate({"C.npd", "S(30 m, 0.1 Hz) [m2/s]", 67.142, npd.gust_density(30.0, 0.1), 5e-4, false});
    for (const auto& [height, expected] : {std::pair{10.0, 6.915}, std::pair{30.0, 6.173}}) {
        double variance = 0.0;
        const WindField wind({.spectrum = WindSpectrum::npd, .speed = 45.0138}, 0.0, height);
        for (const GustComponent& c : wind.components())
            variance += 0.5 * c.amplitude * c.amplitude;
        validate({"C.npd", height == 10.0 ? "gust std, 10 m [m/s]" : "gust std, 30 m [m/s]",
                  expected, std::sqrt(variance), 5e-4, false});
    }
    const CurrentProfile current(
        Current{.heading = 0.0, .profile = {{0.0, 1.9, {}}, {40.0, 1.4, {}}, {75.0, 0.0, {}}}});
    validate({"C.current", "speed at 57.5 m [m/s]", 0.7, current.velocity(-57.5).norm(), 1e-14});
    validate(
        {"C.current", "speed on a crest of 15 m [m/s]", 1.9, current.velocity(15.0).norm(), 1e-14});
}

}  // namespace
}  // namespace hawser
