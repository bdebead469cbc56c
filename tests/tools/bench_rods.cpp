// Speed of the packed rod kernel: nanoseconds per element and time step, by user CPU time.
//
//     build/tests/bench_rods [elements] [seconds simulated] [friction coefficient of the bed]
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "../worker/rod_cases.hpp"

namespace {

double user_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

using namespace hawser;
using namespace hawser::worker;

/// A chain-polyester-chain line in 1500 m with seabed, drag, two-modulus rope and moving top.
Case mooring_line(int elements, double friction) {
    LineType chain = worker::testing::plain_type(589, 3.07119e9),
             rope = worker::testing::plain_type(57.1, 7.0632e8);
    chain.displaced_area = 0.07503;
    rope.displaced_area = 0.04138;
    for (LineType* type : {&chain, &rope}) {
        type->drag_normal = 2.0, type->drag_axial = 0.5, type->drag_diameter = 0.2;
        type->added_mass_normal = 1.0, type->added_mass_axial = 0.3;
        type->damping_ratio = 0.01;
    }
    rope.viscoelastic = Viscoelastic{7.0632e8, 4.5126e8, 300};
    LineEnd top = worker::testing::fixed_at({0, 0, -60});
    EndMotion motion;
    motion.amplitude = {3.0, 0, 0.5};
    motion.period = {15.6, 1, 15.6};
    top.motion = motion;
    Case input = worker::testing::one_line(chain, 91, elements, top,
                                           worker::testing::anchored_at({2050, 0, -1500}), 1500);
    input.environment.seabed.friction_axial = input.environment.seabed.friction_lateral = friction;
    input.line_types.push_back(rope);
    const int chain_elements = std::max(2, elements / 10);
    input.lines[0].sections = {
        {.type = 0, .length = 91, .elements = chain_elements},
        {.type = 1, .length = 2286, .elements = elements - 2 * chain_elements},
        {.type = 0, .length = 122, .elements = chain_elements}};
    for (int i = 1; i < 4; ++i) input.lines.push_back(input.lines[0]);
    return input;
}

}  // namespace

int main(int argc, char** argv) {
    const int elements = argc > 1 ? std::atoi(argv[1]) : 40;
    const double duration = argc > 2 ? std::atof(argv[2]) : 100.0;
    const double friction = argc > 3 ? std::atof(argv[3]) : 0.5;
    const Case input = mooring_line(elements, friction);
    const Sea sea(input.environment, 0.0, 1.0);
    std::vector<double> figures;
    for (int repeat = 0; repeat < 5; ++repeat) {
        RodPack<Quad> pack(input, sea, {0, 1, 2, 3});
        if (!pack.equilibrium({}, false).ok()) return 1;
        const PlatformMotion still;
        const double start = user_seconds();
        for (int k = 0; k < static_cast<int>(duration / 0.5); ++k) {
            const MotionSpline platform(0.5 * k, still, 0.5 * (k + 1), still);
            if (!pack.pass(0.5 * k, 0.5 * (k + 1), platform).ok()) return 1;
            pack.keep();
        }
        const double used = user_seconds() - start;
        const double element_steps = 4.0 * elements * static_cast<double>(pack.work().steps);
        figures.push_back(1e9 * used / element_steps);
        if (repeat == 0)
            fmt::print(
                "{} steps, {:.3f} solves a step, top tension {:.6f} kN\n", pack.work().steps,
                static_cast<double>(pack.work().solves) / static_cast<double>(pack.work().steps),
                pack.tension_a(0) / 1e3);
    }
    std::sort(figures.begin(), figures.end());
    fmt::print(
        "{:.0f} ns per element and step (median of 5; least {:.0f}), pack of 4 lines of {} "
        "elements\n",
        figures[2], figures[0], elements);
    return 0;
}
