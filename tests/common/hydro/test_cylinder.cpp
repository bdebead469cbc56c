// Matched eigenfunctions (H:1 to H:13) against closed forms, their own identities, and the numbers
// of another program. Folders truncated_cylinder and spar_hard_soft_tank of the reference data.
#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <cmath>

#include "environment/dispersion.hpp"
#include "hydro/cylinder_data.hpp"

namespace hawser::hydro {
namespace {

constexpr double rho = 1025.0, g = 9.80665;
const Hull column{100.0, {{10.0, 0.0, -100.0}}};
const Hull truncated{300.0, {{20.0, 0.0, -70.0}}};
const Hull spar{1500.0, {{20.0, 0.0, -70.0}, {20.0, -165.0, -175.0}}};

CylinderFlow flow_of(const Hull& hull, double level, double w = 1.0) {
    return {hull, {level, w * w / g}};
}
WaveResponse response(const Hull& hull, double level, double w, const FreeHull* free = nullptr) {
    CylinderFlow flow = flow_of(hull, level, w);
    return wave_response(flow, hull, w, {rho, g}, free);
}

/// |H_m'(x)|^2.
double slope2(int m, double x) {
    const double j = boost::math::cyl_bessel_j_prime(m, x),
                 y = boost::math::cyl_neumann_prime(m, x);
    return j * j + y * y;
}

TEST(BottomFoundedColumn, IsExcitedAsMacCamyAndFuchsSay) {  // H:9
    // F = 4 rho g tanh kh / (k^2 |H_1'(kR)|); M about the waterline likewise with
    // integral z cosh k(z+h) dz = -(cosh kh - 1) / k^2. No sum is involved: rounding.
    const double R = 10.0, h = 100.0;
    for (const double w : {0.2, 0.5, 1.0, 2.0}) {
        const double k = wave_number(w, h, g), H = std::sqrt(slope2(1, k * R));
        const WaveResponse r = response(column, 1.0, w);
        const double F = 4.0 * rho * g * std::tanh(k * h) / (k * k * H);
        const double M = 4.0 * rho * g * (1.0 - 1.0 / std::cosh(k * h)) / (k * k * k * H);
        EXPECT_NEAR(std::abs(r.surge_force), F, 1e-9 * F) << w;
        EXPECT_NEAR(std::abs(r.pitch_moment), M, 1e-9 * M) << w;
        EXPECT_EQ(r.heave_force, 0.0);
    }
    // Long waves: 2 rho pi R^2 times the water's acceleration, which leads the crest by 90 degrees.
    const WaveResponse r = response(column, 1.0, 0.05);
    EXPECT_NEAR(std::arg(r.surge_force), M_PI / 2, 1e-3);
}

TEST(BottomFoundedColumn, DriftsAsHavelockSays) {  // H:11
    // 4 / (pi kR)^2 rho g / k (1 + 2kh / sinh 2kh) sum [1 - m(m+1)/(kR)^2]^2 / (|H_m'|^2
    // |H_(m+1)'|^2) in long waves of deep water 5/16 pi^2 rho g R (kR)^3, in short ones 2/3 rho g
    // R.
    for (const double w : {0.3, 0.6, 1.0, 2.0}) {
        const double R = 10.0, h = 100.0, k = wave_number(w, h, g), x = k * R;
        double sum = 0.0;
        for (int m = 0; m < 40; ++m) {
            const double factor = 1.0 - m * (m + 1.0) / (x * x);
            sum += factor * factor / (slope2(m, x) * slope2(m + 1, x));
        }
        const double depth_factor = 1.0 + 2.0 * k * h / std::sinh(2.0 * k * h);
        const double drift = 4.0 / (M_PI * M_PI * x * x) * rho * g / k * depth_factor * sum;
        EXPECT_NEAR(response(column, 1.0, w).drift, drift, 1e-9 * drift) << w;
    }
}

TEST(BottomFoundedColumn, SlowlyMovedCarriesTheWaterItDisplaces) {  // H:7
    // Under a rigid lid the flow is plane: A11 = rho pi R^2 h. K h = 1e-5 here; the sum has 2e4
    // terms.
    const double A = rho * M_PI * 100.0 * 100.0;
    EXPECT_NEAR(response(column, 1.0, 0.001).surge_added_mass, A, 1e-4 * A);
}

TEST(TruncatedCylinder, AgreesWithTheReference) {
    // truncated_cylinder, w = 0.425 and 0.75 rad/s: added mass and damping / rho, and the README's
    // drift. They carry 0.1 % of their own, the off-diagonal terms 0.3 %.
    const WaveResponse r = response(truncated, 2.0, 0.425), q = response(truncated, 2.0, 0.75);
    const auto near = [](double value, double expected, double part) {
        EXPECT_NEAR(value, expected, part * std::abs(expected));
    };
    near(r.surge_added_mass, rho * 8.672581e4, 1e-3);
    near(r.surge_pitch_added_mass, rho * -2.614312e6, 1e-3);
    near(r.heave_added_mass, rho * 1.505740e4, 1e-3);
    near(r.pitch_added_mass, rho * 9.867721e7, 1e-3);
    near(r.surge_damping, rho * 0.425 * 1.525758e4, 1e-3);
    near(r.heave_damping, rho * 0.425 * 6.253117e2, 1e-3);
    near(r.pitch_damping, rho * 0.425 * 1.079913e7, 1e-3);
    near(q.surge_added_mass, rho * 4.751005e4, 1e-3);
    near(q.heave_damping, rho * 0.75 * 2.860603, 3e-3);
    near(std::abs(r.surge_force), 1.830e7, 1e-3);
    near(q.drift, 1.303e5, 1e-3);
}

TEST(HardAndSoftTank, AgreeWithTheReference) {
    // spar_hard_soft_tank at w = 0.425 rad/s, /rho, and its infinite limit, which it takes at 40
    // rad/s (0.3 % of surge is due to that). It carries 0.2 % of its own.
    const WaveResponse r = response(spar, 2.0, 0.425);
    const auto near = [](double value, double expected) {
        EXPECT_NEAR(value, expected, 5e-3 * std::abs(expected));
    };
    near(r.surge_added_mass, rho * 9.018406e4);
    near(r.surge_pitch_added_mass, rho * -3.199627e6);
    near(r.heave_added_mass, rho * 4.069700e4);
    near(r.pitch_added_mass, rho * 1.988254e8);
    near(r.surge_damping, rho * 0.425 * 1.547602e4);
    near(r.heave_damping, rho * 0.425 * 4.907367e2);
    near(r.pitch_damping, rho * 0.425 * 1.181641e7);
    CylinderFlow flow = flow_of(spar, 2.0);
    const AzimuthFlow heave = flow.solve(0, infinite_frequency);
    const AzimuthFlow pitch = flow.solve(1, infinite_frequency);
    near(-heave.force(0, 0).real(), 4.124967e4);
    near(-pitch.force(0, 0).real(), 5.784061e4);
    near(-pitch.force(1, 1).real(), 1.865454e8);
}

// A stepped column, a sunken drum, three radii with gaps, a drum on the seabed under a float.
const Hull stepped{120.0, {{10.0, 0.0, -30.0}, {20.0, -30.0, -60.0}}};
const Hull sunken{100.0, {{10.0, -10.0, -30.0}}};
const Hull threefold{200.0, {{10.0, 0.0, -30.0}, {5.0, -40.0, -60.0}, {14.0, -70.0, -80.0}}};
const Hull above_a_drum{60.0, {{12.0, 0.0, -10.0}, {8.0, -40.0, -60.0}}};

class EveryHull : public testing::TestWithParam<const Hull*> {};
INSTANTIATE_TEST_SUITE_P(Hulls, EveryHull,
                         testing::Values(&column, &truncated, &stepped, &sunken, &threefold,
                                         &above_a_drum));

TEST_P(EveryHull, KeepsReciprocityHaskindAndEnergy) {  // H:7, H:9, H:12
    CylinderFlow flow = flow_of(*GetParam(), 1.0);
    for (const double w : {0.2, 0.6, 1.0}) {
        const AzimuthFlow f = flow.solve(1, w * w / g);
        EXPECT_LT(std::abs(f.force(0, 1) - f.force(1, 0)), 1e-9 * std::abs(f.force(0, 1)));
        const WaveResponse r = wave_response(flow, *GetParam(), w, {rho, g}, nullptr);
        EXPECT_LT(r.haskind_gap, 1e-6) << w;
        EXPECT_LT(r.energy_gap, 1e-6) << w;
        EXPECT_GE(r.heave_damping, 0.0);
        EXPECT_GE(r.surge_damping, 0.0);
        EXPECT_GE(r.drift, -1e-6 * rho * g);  // no hull at rest is pulled against the waves
    }
}

TEST_P(EveryHull, ConvergesAndStaysWithinItsStatedError) {  // H:13
    CylinderRequest request{*GetParam(), {0.3, 0.6}, {0.0}, {rho, g}, {}, 0.0, 5e-3};
    const CylinderData data = cylinder_data(request);
    EXPECT_TRUE(data.within_tolerance);
    EXPECT_LT(data.truncation_error, 5e-3);
    const WaveResponse finest = response(*GetParam(), 3.0, 0.6);
    const Mat6& A = data.data.added_mass[1];
    EXPECT_NEAR(A(0, 0), finest.surge_added_mass, data.truncation_error * A(0, 0) + 1e-9 * A(0, 0));
    EXPECT_NEAR(A(2, 2), finest.heave_added_mass, data.truncation_error * A(2, 2) + 1e-9 * A(0, 0));
    EXPECT_NEAR(A(4, 4), finest.pitch_added_mass, data.truncation_error * A(4, 4) + 1e-9 * A(4, 4));
}

TEST(PartsOfOneRadius, AreOneCylinder) {  // H:1
    const Hull two{300.0, {{20.0, -30.0, -70.0}, {20.0, 0.0, -30.0}}};
    const WaveResponse a = response(two, 1.0, 0.5), b = response(truncated, 1.0, 0.5);
    EXPECT_EQ(a.surge_added_mass, b.surge_added_mass);
    EXPECT_EQ(a.heave_force, b.heave_force);
}

TEST(DeeplySunkenDrum, MovesAsInUnboundedWater) {  // H:7
    // Far from surface and bed nothing radiates and the surface's two limits are alike: images at
    // 200 m change the added mass of 5 m by (5/200)^3.
    const Hull drum{200.0, {{5.0, -95.0, -105.0}}};
    CylinderFlow flow = flow_of(drum, 2.0);
    const double still = flow.solve(0, 1e-6).force(0, 0).real();
    EXPECT_NEAR(flow.solve(0, infinite_frequency).force(0, 0).real() / still, 1.0, 1e-3);
    // Between a disc and a sphere of its size: 8/3 and 2/3 pi times rho R^3, the drum's being
    // larger.
    EXPECT_GT(-still, 8.0 / 3.0 * 125.0);
}

TEST(FreeHullInWaves, RidesLongWavesAndLosesItsDriftThere) {  // H:10, H:11
    const FreeHull free{9.016371e7, -42.0, 25.0, 0.0, 0.0};
    const WaveResponse r = response(truncated, 2.0, 0.06, &free);
    EXPECT_NEAR(std::abs(r.heave), 1.0, 0.05);
    EXPECT_LT(std::abs(r.drift), 0.02 * response(truncated, 2.0, 0.06).drift);
}

TEST(FreeHullInWaves, DampedHeaveIsAsHighAsItsDampingSays) {  // H:10
    // At resonance |heave| = |X| / (w (B + c)).
    const FreeHull still{9.016371e7, -42.0, 25.0, 2e7, 0.0};
    CylinderFlow flow = flow_of(truncated, 1.0);
    const double c = heave_damping_of(0.1, flow, truncated, {rho, g}, still);
    const double C33 = rho * g * M_PI * 400.0;
    const double w = 2.0 * 0.1 * C33 / c;  // c = 2 z C / w
    FreeHull damped = still;
    damped.heave_damping = c;
    const WaveResponse r = wave_response(flow, truncated, w, {rho, g}, &damped);
    EXPECT_NEAR(std::abs(r.heave) * w * (r.heave_damping + c) / std::abs(r.heave_force), 1.0, 1e-6);
}

TEST(WrongHull, IsToldAllAtOnce) {
    EXPECT_TRUE(problems_of(spar).empty());
    EXPECT_EQ(problems_of({0.0, {}}).size(), 2U);
    EXPECT_EQ(problems_of({100.0, {{-1.0, 0.0, -10.0}, {5.0, 2.0, -5.0}}}).size(), 3U);
    EXPECT_EQ(problems_of({100.0, {{5.0, 0.0, -101.0}}}).size(), 1U);
    EXPECT_EQ(problems_of({100.0, {{5.0, -10.0, -5.0}}}).size(), 1U);
    EXPECT_EQ(problems_of({3000.0, {{5.0, 0.0, -10.0}, {5.001, -10.0, -20.0}}}).size(), 1U);
}

}  // namespace
}  // namespace hawser::hydro
