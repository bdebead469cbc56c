// Validation rows A13, A18, A20, A21: rods in motion through the kernel, where the motion of an end
// is not a harmonic that a case file can give.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "validation/reference.hpp"
#include "validation/row.hpp"
#include "worker/rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Energy of a stiff rod in the kept state [N.m]: kinetic and in gravity.
double energy(const RodPack<Single>& rod, double L, double mass, double g) {
    const NodeState<Single>* node = rod.kept().nodes();
    double sum = 0.0;
    for (int e = 0; e < rod.elements(); ++e) {
        const NodeState<Single>&a = node[e], &b = node[e + 1];
        for (std::size_t k = 0; k < gauss_points; ++k) {
            const auto& A = shape.A[k];
            const Vec3 v =
                A[0] * vec(a.v) + A[1] * L * vec(a.vd) + A[2] * vec(b.v) + A[3] * L * vec(b.vd);
            const Vec3 r =
                A[0] * vec(a.r) + A[1] * L * vec(a.d) + A[2] * vec(b.r) + A[3] * L * vec(b.d);
            sum += gauss_weight[k] * L * (0.5 * mass * v.squaredNorm() + mass * g * r.z());
        }
    }
    return sum;
}

TEST(ValidationA13, RodSwingsAsThePendulum) {  // elliptic integrals
    const double L = 10, EA = 1e9, EI = 1e8, m = 100, g = 9.80665;
    struct Row {
        double angle, period;
        const char *period_is, *energy_is;
    };
    for (const Row row : {Row{30, 5.2707, "period from 30 deg [s]",
                              "energy lost in ten periods from 30 deg, of m g L2/2"},
                          Row{90, 6.1148, "period from 90 deg [s]",
                              "energy lost in ten periods from 90 deg, of m g L2/2"}}) {
        Case input = one_line(plain_type(m, EA, EI), L, 4, fixed_at({0, 0, 0}), LineEnd{});
        input.environment.water.density = 0.0;
        input.analysis.dynamics.line_step = 0.02;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        const Mat3 Q = Eigen::AngleAxisd(-row.angle * M_PI / 180, Vec3::UnitY()).matrix();
        NodeState<Single>* node = rod.kept().nodes();
        for (int n = 0; n <= 4; ++n) {
            node[n].r = lanes_of(Vec3(Q * vec(node[n].r)));
            node[n].d = lanes_of(Vec3(Q * vec(node[n].d)));
        }
        const double e0 = energy(rod, L / 4, m, g), unit = m * g * L * L / 2;
        Record tip;
        ASSERT_TRUE(run(rod, 10.5 * row.period, 0.1, [&](double t) {
                        tip.add(t, rod.node_position(0, 4).x());
                    }).ok());
        validate({"A13", row.period_is, row.period, tip.period(), 3e-3});
        validate({"A13", row.energy_is, 0, (energy(rod, L / 4, m, g) - e0) / unit, 1e-3, false});
    }
}

/// The reference line of validation rows A2 and A18 with its fairlead on a platform.
Case reference_line() {
    LineType chain = plain_type(588.7, 3.07119e9), rope = plain_type(66.0, 706.32e6);
    chain.displaced_area = M_PI / 4 * 0.3096 * 0.3096;
    chain.drag_diameter = 0.3096, chain.drag_normal = 1.333, chain.drag_axial = 0.64 * M_PI;
    rope.displaced_area = M_PI / 4 * 0.2474 * 0.2474;
    rope.drag_diameter = 0.2474, rope.drag_normal = 1.2;
    for (LineType* type : {&chain, &rope})
        type->added_mass_normal = 1.0, type->damping_ratio = 0.01;
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = {0, 0, -50};
    Case input = one_line(chain, 91, 6, a, fixed_at({2040, 0, -1500}), 3000);
    input.line_types.push_back(rope);
    input.lines[0].sections = {{.type = 0, .length = 91, .elements = 6},
                               {.type = 1, .length = 2286, .elements = 60},
                               {.type = 0, .length = 122, .elements = 8}};
    return input;
}

TEST(ValidationA18, ReferenceLineAsTheOtherProgramWasDriven) {
    // MoorDyn was told the fairlead's place every 0.1 s and carries it on at constant speed
    // between. The speed is then wrong by a w dt/2 at the times of its output, and this times the
    // chain's impedance sqrt(EA m) is some 35 kN in phase with the acceleration. The same here.
    const double w = 2 * M_PI / 15.6, dt = 0.1;
    const Case input = reference_line();
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const double half_segment = rod.tension_a(0) - 2884.75e3;  // its tension is told in mid-segment
    const auto place = [&](double t) {
        const double r = std::min(1.0, t / 31.2);
        return Vec3(r * r * (3 - 2 * r) * Vec3(3 * std::sin(w * t), 0, 2 * std::cos(w * t)));
    };
    double least = 1e12, greatest = 0.0;
    for (int k = 0; k < 1250; ++k) {
        const double t0 = dt * k, t1 = dt * (k + 1);
        PlatformMotion from, to;
        from.position = place(t0), to.position = place(t1);
        from.velocity = to.velocity = (to.position - from.position) / dt;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, from, t1, to)).ok()) << t0;
        rod.keep();
        if (t1 < 125 - 15.6) continue;
        least = std::min(least, rod.tension_a(0) - half_segment);
        greatest = std::max(greatest, rod.tension_a(0) - half_segment);
    }
    const double range = 3574.0e3 - 2274.8e3;
    validate({"A18",
              "reference line, 15.6 s, straight from sample to sample: least, error of range [N]",
              0, (least - 2274.8e3) / range, 3e-2, false});
    validate(
        {"A18",
         "reference line, 15.6 s, straight from sample to sample: greatest, error of range [N]", 0,
         (greatest - 3574.0e3) / range, 3e-2, false});
}

TEST(ValidationA20, PolyesterLineUnderARamp) {  // MoorDyn's tests: polyester
    struct Row {
        double t, load;
        const char* what;
    };
    const Row rows[] = {{320, .0958, "mean tension over MBL at 320 s"},
                        {640, .1982, "mean tension over MBL at 640 s"},
                        {960, .2986, "mean tension over MBL at 960 s"},
                        {1280, .3988, "mean tension over MBL at 1280 s"},
                        {1599, .4988, "mean tension over MBL at 1599 s"}};
    const std::string folder = reference_folder();
    if (folder.empty()) {
        for (const Row& row : rows) skip_row("A20", row.what);
        GTEST_SKIP();
    }
    const auto ramp = read_table(folder + "/polyester/ramp_motion.csv");
    ASSERT_GT(ramp.size(), 1599U);
    const double MBL = 25.3e6, EA = 13.4 * MBL;
    LineType rope = plain_type(52, EA);
    rope.displaced_area = M_PI / 4 * 0.217 * 0.217;
    rope.drag_diameter = 0.217, rope.drag_normal = 1.2, rope.added_mass_normal = 1.0;
    rope.damping_ratio = 0.05;
    LineEnd a;
    a.kind = EndKind::platform;
    a.position = {ramp[0][1], 0, -18};
    Case input = one_line(rope, 1400, 40, a, fixed_at({0, 0, -372.192}), 3000);
    input.analysis.dynamics.line_step = 0.1;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const Row* row = rows;
    const auto motion = [&](std::size_t k) {  // place and speed at a sample
        PlatformMotion at;
        const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, ramp.size() - 1);
        at.position.x() = ramp[k][1] - ramp[0][1];
        at.velocity.x() = (ramp[after][1] - ramp[before][1]) / (ramp[after][0] - ramp[before][0]);
        return at;
    };
    for (std::size_t k = 0; k + 1 < ramp.size(); ++k) {
        const double t0 = ramp[k][0], t1 = ramp[k + 1][0];
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, motion(k), t1, motion(k + 1))).ok()) << t0;
        rod.keep();
        if (row == std::end(rows) || t1 < row->t - 0.5) continue;
        double sum = 0.0;  // Simpson over lambda, which is T less the stretch of it
        for (int e = 0; e < rod.elements(); ++e) {
            const auto tension = [&](int i) {
                const double l = rod.kept().lambda()[2 * e + i].now[0];
                return l / (1 - l / EA);
            };
            sum += (tension(0) + 4 * tension(1) + tension(2)) / 6;
        }
        validate({"A20", row->what, row->load, sum / rod.elements() / MBL, 5e-3, false});
        ++row;
    }
}

constexpr double EA_d = 706.32e6, EA_s = 451.26e6;

/// A nearly massless rope of two moduli: nothing but the material acts.
Case rope_of_two_moduli(double relaxation_time, double strain, LineEnd a) {
    LineType type = plain_type(1e-3, EA_d);
    type.viscoelastic =
        Viscoelastic{.EA_dynamic = EA_d, .EA_static = EA_s, .relaxation_time = relaxation_time};
    a.position = {100 * (1 + strain), 0, 0};
    Case input = one_line(type, 100, 2, a, fixed_at({0, 0, 0}));
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 1e-9;
    return input;
}

TEST(ValidationA21, RopeOfTwoModuliInHarmonicStrain) {  // standard linear solid
    struct Row {
        double tau_r, storage, loss;
        const char *storage_is, *loss_is;
    };
    for (const Row row : {Row{2.5, 579.67, 127.53, "storage modulus, 15.6 s, tau_r 2.5 s [MN]",
                              "loss modulus, 15.6 s, tau_r 2.5 s [MN]"},
                          Row{20, 702.45, 31.18, "storage modulus, 15.6 s, tau_r 20 s [MN]",
                              "loss modulus, 15.6 s, tau_r 20 s [MN]"}}) {
        const double period = 15.6, w = 2 * M_PI / period, e0 = 0.01, a = 0.002;
        Case input =
            rope_of_two_moduli(row.tau_r, e0, moving(fixed_at({0, 0, 0}), {100 * a, 0, 0}, period));
        input.analysis.dynamics.line_step = 0.1;
        input.analysis.dynamics.ramp = 15.6;
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        Mat3 N = Mat3::Zero();
        Vec3 b = Vec3::Zero();
        ASSERT_TRUE(run(rod, 16 * period, 0.2, [&](double t) {
                        if (t < 14 * period) return;
                        const Vec3 basis(1, std::sin(w * t), std::cos(w * t));
                        N += basis * basis.transpose();
                        b += basis * rod.tension_a(0);
                    }).ok());
        const Vec3 fit = N.inverse() * b;
        validate({"A21", row.storage_is, row.storage, fit[1] / a / 1e6, 1e-3});
        validate({"A21", row.loss_is, row.loss, fit[2] / a / 1e6, 1e-3});
    }
}

TEST(ValidationA21, RopeOfTwoModuliAfterAStepOfStrain) {
    const double tau_r = 20.0, e0 = 0.002, step = 0.003, quick = 1e-3;
    LineEnd a;
    a.kind = EndKind::platform;
    Case input = rope_of_two_moduli(tau_r, e0, a);
    input.analysis.dynamics.line_step = 0.05;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const PlatformMotion before;
    PlatformMotion after;
    after.position.x() = step * 100;
    ASSERT_TRUE(rod.pass(0, quick, MotionSpline(0, before, quick, after)).ok());
    rod.keep();
    const auto modulus = [&] { return (rod.tension_a(0) - EA_s * e0) / step / 1e6; };
    double worst = 0.0;
    for (int k = 0; k < 400; ++k) {
        const double t0 = quick + 0.5 * k, t1 = t0 + 0.5;
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, after, t1, after)).ok());
        rod.keep();
        const double exact = (EA_s + (EA_d - EA_s) * std::exp(-(t1 - quick / 2) / tau_r)) / 1e6;
        worst = std::max(worst, std::abs(modulus() / exact - 1));
        if (k > 0) continue;  // half a second later, carried back to the step
        const double at_once =
            EA_s / 1e6 + (modulus() - EA_s / 1e6) * std::exp((t1 - quick / 2) / tau_r);
        validate({"A21", "modulus at once after a step of strain [MN]", 706.32, at_once, 1e-3});
    }
    validate(
        {"A21", "modulus 200 s after a step of strain, tau_r 20 s [MN]", 451.26, modulus(), 1e-3});
    validate({"A21", "largest error of the exponential between", 0, worst, 1e-3, false});
}

}  // namespace
}  // namespace hawser::worker
