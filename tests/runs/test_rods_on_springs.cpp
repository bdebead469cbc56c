// The paper's loop with real rods: order of the coupling, passes per step. P:3, R section 12.2.
#include <gtest/gtest.h>

#include <cmath>

#include "../master/doubles.hpp"
#include "../worker/rod_cases.hpp"
#include "environment/ramp.hpp"
#include "equilibrium.hpp"
#include "local_lines.hpp"
#include "paper_loop.hpp"

namespace hawser {
namespace {

using master::State;

/// Two lines on springs from a floating mass to the ground, one step size for the rods throughout.
Case rods_on_springs(double rod_step) {
    LineType type = worker::testing::plain_type(100.0, 1e7);
    type.damping_ratio = 0.05;
    LineEnd a;
    a.kind = EndKind::platform;
    a.joint = Joint::spring;
    a.spring_stiffness = 4e4;
    a.position = {5, 0, -2};
    Case input =
        worker::testing::one_line(type, 120, 6, a, worker::testing::fixed_at({80, 0, -80}));
    input.environment.water.density = 0.0;
    Line second = input.lines[0];
    second.name = "second";
    second.end_a.position = {-5, 0, -2};
    second.end_b.position = {-80, 0, -80};
    input.lines.push_back(second);
    input.analysis.dynamics.line_step = rod_step;
    input.analysis.dynamics.platform_step = 1.6;
    return input;
}

struct Finished {
    State end;
    worker::WorkCount work;
};

Finished run(double D, int steps, double rod_step) {
    Case input = rods_on_springs(rod_step);
    input.analysis.dynamics.platform_step = D;
    worker::LocalLines lines(input, {0}, nullptr);
    lines.packs()[0].newton.tolerance = 1e-10;  // what is left is the coupling
    lines.packs()[0].newton.max_iterations = 20;
    test::Body body;
    body.masses << 1e5, 1e5, 1e5, 1e7, 1e7, 1e7;
    const Reply start =
        master::lines_at(lines, {}, false, [](const Status&, const PlatformMotion&) { return ""; });
    const Vec6 balance = master::total_wrench(start);
    body.force = [balance](double t) {  // brought in smoothly: the rods start at rest
        const Vec6 push = 4e4 * (Vec6() << 1, 0, -0.6, 0, 8, 0).finished();
        return Vec6(ramp_factor(t, 8.0) * std::sin(0.6 * t) * push - balance);
    };
    const State y = State::Zero();
    master::PaperRate<test::Body> rate(body, lines, start);
    const State end = master::paper_loop(
        rate, y, D, [steps](int step, double, const State&) { return step < steps; });
    return {end, lines.packs()[0].work()};
}

TEST(PaperLoopWithRods, ErrorFallsWithFourthPowerOfPlatformStep) {
    // The rod step is the same throughout (every pass is a multiple of it), so what changes is the
    // coupling. The steps resolve the rods' first axial period of 0.76 s.
    const double h = 0.0125, T = 12.8;
    const auto end = [&](double D) { return run(D, static_cast<int>(std::lround(T / D)), h).end; };
    const State reference = end(0.025), coarse = end(0.4), middle = end(0.2), fine = end(0.1);
    const auto error = [&](const State& s) { return (s - reference).head<3>().norm(); };
    const double e1 = error(coarse), e2 = error(middle), e3 = error(fine);
    EXPECT_GT(e3, 1e-8);  // there is something to measure
    EXPECT_NEAR(std::log2(e1 / e2), 4.0, 0.6);
    EXPECT_NEAR(std::log2(e2 / e3), 4.0, 0.4);
}

TEST(PaperLoopWithRods, RunsThreePlatformStepsOfRodTimePerStep) {
    const Finished result = run(0.5, 20, 0.02);
    EXPECT_EQ(result.work.passes, 4 * 20);
    EXPECT_NEAR(result.work.rod_time, 3 * 0.5 * 20, 1e-9);
    EXPECT_EQ(result.work.steps, (13 + 13 + 25 + 25) * 20);  // R:28
}

}  // namespace
}  // namespace hawser
