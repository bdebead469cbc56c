// Time of the hull loads and the equation of motion alone: the paper's truss spar in 100 wave
// components, current and wind, four evaluations per platform step of 0.5 s, with constant
// radiation matrices and with memory (fitted and discrete, 60 s), with Newman's drift and with full
// QTFs over 46 frequencies. By hand:
//     build/tests/bench_hull
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "../master/spar_hull.hpp"

namespace {

using namespace hawser;
using namespace hawser::master;

Case paper_spar() {
    Case c = spar_case();
    c.environment.waves = {paper_sea()};
    c.environment.current = Current{.profile = {{0, 1.9, {}}, {40, 1.4, {}}, {75, 0, {}}}};
    c.environment.wind = Wind{.spectrum = WindSpectrum::npd, .speed = 45, .seed = 11};
    Platform& p = *c.platform;
    p.hydrodynamics.drift = Drift::newman;
    const auto cylinder = [](double top, double bottom, double width, double Cd, double area) {
        return Member{.name = "",
                      .from = {0, 0, top},
                      .to = {0, 0, bottom},
                      .diameter = width,
                      .Cd = Cd,
                      .end_Cd_to = 0.6,
                      .inertia = area > 0,
                      .displaced_area = area,
                      .Ca = 2.6};
    };
    p.members = {cylinder(19, -70, 40, 1.2, 0), cylinder(-70, -165, 12, 1.6, 7.77),
                 cylinder(-165, -175, 40, 1.6, 0)};
    for (const double z : {-95.0, -115.0, -135.0})
        p.plates.push_back(
            {.name = "", .position = {0, 0, z}, .area = 900, .Cd = 5, .added_mass = 1.3e7});
    p.wind = WindArea{2500, 45, 1};
    return c;
}

/// Difference and sum QTF of any values, all round: four of the headings act at a time.
HydroData data_with_qtf() {
    HydroData data = spar_data();
    for (Qtf* qtf : {&data.difference, &data.sum}) {
        for (int i = 0; i < 46; ++i) qtf->frequencies.push_back(0.25 + 0.05 * i);
        for (int b = -180; b < 180; b += 30) {
            QtfPair& pair = qtf->pairs.emplace_back();
            pair.heading_1 = pair.heading_2 = b * M_PI / 180;
            for (int m = 0; m < 46; ++m)
                for (int n = 0; n < 46; ++n)
                    pair.values.emplace_back(CVec6::Constant(Complex(m * n, n - m)));
            pair.given.assign(pair.values.size(), 1);
        }
    }
    return data;
}

void measure(const char* what, const Case& c, const HydroData& data = spar_data()) {
    Hull hull(c, &data);
    State s = hull.start({.position = {30, 0, 0}}, {.position = {30, 0, 0}});
    const int steps = 4000;
    const double D = c.analysis.dynamics.platform_step;
    Vec6 acceleration;
    const auto rate = [&](double t, const State& y) {
        HullLoads loads = hull.loads(t, y);
        return hull.rate(t, y, loads, Vec6::Zero(), &acceleration);
    };
    double least = 1e300;  // of four parts of the run: other programs disturb some
    State k1 = rate(0, s);
    for (int part = 0; part < 4; ++part) {
        const std::clock_t start = std::clock();
        for (int i = part * steps / 4; i < (part + 1) * steps / 4; ++i) {
            hull.remember(i * D, s, acceleration);
            const State k2 = rate((i + 0.5) * D, s + D / 2 * k1);
            const State k3 = rate((i + 0.5) * D, s + D / 2 * k2);
            const State k4 = rate((i + 1) * D, s + D * k3);
            s += D / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            k1 = rate((i + 1) * D, s);
        }
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    const int evaluations = 4 * steps / 4;
    std::printf("%-28s %.3f ms CPU per simulated second, %.1f us per evaluation\n", what,
                1e3 * least / (steps / 4 * D), 1e6 * least / evaluations);
}

}  // namespace

int main() {
    using Form = RadiationMemoryKeys::Form;
    Case c = paper_spar();
    measure("constant matrices", c);
    c.platform->hydrodynamics.added_mass_frequency.reset();
    for (const int order : {3, 6, 12}) {
        c.platform->hydrodynamics.memory = {.form = Form::fitted, .order = order};
        measure(order == 3 ? "fitted, 3 oscillators"
                           : (order == 6 ? "fitted, 6 oscillators" : "fitted, 12 oscillators"),
                c);
    }
    c.platform->hydrodynamics.memory = {.form = Form::discrete, .order = {}};
    measure("discrete, 60 s", c);

    c = paper_spar();
    const HydroData data = data_with_qtf();
    for (const int components : {100, 400}) {
        c.environment.waves[0].components = components;
        c.platform->hydrodynamics.drift = Drift::newman;
        measure(components == 100 ? "100 components, newman" : "400 components, newman", c, data);
        c.platform->hydrodynamics.drift = Drift::full_qtf;
        measure(components == 100 ? "100 components, full_qtf" : "400 components, full_qtf", c,
                data);
    }
}
