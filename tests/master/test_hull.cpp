// The free spar hull of validation row B2: stiffness, periods, response, invariance.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "spar_hull.hpp"

namespace hawser::master {
namespace {

TEST(FreeHull, CrossingSeasLoadItWithTheSumOfBoth) {  // first order is linear
    const auto load = [](const std::vector<WaveTrain>& trains) {
        Case c = spar_case();
        c.analysis.dynamics.ramp = 0;
        c.environment.waves = trains;
        return Vec6(Hull(c, &spar_data()).loads(7.0, State::Zero())[Load::wave1]);
    };
    WaveTrain sea = paper_sea(), cross = paper_sea(2), swell = regular_wave(0.45, 2);
    cross.heading = 1.3, swell.heading = -2.0;
    const Vec6 sum = load({sea}) + load({cross}) + load({swell});
    EXPECT_LT((load({sea, cross, swell}) - sum).norm(), 1e-9 * sum.norm());
    EXPECT_LT((load({swell, sea, cross}) - sum).norm(), 1e-9 * sum.norm());
}

TEST(FreeHull, RightingStiffnessIsThatOfWeightBuoyancyAndWaterplane) {  // K:6, K:7
    const Hull hull(spar_case(), &spar_data());
    const double rho_g = 1025 * 9.80665, waterplane = M_PI / 4 * std::pow(20.0, 4);
    const double C55 = rho_g * (100530.965 * -51.875 + waterplane) - 1.030442e8 * 9.80665 * -66;
    for (const double yaw : {0.0, 0.7}) {
        const Mat6 K = hull.static_stiffness({.angles = {0, 0, yaw}}, Statics{});
        EXPECT_NEAR(K(4, 4) / C55, 1, 1e-4);  // seven digits of the file, C55 a third of its terms
        EXPECT_NEAR(K(3, 3) / C55, 1, 1e-4);
        EXPECT_NEAR(C55, 1.553673e10, 2e6);  // validation row B2
        EXPECT_NEAR(K(2, 2) / (rho_g * M_PI * 400), 1, 1e-5);
        EXPECT_LT(std::abs(K(3, 4)), 1e-6 * C55);
        EXPECT_LT(K.topRows(2).norm(), 1);
    }
}

TEST(FreeHull, HeelsBackByTheExactRotation) {  // K:6: sin, not the angle
    const Hull hull(spar_case(), &spar_data());
    const double rho_g = 1025 * 9.80665, pitch = 0.5;
    const double righting = rho_g * 100530.965 * -51.875 - 1.030442e8 * 9.80665 * -66;
    const double waterplane = spar_data().waterplane_stiffness(2, 2);
    const Vec6 load = hull.static_load({.angles = {0, pitch, 0}}, Statics{});
    EXPECT_NEAR(load[4], -righting * std::sin(pitch) - waterplane * pitch, 1e-9 * righting);
}

TEST(FreeHull, AutomaticMassFloatsAtTheDesignDraft) {
    Case c = spar_case();
    c.platform->mass.reset();
    c.platform->members = {{.name = "truss",
                            .from = {0, 0, -70},
                            .to = {0, 0, -165},
                            .diameter = 12,
                            .Cd = 1.6,
                            .displaced_area = 7.77,
                            .Ca = 2.6}};
    const Hull hull(c, &spar_data());
    EXPECT_TRUE(hull.mass_is_auto());
    EXPECT_NEAR(hull.acting_buoyancy(), 1025 * 9.80665 * (100530.965 + 7.77 * 95), 1);
    EXPECT_NEAR(hull.static_load({}, Statics{})[2], 0, 1);  // 1 N of 1 GN
}

// Mean period between the upward zero crossings of a motion in free decay.
double decay_period(int motion, double start, double frequency) {
    Case c = spar_case();
    c.platform->mass = 100530.965 * 1025;  // in equilibrium at the design draft
    c.platform->hydrodynamics.added_mass_frequency = frequency;
    const Hull hull(c, &spar_data());
    State s = State::Zero();
    s[motion] = start;
    double first = -1, last = -1, before = start, before_t = 0;
    int count = 0;
    run(hull, s, 0.25, 1600, [&](double t, const State& y, const HullLoads&) {
        if (before < 0 && y[motion] >= 0) {
            last = before_t + (t - before_t) * -before / (y[motion] - before);
            if (count++ == 0) first = last;
        }
        before = y[motion];
        before_t = t;
    });
    return (last - first) / (count - 1);
}

TEST(FreeHull, HeavesAndPitchesWithItsNaturalPeriods) {  // validation row B2
    // A and B taken at the natural frequency itself; four digits are printed.
    EXPECT_NEAR(decay_period(2, 1.0, 2 * M_PI / 21.30), 21.30, 0.02);
    EXPECT_NEAR(decay_period(4, 0.01, 2 * M_PI / 45.87), 45.87, 0.02);
}

struct Rao {
    double omega;
    Complex surge, heave, pitch;
};
std::vector<Rao> reference_raos() {
    std::ifstream in(std::string(HAWSER_SOURCE_DIR) + "/tests/data/spar_free_rao.csv");
    std::vector<Rao> raos;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || std::isdigit(line[0]) == 0) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        double w, a, b, d, e, f, g;
        numbers >> w >> a >> b >> d >> e >> f >> g;
        raos.push_back({w, {a, b}, {d, e}, {f, g}});
    }
    return raos;
}

TEST(FreeHull, FollowsSmallRegularWavesWithItsLinearResponse) {  // validation row B2
    const std::vector<Rao> raos = reference_raos();
    ASSERT_EQ(raos.size(), 6u);
    for (const Rao& rao : raos) {
        const double amplitude = 0.01;
        Case c = spar_case();
        c.platform->mass = 100530.965 * 1025;
        c.platform->hydrodynamics.added_mass_frequency.reset();  // auto: the wave's own
        c.environment.waves = {regular_wave(rao.omega, amplitude)};
        c.analysis.dynamics.ramp = 400;  // long, so that natural motions are hardly excited
        const Hull hull(c, &spar_data());
        EXPECT_NEAR(hull.radiation().frequency, rao.omega, 1e-12);
        // After the ramp: least squares of the harmonic beside drifting and natural motions.
        const int n = 2000;
        Eigen::MatrixXd basis(n, 8), motion(n, 3);
        int row = 0;
        run(hull, State::Zero(), 0.25, 1600 + n, [&](double t, const State& y, const HullLoads&) {
            if (t < 400) return;
            const double heave = 2 * M_PI / 21.3, pitch = 2 * M_PI / 45.87;
            basis.row(row) << std::cos(rao.omega * t), std::sin(rao.omega * t), 1, (t - 650) / 250,
                std::cos(heave * t), std::sin(heave * t), std::cos(pitch * t), std::sin(pitch * t);
            motion.row(row++) << y[0], y[2], y[4];
        });
        ASSERT_EQ(row, n);
        const Eigen::MatrixXd fit = basis.colPivHouseholderQr().solve(motion) / amplitude;
        const CVec6 expected = linear_response(hull, spar_data(), rao.omega);
        const Complex published[3] = {rao.surge, rao.heave, rao.pitch};
        for (int i = 0; i < 3; ++i) {
            const Complex got(fit(0, i), -fit(1, i));  // Re(X e^{iwt}) = Re X cos - Im X sin
            // The same linear equation in time and frequency: what is left is the ramp's start-up,
            // 3e-5 of the response at most.
            EXPECT_LT(std::abs(got - expected[2 * i]), 1e-4 * std::abs(expected[2 * i]))
                << "motion " << i << " at " << rao.omega << " rad/s: " << got << " for "
                << expected[2 * i];
            // Row B2 was computed with sums that leave 0.1 to 0.2 %.
            EXPECT_LT(std::abs(got - published[i]), 2e-3 * std::abs(published[i]))
                << "motion " << i << " at " << rao.omega << " rad/s: " << got << " for "
                << published[i];
        }
    }
}

// Everything that acts, at a state far from rest.
Case loaded_case(double heading) {
    Case c = spar_case();
    WaveTrain sea = paper_sea();
    sea.heading = heading;
    c.environment.waves = {sea};
    c.environment.current = Current{.heading = heading, .profile = {{0, 1.9, {}}, {75, 0, {}}}};
    c.environment.wind =
        Wind{.spectrum = WindSpectrum::npd, .speed = 45, .heading = heading, .seed = 3};
    c.analysis.dynamics.ramp = 0;
    Platform& p = *c.platform;
    p.hydrodynamics.drift = Drift::newman;
    p.members = {{.name = "column",
                  .from = {0, 0, 19},
                  .to = {0, 0, -70},
                  .diameter = 40,
                  .Cd = 1.2,
                  .end_Cd_to = 0.6,
                  .inertia = false},
                 {.name = "brace",
                  .from = {15, 5, -80},
                  .to = {-15, 8, -120},
                  .diameter = 3,
                  .Cd = 1,
                  .axial_Cd = 0.1,
                  .displaced_area = 7,
                  .Ca = 1}};
    p.plates = {{.name = "plate",
                 .position = {2, 1, -100},
                 .normal = {0.1, 0, std::sqrt(0.99)},
                 .area = 900,
                 .Cd = 5,
                 .added_mass = 1.3e7}};
    p.wind = WindArea{2500, 45, 1};
    p.linear_damping(5, 5) = 2e8;
    p.linear_damping(0, 0) = 1e5;
    p.quadratic_damping(0, 0) = 1e5;
    return c;
}

TEST(FreeHull, EverythingTurnedByAQuarterTurnMovesTheSame) {
    const double quarter = M_PI / 2;
    const Hull straight(loaded_case(0.3), &spar_data());
    const Hull turned_hull(loaded_case(0.3 + quarter), &spar_data());
    const Mat3 Q = rotation({0, 0, quarter});
    PlatformMotion m{.position = {12, -5, 1},
                     .angles = {0.05, -0.1, 0.1},
                     .velocity = {1, 0.5, -0.5},
                     .angle_rates = {0.01, 0.02, -0.01}};
    const State s = straight.start(m, m);
    m.position = Q * m.position;
    m.velocity = Q * m.velocity;
    m.angles.z() += quarter;
    const State q = turned_hull.start(m, m);
    const State a = run(straight, s, 0.5, 40), b = run(turned_hull, q, 0.5, 40);
    const PlatformMotion ma = motion_of(a), mb = motion_of(b);
    // Rounding alone, 1e-16 a step, grown by the stiffness of the motion.
    EXPECT_LT((Q * ma.position - mb.position).norm(), 1e-10);
    EXPECT_LT((Q * ma.velocity - mb.velocity).norm(), 1e-10);
    EXPECT_LT((ma.angles + Vec3(0, 0, quarter) - mb.angles).norm(), 1e-12);
    EXPECT_GT((ma.position - m.position).norm(), 1);  // it has moved
}

TEST(FreeHull, LedgerOfComponentsIsTheRateOfMomentum) {  // K:4 with added mass of every kind
    const Hull hull(loaded_case(0.3), &spar_data());
    const PlatformMotion m{.position = {12, -5, 1},
                           .angles = {0.05, -0.1, 0.1},
                           .velocity = {1, 0.5, -0.5},
                           .angle_rates = {0.01, 0.02, -0.01}};
    const State s = hull.start(m, m);
    HullLoads loads = hull.loads(100, s);
    const State rate = hull.rate(100, s, loads, Vec6::Zero());
    const double h = 1e-3;
    const Vec6 change =
        (hull.momentum(State(s + h * rate)) - hull.momentum(State(s - h * rate))) / (2 * h);
    const Vec6 expected = loads.total() - hull.momentum_transport(s);
    EXPECT_LT((change - expected).head<3>().norm(), 1e-6 * expected.head<3>().norm());
    EXPECT_LT((change - expected).tail<3>().norm(), 1e-6 * expected.tail<3>().norm());
}

TEST(AddedMassAndDamping, TurnWithTheBody) {  // K:4: A_w = Q A Q^T
    Case c;
    c.environment.seabed.depth = 100;
    c.environment.water.gravity = 0;
    Platform& p = c.platform.emplace();
    p.mass = 1e6;
    p.radii_of_gyration = {10, 20, 30};
    HydroMatrix& matrix = p.hydrodynamics.matrix.emplace();
    matrix.added_mass.diagonal() << 1e6, 2e6, 3e6, 1e8, 2e8, 3e8;
    matrix.damping.diagonal() << 1e4, 2e4, 3e4, 1e6, 2e6, 3e6;
    const Hull hull(c, nullptr);
    const Vec3 angles(0.3, -0.4, 1.1);
    const Mat3 R = rotation(angles);
    for (int i = 0; i < 3; ++i) {
        State s = State::Zero();
        set_motion(s, {.angles = angles, .velocity = 0.5 * R.col(i)});
        HullLoads loads = hull.loads(0, s);
        Vec6 push = Vec6::Zero(), a;
        push.head<3>() = 1e6 * R.col(i);  // along a body axis, which is a principal one
        (void)hull.rate(0, s, loads, push, &a);
        const double B = matrix.damping(i, i), A = matrix.added_mass(i, i);
        EXPECT_LT((a.head<3>() - (1e6 - 0.5 * B) / (1e6 + A) * R.col(i)).norm(), 1e-12);
        EXPECT_LT(a.tail<3>().norm(), 1e-12);
    }
}

TEST(StaticLoad, IsTheDynamicLoadAtRestInStillAirAndWater) {
    Case c = loaded_case(0.3);
    c.environment.waves.clear();
    c.environment.wind->spectrum = WindSpectrum::constant;
    c.platform->hydrodynamics.drift = Drift::none;
    const Hull hull(c, &spar_data());
    const PlatformMotion pose{.position = {3, 1, -2}, .angles = {0.02, 0.1, 0.3}};
    const Vec6 moving = hull.loads(50, hull.start(pose, pose)).total();
    const Vec6 still = hull.static_load(pose, Statics{});
    EXPECT_LT((moving - still).head<3>().norm(), 1e-9 * still.head<3>().norm());
    EXPECT_LT((moving - still).tail<3>().norm(), 1e-9 * still.tail<3>().norm());
    Statics none{.current = false, .wind_mean = false, .drift_mean = false};
    EXPECT_GT((still - hull.static_load(pose, none)).norm(), 1e6);
}

TEST(Ramp, LeavesTheMeanLoadsOnAndBringsInTheRest) {
    Case c = loaded_case(0.0);
    c.analysis.dynamics.ramp = 100;
    const Hull hull(c, &spar_data());
    const PlatformMotion pose{.position = {30, 0, 0}};
    const State s = hull.start(pose, pose);
    const HullLoads at_0 = hull.loads(0, s);
    EXPECT_EQ(at_0[Load::wave1].norm(), 0);
    EXPECT_LT((at_0.total() - hull.static_load(pose, c.analysis.statics)).norm(),
              1e-9 * at_0[Load::weight].norm());  // all that acts at t = 0 is in the static start
    c.analysis.statics.wind_mean = false;         // left out of the statics: ramped with the rest
    const Hull other(c, &spar_data());
    EXPECT_NEAR(other.loads(0, s)[Load::wind].norm(), 0, 1e-3);
    EXPECT_GT(other.loads(100, s)[Load::wind][0], 1e6);
}

}  // namespace
}  // namespace hawser::master
