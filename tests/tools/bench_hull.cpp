// Time of the hull loads and the equation of motion alone: the paper's truss spar in 100 wave
// components, current and wind, four evaluations per platform step of 0.5 s. By hand:
//     build/tests/bench_hull
#include <cstdio>
#include <ctime>

#include "../master/spar_hull.hpp"

int main() {
    using namespace hawser;
    using namespace hawser::master;
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
    const Hull hull(c, &spar_data());
    const State s = hull.start({.position = {30, 0, 0}}, {.position = {30, 0, 0}});
    const int steps = 2000;
    const std::clock_t start = std::clock();
    const State end = run(hull, s, 0.5, steps);
    const double cpu = double(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf(
        "%.3f ms CPU per simulated second, %.1f us per evaluation (surge %.1f m at the end)\n",
        1e3 * cpu / (steps * 0.5), 1e6 * cpu / (4 * steps), end[0]);
}
