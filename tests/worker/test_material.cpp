// The two-modulus rope, a standard linear solid: R:4, R:35, R:36; validation row A21.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

constexpr double EA_d = 706.32e6, EA_s = 451.26e6, K_c = EA_d * EA_s / (EA_d - EA_s);
constexpr double length = 100.0;

/// A nearly massless rope: nothing but the material acts.
LineType rope(double relaxation_time) {
    LineType type = plain_type(1e-3, EA_d);
    type.viscoelastic = Viscoelastic{EA_d, EA_s, relaxation_time};
    return type;
}
Case taut(double relaxation_time, double strain, LineEnd a) {
    a.position = {length * (1 + strain), 0, 0};
    Case input = one_line(rope(relaxation_time), length, 2, a, fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 1e-9;
    return input;
}

TEST(TwoModulusRope, StepOfStrainRelaxesWithTheRelaxationTime) {  // R:35, R:36
    const double tau_r = 20.0, e0 = 0.002, step = 0.003, quick = 1e-3;
    LineEnd a;
    a.kind = EndKind::platform;
    Case input = taut(tau_r, e0, a);
    input.analysis.dynamics.line_step = 0.05;
    input.lines[0].end_a.joint = Joint::ball;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_NEAR(rod.tension_a(0), EA_s * e0, 1e-6 * EA_s * e0);
    const PlatformMotion before;
    PlatformMotion after;
    after.position.x() = step * length;
    ASSERT_TRUE(rod.pass(0, quick, MotionSpline(0, before, quick, after)).ok());
    rod.keep();
    for (int k = 0; k < 160; ++k) {
        const double t0 = quick + 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, after, t1, after)).ok());
        rod.keep();
        // the step is an instant: 1e-3 s are 5e-5 of tau_r
        const double modulus = (rod.tension_a(0) - EA_s * e0) / step;
        const double exact = EA_s + (EA_d - EA_s) * std::exp(-(t1 - quick / 2) / tau_r);
        EXPECT_NEAR(modulus, exact, 1e-3 * exact) << t1;
    }
}

TEST(TwoModulusRope, StepOfTensionCreepsWithTheRetardationTime) {  // R:36: tau = 1.5652 tau_r
    const double tau_r = 20.0, tau = tau_r * EA_d / EA_s, weight = 1e6;
    Case input = one_line(rope(tau_r), length, 4, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.density = 0.0;
    input.lines[0].attachments = {{.arc_length = length, .mass = weight / 9.80665}};
    input.analysis.dynamics.line_step = 0.05;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    EXPECT_NEAR(-rod.node_position(0, 4).z(), length * (1 + weight / EA_s), 1e-5);
    // The same weight an instant after it came on: no creep yet, creeping at T/(K_c tau)
    const double e = weight / EA_d, rate = weight / (K_c * tau);
    NodeState<Single>* node = rod.kept().nodes();
    for (int n = 0; n <= 4; ++n) {
        const double s = length * (4 - n) / 4.0;
        node[n].r = lanes_of(Vec3(0, 0, -s * (1 + e))), node[n].d = lanes_of(Vec3(0, 0, 1 + e));
        node[n].v = lanes_of(Vec3(0, 0, -s * rate)), node[n].vd = lanes_of(Vec3(0, 0, rate));
    }
    for (int i = 0; i < 9; ++i)
        rod.kept().lambda()[i].now = rod.kept().lambda()[i].before = weight / (1 + e);
    for (int i = 0; i < 16; ++i)
        rod.kept().strain()[i] = {.damper = e, .damper_rate = 0, .creep = 0, .creep_rate = rate};
    ASSERT_TRUE(run(rod, 100, 1.0, [&](double t) {
                    const double strain = -rod.node_position(0, 4).z() / length - 1;
                    const double exact = e + weight / K_c * (1 - std::exp(-t / tau));
                    // the weight bobs by rate/omega (8 rad/s) x w/g of it: 0.03 % of the creep
                    EXPECT_NEAR(strain, exact, 1e-3 * exact) << t;
                }).ok());
}

TEST(TwoModulusRope, HasTheStorageAndLossModulusOfTheStandardSolid) {  // validation row A21: 0.1 %
    struct Row {
        double tau_r, storage, loss;
    };
    for (const Row row : {Row{2.5, 579.67e6, 127.53e6}, Row{20, 702.45e6, 31.18e6}}) {
        const double period = 15.6, w = 2 * M_PI / period, e0 = 0.01, a = 0.002;
        Case input = taut(row.tau_r, e0, moving(fixed_at({0, 0, 0}), {a * length, 0, 0}, period));
        input.analysis.dynamics.line_step = 0.1;
        input.analysis.dynamics.ramp = 15.6;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        // after the ramp and 10 relaxation times, two periods: mean, in phase, out of phase
        const double from = 14 * period;
        Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
        Vec3 b = Vec3::Zero();
        ASSERT_TRUE(run(rod, 16 * period, 0.2, [&](double t) {
                        if (t < from) return;
                        const Vec3 basis(1, std::sin(w * t), std::cos(w * t));
                        N += basis * basis.transpose();
                        b += basis * rod.tension_a(0);
                    }).ok());
        const Vec3 fit = N.inverse() * b;
        EXPECT_NEAR(fit[1] / a, row.storage, 1e-3 * row.storage) << row.tau_r;
        EXPECT_NEAR(fit[2] / a, row.loss, 1e-3 * row.loss) << row.tau_r;
        EXPECT_NEAR(fit[0], EA_s * e0, 1e-3 * EA_s * e0) << row.tau_r;
    }
}

TEST(DualStiffness, StretchesStaticallyThenAnswersDynamically) {  // R:39
    const double e0 = 0.002, step = 0.003, quick = 1e-3;
    LineEnd a;
    a.kind = EndKind::platform;
    Case input = taut(0.0, e0, a);
    input.line_types[0].viscoelastic->model = RopeLaw::dual_stiffness;
    input.analysis.dynamics.line_step = 0.05;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double T0 = EA_s * e0;
    EXPECT_NEAR(rod.tension_a(0), T0, 1e-6 * T0);
    const PlatformMotion before;
    PlatformMotion after;
    after.position.x() = step * length;
    ASSERT_TRUE(rod.pass(0, quick, MotionSpline(0, before, quick, after)).ok());
    rod.keep();
    for (int k = 0; k < 2000; ++k) {  // it keeps: nothing creeps in 1000 s
        const double t0 = quick + 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, after, t1, after)).ok());
        rod.keep();
        // the jerk of the step rings in its axial modes at first
        EXPECT_NEAR(rod.tension_a(0), T0 + EA_d * step, 1e-5 * EA_d * step) << t1;
    }
}

TEST(StructuralDamping, StrainLagsByTheRetardationTimeAndForgetsAKink) {  // R:4 with g of R:27
    // A sudden start of the end at 1 m/s: the rate of strain must not go on changing its sign
    LineType type = plain_type(1e-3, EA_d);
    type.axial_damping = 0.05 * EA_d;  // c/EA = 0.05 s
    LineEnd a = moving(fixed_at({length * 1.01, 0, 0}), {1, 0, 0}, 2 * M_PI);
    Case input = one_line(type, length, 2, a, fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 1e-9;
    input.analysis.dynamics.line_step = 0.02;
    input.analysis.dynamics.ramp = 0.0;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    double worst = 0.0;
    ASSERT_TRUE(run(rod, 4, 0.02, [&](double t) {
                    // T = EA e + c e_t with e = 0.01 + sin(t)/100
                    const double exact =
                        EA_d * (0.01 + std::sin(t) / length) + 0.05 * EA_d * std::cos(t) / length;
                    if (t > 1) worst = std::max(worst, std::abs(rod.tension_a(0) - exact));
                }).ok());
    // (g - 1/2) h w of the damper's share, R:5: 1e-3 of 350 kN
    EXPECT_LT(worst, 1.5e-3 * 0.05 * EA_d / length);
}

}  // namespace
}  // namespace hawser::worker
