#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "doubles.hpp"
#include "paper_loop.hpp"

namespace hawser::master {
namespace {

using test::Body;
using test::SpringLines;
using test::SprungMass;

/// Runs n steps of length D from y and returns the last state.
State run(const Body& body, Lines& lines, const Reply& start, const State& y, double D, int n) {
    PaperRate<Body> rate(body, lines, start);
    return paper_loop(rate, y, D, [n](int step, double, const State&) { return step < n; });
}

// Six oscillators, m x'' + k x = 0, x(0) = 1: x = cos(w t).
double oscillator_error(double D) {
    Body body;
    body.masses << 1, 2, 3, 4, 5, 6;
    const Vec6 k = Vec6::Constant(1.0);
    SpringLines lines({0.25 * k, 0.75 * k});
    State y = State::Zero();
    y.head<6>().setOnes();
    Reply start;
    start.lines.resize(2);
    start.lines[0].wrench = -0.25 * k;
    start.lines[1].wrench = -0.75 * k;
    const int n = static_cast<int>(std::lround(8.0 / D));
    const State end = run(body, lines, start, y, D, n);
    double error = 0.0;
    for (int i = 0; i < 6; ++i)
        error = std::max(error, std::abs(end[i] - std::cos(8.0 / std::sqrt(body.masses[i]))));
    return error;
}

TEST(PaperLoop, ErrorFallsWithFourthPowerOfStep) {  // P:3, lines as springs
    const double e1 = oscillator_error(0.2), e2 = oscillator_error(0.1),
                 e3 = oscillator_error(0.05);
    EXPECT_LT(e1, 2e-4);  // t w^5 D^4 / 120 of Runge-Kutta for w = 1
    EXPECT_NEAR(std::log2(e1 / e2), 4.0, 0.1);
    EXPECT_NEAR(std::log2(e2 / e3), 4.0, 0.1);
}

// Platform M on a ground spring K beside the sprung mass: the linear system's own solution.
struct TwoMasses {
    double M = 20.0, K = 15.0, m = 1.0, k = 2.0, k_g = 0.5, c = 0.3;
    [[nodiscard]] Eigen::Vector4d exact(const Eigen::Vector4d& start, double t) const {
        Eigen::Matrix4d A;  // of (x, z, x', z')
        A << 0, 0, 1, 0, 0, 0, 0, 1, -(K + k) / M, k / M, 0, 0, k / m, -(k + k_g) / m, 0, -c / m;
        const Eigen::Matrix4d B = A * (t / 1024);  // exp(A t) = exp(B)^1024, B small: a series
        Eigen::Matrix4d term = Eigen::Matrix4d::Identity(), sum = term;
        for (int i = 1; i < 12; ++i) sum += term = term * B / i;
        for (int i = 0; i < 10; ++i) sum = sum * sum;
        return sum * start;
    }
};

/// Sprung mass and ground spring as one set of lines.
class SprungMassAndGround final : public Lines {
 public:
    explicit SprungMassAndGround(const TwoMasses& system) : K_(system.K) {
        mass.m = system.m, mass.k = system.k, mass.k_g = system.k_g, mass.c = system.c;
        reply_.lines.resize(2);
    }
    void send(const Order& order) override {
        x_ = order.to[0].position.x();
        mass.send(order);
    }
    const Reply& receive() override {
        reply_.lines[0] = mass.receive().lines[0];
        reply_.lines[1].wrench = -K_ * x_ * Vec6::Unit(0);
        return reply_;
    }
    SprungMass mass;

 private:
    double K_, x_ = 0.0;
    Reply reply_;
};

double two_masses_error(ForceFit fit, double D, SprungMassAndGround* out = nullptr) {
    const TwoMasses system;
    Body body;
    body.masses.setConstant(system.M);
    const Eigen::Vector4d start(1.0, 0.4, 0.0, 0.2);
    SprungMassAndGround lines(system);
    lines.mass.fit = fit;
    lines.mass.step = 0.01;  // its own error, about 1e-10, is far below the platform's
    lines.mass.z = start[1], lines.mass.v = start[3];
    State y = State::Zero();
    y[0] = start[0];
    Reply first;
    first.lines.resize(2);
    first.lines[0].wrench = system.k * (start[1] - start[0]) * Vec6::Unit(0);
    first.lines[1].wrench = -system.K * start[0] * Vec6::Unit(0);
    const int n = static_cast<int>(std::lround(8.0 / D));
    const State end = run(body, lines, first, y, D, n);
    if (out != nullptr)
        out->mass.time_run = lines.mass.time_run, out->mass.passes = lines.mass.passes;
    return std::abs(end[0] - system.exact(start, 8.0)[0]);
}

TEST(PaperLoop, IsOfFourthOrderWithALineThatHasMassAndStepsOfItsOwn) {  // P:3, P:5
    const double e1 = two_masses_error(ForceFit::instantaneous, 0.2);
    const double e2 = two_masses_error(ForceFit::instantaneous, 0.1);
    const double e3 = two_masses_error(ForceFit::instantaneous, 0.05);
    EXPECT_NEAR(std::log2(e1 / e2), 4.0, 0.3);
    EXPECT_NEAR(std::log2(e2 / e3), 4.0, 0.3);
}

TEST(PaperLoop, KeepsItsOrderUnderAQuadraticFitAndTwoUnderALinearOne) {
    // A fit of degree d over a pass of length D errs by D^(d+1) in the force. The line carries a
    // tenth of the platform's stiffness here, so the quadratic fit still shows the fourth order of
    // the rest.
    const double l1 = two_masses_error(ForceFit::linear_fit, 0.1);
    const double l2 = two_masses_error(ForceFit::linear_fit, 0.05);
    EXPECT_NEAR(std::log2(l1 / l2), 2.0, 0.3);
    const double q1 = two_masses_error(ForceFit::quadratic_fit, 0.1);
    const double q2 = two_masses_error(ForceFit::quadratic_fit, 0.05);
    EXPECT_GT(std::log2(q1 / q2), 2.9);
}

TEST(PaperLoop, TellsAWatcherEveryEvaluationWithWhatLedToIt) {  // P:3
    Body body;
    body.force = [](double t) { return Vec6(t * Vec6::Ones()); };
    SpringLines lines({Vec6::Constant(1.0)});
    Reply start;
    start.lines.resize(1);
    PaperRate<Body> rate(body, lines, start);
    std::vector<int> stages;
    std::vector<double> times;
    rate.watch([&](int stage, double t, const State& s) {
        stages.push_back(stage);
        times.push_back(t);
        EXPECT_EQ(rate.loads().outer[0], t);
        EXPECT_EQ(rate.reply().lines[0].wrench[0], -s[0]);
        EXPECT_EQ(rate.acceleration()[0], t - s[0]);
    });
    paper_loop(rate, State::Zero(), 0.5, [](int step, double, const State&) { return step < 2; });
    EXPECT_EQ(stages, (std::vector<int>{0, 1, 2, 3, 4, 1, 2, 3, 4}));
    EXPECT_EQ(times, (std::vector<double>{0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1}));
}

TEST(PaperLoop, MakesFourPassesOfThreeStepsOfLineTimePerStep) {  // P:3: D/2 + D/2 + D + D
    for (ForceFit fit : {ForceFit::instantaneous, ForceFit::linear_fit, ForceFit::quadratic_fit}) {
        SprungMassAndGround lines((TwoMasses()));
        two_masses_error(fit, 0.5, &lines);
        EXPECT_EQ(lines.mass.passes, 4 * 16);
        EXPECT_NEAR(lines.mass.time_run, 3 * 8.0, 1e-12);  // sums of binary fractions
    }
}

struct Recorded {
    std::vector<Order> orders;
    std::vector<std::string> log;
    std::vector<double> times;
};

Recorded recorded_run(double D, int n) {
    Recorded out;
    Body body;
    body.log = &out.log;
    body.masses.setConstant(2.0);
    SpringLines lines({Vec6::Constant(1.0)});
    lines.log = &out.log;
    State y = State::Zero();
    y[0] = 1.0;
    Reply start;
    start.lines.resize(1);
    start.lines[0].wrench = -Vec6::Unit(0);
    PaperRate<Body> rate(body, lines, start);
    paper_loop(rate, y, D, [&](int step, double t, const State&) {
        out.times.push_back(t);
        rate.next().sample = true;
        return step < n;
    });
    out.orders = lines.orders;
    return out;
}

TEST(PaperLoop, SendsEveryPassFromTheKeptStateAndKeepsTheLastOnly) {
    const double D = 0.3;
    const Recorded run = recorded_run(D, 3);
    ASSERT_EQ(run.orders.size(), 12U);
    for (int step = 0; step < 3; ++step) {
        const Order* pass = &run.orders[static_cast<size_t>(4 * step)];
        for (int i = 0; i < 4; ++i) {
            EXPECT_EQ(pass[i].ask, Ask::run_to);
            EXPECT_EQ(pass[i].t0, step * D);  // never a running sum
            EXPECT_EQ(pass[i].t1, (i < 2 ? step + 0.5 : step + 1) * D);
            EXPECT_EQ(pass[i].from, pass[0].from);
            EXPECT_EQ(pass[i].keep_previous, i == 0 && step > 0);
            EXPECT_EQ(pass[i].sample, i == 0);  // a flag is carried once
        }
        // stage states from the platform's state alone: s1 and s3 are Euler steps
        EXPECT_EQ(pass[0].to[0].position,
                  pass[0].from[0].position + D / 2 * pass[0].from[0].velocity);
        if (step > 0) {
            EXPECT_EQ(pass[0].from, pass[-1].to);  // the spline goes on from where it ended
        }
    }
    EXPECT_EQ(run.times, (std::vector<double>{0.0, D, 2 * D, 3 * D}));
}

TEST(PaperLoop, LoadsTheHullWhileTheLinesRunAndReusesTheLastRate) {  // P:2
    const Recorded run = recorded_run(0.3, 2);
    std::vector<std::string> expected{"loads"};  // the static start
    for (int pass = 0; pass < 8; ++pass)
        for (const char* verb : {"send", "loads", "receive"}) expected.emplace_back(verb);
    EXPECT_EQ(run.log, expected);
}

TEST(PaperLoop, StopsAtALineThatFailsAndSaysInWhichStage) {
    class Failing final : public Lines {
     public:
        void send(const Order&) override { ++orders; }
        const Reply& receive() override {
            reply.lines.resize(1);
            if (orders == 7) reply.status = {.code = Status::Code::not_converged, .line = 0};
            return reply;
        }
        int orders = 0;
        Reply reply;
    } lines;
    const Body body;
    Reply start;
    start.lines.resize(1);
    PaperRate<Body> rate(body, lines, start);
    try {
        paper_loop(rate, State::Zero(), 0.5, [](int, double, const State&) { return true; });
        FAIL();
    } catch (const LinesFailed& failure) {
        EXPECT_EQ(failure.stage, 3);
        EXPECT_EQ(failure.status.line, 0);
        EXPECT_EQ(lines.orders, 7);
    }
}

TEST(PaperLoop,
     WaitsForTheLinesAlsoWhenTheHullFails) {  // else the workers' reply stays in the pipe
    std::vector<std::string> log;
    SpringLines lines({Vec6::Ones()});
    lines.log = &log;
    Body body;
    body.force = [](double t) -> Vec6 {
        if (t > 0.3) throw std::runtime_error("capsized");
        return Vec6::Zero();
    };
    Reply start;
    start.lines.resize(1);
    PaperRate<Body> rate(body, lines, start);
    EXPECT_THROW(
        paper_loop(rate, State::Zero(), 0.5, [](int, double, const State&) { return true; }),
        std::runtime_error);
    // two stages at 0.25 s, and the one at 0.5 s where the hull fails
    EXPECT_EQ(log,
              (std::vector<std::string>{"send", "receive", "send", "receive", "send", "receive"}));
}

TEST(TotalWrench, IsTheSumInLineOrder) {
    Reply reply;
    for (const double fx : {1e16, 1.0, -1e16}) {  // any other order gives another sum
        LineLoad load;
        load.wrench = fx * Vec6::Unit(0);
        reply.lines.push_back(load);
    }
    EXPECT_EQ(total_wrench(reply)[0], (1e16 + 1.0) - 1e16);
}

}  // namespace
}  // namespace hawser::master
