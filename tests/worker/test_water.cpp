// Rods in the water: towed cable, terminal speed, free surface, Froude-Krylov and Morison loads,
// one clock of wave samples for all passes (R:16, R:18, R:19).
#include <gtest/gtest.h>

#include <cmath>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

Current uniform(double speed, double heading = 0.0) {
    return {.heading = heading, .profile = {{.depth = 0, .speed = speed}}};
}

/// Cable of validation row A15: submerged weight 200 N/m, D 0.1 m, Cd 1.2.
LineType towed_type() {
    LineType type = plain_type(200 / 9.80665, 1e9);
    type.drag_diameter = 0.1, type.drag_normal = 1.2;
    return type;
}

TEST(TowedCable, HangsStraightAtTheAngleOfItsDrag) {  // validation row A15: 0.1 deg
    struct Row {
        double speed, angle;
    };
    for (const Row row : {Row{0.5, 85.617}, Row{1, 73.567}, Row{1.5, 59.261}, Row{2, 47.704},
                          Row{4, 25.375}}) {  // the last from k sin^2 p = cos p
        Case input = one_line(towed_type(), 200, 20, fixed_at({0, 0, -10}), LineEnd{});
        input.environment.current = uniform(row.speed);
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, true).ok()) << row.speed;
        for (const int n : {1, 10, 19}) {
            const Vec3 u = rod.node_position(0, n + 1) - rod.node_position(0, n - 1);
            EXPECT_NEAR(std::atan2(-u.z(), u.x()) * 180 / M_PI, row.angle, 0.1) << row.speed;
        }
    }
}

TEST(TowedCable, FeelsItsOwnSpeedAsACurrent) {  // R:16: relative velocity
    Case towed = one_line(towed_type(), 200, 20, fixed_at({0, 0, -10}), LineEnd{});
    towed.lines[0].end_a.kind = EndKind::platform;
    Case held = towed;
    held.environment.current = uniform(1.5);
    towed.analysis.dynamics.line_step = held.analysis.dynamics.line_step = 0.05;
    const Sea still = still_sea(towed), stream = still_sea(held);
    RodPack<Single> at_rest(held, stream, {0}), moving_on(towed, still, {0});
    ASSERT_TRUE(at_rest.equilibrium({}, true).ok());
    ASSERT_TRUE(moving_on.equilibrium({}, false).ok());
    for (int n = 0; n <= 20; ++n) {  // the same shape, all of it at -1.5 m/s
        moving_on.kept().nodes()[n] = at_rest.kept().nodes()[n];
        moving_on.kept().nodes()[n].v = lanes_of({-1.5, 0, 0});
    }
    for (int i = 0; i <= 40; ++i) moving_on.kept().lambda()[i] = at_rest.kept().lambda()[i];
    for (int k = 0; k < 20; ++k) {
        const double t0 = 0.5 * k, t1 = t0 + 0.5;
        PlatformMotion from, to;
        from.position.x() = -1.5 * t0, to.position.x() = -1.5 * t1;
        from.velocity.x() = to.velocity.x() = -1.5;
        ASSERT_TRUE(moving_on.pass(t0, t1, MotionSpline(t0, from, t1, to)).ok());
        moving_on.keep();
    }
    for (int n = 0; n <= 20; ++n)
        EXPECT_LT(
            (moving_on.node_position(0, n) + Vec3(15, 0, 0) - at_rest.node_position(0, n)).norm(),
            1e-6)
            << n;
    EXPECT_NEAR(moving_on.tension_a(0), at_rest.tension_a(0), 1e-6 * at_rest.tension_a(0));
}

TEST(FallingRod, StartsWithItsAxialMassAndReachesItsAxialTerminalSpeed) {  // R:16, acceptance 14
    LineType type = plain_type(30, 1e8, 1e4);
    type.displaced_area = 0.01, type.added_mass_normal = 1.0, type.added_mass_axial = 0.4;
    type.drag_diameter = 0.1, type.drag_normal = 1.2, type.drag_axial = 0.5;
    Case input = one_line(type, 20, 5, LineEnd{}, LineEnd{});
    input.analysis.dynamics.line_step = 0.01;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 5; n >= 0; --n)
        nodes.push_back(
            {.position = Vec3(0, 0, -100 - 4.0 * n), .tangent = Vec3::UnitZ(), .tension = 1e-3});
    rod.set_guess(0, nodes);
    const double rho = 1025, g = 9.80665, weight = (30 - rho * 0.01) * g;
    const double mass = 30 + 0.4 * rho * 0.01, ct = 0.5 * rho * 0.5 * 0.1;
    const double terminal = std::sqrt(weight / ct), scale = mass * terminal / weight;
    for (int n = 0; n <= 5; ++n)
        rod.kept().nodes()[n].a = rod.kept().nodes()[n].A = lanes_of({0, 0, -weight / mass});
    ASSERT_TRUE(run(rod, 0.01, 0.01).ok());
    // the balance holds at the end of the step, where drag has grown to (a h)^2 ct
    EXPECT_NEAR(-rod.kept().nodes()[3].a.z[0], weight / mass, 1e-3 * weight / mass);
    const PlatformMotion still;
    for (int k = 1; k < 2000; ++k) {
        const double t0 = 0.01 * k, t1 = 0.01 * (k + 1);
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, still, t1, still)).ok());
        rod.keep();
        // m v' = w - ct v^2: v = terminal tanh(t/scale)
        const double exact = terminal * std::tanh(t1 / scale);
        ASSERT_NEAR(-rod.kept().nodes()[k % 6].v.z[0], exact, 1e-3 * exact) << t1;
    }
    EXPECT_NEAR(-rod.kept().nodes()[2].v.z[0], terminal, 1e-3 * terminal);
    EXPECT_NEAR(rod.node_position(0, 0).x(), 0.0, 1e-9);
}

TEST(FreeSurface, WeightOnTheSupportFollowsTheDraft) {  // R:18, acceptance 15: 4 % of an element
    LineType type = plain_type(200, 1e9, 1e4);
    type.displaced_area = 0.1, type.outer_diameter = 0.2;  // D = L/10
    const double L = 20, dry = 200 * 9.80665 * L, buoyancy = 1025 * 0.1 * 9.80665;
    for (double draft = 0.0; draft <= 19.0; draft += 0.37) {
        Case input = one_line(type, L, 10, fixed_at({0, 0, L - draft}), LineEnd{});
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok()) << draft;
        const double miss =
            std::abs(-rod.force_on_support_a(0).z() - dry + buoyancy * draft) / (buoyancy * L / 10);
        EXPECT_LT(miss, 0.04 + (draft == 0.0 ? 0.005 : 0.0)) << draft;  // 4.3 % at its very end
    }
}

TEST(FreeSurface, ARodAboveItHangsInStillAir) {  // acceptance 15
    LineType type = plain_type(200, 1e9, 1e4);
    type.displaced_area = 0.1, type.drag_diameter = 0.3, type.drag_normal = 1.2;
    Case input = one_line(type, 20, 10, fixed_at({0, 0, 30}), LineEnd{});
    input.environment.seabed.depth = 1000;
    input.environment.current = uniform(2.0);
    input.environment.waves = {WaveTrain{.type = WaveType::airy, .H = 8, .T = 10}};
    const Sea sea(input.environment, 4.0, 0.0);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, true).ok());
    ASSERT_TRUE(run(rod, 10, 0.5, [&](double) {
                    EXPECT_NEAR(rod.node_position(0, 10).x(), 0.0, 1e-9);
                    EXPECT_NEAR(rod.tension_a(0), 200 * 9.80665 * 20, 1e-3);
                }).ok());
}

/// Taut short rod across the waves (along y), fully submerged, in a regular wave.
Case in_waves(double height, double wave_step) {
    LineType type = plain_type(50, 1e9);
    type.displaced_area = 0.04, type.added_mass_normal = 1.0, type.drag_diameter = 0.2;
    const double T = 5e6, L = 10;
    Case input = one_line(type, L, 4, fixed_at({0, L * (1 + T / 1e9) / 2, -20}),
                          fixed_at({0, -L * (1 + T / 1e9) / 2, -20}), 1000);
    input.environment.waves = {
        WaveTrain{.type = WaveType::airy, .H = height, .T = 10, .stretching = Stretching::none}};
    input.analysis.dynamics.wave_step = wave_step;
    input.analysis.dynamics.line_step = 0.05;
    input.analysis.dynamics.ramp = 0.0;
    return input;
}

TEST(WaveLoads, AreFroudeKrylovAddedMassAndDrag) {  // R:16, R:19
    for (const double Cd : {0.0, 1.5}) {
        Case input = in_waves(4.0, 0.1);
        input.line_types[0].drag_normal = Cd;
        const Sea sea(input.environment, 4.0, 0.0);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        const double w = 2 * M_PI / 10, k = w * w / 9.80665, decay = std::exp(-k * 20), L = 10;
        const double speed = 2.0 * w * decay, rho = 1025;
        Record force;
        double worst = 0.0, largest = 0.0;
        ASSERT_TRUE(run(rod, 20, 0.5, [&](double t) {
                        if (t < 5) return;  // after the ramp
                        // deep water: u = a w e^kz (cos, 0, -sin)(wt) at x = 0
                        const Vec3 u = speed * Vec3(std::cos(w * t), 0, -std::sin(w * t));
                        const Vec3 ud = speed * w * Vec3(-std::sin(w * t), 0, -std::cos(w * t));
                        const double c = 0.5 * rho * Cd * 0.2;
                        const Vec3 f = rho * 0.04 * 2.0 * ud + c * u.norm() * u +
                                       Vec3(0, 0, -(50 - rho * 0.04) * 9.80665);
                        const Vec3 got = rod.force_on_support_a(0) + rod.force_on_support_b(0);
                        worst = std::max(worst, (got - L * f).norm());
                        largest =
                            std::max(largest, (L * u.norm() * c * u + L * rho * 0.08 * ud).norm());
                    }).ok());
        // linear between samples: (w dt)^2/8 = 5e-4; the rod gives way by millimetres
        EXPECT_LT(worst, 0.01 * largest) << Cd;
    }
}

TEST(WaveLoads,
     AreSampledOnceForAllPassesAtTheStatedRate) {  // P:5w; acceptance 17: elements x 4 / dt
    for (const double wave_step : {0.25, 0.4}) {
        const Case input = in_waves(4.0, wave_step);
        const Sea sea(input.environment, 4.0, 0.0);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        const PlatformMotion still;
        const auto step = [&](int k) {
            const double t = 0.5 * k;
            for (const double H : {0.25, 0.25, 0.5, 0.5})
                ASSERT_TRUE(rod.pass(t, t + H, MotionSpline(t, still, t + H, still)).ok());
            rod.keep();
        };
        for (int k = 0; k < 4; ++k) step(k);  // from 0 to 2 s, and the left end
        const auto first = static_cast<long>(rod.work().water_samples);
        EXPECT_EQ(first, 4 * gauss_points * std::lround(2.0 / wave_step + 1));
        for (int k = 4; k < 24; ++k) step(k);
        EXPECT_EQ(static_cast<long>(rod.work().water_samples) - first,
                  4 * gauss_points * std::lround(10.0 / wave_step));
    }
}

TEST(WaveLoads, AreSampledWhereTheRodWillBe) {  // R:19: at r + (T - t) v of the kept state
    const Case input = in_waves(4.0, 0.25);
    const Sea sea(input.environment, 0.0, 0.0);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const Vec3 v(6.0, 0.0, -2.0);
    for (int n = 0; n <= rod.elements(); ++n) rod.kept().nodes()[n].v = lanes_of(v);
    const Vec3 end_b = vec(rod.kept().nodes()[0].r), end_a = vec(rod.kept().nodes()[4].r);
    const PlatformMotion still;
    (void)rod.pass(0, 0.5, MotionSpline(0, still, 0.5, still));  // its ends stand: only the samples
    for (std::size_t j = 0; j <= 2; ++j) {
        const double T = 0.25 * static_cast<double>(j);
        for (const std::size_t g :
             {std::size_t{0}, std::size_t{2}}) {  // points of the first element
            const Vec3 x = end_b + gauss_xi[g] / 4 * (end_a - end_b) + T * v;
            double out[7];
            sea.sample(T, 1, &x.x(), &x.y(), &x.z(),
                       {&out[0], &out[1], &out[2], &out[3], &out[4], &out[5], &out[6]});
            const Water<Single>& water = rod.kept().water(j)[g];
            // the line sags by 0.2 mm
            EXPECT_LT((vec(water.u) - Vec3(out[0], out[1], out[2])).norm(), 1e-4) << T;
            EXPECT_LT((vec(water.ud) - Vec3(out[3], out[4], out[5])).norm(), 1e-4) << T;
        }
    }
}

TEST(WaveLoads, AreContinuousInTime) {  // R:19: the old right end is the new left end
    Case input = in_waves(6.0, 0.25);
    input.line_types[0].drag_normal = 1.2;
    input.analysis.dynamics.line_step = 0.0125;
    const Sea sea(input.environment, 4.0, 0.0);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    std::vector<double> fx;
    ASSERT_TRUE(run(rod, 20, 0.0125, [&](double t) {
                    if (t > 5)
                        fx.push_back(rod.force_on_support_a(0).x() + rod.force_on_support_b(0).x());
                }).ok());
    double steepest = 0.0, amplitude = 0.0;
    for (std::size_t i = 1; i < fx.size(); ++i) {
        steepest = std::max(steepest, std::abs(fx[i] - fx[i - 1]));
        amplitude = std::max(amplitude, std::abs(fx[i]));
    }
    // a harmonic of 10 s changes by w dt = 0.8 % of its amplitude per step; drag steepens it
    EXPECT_LT(steepest, 0.02 * amplitude);
}

}  // namespace
}  // namespace hawser::worker
