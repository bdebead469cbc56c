// Prints the CPU time of one evaluation of the water at one point, 100 wave components, by depth.
// Not a test: it has no limit. Usage: bench_waves
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "environment/sea.hpp"

namespace {

/// Best of several repetitions [ns per point].
double nanoseconds_per_point(const hawser::Sea& sea, double depth) {
    constexpr int n = 400, blocks = 50, repetitions = 7;
    std::vector<double> x(n), y(n), z(n, -depth);
    std::vector<std::vector<double>> results(7, std::vector<double>(n));
    for (int i = 0; i < n; ++i) {
        x[static_cast<std::size_t>(i)] = 3.0 * i;
        y[static_cast<std::size_t>(i)] = 0.7 * i;
    }
    const hawser::WaterKinematics out{results[0].data(), results[1].data(), results[2].data(),
                                      results[3].data(), results[4].data(), results[5].data(),
                                      results[6].data()};
    double best = 1e30;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        const std::clock_t start = std::clock();
        for (int block = 0; block < blocks; ++block)
            sea.sample(1000.0 + 0.25 * block, n, x.data(), y.data(), z.data(), out);
        const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best = std::min(best, 1e9 * spent / (n * blocks));
    }
    return best;
}

}  // namespace

int main() {
    hawser::Environment environment;
    environment.seabed.depth = 1500.0;
    environment.waves = {{.type = hawser::WaveType::jonswap,
                          .Hs = 15.2,
                          .Tp = 15.6,
                          .gamma = 2.4,
                          .heading = 0.5,
                          .seed = 1}};
    environment.current = hawser::Current{
        .heading = 0.0, .profile = {{0.0, 1.9, {}}, {40.0, 1.4, {}}, {75.0, 0.0, {}}}};
    const hawser::Sea all(environment, 100.0, 0.0), filtered(environment, 100.0, 1.0);
    std::printf("depth [m]   ns per point, all components   with the depth filter\n");
    for (const double depth : {0.0, 20.0, 100.0, 300.0, 1000.0})
        std::printf("%9.0f   %28.0f   %21.0f\n", depth, nanoseconds_per_point(all, depth),
                    nanoseconds_per_point(filtered, depth));
}
