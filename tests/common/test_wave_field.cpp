// Particle kinematics against the closed forms of Airy theory, stretching, depth filter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/dispersion.hpp"
#include "environment/wave_field.hpp"

namespace hawser {
namespace {

constexpr double g = 9.80665, pi = std::numbers::pi;

WaveComponent component(double amplitude, double omega, double depth, double phase = 0.0,
                        double heading = 0.0) {
    return {.amplitude = amplitude,
            .omega = omega,
            .k = wave_number(omega, depth, g),
            .phase = phase,
            .heading = heading};
}

/// Components from 0.3 to 2.2 rad/s with amplitudes of a steep sea, two headings.
std::vector<WaveComponent> some_sea(double depth) {
    std::vector<WaveComponent> components;
    for (int i = 0; i < 20; ++i)
        components.push_back(component(1.2 / (1.0 + 0.2 * i), 0.3 + 0.1 * i, depth, 1.7 * i * i,
                                       i % 2 == 0 ? 0.4 : -0.9));
    return components;
}

WaveField unstretched(const std::vector<WaveComponent>& components, double depth) {
    return {components, {.depth = depth, .stretching = Stretching::none}};
}

WaveField wheeler(const std::vector<WaveComponent>& components, double depth,
                  double depth_filter = 0.0) {
    return {components, {.depth = depth, .depth_filter = depth_filter}};
}

// The closed form with the standard library's functions; shallow, intermediate, deep. cosh(kh) of
// the deep case is 1e10 and more: the quotients of the code stay accurate where these do.
TEST(WaveField, KinematicsAreAirysInAnyDepth) {
    for (const double depth : {8.0, 50.0, 400.0}) {
        const double a = 1.5, w = 0.6, phase = 0.8, heading = 0.7;
        const WaveField field = unstretched({component(a, w, depth, phase, heading)}, depth);
        const double k = wave_number(w, depth, g);
        for (const double relative : {0.0, -0.1, -0.5, -0.97, -1.0}) {
            const double x = 31.0, y = -17.0, z = relative * depth, t = 123.4;
            const double theta =
                w * t - k * (x * std::cos(heading) + y * std::sin(heading)) + phase;
            const double C = std::cosh(k * (z + depth)) / std::sinh(k * depth);
            const double S = std::sinh(k * (z + depth)) / std::sinh(k * depth);
            const WaveSample s = field.sample(t, 1.0, x, y, z);
            const double tolerance = 1e-13;  // phases of 75 rad: 1e-14
            EXPECT_NEAR(s.ux, a * w * C * std::cos(theta) * std::cos(heading), tolerance);
            EXPECT_NEAR(s.uy, a * w * C * std::cos(theta) * std::sin(heading), tolerance);
            EXPECT_NEAR(s.uz, -a * w * S * std::sin(theta), tolerance);
            EXPECT_NEAR(s.ax, -a * w * w * C * std::sin(theta) * std::cos(heading), tolerance);
            EXPECT_NEAR(s.ay, -a * w * w * C * std::sin(theta) * std::sin(heading), tolerance);
            EXPECT_NEAR(s.az, -a * w * w * S * std::cos(theta), tolerance);
            EXPECT_NEAR(field.elevation(t, 1.0, x, y), a * std::cos(theta), tolerance);
        }
        // No flow through the bottom, but for the rounding of e^(-kh).
        EXPECT_NEAR(field.sample(3.0, 1.0, 0.0, 0.0, -depth).uz, 0.0, 1e-15);
    }
}

TEST(WaveField, SumsItsComponents) {
    const std::vector<WaveComponent> sea = some_sea(60.0);
    WaveSample total;
    for (const WaveComponent& c : sea) {
        const WaveSample s = unstretched({c}, 60.0).sample(77.0, 1.0, 5.0, -40.0, -12.0);
        total.ux += s.ux;
        total.uz += s.uz;
        total.ay += s.ay;
        total.az += s.az;
    }
    const WaveSample s = unstretched(sea, 60.0).sample(77.0, 1.0, 5.0, -40.0, -12.0);
    EXPECT_NEAR(s.ux, total.ux, 1e-13);
    EXPECT_NEAR(s.uz, total.uz, 1e-13);
    EXPECT_NEAR(s.ay, total.ay, 1e-13);
    EXPECT_NEAR(s.az, total.az, 1e-13);
}

// Central differences over 2e-3 m and s: error (w d)^2/6 about 1e-5 of k u or w u.
TEST(WaveField, FlowIsIncompressibleAndAccelerationIsItsRate) {
    const double d = 1e-3, t = 55.0, x = 12.0, y = 34.0, z = -7.0;
    const WaveField field = unstretched(some_sea(60.0), 60.0);
    const auto at = [&](double dt, double dx, double dy, double dz) {
        return field.sample(t + dt, 1.0, x + dx, y + dy, z + dz);
    };
    const double divergence = (at(0, d, 0, 0).ux - at(0, -d, 0, 0).ux + at(0, 0, d, 0).uy -
                               at(0, 0, -d, 0).uy + at(0, 0, 0, d).uz - at(0, 0, 0, -d).uz) /
                              (2.0 * d);
    EXPECT_NEAR(divergence, 0.0, 1e-6);
    EXPECT_NEAR(at(0, 0, 0, 0).ax, (at(d, 0, 0, 0).ux - at(-d, 0, 0, 0).ux) / (2.0 * d), 1e-5);
    EXPECT_NEAR(at(0, 0, 0, 0).ay, (at(d, 0, 0, 0).uy - at(-d, 0, 0, 0).uy) / (2.0 * d), 1e-5);
    EXPECT_NEAR(at(0, 0, 0, 0).az, (at(d, 0, 0, 0).uz - at(-d, 0, 0, 0).uz) / (2.0 * d), 1e-5);
}

// The surface rises with its particles: w at z = 0 is d eta/dt.
TEST(WaveField, SurfaceMovesWithItsParticles) {
    const WaveField field = unstretched(some_sea(60.0), 60.0);
    const double d = 1e-3;
    const double rate =
        (field.elevation(9.0 + d, 1.0, 3.0, 2.0) - field.elevation(9.0 - d, 1.0, 3.0, 2.0)) /
        (2.0 * d);
    EXPECT_NEAR(field.sample(9.0, 1.0, 3.0, 2.0, 0.0).uz, rate, 1e-5);
}

TEST(WaveField, WithoutStretchingWaterAboveMeanLevelMovesAsAtMeanLevel) {
    const WaveField field = unstretched(some_sea(60.0), 60.0);
    const WaveSample above = field.sample(9.0, 1.0, 3.0, 2.0, 4.0);
    const WaveSample level = field.sample(9.0, 1.0, 3.0, 2.0, 0.0);
    EXPECT_EQ(above.ux, level.ux);
    EXPECT_EQ(above.az, level.az);
    EXPECT_EQ(above.eta, 0.0);
}

// Wheeler 1970: z' = (z - eta) h/(h + eta), the same for every component.
TEST(WaveField, WheelerMovesTheProfileWithTheSurface) {
    const double h = 60.0, t = 41.0, x = 3.0, y = 2.0;
    const WaveField stretched = wheeler(some_sea(h), h), plain = unstretched(some_sea(h), h);
    const double eta = plain.elevation(t, 1.0, x, y);
    ASSERT_GT(std::abs(eta), 0.5);
    for (const double z : {eta, eta - 3.0, -20.0, -59.0, -h}) {
        const WaveSample s = stretched.sample(t, 1.0, x, y, z);
        const WaveSample p = plain.sample(t, 1.0, x, y, (z - eta) * h / (h + eta));
        EXPECT_NEAR(s.ux, p.ux, 1e-13);
        EXPECT_NEAR(s.uz, p.uz, 1e-13);
        EXPECT_NEAR(s.ax, p.ax, 1e-13);
        EXPECT_NEAR(s.az, p.az, 1e-13);
        EXPECT_NEAR(s.eta, eta, 1e-13);
    }
    // Surface to surface, bottom to bottom.
    EXPECT_NEAR(stretched.sample(t, 1.0, x, y, eta).ux, plain.sample(t, 1.0, x, y, 0.0).ux, 1e-13);
    EXPECT_NEAR(stretched.sample(t, 1.0, x, y, -h).ux, plain.sample(t, 1.0, x, y, -h).ux, 1e-13);
    // Nothing grows above the surface.
    EXPECT_EQ(stretched.sample(t, 1.0, x, y, eta + 30.0).ux,
              stretched.sample(t, 1.0, x, y, eta + 1.0).ux);
}

// Wavelength 100 m: seen at 99.9 m of stretched depth, not at 100.1 m.
TEST(WaveField, FilterDropsAComponentBelowItsWavelengths) {
    const double h = 1500.0, w = std::sqrt(g * 2.0 * pi / 100.0);
    for (const double filter : {1.0, 0.5}) {
        const WaveField field({component(1.0, w, h)},
                              {.depth = h, .depth_filter = filter, .stretching = Stretching::none});
        const WaveField all = unstretched({component(1.0, w, h)}, h);
        const WaveSample seen = field.sample(1.0, 1.0, 0.0, 0.0, -99.9 * filter);
        EXPECT_EQ(seen.ux, all.sample(1.0, 1.0, 0.0, 0.0, -99.9 * filter).ux);
        EXPECT_NE(seen.ux, 0.0);
        EXPECT_EQ(field.sample(1.0, 1.0, 0.0, 0.0, -100.1 * filter).ux, 0.0);
        EXPECT_NE(all.sample(1.0, 1.0, 0.0, 0.0, -100.1 * filter).ux, 0.0);
    }
}

// Between the depths of two wavelengths only the longer wave is left, also where both are summed
// side by side.
TEST(WaveField, FilterKeepsTheLongerOfTwoWaves) {
    const double h = 1500.0;
    const WaveComponent longer = component(1.0, std::sqrt(g * 2.0 * pi / 104.0), h);
    const WaveComponent shorter = component(1.0, std::sqrt(g * 2.0 * pi / 100.0), h, 1.0);
    const WaveField::Settings filter{
        .depth = h, .depth_filter = 1.0, .stretching = Stretching::none};
    const WaveSample two = WaveField({longer, shorter}, filter).sample(1.0, 1.0, 0.0, 0.0, -102.0);
    const WaveSample one = WaveField({longer}, filter).sample(1.0, 1.0, 0.0, 0.0, -102.0);
    EXPECT_EQ(two.ux, one.ux);
    EXPECT_EQ(two.az, one.az);
    EXPECT_NE(one.ux, 0.0);
}

// Each component left out has a depth factor below e^(-2 pi) = 0.0019, so at any depth the filter
// changes u by less than that times the sum of their A w, and a by that times A w^2. The elevation
// above the point keeps all components.
TEST(WaveField, FilterErrorIsBoundedAtAnyDepth) {  // P:6
    const double h = 1500.0;
    const std::vector<WaveComponent> sea = some_sea(h);
    const WaveField filtered = wheeler(sea, h, 1.0), all = wheeler(sea, h);
    bool differs = false;
    for (double z = 0.0; z > -h; z -= 7.3) {
        const WaveSample f = filtered.sample(200.0, 1.0, 30.0, 0.0, z);
        const WaveSample s = all.sample(200.0, 1.0, 30.0, 0.0, z);
        double bound = 0.0;
        for (const WaveComponent& c : sea)
            if (c.k * (-z + 12.0) > 2.0 * pi)  // 12 m: more than the stretching moves any point
                bound += c.amplitude * c.omega * std::max(1.0, c.omega) * std::exp(-2.0 * pi);
        for (const double difference :
             {f.ux - s.ux, f.uy - s.uy, f.uz - s.uz, f.ax - s.ax, f.ay - s.ay, f.az - s.az}) {
            EXPECT_LE(std::abs(difference), bound) << z;
            differs = differs || difference != 0.0;
        }
        EXPECT_EQ(f.eta, s.eta);
    }
    EXPECT_TRUE(differs);
}

// The ramp multiplies velocity, acceleration and elevation, and the stretching sees the ramped
// elevation: below, half a wave of 2 m is a wave of 1 m.
TEST(WaveField, RampedWaveIsASmallerWave) {
    const double h = 100.0;
    const WaveField tall = wheeler({component(2.0, 0.7, h)}, h);
    const WaveField low = wheeler({component(1.0, 0.7, h)}, h);
    const WaveSample a = tall.sample(4.0, 0.5, 10.0, 0.0, -3.0);
    const WaveSample b = low.sample(4.0, 1.0, 10.0, 0.0, -3.0);
    EXPECT_NEAR(a.ux, b.ux, 1e-15);
    EXPECT_NEAR(a.az, b.az, 1e-15);
    EXPECT_NEAR(a.eta, b.eta, 1e-15);
    EXPECT_NE(b.eta, 0.0);
}

// More components than the kernel keeps between its two passes (512): the rest is worked out again.
TEST(WaveField, AnyNumberOfComponentsIsSummed) {
    const double h = 300.0;
    std::vector<WaveComponent> few, many;
    for (int i = 0; i < 90; ++i) {
        few.push_back(component(0.9, 0.3 + 0.01 * i, h, 0.1 * i * i));
        for (int j = 0; j < 9; ++j) many.push_back(component(0.1, 0.3 + 0.01 * i, h, 0.1 * i * i));
    }
    const WaveSample a = wheeler(few, h).sample(100.0, 1.0, 10.0, 0.0, -5.0);
    const WaveSample b = wheeler(many, h).sample(100.0, 1.0, 10.0, 0.0, -5.0);
    EXPECT_NEAR(a.ux, b.ux, 1e-11);
    EXPECT_NEAR(a.az, b.az, 1e-11);
    EXPECT_NEAR(a.eta, b.eta, 1e-11);
}

// --- vertical and extrapolated ------------------------------------------------------------------

WaveField stretched(const std::vector<WaveComponent>& components, double depth,
                    Stretching stretching) {
    return {components, {.depth = depth, .stretching = stretching}};
}

void expect_same_motion(const WaveSample& a, const WaveSample& b) {
    EXPECT_EQ(a.ux, b.ux);
    EXPECT_EQ(a.uy, b.uy);
    EXPECT_EQ(a.uz, b.uz);
    EXPECT_EQ(a.ax, b.ax);
    EXPECT_EQ(a.ay, b.ay);
    EXPECT_EQ(a.az, b.az);
}

TEST(WaveField, VerticalStretchingHoldsTheMeanLevelsValuesUpToTheSurface) {
    const double h = 60.0;
    const WaveField vertical = stretched(some_sea(h), h, Stretching::vertical);
    const WaveField plain = unstretched(some_sea(h), h);
    for (const double t : {1.0, 7.0, 20.0})
        for (const double z : {-30.0, -1.0, 0.0, 2.0, 50.0}) {
            const WaveSample sample = vertical.sample(t, 0.8, 3.0, 1.0, z);
            expect_same_motion(sample, plain.sample(t, 0.8, 3.0, 1.0, std::min(z, 0.0)));
            EXPECT_NEAR(sample.eta, vertical.elevation(t, 0.8, 3.0, 1.0), 1e-14);
        }
}

// One component under its crest, where u = A w (coth kh + k z) above mean sea level: the tangent of
// A w cosh k(z + h)/sinh kh at z = 0. The vertical acceleration likewise, -A w^2 (1 + k z coth kh).
TEST(WaveField, ExtrapolationFollowsTheTangentAtMeanLevel) {
    for (const double h : {10.0, 200.0}) {
        const double A = 2.5, w = 0.7;
        const WaveComponent c = component(A, w, h, 0.0, 0.5);
        const WaveField field = stretched({c}, h, Stretching::extrapolation);
        for (const double z : {0.0, 0.6, 2.0, 2.5}) {
            const WaveSample crest = field.sample(0.0, 1.0, 0.0, 0.0, z);
            const double coth = 1 / std::tanh(c.k * h), u = A * w * (coth + c.k * z);
            EXPECT_NEAR(crest.ux, u * std::cos(0.5), 1e-12);
            EXPECT_NEAR(crest.uy, u * std::sin(0.5), 1e-12);
            EXPECT_NEAR(crest.az, -A * w * w * (1 + c.k * z * coth), 1e-12);
            EXPECT_NEAR(crest.eta, A, 1e-12);
        }
        // In the air the surface's values hold.
        expect_same_motion(field.sample(0.0, 1.0, 0.0, 0.0, 9.0),
                           field.sample(0.0, 1.0, 0.0, 0.0, field.elevation(0.0, 1.0, 0.0, 0.0)));
    }
}

// In a sea: value and slope of the unstretched field go on; below, and in troughs, nothing changes.
TEST(WaveField, ExtrapolationContinuesTheUnstretchedField) {
    const double h = 60.0;
    const WaveField field = stretched(some_sea(h), h, Stretching::extrapolation);
    const WaveField plain = unstretched(some_sea(h), h);
    int crests = 0;
    for (double t = 0.0; t < 60.0; t += 1.0) {
        const double eta = field.elevation(t, 1.0, 3.0, 1.0);
        for (const double z : {-20.0, -0.5, 0.0})
            expect_same_motion(field.sample(t, 1.0, 3.0, 1.0, z),
                               plain.sample(t, 1.0, 3.0, 1.0, z));
        const double d = 1e-4;  // difference of the plain field: second order, k^2 d/2
        const WaveSample top = plain.sample(t, 1.0, 3.0, 1.0, 0.0);
        const WaveSample low = plain.sample(t, 1.0, 3.0, 1.0, -d);
        const double z = std::clamp(0.7 * eta, 0.0, 10.0);
        const WaveSample above = field.sample(t, 1.0, 3.0, 1.0, z);
        crests += z > 0.5;
        EXPECT_NEAR(above.ux, top.ux + z * (top.ux - low.ux) / d, 1e-3 * (1 + z));
        EXPECT_NEAR(above.uz, top.uz + z * (top.uz - low.uz) / d, 1e-3 * (1 + z));
        EXPECT_NEAR(above.ay, top.ay + z * (top.ay - low.ay) / d, 1e-3 * (1 + z));
        EXPECT_NEAR(above.az, top.az + z * (top.az - low.az) / d, 1e-3 * (1 + z));
    }
    EXPECT_GT(crests, 5);
}

}  // namespace
}  // namespace hawser
