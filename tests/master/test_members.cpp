// Morison members, heave plates and wind against closed forms.
#include <gtest/gtest.h>

#include "spar_hull.hpp"

namespace hawser::master {
namespace {

constexpr double rho = 1025.0, g = 9.80665;

Case bare_case() {
    Case c;
    c.environment.seabed.depth = 1500;
    c.analysis.dynamics.ramp = 0;
    Platform& p = c.platform.emplace();
    p.mass = 1e6;
    p.centre_of_gravity = {0, 0, -10};
    p.radii_of_gyration = {10, 10, 10};
    return c;
}

Member column(double top, double bottom, double diameter) {
    return {.name = "column",
            .from = {0, 0, top},
            .to = {0, 0, bottom},
            .diameter = diameter,
            .inertia = false};
}

State moving(const Vec3& velocity, const Vec3& angular = Vec3::Zero()) {
    State s = State::Zero();
    set_motion(s, {.velocity = velocity, .angle_rates = angular});
    return s;
}

TEST(Members, TowedColumnDragsByItsWettedArea) {
    Case c = bare_case();
    Member m = column(19, -70, 40);
    m.Cd = 1.2;
    m.axial_Cd = 0.02;
    m.end_Cd_to = 0.6;
    c.platform->members = {m};
    const Hull hull(c, nullptr);
    const HullLoads loads = hull.loads(0, moving({1.5, -2, 0.5}));
    const double speed = 2.5, q = 0.5 * rho * 1.2 * 40 * 70 * speed;
    EXPECT_NEAR(loads[Load::members][0], -q * 1.5, 1e-9 * q);
    EXPECT_NEAR(loads[Load::members][1], q * 2, 1e-9 * q);
    EXPECT_NEAR(loads[Load::members][2],
                -0.5 * rho * 0.25 * (0.02 * 40 * 70 + 0.6 * M_PI / 4 * 1600), 1e-6);
    EXPECT_NEAR(loads[Load::members][4], -q * 1.5 * -35, 1e-9 * q * 35);  // at mid draft
    EXPECT_NEAR(hull.loads(0, moving({0, 0, -0.5}))[Load::members][2],    // sinking: upwards
                -loads[Load::members][2], 1e-6);
}

TEST(Members, CurrentOnTheSparIsThatOfThePapersProfile) {  // case notes: 3.3 MN on the hard tank
    Case c = bare_case();
    c.environment.current = Current{.profile = {{0, 1.9, {}}, {40, 1.4, {}}, {75, 0, {}}}};
    Member hard = column(19, -70, 40), truss = column(-70, -165, 12);
    hard.Cd = 1.2;
    truss.Cd = 1.6;
    c.platform->members = {hard, truss};
    const Hull hull(c, nullptr);
    // int U^2 dz of a linear piece: l (a^2 + a b + b^2)/3
    const double U70 = 1.4 * 5 / 35, square = [](double l, double a, double b) {
        return l * (a * a + a * b + b * b) / 3;
    }(40, 1.9, 1.4) + 30 * (1.4 * 1.4 + 1.4 * U70 + U70 * U70) / 3;
    const double force = 0.5 * rho * (1.2 * 40 * square + 1.6 * 12 * 5 * U70 * U70 / 3);
    EXPECT_NEAR(force, 3.3e6, 0.05e6);
    const State s = State::Zero();
    // Midpoint rule over 2.5 m strips: h^2/12 of the slopes' squares, 1e-4.
    EXPECT_NEAR(hull.loads(0, s)[Load::current][0], force, 3e-4 * force);
    EXPECT_NEAR(hull.static_load({}, Statics{})[0], force, 3e-4 * force);
    EXPECT_NEAR(hull.loads(0, s)[Load::members][0], 0, 1e-6);  // nothing beside the current
}

TEST(Members, EachEndFaceFeelsTheWaterWhereItIs) {
    Case c = bare_case();
    // one metre a second down to 20 m, nothing from 30 m on; the member leans by 45 degrees
    c.environment.current = Current{.profile = {{0, 1.0, {}}, {20, 1.0, {}}, {30, 0, {}}}};
    Member m{.name = "brace", .from = {0, 0, -10}, .to = {30, 0, -40}, .diameter = 2};
    m.inertia = false, m.Cd = 0.0;
    const auto push = [&] {
        c.platform->members = {m};
        return Vec6(Hull(c, nullptr).loads(0, State::Zero())[Load::current]);
    };
    m.end_Cd_to = 0.8;
    EXPECT_EQ(push().norm(), 0.0);  // in still water
    std::swap(m.end_Cd_to, m.end_Cd_from);
    const Vec3 along = Vec3(1, 0, -1).normalized();
    const Vec3 force = 0.5 * rho * 0.8 * M_PI * 0.5 * along;  // of the part sqrt(1/2) m/s
    const Vec6 load = push();
    EXPECT_LT((load.head<3>() - force).norm(), 1e-9 * force.norm());
    EXPECT_NEAR(load[4], -10 * force.x(), 1e-9 * 10 * force.x());
}

TEST(Members, FacesAndPlatesInTheAirFeelNothing) {
    Case c = bare_case();
    Member m = column(19, -3, 4);
    m.Cd = 0.0, m.end_Cd_from = 0.9;  // its upper face
    c.platform->members = {m};
    c.platform->plates = {
        {.name = "deck", .position = {0, 0, 12}, .area = 900, .Cd = 5, .added_mass = 1e6}};
    const HullLoads dry = Hull(c, nullptr).loads(0, moving({0, 0, 2}, {0.1, 0.1, 0}));
    EXPECT_EQ(dry[Load::members].norm(), 0.0);
    EXPECT_EQ(dry[Load::plates].norm(), 0.0);
    EXPECT_EQ(dry.plate_added_mass.norm(), 0.0);
}

TEST(Members, DragSwitchesTakeOutWavesOrCurrent) {
    Case c = bare_case();
    c.environment.current = Current{.profile = {{0, 1.0, {}}}};
    c.environment.waves = {regular_wave(0.5, 3)};
    const auto force = [&](bool waves, bool current) {
        Member m = column(-10, -30, 10);
        m.Cd = 1;
        m.waves_in_drag = waves;
        m.current = current;
        c.platform->members = {m};
        const HullLoads loads = Hull(c, nullptr).loads(0, State::Zero());  // crest
        return Vec3((loads[Load::members] + loads[Load::current]).head<3>());
    };
    const double current_alone = 0.5 * rho * 10 * 20;
    EXPECT_NEAR(force(false, true)[0], current_alone, 1e-6 * current_alone);
    EXPECT_EQ(force(false, false).norm(), 0);
    EXPECT_GT(std::abs(force(true, true)[0] - current_alone), 0.1 * current_alone);
    EXPECT_GT(force(true, false).norm(), 0.01 * current_alone);
}

TEST(Members, UprightCylinderFloatsByArchimedes) {
    Case c = bare_case();
    Member m = column(7.3, -20, 6);
    m.displaced_area = M_PI * 9;
    c.platform->members = {m};
    const Hull hull(c, nullptr);
    const double area = M_PI * 9;
    EXPECT_NEAR(hull.acting_buoyancy(), rho * g * area * 20, 1e-6);
    for (const double heave : {-3.1, 0.0, 4.4}) {  // exact wherever the surface cuts a strip
        const Vec6 load = hull.static_load({.position = {0, 0, heave}}, Statics{});
        EXPECT_NEAR(load[2] + 1e6 * g, rho * g * area * (20 - heave), 1e-3);
    }
    EXPECT_NEAR(hull.static_stiffness({}, Statics{})(2, 2), rho * g * area, 1e-3);
    // A vertical force at body height -10 leans with the column: lever arm sin(pitch).
    const Vec6 leaning = hull.static_load({.angles = {0, 0.05, 0}}, Statics{});
    const double weight_arm = 1e6 * g * 10, wet = 20 - 0.0;
    const double own = rho * g * M_PI / 4 * 81;  // of its waterplane
    EXPECT_NEAR(leaning[4], (rho * g * area * wet * wet / 2 - weight_arm - own) * std::sin(0.05),
                2e-3 * weight_arm * 0.05);  // wet length along the axis is longer by 1/cos
}

// Two columns far apart, cut so that two strips meet at the surface (10 + 20 m) or not (11 + 20 m):
// C44 = rho g (2 A d^2 + 2 I - V h/2) with the centre of gravity in the surface and I = A^2/(4 pi)
// of each column's own waterplane.
TEST(Members, LeaningColumnsRightTheHullHoweverTheyAreCut) {
    for (const double top : {10.0, 11.0}) {
        Case c = bare_case();
        c.platform->centre_of_gravity = {0, 0, 0};
        for (const double y : {-30.0, 30.0}) {
            Member m = column(top, -20, 12);
            m.from.y() = m.to.y() = y;
            m.inertia = true;
            m.displaced_area = 100;
            c.platform->members.push_back(m);
        }
        const Hull hull(c, nullptr);
        const Mat6 K = hull.static_stiffness({}, Statics{});
        const double own = rho * g * 2 * 100 * 100 / (4 * M_PI);
        const double C44 = rho * g * 200 * (30 * 30 - 20 * 10) + own;
        const double C55 = -rho * g * 200 * 20 * 10 + own;
        EXPECT_NEAR(K(3, 3), C44, 1e-4 * C44)
            << top;  // tilts by 1e-4: of a strip's 2.5 m the surface passes 6 mm
        EXPECT_NEAR(K(4, 4), C55, 1e-4 * C44) << top;
        EXPECT_NEAR(K(2, 3), 0, 1e-6 * C44) << top;
    }
}

TEST(Members, LyingCylinderSubmergesWithoutAJump) {
    Case c = bare_case();
    c.platform->members = {{.name = "lying",
                            .from = {-10, 0, 0},
                            .to = {10, 0, 0},
                            .diameter = 4,
                            .displaced_area = M_PI * 4}};
    const Hull hull(c, nullptr);
    const double full = rho * g * M_PI * 4 * 20;
    double before = full;
    for (int i = -20; i <= 20; ++i) {
        const double z = i / 10.0;
        const double lift = hull.static_load({.position = {0, 0, z}}, Statics{})[2] + 1e6 * g;
        EXPECT_LE(lift, before + 1e-6);
        EXPECT_LT(before - lift, 0.0319 * full);  // 0.1 m of the full width: 0.1 2/(pi 2)
        before = lift;
    }
    EXPECT_NEAR(before, 0, 1e-6);
}

TEST(Members, AddedMassOfTheSubmergedPartEntersTheVirtualMass) {
    Case c = bare_case();
    Member m = column(5, -20, 4);
    m.inertia = true;
    m.displaced_area = M_PI * 4;
    m.Ca = 0.9;
    c.platform->members = {m};
    c.platform->centre_of_gravity = {0, 0, 0};
    const Hull hull(c, nullptr);
    const State s = State::Zero();
    HullLoads loads = hull.loads(0, s);
    const double a = rho * 0.9 * M_PI * 4;  // per length
    EXPECT_NEAR(loads.member_added_mass(0, 0), a * 20, 1e-6);
    EXPECT_NEAR(loads.member_added_mass(2, 2), 0, 1e-9);  // none along the axis
    EXPECT_NEAR(loads.member_added_mass(0, 4), -a * 200, 1e-6);
    EXPECT_NEAR(loads.member_added_mass(4, 4), a * 20.0 * 20 * 20 / 3,
                a * 20 * 2.5 * 2.5 / 12 * 1.01);  // strips as points: l^2/12 each
    Vec6 push = Vec6::Zero(), acceleration;
    push[1] = 1e6;
    (void)hull.rate(0, s, loads, push, &acceleration);
    // F and M of the push are met by the virtual mass at the accelerations found.
    EXPECT_NEAR((1e6 + a * 20) * acceleration[1] - loads.member_added_mass(1, 3) * -acceleration[3],
                1e6, 1e-3);
    EXPECT_NEAR(loads.total()[1], 1e6 * acceleration[1], 1e-3);  // rate of the rigid momentum
}

TEST(Members, SmallCylinderFeelsFroudeKrylovAndDiffraction) {
    Case c = bare_case();
    const double omega = 0.6, amplitude = 1, depth = 20;
    c.environment.waves = {regular_wave(omega, amplitude)};
    c.environment.waves[0].stretching = Stretching::none;
    const double area = 0.5;
    c.platform->members = {{.name = "small",
                            .from = {0, 0, -depth - 1},
                            .to = {0, 0, -depth + 1},
                            .diameter = 0.8,
                            .displaced_area = area,
                            .Ca = 1}};
    const Hull hull(c, nullptr);
    const double k = omega * omega / g;  // 1500 m are deep
    for (const double t : {0.0, 1.7, 4.0}) {
        const Vec6 load = hull.loads(t, State::Zero())[Load::members];
        const double a = amplitude * omega * omega * std::exp(-k * depth);
        // u = A w e^kz cos wt, du/dt = -A w^2 e^kz sin wt; upwards the cosine.
        EXPECT_NEAR(load[0], -rho * area * 2 * (1 + 1) * a * std::sin(omega * t), 1e-3 * rho * a);
        EXPECT_NEAR(load[2], -rho * area * 2 * a * std::cos(omega * t), 1e-3 * rho * a);
    }
}

TEST(Members, SinkingColumnGivesMomentumToTheWaterItEnters) {  // P:2 footnote 4
    Case c = bare_case();
    Member m = column(6, -21, 4);
    m.inertia = true;
    m.displaced_area = M_PI * 4;
    m.Ca = 0.9;
    c.platform->members = {m};
    const Hull hull(c, nullptr);
    const double sinking = 0.7, speed = 2.0;
    // d(rho Ca A l)/dt = rho Ca A sinking; the water gains that times the velocity.
    EXPECT_NEAR(hull.loads(0, moving({speed, 0, -sinking}))[Load::members][0],
                -rho * 0.9 * M_PI * 4 * sinking * speed, 1e-6);
    c.platform->members[0].to.z() = -2;  // wholly dry and wholly wet columns gain none
    c.platform->members[0].from.z() = -30;
    EXPECT_NEAR(Hull(c, nullptr).loads(0, moving({speed, 0, -sinking}))[Load::members][0], 0, 1e-9);
}

// The surface that rises along a column at rest changes its added mass as well. Second order in the
// wave, the half sum at t and half a period later: rho A (1 + Ca) eta a of the crest's water and
// rho A Ca u_z u_x of the footnote, the latter at the middle of the wet part of its strip.
TEST(Members, RisingSurfaceGivesMomentumToTheWaterItBrings) {  // P:2 footnote 4
    Case c = bare_case();
    const double w = 0.5, amplitude = 0.5, k = w * w / g, T = 2 * M_PI / w, Ca = 0.9;
    c.environment.waves = {regular_wave(w, amplitude)};
    c.environment.waves[0].stretching = Stretching::vertical;
    Member m = column(6, -30, 4);  // 15 strips, one from -1.2 to 1.2 m
    m.Cd = 0;
    m.inertia = true;
    m.displaced_area = M_PI * 4;
    m.Ca = Ca;
    c.platform->members = {m};
    const Hull hull(c, nullptr);
    const double t = 0.1 * T, cs = std::cos(w * t) * std::sin(w * t);
    const double second = 0.5 * (hull.loads(t, State::Zero())[Load::members][0] +
                                 hull.loads(t + T / 2, State::Zero())[Load::members][0]);
    const double q = rho * M_PI * 4 * amplitude * amplitude * w * w * cs;
    const double expected = -q * (1 + Ca + Ca * std::exp(-1.2 * k));
    EXPECT_NEAR(second, expected, 2e-3 * std::abs(expected));  // (1.2 k)^2
}

TEST(Members, WhirledAddedMassPullsOutwards) {  // -m_a w x (w x r), across the axis
    Case c = bare_case();
    c.platform->members = {{.name = "leg",
                            .from = {30, 0, -10},
                            .to = {30, 0, -20},
                            .diameter = 2,
                            .displaced_area = 3,
                            .Ca = 1.2}};
    const Vec6 load = Hull(c, nullptr).loads(0, moving({0, 0, 0}, {0, 0, 0.2}))[Load::members];
    EXPECT_NEAR(load[0], rho * 1.2 * 3 * 10 * 0.04 * 30, 1e-6);
}

TEST(Plates, ActAlongTheirNormalAlone) {
    Case c = bare_case();
    c.environment.waves = {regular_wave(0.6, 1)};
    c.environment.waves[0].stretching = Stretching::none;
    c.platform->plates = {{.name = "fin",
                           .position = {30, 0, -10},
                           .normal = {1, 0, 0},
                           .area = 50,
                           .Cd = 0,
                           .added_mass = 2e5}};
    const Hull hull(c, nullptr);
    const double t = 3, k = 0.36 / g;
    const HullLoads still = hull.loads(t, State::Zero());
    const double a = -0.36 * std::exp(-10 * k) * std::sin(0.6 * t - 30 * k);
    EXPECT_NEAR(still[Load::plates][0], 2e5 * a, 1e-3 * 2e5 * 0.36);
    EXPECT_EQ(still[Load::plates][2], 0);
    EXPECT_NEAR(still.plate_added_mass(0, 0), 2e5, 1e-6);
    EXPECT_EQ(still.plate_added_mass(1, 1), 0);
    EXPECT_EQ(still.plate_added_mass(2, 2), 0);
    const HullLoads whirled = hull.loads(t, moving({0, 0, 0}, {0, 0, 0.2}));
    EXPECT_NEAR((whirled[Load::plates] - still[Load::plates])[0], 2e5 * 0.04 * 30, 1e-6);
}

TEST(Plates, CurrentThatTheStaticsLeftOutIsRampedOnThem) {
    Case c = bare_case();
    c.analysis.dynamics.ramp = 100;
    c.analysis.statics.current = false;
    c.environment.current = Current{.profile = {{0, 1.5, {}}}};
    c.platform->plates = {
        {.name = "fin", .position = {0, 0, -10}, .normal = {1, 0, 0}, .area = 50, .Cd = 4}};
    const Hull hull(c, nullptr);
    const double full = 0.5 * rho * 4 * 50 * 1.5 * 1.5;
    for (const double t : {0.0, 30.0, 100.0}) {
        const double r = ramp_factor(t, 100);
        const HullLoads loads = hull.loads(t, State::Zero());
        EXPECT_NEAR(loads[Load::current][0], r * r * full, 1e-9 * full) << t;
        EXPECT_NEAR(loads[Load::plates][0], 0, 1e-9 * full) << t;
    }
}

TEST(Plates, PitchingDragsThemBySpeedOfTheirPlace) {
    Case c = bare_case();
    c.platform->plates = {{.name = "fin", .position = {30, 0, -20}, .area = 50, .Cd = 4}};
    const Vec6 load = Hull(c, nullptr).loads(0, moving({0, 0, 0}, {0, 0.1, 0}))[Load::plates];
    const double lift = 0.5 * rho * 4 * 50 * 3.0 * 3.0;  // it sinks with 3 m/s
    EXPECT_NEAR(load[2], lift, 1e-9 * lift);
    EXPECT_NEAR(load[4], -30 * lift, 1e-9 * 30 * lift);
}

TEST(Plates, SinkingPlateReachesItsTerminalSpeed) {
    Case c = bare_case();
    c.platform->plates = {
        {.name = "plate", .position = {0, 0, -30}, .area = 900, .Cd = 5, .added_mass = 1.3e7}};
    const Hull hull(c, nullptr);
    const double terminal = std::sqrt(2 * 1e6 * g / (rho * 5 * 900));
    double first = 0;
    const State s = run(hull, State::Zero(), 0.1, 300, [&](double t, const State& y, const auto&) {
        if (t == 0.1) first = y[8];
    });
    EXPECT_NEAR(s[8], -terminal, 1e-6 * terminal);
    EXPECT_NEAR(first, -1e6 * g / 1.4e7 * 0.1, 1e-4);  // set off by the virtual mass
}

TEST(Wind, MeanForceIsThatOfTheMeanSpeedAtTheHeight) {  // case notes: 55.8 m/s, 4.8 MN
    Case c = bare_case();
    c.environment.wind =
        Wind{.spectrum = WindSpectrum::npd, .speed = 87.5 * 1852 / 3600, .seed = 11};
    c.platform->wind = WindArea{2500, 45, 1};
    c.analysis.dynamics.ramp = 100;
    const Hull hull(c, nullptr);
    const Vec6 mean = hull.static_load({}, Statics{});
    EXPECT_NEAR(mean[0], 4.8e6, 0.05e6);
    EXPECT_NEAR(mean[4], 45 * mean[0], 1);
    EXPECT_NEAR(hull.loads(0, State::Zero())[Load::wind][0], mean[0], 1);  // no gust yet
    // Against the moving platform: (U - v)^2.
    const double U = std::sqrt(mean[0] / (0.5 * 1.226 * 2500));
    EXPECT_NEAR(U, 55.8, 0.05);
    EXPECT_NEAR(hull.loads(0, moving({2, 0, 0}))[Load::wind][0],
                0.5 * 1.226 * 2500 * (U - 2) * (U - 2), 1);
    const double top = 0.02 * 45;  // pitching lends the centre a speed; heaving does not count
    const Vec6 pitching = hull.loads(0, moving({0, 0, 3}, {0, 0.02, 0}))[Load::wind];
    EXPECT_NEAR(pitching[0], 0.5 * 1.226 * 2500 * (U - top) * (U - top), 1);
    EXPECT_EQ(pitching[2], 0);
}

TEST(UserDamping, ActsOnAxesThatTurnWithYaw) {
    Case c = bare_case();
    c.platform->linear_damping(0, 0) = 1e4;
    c.platform->quadratic_damping(1, 1) = 2e3;
    const Hull hull(c, nullptr);
    State s = State::Zero();
    set_motion(s, {.angles = {0, 0, M_PI / 2}, .velocity = {3, 2, 0}});
    const Vec6 load = hull.loads(0, s)[Load::damping];  // ahead 2 m/s, to starboard 3 m/s
    EXPECT_NEAR(load[1], -1e4 * 2, 1e-8);
    EXPECT_NEAR(load[0], -2e3 * 9, 1e-8);
}

}  // namespace
}  // namespace hawser::master
