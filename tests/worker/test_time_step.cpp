// Time steps and passes of one rod: order, damping of kinks, one iteration, energy, motion of the
// ends (sections 5 and 14 of the rod formulation).
#include <gtest/gtest.h>

#include <cmath>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

struct Setting {
    double h = 0.05;
    double tolerance = 0.005;
    RodScheme scheme = {};
    double ramp = 20.0;
    int refine = 1;
    double from = 0.0;
    double damping_ratio = 0.0;
};

/// Tension at the top of the standing line, sampled every 0.4 s.
Record top_tension(const LineEnd& top, double span, double duration, const Setting& setting) {
    Case input = standing_line(top, span, setting.refine);
    input.analysis.dynamics.line_step = setting.h;
    input.analysis.dynamics.rod_scheme = setting.scheme;
    input.analysis.dynamics.ramp = setting.ramp;
    for (LineType& type : input.line_types) type.damping_ratio = setting.damping_ratio;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    rod.newton.tolerance = setting.tolerance;
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    Record tension;
    EXPECT_TRUE(run(rod, duration, 0.4, [&](double t) {
                    if (t >= setting.from) tension.add(t, rod.tension_a(0));
                }).ok());
    return tension;
}

constexpr double slack_span = 2030, taut_span = 2062;  // about 2 and 7 MN at the top
const LineEnd fairlead = fixed_at({0, 0, -100});
const LineEnd storm = moving(fairlead, {-5, 0, 3}, 10);

TEST(TimeStep, ErrorFallsWithTheSquareOfTheStep) {  // R:27, acceptance 4
    // Without structural damping the line's higher axial modes, excited where drag changes its
    // sign, ring on and keep the error (0.1 % of the deviation) from its order.
    Setting s;
    s.from = 20, s.damping_ratio = 0.01;
    std::vector<Record> of;
    for (const double h : {0.05, 0.025, 0.0125}) {
        s.h = h;
        of.push_back(top_tension(storm, taut_span, 60, s));
    }
    const double coarse = rms_difference(of[0], of[1]), fine = rms_difference(of[1], of[2]);
    EXPECT_GT(coarse / fine, 3.5);
    EXPECT_LT(coarse / fine, 4.2);
    EXPECT_LT(coarse, 1e-3 * of[2].deviation());
}

TEST(TimeStep, OneIterationIsEnough) {  // acceptance 5: rms below 0.01 % of std at h = 0.1
    Setting s;
    s.from = 20;
    for (const double h : {0.1, 0.2}) {
        s.h = h;
        s.tolerance = 1e9;
        const Record one = top_tension(storm, taut_span, 60, s);
        s.tolerance = 1e-7;
        const Record newton = top_tension(storm, taut_span, 60, s);
        // at 0.2 s half of what is left without the prediction R:29 of lambda
        EXPECT_LT(rms_difference(one, newton), (h < 0.15 ? 1e-4 : 4.5e-4) * newton.deviation())
            << h;
    }
}

/// Size of the sawtooth: rms of the second difference over the last 2 s of 100 s, quarter of it.
double sawtooth(double h, const RodScheme& scheme) {
    Case input = standing_line(moving(fairlead, {3, 0, 0}, 15.6), slack_span);
    input.analysis.dynamics.line_step = h;
    input.analysis.dynamics.rod_scheme = scheme;
    input.analysis.dynamics.ramp = 0.0;  // the top starts with 1.2 m/s
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    std::vector<double> T;
    EXPECT_TRUE(run(rod, 100, h, [&](double t) {
                    if (t > 98) T.push_back(rod.tension_a(0));
                }).ok());
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < T.size(); ++i)
        sum += std::pow((T[i - 1] - 2 * T[i] + T[i + 1]) / 4, 2);
    return std::sqrt(sum / static_cast<double>(T.size() - 2));
}

TEST(TimeStep, ForgetsAKinkThatAdamsMoultonKeeps) {  // acceptance 8, section 5.3a
    for (const double h : {0.02, 0.05}) {
        const double damped = sawtooth(h, {}),
                     undamped = sawtooth(h, {.type = RodSchemeType::adams_moulton});
        EXPECT_LT(damped, 1e3) << h;
        EXPECT_GT(undamped, 20e3) << h;
    }
}

/// Energy of a single rod in the state kept [N.m]: kinetic, elastic and in gravity; no buoyancy.
double energy(const RodPack<Single>& rod, double L, double EA, double EI, double mass, double g) {
    const NodeState<Single>* node = rod.kept().nodes();
    const Multiplier<Single>* lambda = rod.kept().lambda();
    double sum = 0.0;
    for (int e = 0; e < rod.elements(); ++e) {
        const NodeState<Single>&a = node[e], &b = node[e + 1];
        for (std::size_t k = 0; k < gauss_points; ++k) {
            const auto& A = shape.A[k];
            const Vec3 v =
                A[0] * vec(a.v) + A[1] * L * vec(a.vd) + A[2] * vec(b.v) + A[3] * L * vec(b.vd);
            const Vec3 r =
                A[0] * vec(a.r) + A[1] * L * vec(a.d) + A[2] * vec(b.r) + A[3] * L * vec(b.d);
            const auto c = reduced_curvature(gauss_xi[k]);
            const Vec3 q0 = vec(b.r) - vec(a.r);
            const Vec3 bend = (c[0] * q0 + c[1] * L * vec(a.d) + c[2] * L * vec(b.d)) / (L * L);
            const double l = shape.P[k][0] * lambda[2 * e].now[0] +
                             shape.P[k][1] * lambda[2 * e + 1].now[0] +
                             shape.P[k][2] * lambda[2 * e + 2].now[0];
            const double T = l / (1 - l / EA);
            sum += gauss_weight[k] * L *
                   (0.5 * mass * v.squaredNorm() + mass * g * r.z() + 0.5 * T * T / EA +
                    0.5 * EI * bend.squaredNorm());
        }
    }
    return sum;
}

/// Turns the kept state of a hanging rod about its upper end, in the xz plane.
void turn(RodPack<Single>& rod, double angle) {
    const Eigen::Matrix3d Q = Eigen::AngleAxisd(-angle, Vec3::UnitY()).matrix();
    NodeState<Single>* node = rod.kept().nodes();
    for (int n = 0; n <= rod.elements(); ++n) {
        node[n].r = lanes_of(Vec3(Q * vec(node[n].r)));
        node[n].d = lanes_of(Vec3(Q * vec(node[n].d)));
    }
}

TEST(TimeStep, ASwingingCableKeepsItsEnergy) {  // table of section 14.3
    const double L = 50, EA = 1e8, m = 20, g = 9.80665;
    for (const double h : {0.02, 0.05}) {
        Case input = one_line(plain_type(m, EA), L, 20, fixed_at({0, 0, 0}), LineEnd{});
        input.environment.water.density = 0.0;
        input.analysis.dynamics.line_step = h;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        rod.newton.tolerance = 1e-7;
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        turn(rod, 38 * M_PI / 180);
        const double unit = m * g * L * L / 2, e0 = energy(rod, L / 20, EA, 0, m, g);
        double early = 0.0, largest = 0.0;
        const Status status = run(rod, 10, 0.1, [&](double t) {
            const double change = (energy(rod, L / 20, EA, 0, m, g) - e0) / unit;
            if (t < 1.05) early = change;
            largest = std::max(largest, std::abs(change - early));
        });
        ASSERT_TRUE(status.ok()) << status.t << " " << status.residual;
        // dissipation of the scheme, of second order in h
        EXPECT_LT(largest, h < 0.03 ? 1e-4 : 5e-4);
    }
}

TEST(StiffRod, SwingsLikeThePendulum) {  // validation row A13: 0.3 %, energy 0.1 % in ten periods
    const double L = 10, EA = 1e9, EI = 1e8, m = 100, g = 9.80665;
    struct Row {
        double angle, period;
    };
    for (const Row row : {Row{30, 5.2707}, Row{90, 6.1148}}) {
        Case input = one_line(plain_type(m, EA, EI), L, 4, fixed_at({0, 0, 0}), LineEnd{});
        input.environment.water.density = 0.0;
        input.analysis.dynamics.line_step = 0.02;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        turn(rod, row.angle * M_PI / 180);
        const double e0 = energy(rod, L / 4, EA, EI, m, g);
        Record tip;
        const Status status = run(rod, 10.5 * row.period, 0.1,
                                  [&](double t) { tip.add(t, rod.node_position(0, 4).x()); });
        ASSERT_TRUE(status.ok()) << status.t;
        EXPECT_NEAR(tip.period(), row.period, 0.003 * row.period);
        EXPECT_NEAR(energy(rod, L / 4, EA, EI, m, g), e0, 1e-3 * m * g * L * L / 2);
    }
}

TEST(MooringLine, InMotionAgreesWithAMeshAndStepFourTimesFiner) {  // section 14.2: within 6e-5
    Setting s;
    s.h = 0.05, s.from = 20;
    const Record coarse = top_tension(storm, slack_span, 60, s);
    s.h = 0.0125, s.refine = 4;
    const Record fine = top_tension(storm, slack_span, 60, s);
    EXPECT_NEAR(coarse.deviation(), fine.deviation(), 1e-3 * fine.deviation());
    EXPECT_NEAR(coarse.largest(), fine.largest(), 1e-3 * (fine.largest() - fine.mean()));
    EXPECT_LT(rms_difference(coarse, fine), 2e-3 * fine.deviation());
}

TEST(EndMotion, HasTheVelocityAndAccelerationOfItsPosition) {
    LineEnd top = fairlead;
    top.motion =
        EndMotion{.amplitude = {3, 1, 0.5}, .period = {15.6, 9.0, 7.0}, .phase = {0.3, -1.0, 2.0}};
    Case input = standing_line(top, taut_span);
    const double h = 0.01;
    input.analysis.dynamics.line_step = h;
    input.analysis.dynamics.ramp = 8.0;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    std::vector<PointMotion> of;
    ASSERT_TRUE(run(rod, 12, h, [&](double) {
                    const NodeState<Quad>& n = rod.kept().nodes()[rod.elements()];
                    of.push_back({.position = {n.r.x[0], n.r.y[0], n.r.z[0]},
                                  .velocity = {n.v.x[0], n.v.y[0], n.v.z[0]},
                                  .acceleration = {n.a.x[0], n.a.y[0], n.a.z[0]}});
                }).ok());
    double fastest = 0.0;
    for (std::size_t i = 1; i + 1 < of.size(); ++i) {
        const Vec3 v = (of[i + 1].position - of[i - 1].position) / (2 * h);
        const Vec3 a = (of[i + 1].velocity - of[i - 1].velocity) / (2 * h);
        // h^2/6 times the next derivatives; and where the ramp ends its third derivative jumps by
        // 60/ramp^3, times 3 m and h/4
        EXPECT_LT((v - of[i].velocity).norm(), 1e-4) << i;
        EXPECT_LT((a - of[i].acceleration).norm(), 1e-3) << i;
        fastest = std::max(fastest, of[i].velocity.norm());
    }
    EXPECT_GT(fastest, 1.2);
    // after the ramp: amplitude sin(2 pi t/period + phase), here surge at 12 s
    EXPECT_NEAR(of.back().position.x(), 3 * std::sin(2 * M_PI * 12 / 15.6 + 0.3), 1e-9);
}

TEST(TimeStep, PassesTakeTheFewestEqualSteps) {  // R:28
    Case input = standing_line(fairlead, taut_span);
    input.analysis.dynamics.line_step = 0.02;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const PlatformMotion still;
    for (const double t1 : {0.25, 0.25, 0.5, 0.5})  // the four passes of a platform step of 0.5 s
        ASSERT_TRUE(rod.pass(0, t1, MotionSpline(0, still, t1, still)).ok());
    EXPECT_EQ(rod.work().steps, 13 + 13 + 25 + 25);
    EXPECT_EQ(rod.work().passes, 4);
    EXPECT_DOUBLE_EQ(rod.work().rod_time, 3 * 0.5);
}

TEST(TimeStep, HalvedStepsGiveThePlatformTheSameForce) {  // P:5: the fit's weights sum to one
    LineEnd top;
    top.kind = EndKind::platform;
    top.position = {0, 0, -100};
    Case input = standing_line(top, taut_span);
    input.analysis.dynamics.line_step = 0.1;
    for (LineType& type : input.line_types) type.damping_ratio = 0.01;
    PlatformMotion from, to;
    to.position.x() = -0.1, to.velocity.x() = -0.4;
    const Sea sea = still_sea(input);
    const auto pull = [&](double tolerance, std::int64_t& steps) {
        RodPack<Quad> rod(input, sea, {0});
        EXPECT_TRUE(rod.equilibrium({}, false).ok());
        rod.newton.tolerance = tolerance;
        rod.newton.max_iterations = 1;  // a correction beyond the tolerance halves the step at once
        EXPECT_TRUE(rod.pass(0, 0.5, MotionSpline(0, from, 0.5, to)).ok());
        steps = rod.work().steps;
        return Vec6(rod.pass_wrench(0));
    };
    std::int64_t whole_steps = 0, halved_steps = 0;
    const Vec6 whole = pull(1.0, whole_steps), halved = pull(2e-4, halved_steps);
    EXPECT_EQ(whole_steps, 5);
    EXPECT_GT(halved_steps, 15);  // twice over
    EXPECT_LT((halved - whole).norm(), 5e-3 * whole.norm());
}

TEST(TimeStep, ALineStretchedSlowlyPastTwiceItsLengthFails) {
    // Beyond s lambda = 0.5 (R:6) the stretch law has no solution left: Newton must not settle
    // there.
    LineEnd a = fixed_at({0, 0, -10}), b = fixed_at({-10.5, 0, -10});
    EndMotion motion;
    motion.amplitude = {15.0, 0, 0};
    motion.period = {400.0, 1, 1};
    a.motion = motion;
    Case input = one_line(plain_type(1.0, 1e4), 10.0, 4, a, b);
    input.analysis.dynamics.ramp = 0.0;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const PlatformMotion still;
    double t = 0.0;
    Status status;
    for (; t < 100.0 && status.ok(); t += 0.5) {
        status = rod.pass(t, t + 0.5, MotionSpline(t, still, t + 0.5, still));
        if (status.ok()) rod.keep();
    }
    ASSERT_FALSE(status.ok());
    const double stretched = 10.5 + 15.0 * std::sin(2 * M_PI * status.t / 400);
    EXPECT_NEAR(stretched, 20.0, 0.2);  // one platform step moves the end by 0.12 m
}

}  // namespace
}  // namespace hawser::worker
