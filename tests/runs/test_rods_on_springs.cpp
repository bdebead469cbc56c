// The paper's loop with real rods: order of the coupling, passes per step. P:3, R section 12.2.
#include <gtest/gtest.h>

#include <cmath>

#include "../master/doubles.hpp"
#include "../worker/rod_cases.hpp"
#include "environment/ramp.hpp"
#include "equilibrium.hpp"
#include "local_lines.hpp"
#include "paper_loop.hpp"
#include "rod/lane_access.hpp"

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

Finished run(double D, int steps, double rod_step, ForceFit force = ForceFit::instantaneous) {
    Case input = rods_on_springs(rod_step);
    input.analysis.dynamics.platform_step = D;
    input.analysis.dynamics.force = force;
    worker::LocalLines lines(input, {0}, nullptr);
    lines.packs()[0].newton.tolerance = 1e-10;  // what is left is the coupling
    lines.packs()[0].newton.max_iterations = 20;
    test::Body body;
    body.masses << 1e5, 1e5, 1e5, 1e7, 1e7, 1e7;
    const Reply start =
        master::lines_at(lines, {}, false, [](const Status&, const master::Poses&) { return ""; });
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
    // coupling. The steps resolve the rods' first axial period of 0.76 s, the coarse one barely.
    const double h = 0.0125, T = 12.8;
    double paper = 0.0;
    for (const ForceFit force : {ForceFit::instantaneous, ForceFit::impulse_matched}) {
        const auto end = [&](double D) {
            return run(D, static_cast<int>(std::lround(T / D)), h, force).end;
        };
        const State reference = end(0.025), coarse = end(0.4), middle = end(0.2), fine = end(0.1);
        const auto error = [&](const State& s) { return (s - reference).head<3>().norm(); };
        const double e1 = error(coarse), e2 = error(middle), e3 = error(fine);
        EXPECT_GT(e3, 1e-8);  // there is something to measure
        EXPECT_NEAR(std::log2(e1 / e2), 4.0, 0.7);
        EXPECT_NEAR(std::log2(e2 / e3), 4.0, 0.4);
        // the spline's end acceleration is of order 2: matching takes its share out (R:48)
        if (force == ForceFit::instantaneous) {
            paper = e3;
        } else {
            EXPECT_LT(e3, 0.5 * paper);
        }
    }
}

/// A floating mass and a short rod that flies to and fro in its guide, nothing else.
struct Knocks {
    double lost = 0.0;    ///< most that the hull's momentum, with what it is owed, is off, of it
    double behind = 0.0;  ///< the same of its momentum alone
    double turned = 0.0;  ///< angular momentum against lever times momentum
    double reported = 0.0, given = 0.0, rod = 0.0;  ///< mismatch; impulse on the rod, its momentum
    int knocks = 0;
};
Knocks knock(ForceFit force, double D, int steps) {
    using namespace worker::testing;
    Case input = one_line(plain_type(300, 1e10, 1e10), 2.0, 2, LineEnd{}, LineEnd{});
    input.lines[0].constraints = {{.type = ConstraintType::guide,
                                   .name = "guide",
                                   .position = {0, 0, 1},
                                   .arc_length = {},
                                   .stiffness = 2e7,
                                   .damping = 1e4,
                                   .gap = 0.1}};
    input.environment.water.density = input.environment.water.gravity = 0.0;
    input.analysis.dynamics.line_step = 0.005;
    input.analysis.dynamics.platform_step = D;
    input.analysis.dynamics.force = force;
    worker::LocalLines lines(input, {0}, nullptr);
    worker::RodPack<worker::Quad>& pack = lines.packs()[0];
    std::vector<worker::CatenaryNode> nodes;
    for (int n = 0; n <= 2; ++n)
        nodes.push_back({.position = Vec3(0, 0, n), .tangent = Vec3::UnitZ(), .tension = 0.0});
    pack.set_guess(0, nodes);
    for (int n = 0; n <= 2; ++n)
        worker::set_lane_vector(pack.kept().nodes()[n].v, 0, Vec3(2, 0, 0));
    test::Body body;
    body.masses << 1e4, 1e4, 1e4, 1e12, 1e12, 1e12;
    Reply start;
    start.lines.resize(1);
    const auto kept = [&] { return pack.kept().constraints()[0]; };
    Knocks out;
    Vec3 before = Vec3::Zero();
    double size = 0.0, largest = 0.0;
    // what the hull has taken when its state is y: all but the last pass, which is kept at once
    const auto look = [&](const State& y) {
        pack.keep();
        const Vec3 given = worker::lane_vector(kept().impulse, 0);
        const Vec3 owed = worker::lane_vector(pack.kept().head().handed[0].owed_force, 0);
        const Vec3 momentum = body.masses[0] * y.segment<3>(6);
        out.lost = std::max(out.lost, (momentum + owed + given).norm());
        out.behind = std::max(out.behind, (momentum + given).norm());
        out.turned = std::max(out.turned, std::abs(body.masses[4] * y[10] - momentum.x()));
        if ((given - before).norm() > 100.0) ++out.knocks;
        before = given, size = kept().impulse_size[0];
        largest = std::max(largest, given.norm());
        out.reported = std::abs(pack.impulse_mismatch(0, 0) - (momentum + given).norm() / size);
    };
    master::PaperRate<test::Body> rate(body, lines, start);
    master::paper_loop(rate, State(State::Zero()), D, [&](int step, double, const State& y) {
        if (step > 0) look(y);
        rate.next().keep_previous = false;  // done above
        return step < steps;
    });
    out.lost /= largest, out.behind /= largest, out.turned /= largest;
    out.given = before.x();
    for (int n = 0; n < 3; ++n)
        out.rod +=
            (n == 1 ? 300.0 : 150.0) * (worker::lane_vector(pack.kept().nodes()[n].v, 0).x() - 2.0);
    return out;
}

TEST(PaperLoopWithRods, TakesTheWholeImpulseOfKnocksBetweenItsRates) {  // R:48
    // 600 kg to and fro between walls 0.2 m apart in a hull of 10 t; a knock lasts 17 ms, less than
    // a tenth of the platform's stages.
    const Knocks matched = knock(ForceFit::impulse_matched, 0.4, 40);
    EXPECT_GT(matched.knocks, 10);
    EXPECT_LT(matched.lost, 1e-12);   // to rounding, at every step
    EXPECT_GT(matched.behind, 0.1);   // a knock of the last step is handed over in the next
    EXPECT_LT(matched.turned, 1e-3);  // the moment about O as well, 1 m times the force
    EXPECT_LT(matched.reported, 1e-12);
    EXPECT_NEAR(matched.given, matched.rod, 0.02 * std::abs(matched.given));
    const Knocks missed = knock(ForceFit::instantaneous, 0.4, 40);
    EXPECT_GT(missed.lost, 0.3);
    EXPECT_LT(missed.reported, 1e-12);
}

TEST(PaperLoopWithRods, StaysAsStableWithTheImpulseMatched) {  // R:48
    // A hull of 10 t on two lines of 12 t: what acts at its end is explicit in the platform's
    // rates.
    const auto largest = [](ForceFit force, double D) {
        Case input = rods_on_springs(0.0125);
        input.analysis.dynamics.platform_step = D;
        input.analysis.dynamics.force = force;
        worker::LocalLines lines(input, {0}, nullptr);
        test::Body body;
        body.masses << 1e4, 1e4, 1e4, 1e6, 1e6, 1e6;
        const Reply start = master::lines_at(
            lines, {}, false, [](const Status&, const master::Poses&) { return ""; });
        const Vec6 balance = master::total_wrench(start);
        body.force = [balance](double) { return Vec6(-balance); };
        State y = State::Zero();
        y[6] = 0.1, y[8] = 0.1;
        master::PaperRate<test::Body> rate(body, lines, start);
        double most = 0.0;
        master::paper_loop(rate, y, D, [&](int step, double t, const State& s) {
            if (t > 30.0) most = std::max(most, s.segment<3>(6).norm());
            return step * D < 40.0;
        });
        return most;
    };
    for (const double D : {0.2, 0.4}) {
        const double matched = largest(ForceFit::impulse_matched, D);
        EXPECT_LT(matched, 0.15) << D;
        EXPECT_LT(matched, 1.3 * largest(ForceFit::instantaneous, D)) << D;
    }
}

TEST(PaperLoopWithRods, RunsThreePlatformStepsOfRodTimePerStep) {
    const Finished result = run(0.5, 20, 0.02);
    EXPECT_EQ(result.work.passes, 4 * 20);
    EXPECT_NEAR(result.work.rod_time, 3 * 0.5 * 20, 1e-9);
    EXPECT_EQ(result.work.steps, (13 + 13 + 25 + 25) * 20);  // R:28
}

}  // namespace
}  // namespace hawser
