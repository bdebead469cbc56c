// Natural frequencies of rods against closed forms: validation rows A8, A9, A11, A12; dynamic
// stiffness; structural damping R:5.
#include <gtest/gtest.h>

#include <cmath>

#include "rod/modes.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// A rod with its static solution, still and without a sea of its own to keep alive.
struct RestingRod {
    Case input;
    Sea sea;
    RodPack<Single> rod;
    explicit RestingRod(Case c) : input(std::move(c)), sea(still_sea(input)), rod(input, sea, {0}) {
        EXPECT_TRUE(rod.equilibrium({}, false).ok());
    }
    std::vector<RodMode> modes(int count) { return rod_modes(rod, 0, input, count); }
};

/// A straight rod along x under tension T, weightless but for what gives it a plane.
Case taut(const LineType& type, double L, int elements, double T) {
    const Vec3 end(L * (1 + T / type.EA), 0, 0);
    Case input = one_line(type, L, elements, fixed_at({0, 0, 0}), fixed_at(end));
    input.environment.water.gravity = 1e-9;
    input.environment.water.density = 0.0;
    return input;
}

/// Frequencies [rad/s] of the modes of one kind.
std::vector<double> frequencies(const std::vector<RodMode>& modes, RodMode::Kind kind) {
    std::vector<double> out;
    for (const RodMode& mode : modes)
        if (mode.kind == kind) out.push_back(std::sqrt(mode.omega_squared));
    return out;
}

TEST(TensionedBeam, HasTheFrequenciesOfTheClosedForm) {  // validation row A9
    // w_n = n pi/L sqrt((T + n^2 pi^2 EI/L^2)/m) with L, m of the stretched beam; order 6
    const double L0 = 1500, EA = 4e9, EI = 4.65e7, m0 = 200, T = 2e6, e = T / EA;
    const auto w = [&](int elements, RodMode::Kind kind) {
        RestingRod beam(taut(plain_type(m0, EA, EI), L0, elements, T));
        return frequencies(beam.modes(20), kind);
    };
    for (const auto kind : {RodMode::Kind::in_plane, RodMode::Kind::out_of_plane}) {
        const std::vector<double> got = w(40, kind);
        ASSERT_GE(got.size(), 10U);
        for (int n = 1; n <= 10; ++n) {
            // per unstretched length: bending energy 1/2 EI r''^2 ds of R:1, tension T/(1 + e)
            const double k = n * M_PI / L0;
            const double exact = k * std::sqrt((T / (1 + e) + k * k * EI) / m0);
            EXPECT_NEAR(got[static_cast<std::size_t>(n - 1)], exact, 1e-5 * exact) << n;
            const double textbook =
                n * M_PI / L0 / (1 + e) * std::sqrt((T + k * k * EI) / (m0 / (1 + e)));
            if (n <= 3) {
                EXPECT_NEAR(got[static_cast<std::size_t>(n - 1)], textbook, 3e-3 * textbook) << n;
            }
        }
    }
    const double k5 = 5 * M_PI / L0, exact = k5 * std::sqrt((T / (1 + e) + k5 * k5 * EI) / m0);
    const double coarse = w(10, RodMode::Kind::in_plane)[4] / exact - 1,
                 fine = w(20, RodMode::Kind::in_plane)[4] / exact - 1;
    EXPECT_GT(coarse / fine, 32);  // order 6 would give 64
}

TEST(AxialTendon, HasTheFrequenciesOfTheClosedForm) {  // validation row A12
    // Axial motion does not know the tension; a high one keeps the transverse modes apart.
    const double L = 3000, area = 0.03, EA = 2.07e11 * area, m = 7850 * area;
    RestingRod held(taut(plain_type(m, EA, 1e7), L, 20, 0.02 * EA));
    const auto w = frequencies(held.modes(60), RodMode::Kind::axial);
    ASSERT_GE(w.size(), 3U);
    EXPECT_NEAR(2 * M_PI / w[0], 1.16843, 1e-5);  // 2 L/c, c = 5135.1 m/s: five digits
    EXPECT_NEAR(w[2], 3 * M_PI / L * std::sqrt(EA / m), 1e-6 * w[2]);
    // Free at its lower end, hanging
    Case input = one_line(plain_type(m, EA, 1e7), L, 20, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 400.0;  // strain 4 % at the top, for the same reason
    RestingRod hanging(input);
    const auto free = frequencies(hanging.modes(60), RodMode::Kind::axial);
    ASSERT_GE(free.size(), 1U);
    EXPECT_NEAR(2 * M_PI / free[0], 2.33686, 1e-5);
}

TEST(HangingChain, HasTheModesOfTheBesselFunction) {  // validation row A8
    const double L = 100, g = 9.80665;
    Case input = one_line(plain_type(100, 1e10), L, 40, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.density = 0.0;
    RestingRod chain(input);
    const auto modes = chain.modes(8);
    const std::vector<double> j0 = {2.404826, 5.520078, 8.653728, 11.791534};
    const auto in_plane = frequencies(modes, RodMode::Kind::in_plane),
               out_of_plane = frequencies(modes, RodMode::Kind::out_of_plane);
    ASSERT_EQ(in_plane.size(), 4U);
    ASSERT_EQ(out_of_plane.size(), 4U);
    for (std::size_t n = 0; n < 4; ++n) {
        const double w = j0[n] / 2 * std::sqrt(g / L);  // 1e-4: the log singularity at the free end
        EXPECT_NEAR(in_plane[n], w, 1e-4 * w) << n;
        EXPECT_NEAR(out_of_plane[n], w, 1e-4 * w) << n;
    }
    // and its shape, J0(j0 sqrt(s/L)) with s from the free end
    for (std::size_t n = 0; n <= 40; ++n) {
        const double s = L * static_cast<double>(40 - n) / 40.0;
        EXPECT_NEAR(modes[0].shape[n].norm(), std::cyl_bessel_j(0.0, j0[0] * std::sqrt(s / L)),
                    1e-3)
            << n;
    }
}

/// First symmetric frequency of a shallow cable over that of a taut string, W/pi, from
/// tan(W/2) = W/2 - (4/l2)(W/2)^3 (Irvine 1981).
double irvine(double l2) {
    const auto f = [&](double W) {
        return std::sin(W / 2) - (W / 2 - 4 / l2 * std::pow(W / 2, 3)) * std::cos(W / 2);
    };
    double low = M_PI * (1 + 1e-9), high = 3 * M_PI;  // the root between the string and its third
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (f(low) * f(middle) <= 0 ? high : low) = middle;
    }
    return low / M_PI;
}

TEST(ShallowCable, HasIrvinesFrequencies) {  // validation row A11
    EXPECT_NEAR(irvine(1), 1.04020, 1e-5);
    EXPECT_NEAR(irvine(10), 1.34512, 1e-5);
    EXPECT_NEAR(irvine(4 * M_PI * M_PI), 2.0, 1e-5);
    EXPECT_NEAR(irvine(100), 2.59718, 1e-5);
    const double span = 100, m = 100, g = 9.80665;
    for (const double l2 : {1.0, 10.0, 4 * M_PI * M_PI, 100.0}) {
        const double slope = l2 < 20 ? 0.04 : 0.2;  // m g L/H: sag 1/200 or 1/40 of the span
        const double H = m * g * span / slope, EA = l2 * H / (slope * slope);
        const double length = span * (1 + slope * slope / 24) / (1 + H / EA);
        Case input =
            one_line(plain_type(m, EA), length, 40, fixed_at({0, 0, 0}), fixed_at({span, 0, 0}));
        input.environment.water.density = 0.0;
        RestingRod cable(input);
        // of the cable as it hangs: its own H, mass per stretched length
        const double H1 = std::abs(cable.rod.force_on_support_a(0).x());
        const double m1 = m / (1 + H1 / EA), q = m1 * g * span / H1, Le = span * (1 + q * q / 8);
        const double own = q * q * span * EA / (H1 * Le);
        const double string = M_PI / span * std::sqrt(H1 / m1);
        const auto modes = cable.modes(12);
        // out of plane a taut string; in plane the antisymmetric modes too, the first symmetric
        // one lies where Irvine says
        const auto across = frequencies(modes, RodMode::Kind::out_of_plane);
        EXPECT_NEAR(across[0] / string, 1.0, 0.01);
        double nearest = 1e300;
        for (const RodMode& mode : modes) {
            const double w = std::sqrt(mode.omega_squared) / string;
            const double symmetric = mode.shape[10].z() * mode.shape[30].z();
            if (mode.kind == RodMode::Kind::in_plane && symmetric > 0.0)
                nearest = std::min(nearest, std::abs(w / irvine(own) - 1));
        }
        EXPECT_LT(nearest, 0.01) << l2;
    }
}

TEST(RodModes, CarryTheWaterAlong) {
    // Added mass of the displaced water on transverse motion: m + rho A, here just doubled
    LineType dry = plain_type(1025, 1e10), wet = dry;
    wet.displaced_area = 1.0;
    wet.added_mass_normal = 1.0;
    Case in_air = taut(dry, 500, 20, 1e6), in_water = taut(wet, 500, 20, 1e6);
    in_water.environment.water.density = 1025.0;
    for (Case* c : {&in_air, &in_water})
        c->lines[0].end_a.position.z() = c->lines[0].end_b.position.z() = -100.0;
    RestingRod a(in_air), w(in_water);
    EXPECT_NEAR(a.modes(1)[0].omega_squared / w.modes(1)[0].omega_squared, 2.0, 1e-6);
}

TEST(RodModes, TellAnUnheldDirectionAsOneWithoutStiffness) {
    // A weightless rod with one free end: it turns about the other for nothing.
    Case input = one_line(plain_type(100, 1e9, 1e9), 50, 10, fixed_at({0, 0, 0}), LineEnd{});
    input.environment.water.gravity = 1e-9;
    input.environment.water.density = 0.0;
    RestingRod rod(input);
    const auto modes = rod.modes(4);
    EXPECT_LT(std::abs(modes[0].omega_squared), 1e-8);
    EXPECT_LT(std::abs(modes[1].omega_squared), 1e-8);
    // then hinged-free bending: (3.926602/L)^2 sqrt(EI/m)
    const double w = std::pow(3.926602 / 50, 2) * std::sqrt(1e9 / 100);
    EXPECT_NEAR(std::sqrt(modes[2].omega_squared), w, 1e-4 * w);
}

/// Dynamic stiffness of a vertical rod from the platform to the ground, heave and surge.
struct HungRod {
    double L = 800, EA = 1e9, m = 150, T = 5e6;
    Vec6 at(double omega, double EA_static = 0.0, double relaxation = 0.0) const {
        LineEnd top;
        top.kind = EndKind::platform;
        top.position = {0, 0, -10};
        LineType type = plain_type(m, EA);
        if (EA_static > 0.0)
            type.viscoelastic = Viscoelastic{
                .EA_dynamic = EA, .EA_static = EA_static, .relaxation_time = relaxation};
        const double stretch = 1 + T / (EA_static > 0.0 ? EA_static : EA);
        Case input = one_line(type, L, 40, top, fixed_at({0, 0, -10 - L * stretch}));
        input.environment.water.gravity = 1e-9;
        input.environment.water.density = 0.0;
        RestingRod rod(input);
        if (omega >= 0.0) rod.rod.swing(omega);
        return rod.rod.stiffness(0, {0, 0, 0}).diagonal();
    }
};

TEST(DynamicStiffness, IsThatOfABarAndAStringInClosedForm) {  // R:44
    const HungRod rod;
    const double lambda = rod.T / (1 + rod.T / rod.EA);
    for (const double omega : {0.3, 1.0, 6.0, 11.0}) {
        const double k = omega * std::sqrt(rod.m / rod.EA), q = omega * std::sqrt(rod.m / lambda);
        const double bar = rod.EA * k / std::tan(k * rod.L);
        const double string = lambda * q / std::tan(q * rod.L);
        const Vec6 S = rod.at(omega);
        EXPECT_NEAR(S[2], bar, 1e-6 * rod.EA / rod.L) << omega;
        if (omega <= 1.0) {  // three elements and more to a wave
            EXPECT_NEAR(S[0], string, 1e-4 * std::abs(string)) << omega;
        }
    }
}

TEST(DynamicStiffness, AtRestIsTheStaticStiffness) {
    const HungRod rod;
    const Vec6 still = rod.at(-1.0), slow = rod.at(0.0);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(slow[i], still[i], 1e-9 * std::abs(still[i]) + 1e-3);
}

TEST(DynamicStiffness, OfARopeGoesFromItsStaticToItsDynamicModulus) {  // validation row A21
    HungRod rod;
    rod.EA = 706.32e6, rod.m = 1e-3, rod.T = 1e6;
    const double Es = 451.26e6, L = rod.L;
    EXPECT_NEAR(rod.at(0.0, Es, 20.0)[2], Es / L, 1e-6 * Es / L);
    EXPECT_NEAR(rod.at(10.0, Es, 20.0)[2], rod.EA / L, 1e-4 * rod.EA / L);
    // storage moduli at 15.6 s, five digits given
    EXPECT_NEAR(rod.at(2 * M_PI / 15.6, Es, 2.5)[2], 579.67e6 / L, 1e-5 * rod.EA / L);
    EXPECT_NEAR(rod.at(2 * M_PI / 15.6, Es, 20.0)[2], 702.45e6 / L, 1e-5 * rod.EA / L);
}

TEST(HangingChain, SwingsWithTheBesselFrequencies) {  // validation row A8: 0.5 %
    const double L = 100, g = 9.80665;
    const std::vector<double> j0 = {2.404826, 5.520078, 8.653728, 11.791534};
    for (int n = 0; n < 4; ++n) {
        const double w = j0[static_cast<std::size_t>(n)] / 2 * std::sqrt(g / L);
        Case input = one_line(plain_type(100, 1e10), L, 40, fixed_at({0, 0, 0}), LineEnd{});
        input.environment.water.density = 0.0;
        // trapezoidal-like lengthening (w h)^2/12: below 1e-4
        input.analysis.dynamics.line_step = 2 * M_PI / w / 200;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        // u = a J0(j0 sqrt(s/L)), s from the free end; J0' = -J1, and at s = 0 the slope -a j0^2/4L
        const double j = j0[static_cast<std::size_t>(n)], a = 0.01;
        const auto mode = [&](double s) { return std::cyl_bessel_j(0.0, j * std::sqrt(s / L)); };
        displace(
            rod, L, -w * w, [&](double s) { return Vec3(a * mode(s), 0, 0); },
            [&](double s) {
                const double q = j * std::sqrt(s / L);
                const double slope =
                    q < 1e-9 ? -j * j / (4 * L) : -std::cyl_bessel_j(1.0, q) * j * j / (2 * L * q);
                return Vec3(a * slope, 0, 0);
            });
        Record swing;
        const double interval = 4 * input.analysis.dynamics.line_step;
        ASSERT_TRUE(run(rod, 6.2 * 2 * M_PI / w, interval, [&](double t) {
                        double sum = 0.0;  // projection on the mode
                        for (int i = 0; i <= 40; ++i)
                            sum += mode(L * (40 - i) / 40.0) * rod.node_position(0, i).x();
                        swing.add(t, sum);
                    }).ok());
        EXPECT_NEAR(swing.period(), 2 * M_PI / w, 0.005 * 2 * M_PI / w) << n + 1;
    }
}

struct AxialVibration {
    double ratio, period;  ///< of critical damping; over that of the closed form
};
/// Free axial vibration of a taut rod between fixed ends, started in its first mode; damping
/// ratio from the decay of the tension at end A over ten periods.
AxialVibration vibrate(double asked, int elements) {
    const double L = 1000, EA = 7e8, m = 60, w = M_PI / L * std::sqrt(EA / m), T = 2e6, e0 = T / EA;
    LineType type = plain_type(m, EA);
    type.damping_ratio = asked;
    Case input = one_line(type, L, elements, fixed_at({L * (1 + e0), 0, 0}), fixed_at({0, 0, 0}));
    input.environment.water.gravity = 1e-9;
    input.environment.water.density = 0.0;
    const double h = 2 * M_PI / w / 200;
    input.analysis.dynamics.line_step = h;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    const double a = 0.05, k = M_PI / L;
    displace(
        rod, L, -w * w, [&](double s) { return Vec3(a * std::sin(k * s), 0, 0); },
        [&](double s) { return Vec3(a * k * std::cos(k * s), 0, 0); });
    const auto strain = [&](double s) { return e0 + a * k * std::cos(k * s); };
    for (int i = 0; i <= 2 * elements; ++i) {
        const double e = strain(0.5 * L * i / elements);
        rod.kept().lambda()[i].now = rod.kept().lambda()[i].before = EA * e / (1 + e);
    }
    for (int i = 0; i < elements; ++i)
        for (std::size_t g = 0; g < gauss_points; ++g)
            rod.kept().strain()[static_cast<std::size_t>(i) * gauss_points + g].damper =
                strain(L * (i + gauss_xi[g]) / elements);
    Record tension;
    EXPECT_TRUE(run(rod, 10.6 * 2 * M_PI / w, h, [&](double t) {
                    tension.add(t, T - rod.tension_a(0));
                }).ok());
    // peaks, each the vertex of the parabola through three samples
    std::vector<double> peaks;
    const auto& y = tension.y;
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
        if (y[i] > y[i - 1] && y[i] >= y[i + 1] && y[i] > 0)
            peaks.push_back(y[i] - (y[i + 1] - y[i - 1]) * (y[i + 1] - y[i - 1]) /
                                       (8 * (y[i + 1] - 2 * y[i] + y[i - 1])));
    const double decrement =
        std::log(peaks.front() / peaks.back()) / (2 * M_PI * static_cast<double>(peaks.size() - 1));
    return {decrement / std::sqrt(1 + decrement * decrement), tension.period() * w / (2 * M_PI)};
}

TEST(StructuralDamping, DecaysWithTheRatioAskedForWhateverTheMesh) {  // R:5, acceptance 13
    for (const int elements : {10, 40}) {
        for (const double asked : {0.01, 0.05}) {
            const AxialVibration v = vibrate(asked, elements);
            EXPECT_NEAR(v.ratio, asked, 0.01 * asked) << elements;
        }
    }
}

TEST(StructuralDamping, IsAbsentWhenNotAskedFor) {  // and A12 in time: 0.5 %
    const AxialVibration v = vibrate(0.0, 20);
    EXPECT_LT(std::abs(v.ratio), 1e-6);  // of the scheme: third order in w h = 0.03, times 1e-3
    EXPECT_NEAR(v.period, 1.0, 0.005);
}

TEST(Modes, OfASingularOrUnfinishedMatrixAreNotTold) {
    SmallMotion motion;
    motion.stiffness.resize(3, 3), motion.mass.resize(3, 3);
    for (int i = 0; i < 3; ++i) motion.mass.insert(i, i) = i < 2 ? 1.0 : 0.0;
    motion.stiffness.insert(0, 0) = 4.0, motion.stiffness.insert(1, 1) = 9.0;
    EXPECT_THROW((void)lowest_modes(motion, 1), RunError);  // nothing holds the third
    motion.stiffness.insert(2, 2) = 1.0;
    EXPECT_NEAR(lowest_modes(motion, 1).omega_squared[0], 4.0, 1e-9);
    motion.stiffness.coeffRef(0, 0) = NAN;
    EXPECT_THROW((void)lowest_modes(motion, 1), RunError);
}

}  // namespace
}  // namespace hawser::worker
