// Members that lean, taper, stand half in the water or are flooded, against closed forms: K:24.
#include <gtest/gtest.h>

#include <functional>

#include "member_strips.hpp"
#include "spar_hull.hpp"

namespace hawser::master {
namespace {

constexpr double rho = 1025.0, g = 9.80665;

Case bare_case(double mass = 1e6) {
    Case c;
    c.environment.seabed.depth = 1500;
    c.analysis.dynamics.ramp = 0;
    Platform& p = c.platform.emplace();
    p.mass = mass;
    p.centre_of_gravity = {0, 0, 0};
    p.radii_of_gyration = {10, 10, 10};
    return c;
}

Member cylinder(const Vec3& from, const Vec3& to, double diameter) {
    Member m{.name = "cylinder", .from = from, .to = to, .diameter = diameter};
    m.displaced_area = M_PI / 4 * diameter * diameter;
    return m;
}

Member cone(const Vec3& from, const Vec3& to, double d0, double d1) {
    Member m = cylinder(from, to, d0);
    m.diameter_to = d1;
    m.displaced_area_to = M_PI / 4 * d1 * d1;
    return m;
}

State at(const PlatformMotion& m) {
    State s = State::Zero();
    set_motion(s, m);
    return s;
}

/// Buoyancy alone.
Vec6 buoyancy(const Case& c, const PlatformMotion& pose = {}) {
    const Vec6 load = Hull(c, nullptr).loads(0, at(pose))[Load::hydrostatic];
    return load;
}

// Volume and centre of a cylinder whose flat surface leans by a and whose end faces stay dry and
// wet: V = A h, centre at h/2 + r^2 tan^2(a)/(8 h) along the axis and r^2 tan(a)/(4 h) across it
// (h: wet length of the axis).
TEST(MemberShapes, LeaningCylinderDisplacesWhatTheSurfaceCutsOff) {  // K:24
    const double r = 3, h = 20, a = 0.5, top = 9;
    Case c = bare_case();
    // The axis meets the surface in O and leans towards +x.
    const Vec3 axis(std::sin(a), 0, std::cos(a));
    c.platform->members = {cylinder(-h * axis, top * axis, 2 * r)};
    const Vec6 load = buoyancy(c);
    const double force = rho * g * M_PI * r * r * h;
    EXPECT_NEAR(load[2], force, 1e-9 * force);
    const double along = -h / 2 + r * r * std::pow(std::tan(a), 2) / (8 * h);
    const double across = r * r * std::tan(a) / (4 * h);  // towards the lower side: -e_up
    const Vec3 e_up = (Vec3::UnitZ() - axis.z() * axis).normalized();
    const Vec3 centre = along * axis - across * e_up;
    EXPECT_NEAR(load[4], -centre.x() * force, 1e-8 * force);
    EXPECT_NEAR(load[3], 0, 1e-9 * force);
}

// Heights of the surface on a cone that stands upright, and one that leans so that the surface cuts
// an ellipse: by direct summation over a fine grid of its sections' segments.
TEST(MemberShapes, TaperedMemberDisplacesATruncatedCone) {
    Case c = bare_case();
    c.platform->members = {cone({0, 0, -20}, {0, 0, 10}, 12, 3)};
    for (const double heave : {-4.0, 0.0, 7.3}) {
        const double h = 20 - heave, r0 = 6, r1 = 6 - 4.5 * h / 30;
        const double V = M_PI * h / 3 * (r0 * r0 + r0 * r1 + r1 * r1);
        const Vec6 load = buoyancy(c, {.position = {0, 0, heave}});
        EXPECT_NEAR(load[2], rho * g * V, 1e-9 * rho * g * V) << heave;
        EXPECT_NEAR(load[4], 0, 1e-6);
    }
    // Stiffness in heave is the waterplane, and upright the cone's GM follows BM = I/V.
    const Hull hull(c, nullptr);
    const double rw = 3;
    const Mat6 K = hull.static_stiffness({}, Statics{});
    EXPECT_NEAR(K(2, 2), rho * g * M_PI * rw * rw, 1e-4 * rho * g * M_PI * rw * rw);
    const double V = M_PI * 20 / 3 * (36 + 18 + 9);
    const double z_B = -20 + 20.0 / 4 * (36 + 2 * 18 + 3 * 9) / (36 + 18 + 9);
    const double I = M_PI / 4 * rw * rw * rw * rw;
    EXPECT_NEAR(K(4, 4), rho * g * (V * z_B + I), 1e-5 * rho * g * V * 10);
    EXPECT_NEAR(K(3, 3), K(4, 4), 1e-6 * std::abs(K(4, 4)));
}

/// Volume and centre of a cone below z = 0 by half a million cells.
Vec3 summed(const Vec3& from, const Vec3& to, double r0, double r1, double& volume) {
    const Vec3 t = (to - from).normalized(), e = t.unitOrthogonal(), f = t.cross(e);
    const double L = (to - from).norm();
    Vec3 moment = Vec3::Zero();
    volume = 0;
    const int n = 200, rings = 40, sectors = 60;
    for (int i = 0; i < n; ++i) {
        const double q = (i + 0.5) / n, r = r0 + q * (r1 - r0);
        for (int j = 0; j < rings; ++j)
            for (int k = 0; k < sectors; ++k) {
                const double rho_ = r * (j + 0.5) / rings, phi = 2 * M_PI * (k + 0.5) / sectors;
                const Vec3 x = from + q * L * t + rho_ * (std::cos(phi) * e + std::sin(phi) * f);
                if (x.z() > 0) continue;
                const double cell = L / n * r / rings * rho_ * 2 * M_PI / sectors;
                volume += cell;
                moment += cell * x;
            }
    }
    return moment / volume;
}

TEST(MemberShapes, LeaningConeCutAnywhereDisplacesTheSumOfItsParts) {
    const Vec3 from(2, -1, -6);
    for (const Vec3& to : {Vec3(14, 3, 5), Vec3(14, 3, -5.2), Vec3(-9, 8, -6), Vec3(5, 5, 0.5)}) {
        Case c = bare_case();
        c.platform->members = {cone(from, to, 5, 2)};
        double V = 0;
        const Vec3 centre = summed(from, to, 2.5, 1.0, V);
        const Vec6 load = buoyancy(c);
        EXPECT_NEAR(load[2], rho * g * V, 2e-3 * rho * g * V) << to.transpose();  // cells
        EXPECT_NEAR(load[3] / load[2], centre.y(), 4e-3);
        EXPECT_NEAR(-load[4] / load[2], centre.x(), 4e-3);
    }
}

// Pieces meet the surface where the strip as a whole does not: wholly wet, wholly dry and cut ones
// together make up the strip, whatever its taper. Cut sections are integrated to 1e-9
// of the whole.
TEST(MemberShapes, StripIsTheSumOfItsPiecesAtAnyDepth) {  // K:24
    const int n = 16;
    for (const double taper : {-0.25, 0.0, 0.25})
        for (const double axis_z : {-0.9, 0.6}) {
            const Strip strip{
                .length = 4, .radius = 2, .taper = taper, .width = 5, .width_taper = -2 * taper};
            for (double depth = -4; depth <= 4; depth += 0.05) {
                double length = 0, first = 0, drag = 0, volume = 0, along = 0, up = 0;
                for (int i = 0; i < n; ++i) {
                    const double s = 4 * ((i + 0.5) / n - 0.5);
                    const Wetting w = wetting({.length = 4.0 / n,
                                               .radius = 2 + taper * s,
                                               .taper = taper,
                                               .width = 5 - 2 * taper * s,
                                               .width_taper = -2 * taper},
                                              axis_z, axis_z * s, depth);
                    length += w.length;
                    first += w.length * (s + w.shift);
                    drag += w.drag_area;
                    volume += w.volume;
                    along += w.volume * (s + w.along);
                    up += w.volume * w.up;
                }
                const Wetting all = wetting(strip, axis_z, 0, depth);
                EXPECT_NEAR(all.length, length, 1e-8) << taper << ' ' << axis_z << ' ' << depth;
                EXPECT_NEAR(all.length * all.shift, first, 3e-8);
                EXPECT_NEAR(all.drag_area, drag, 1e-7);
                EXPECT_NEAR(all.volume, volume, 1e-7);
                EXPECT_NEAR(all.volume * all.along, along, 1e-7);
                EXPECT_NEAR(all.volume * all.up, up, 1e-7);
                const double whole = M_PI * 4 * (4 + taper * taper * 16 / 12);  // truncated cone
                EXPECT_LE(all.whole ? whole - volume : 0.0, 1e-9) << depth;
            }
        }
}

TEST(MemberShapes, LyingCylinderIsWetBySegments) {
    Case c = bare_case();
    c.platform->members = {cylinder({-10, 0, 0}, {10, 0, 0}, 4)};
    for (const double depth : {-1.9, -0.7, 0.0, 1.3}) {  // of its axis
        const double u = depth / 2;
        const double A = 4 * (M_PI / 2 + u * std::sqrt(1 - u * u) + std::asin(u));
        EXPECT_NEAR(buoyancy(c, {.position = {0, 0, -depth}})[2], rho * g * A * 20,
                    1e-9 * rho * g * 250);
    }
    // Its own waterplane: 20 x 4 m; rolling it does nothing, pitching it 4 20^3/12.
    const Mat6 K = Hull(c, nullptr).static_stiffness({}, Statics{});
    EXPECT_NEAR(K(2, 2), rho * g * 80, 1e-4 * rho * g * 80);
    EXPECT_NEAR(K(3, 3), 0, 1e-4 * rho * g * 1e3);  // every section turns about its centre
    const double z_B = -4 * 2 / (3 * M_PI);
    EXPECT_NEAR(K(4, 4), rho * g * (4 * 8000 / 12.0 + M_PI * 2 * 20 * z_B), 1e-3 * rho * g * 2667);
}

TEST(MemberShapes, FloodedMembersCarryTheirWaterAndNothingElse) {
    Case c = bare_case(2e5);
    Member m = cylinder({-15, 0, -10}, {15, 0, -10}, 4);
    m.Ca = 1.0;
    m.axial_Ca = 0.1;
    m.flooded = true;
    c.platform->members = {m};
    const double water = rho * M_PI * 4 * 30, k = 3e6;
    c.platform->stiffness.diagonal() << k, k, k, 1e9, 1e9, 1e9;
    const Hull hull(c, nullptr);
    EXPECT_EQ(hull.acting_buoyancy(), 0.0);
    EXPECT_EQ(buoyancy(c).norm(), 0.0);
    const HullLoads loads = hull.loads(0, State::Zero());
    EXPECT_NEAR(loads.member_added_mass(2, 2), 2 * water, 1e-6);
    EXPECT_NEAR(loads.member_added_mass(0, 0), 1.1 * water, 1e-6);
    // Period of a decay in sway: the water inside and outside moves with it.
    const double T = 2 * M_PI * std::sqrt((2e5 + 2 * water) / k);
    State start = State::Zero();
    start[2] = -2e5 * g / k + 0.5;  // about the static place
    c.platform->fixed = {true, true, false, true, true, true};
    const Hull held(c, nullptr);
    double before = 0.5, crossing = 0;
    run(held, start, T / 200, 120, [&](double t, const State& s, const auto&) {
        const double x = s[2] + 2e5 * g / k;
        if (before > 0 && x <= 0) crossing = t - x / (x - before) * (T / 200);
        before = x;
    });
    EXPECT_NEAR(crossing, T / 4, 1e-4 * T);
}

// A lying cylinder that bobs through the surface: the added mass M(z) changes with immersion and
// P:2's footnote takes d(M v)/dt. So ((m + M) v)^2/2 - int (m + M) F dz stays as it is.
TEST(MemberShapes, BobbingCylinderKeepsItsIntegral) {  // P:2 footnote 4
    Case c = bare_case(120e3);
    Member m = cylinder({-10, 0, 0}, {10, 0, 0}, 4);
    m.Ca = 1;
    c.platform->members = {m};
    c.platform->fixed = {true, true, false, true, true, true};
    const Hull hull(c, nullptr);
    const auto lift = [&](double z) {
        return hull.loads(0, at({.position = {0, 0, z}}))[Load::hydrostatic][2];
    };
    const auto virtual_mass = [&](double z) { return 120e3 + lift(z) / g; };
    const auto force = [&](double z) { return lift(z) - 120e3 * g; };
    const double rest = 1.9;
    const auto integral = [&](double z) {  // Simpson from the start
        double sum = 0;
        const int n = 60;
        const double h = (z - rest) / n;
        for (int i = 0; i <= n; ++i) {
            const double x = rest + i * h, w = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += w * virtual_mass(x) * force(x);
        }
        return sum * h / 3;
    };
    State start = State::Zero();
    start[2] = rest;
    double lowest = rest, worst = 0, scale = 0;
    int turns = 0, step = 0;
    double highest_again = -10, speed_before = 0;
    run(hull, start, 0.02, 400, [&](double, const State& s, const auto&) {
        lowest = std::min(lowest, s[2]);
        if (step++ % 5 == 0) {
            const double P = virtual_mass(s[2]) * s[8];
            scale = std::max(scale, 0.5 * P * P);
            worst = std::max(worst, std::abs(0.5 * P * P - integral(s[2])));
        }
        if (speed_before > 0 && s[8] <= 0) ++turns, highest_again = std::max(highest_again, s[2]);
        speed_before = s[8];
    });
    EXPECT_LT(lowest, -1.0);
    EXPECT_GE(turns, 1);
    EXPECT_LT(worst, 1e-3 * scale);
    EXPECT_NEAR(highest_again, rest, 2e-3);  // comes up again as high as it was
}

// Inertia force on an upright slender cylinder from the bed of deep water up to the still surface:
// F = -rho (1 + Ca) A a g (1 - e^{-k d}) sin(wt) with A of one width; tapered by the integral.
TEST(MemberShapes, WaveForceIsMorisonsIntegral) {
    const double w = 0.7, amplitude = 0.01, k = w * w / g;
    Case c = bare_case();
    c.environment.waves = {regular_wave(w, amplitude)};
    c.environment.waves[0].stretching = Stretching::none;
    const double t = M_PI / (2 * w);  // the surface passes mean sea level at x = 0
    const auto force = [&](const Member& m) {
        c.platform->members = {m};
        return Vec6(Hull(c, nullptr).loads(t, State::Zero())[Load::members]);
    };
    Member upright = cylinder({0, 0, 10}, {0, 0, -60}, 2);
    upright.Ca = 0.8;
    const double q = rho * 1.8 * amplitude * w * w;
    const double F = -q * M_PI * (1 - std::exp(-60 * k)) / k;
    const double M = -q * M_PI * (-1 / k / k + std::exp(-60 * k) * (60 / k + 1 / k / k));
    const Vec6 load = force(upright);
    // strips as midpoints: (k l)^2/24 of the force
    EXPECT_NEAR(load[0], F, 1e-3 * std::abs(F));
    EXPECT_NEAR(load[4], M, 2e-3 * std::abs(M));
    Member tapered = cone({0, 0, 0}, {0, 0, -60}, 1, 4);
    tapered.Ca = 0.8;
    double sum = 0, moment = 0;
    for (int i = 0; i < 6000; ++i) {
        const double z = -0.005 - 0.01 * i, r = 0.5 - 1.5 * z / 60;
        sum -= q * M_PI * r * r * std::exp(k * z) * 0.01;
        moment -= q * M_PI * r * r * std::exp(k * z) * z * 0.01;
    }
    const Vec6 of_cone = force(tapered);
    EXPECT_NEAR(of_cone[0], sum, 1e-3 * std::abs(sum));
    EXPECT_NEAR(of_cone[4], moment, 2e-3 * std::abs(moment));
}

// Pressure p = rho g a e^{kz} cos(wt - kx) on the end faces is all that pushes a cylinder along its
// axis. Upright through the surface: buoyancy to the surface of the instant and Froude-Krylov make
// p on the lower face. Lying: the difference of p between its faces.
TEST(MemberShapes, PressureOnTheEndFaces) {
    const double w = 0.7, amplitude = 0.01, k = w * w / g;
    Case c = bare_case();
    c.environment.waves = {regular_wave(w, amplitude)};
    c.platform->members = {cylinder({0, 0, 10}, {0, 0, -40}, 2)};
    c.platform->members[0].Ca = 0;
    const double A = M_PI, rest = rho * g * A * 40;
    {
        const HullLoads loads = Hull(c, nullptr).loads(0, State::Zero());
        const double p = rho * g * amplitude * std::exp(-40 * k);
        // strips: (k l)^2/24 of rho g a A
        EXPECT_NEAR(loads[Load::members][2] + loads[Load::hydrostatic][2] - rest, p * A,
                    2e-3 * rho * g * amplitude * A);
    }
    c.platform->members = {cylinder({-20, 0, -12}, {20, 0, -12}, 2)};
    c.platform->members[0].Ca = 0;
    const double t = 1.3;
    const double p = rho * g * amplitude * std::exp(-12 * k);
    const double faces =
        p * A * (std::cos(w * t + 20 * k) - std::cos(w * t - 20 * k));  // at -20 m, +20 m
    EXPECT_NEAR(Hull(c, nullptr).loads(t, State::Zero())[Load::members][0], faces, 1e-3 * p * A);
}

TEST(MemberShapes, EndFacesHaveDragAndAddedMassOfTheirOwn) {
    Case c = bare_case();
    Member m = cone({0, 0, -5}, {0, 0, -25}, 4, 10);
    m.Ca = 0;
    m.end_Cd_from = 0.5, m.end_Cd_to = 1.0;
    m.end_Ca_from = 0.64, m.end_Ca_to = 0.64;
    c.platform->members = {m};
    const Hull hull(c, nullptr);
    const HullLoads loads = hull.loads(0, at({.velocity = {0, 0, -1.5}}));
    EXPECT_NEAR(loads.member_added_mass(2, 2), rho * 0.64 * 2 / 3 * M_PI * (8 + 125), 1e-6);
    EXPECT_NEAR(loads.member_added_mass(0, 0), 0, 1e-9);
    EXPECT_NEAR(loads[Load::members][2], 0.5 * rho * 2.25 * M_PI / 4 * (0.5 * 16 + 1.0 * 100),
                1e-6);
}

// Validation row B10: a column of 39 m and 198 m draft heaves with T = 2 pi sqrt(h Cm/g), 28 s
// within 3 %. Its flat keel moves water of 4/3 rho r^3: Cm = 1 + 4/3 r/(pi h) = 1.042.
TEST(MemberShapes, DeepDraftColumnHeavesInTwentyEightSeconds) {
    const double h = 198, r = 19.5;
    Case c = bare_case(rho * M_PI * r * r * h);
    Member m = cylinder({0, 0, 20}, {0, 0, -h}, 2 * r);
    m.end_Ca_to = 2 / M_PI;
    c.platform->members = {m};
    c.platform->fixed = {true, true, false, true, true, true};
    const Hull hull(c, nullptr);
    const double Cm = 1 + 4 * r / (3 * M_PI * h), T = 2 * M_PI * std::sqrt(h * Cm / g);
    State start = State::Zero();
    start[2] = 1;
    double before = 1, crossing = 0;
    run(hull, start, 0.1, 100, [&](double t, const State& s, const auto&) {
        if (before > 0 && s[2] <= 0) crossing = t - s[2] / (s[2] - before) * 0.1;
        before = s[2];
    });
    EXPECT_NEAR(4 * crossing, T, 1e-3 * T);
    EXPECT_NEAR(T, 28.0, 0.03 * 28.0);
}

}  // namespace
}  // namespace hawser::master
