// The free spar hull of validation row B2 (two tanks, no truss, plates or lines) and a Runge-Kutta
// integrator for tests of the platform without the time loop.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <functional>

#include "hull.hpp"
#include "io/hydro_file.hpp"

namespace hawser::master {

/// Case of the free hull in 1500 m of still water.
inline Case spar_case() {
    Case c;
    c.environment.seabed.depth = 1500.0;
    Platform& p = c.platform.emplace();
    p.mass = 1.030442e8;
    p.centre_of_gravity = {0, 0, -66};
    p.radii_of_gyration = {83, 83, 15};
    HydroDatabase& d = p.hydrodynamics.database.emplace();
    d.path = std::string(HAWSER_SOURCE_DIR) + "/cases/truss_spar/hydro/truss_spar";
    d.rho = 1025.0;
    d.displaced_volume = 100530.965;
    d.centre_of_buoyancy = Vec3(0, 0, -51.875);
    p.hydrodynamics.added_mass_frequency = 0.4;
    return c;
}

inline const HydroData& spar_data() {
    static const HydroData data =
        io::read_hydro(*spar_case().platform->hydrodynamics.database, Water{});
    return data;
}

inline WaveTrain regular_wave(double omega, double amplitude) {
    return {.type = WaveType::airy, .H = 2 * amplitude, .T = 2 * M_PI / omega};
}

inline WaveTrain paper_sea(std::uint64_t seed = 1) {
    return {.type = WaveType::jonswap, .Hs = 15.2, .Tp = 15.6, .gamma = 2.4, .seed = seed};
}

/// Load of springs and the like: of time and state.
using ExtraLoad = std::function<Vec6(double, const State&)>;
/// Called at every step before it is taken.
using Watch = std::function<void(double, const State&, const HullLoads&)>;

inline State run(const Hull& hull, State s, double step, int steps, const Watch& watch = {},
                 const ExtraLoad& lines = {}) {
    const auto rate = [&](double t, const State& y, HullLoads* keep = nullptr) {
        HullLoads loads = hull.loads(t, y);
        const State r = hull.rate(t, y, loads, lines ? lines(t, y) : Vec6(Vec6::Zero()));
        if (keep != nullptr) *keep = loads;
        return r;
    };
    for (int i = 0; i < steps; ++i) {
        const double t = i * step, h = step;
        HullLoads loads;
        const State k1 = rate(t, s, &loads);
        if (watch) watch(t, s, loads);
        const State k2 = rate(t + h / 2, s + h / 2 * k1);
        const State k3 = rate(t + h / 2, s + h / 2 * k2);
        const State k4 = rate(t + h, s + h * k3);
        s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return s;
}

/// Its radiation with memory.
inline Case spar_with_memory(RadiationMemoryKeys::Form form) {
    Case c = spar_case();
    c.platform->hydrodynamics.added_mass_frequency.reset();
    c.platform->hydrodynamics.memory =
        RadiationMemoryKeys{.form = form, .duration = 100, .order = {}};
    return c;
}

/// As run, and the hull remembers its steps.
inline State run_remembering(Hull& hull, State s, double h, int steps, const Watch& watch = {},
                             const ExtraLoad& lines = {}) {
    const auto rate = [&](double t, const State& y, Vec6* a = nullptr) {
        HullLoads loads = hull.loads(t, y);
        return hull.rate(t, y, loads, lines ? lines(t, y) : Vec6(Vec6::Zero()), a);
    };
    Vec6 acceleration;
    State k1 = rate(0, s, &acceleration);
    for (int i = 0; i < steps; ++i) {
        const double t = i * h;
        hull.remember(t, s, acceleration);
        if (watch) watch(t, s, {});
        const State k2 = rate(t + h / 2, s + h / 2 * k1);
        const State k3 = rate(t + h / 2, s + h / 2 * k2);
        const State k4 = rate(t + h, s + h * k3);
        s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        k1 = rate(t + h, s, &acceleration);
    }
    return s;
}

/// Motions of the free hull per metre of wave along x at a frequency of the data, in the frequency
/// domain: [ C - w^2 (M + A) + i w B ] x = X.
inline CVec6 linear_response(const Hull& hull, const HydroData& data, double w) {
    const Radiation r = radiation_at(data, w);
    std::size_t f = 0;
    while (data.excitation.frequencies[f] < w - 1e-6) ++f;
    std::size_t along = 0;
    while (std::abs(data.excitation.headings[along].heading) > 1e-9) ++along;
    const Mat6 M = mass_matrix(turned(hull.body(), Mat3::Identity()));
    const Mat6 C =
        hull.static_stiffness({}, {.current = false, .wind_mean = false, .drift_mean = false});
    const Eigen::Matrix<Complex, 6, 6> Z = (C - w * w * (M + r.added_mass)).cast<Complex>() +
                                           Complex(0, w) * r.damping.cast<Complex>();
    return Z.fullPivLu().solve(data.excitation.headings[along].values[f]);
}

}  // namespace hawser::master
