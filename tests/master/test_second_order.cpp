// Forces at difference and sum frequencies from full quadratic transfer functions: K:11, K:12.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "drift.hpp"
#include "second_order.hpp"
#include "spar_hull.hpp"
#include "wave_phases.hpp"
#include "yaw_axes.hpp"

namespace hawser::master {
namespace {

using Of = QuadraticLoad::Of;
constexpr double degree = M_PI / 180;

/// A quadratic transfer function with a formula: sum_r s_r f_r(w1, b1) g_r(w2, b2), g = conj(f) for
/// differences and f for sums, of polynomials f of degree 2 in w, which the program interpolates
/// exactly away from the ends. Every mode another one; Hermitian or symmetric by its making.
CVec6 formula(Of of, double w1, double w2, double b1, double b2) {
    const auto f = [](int mode, int r, double w, double b) {
        const double x = w - 0.5;
        const double c = std::cos(b + 0.3 * mode), s = std::sin(b - 0.1 * r);
        return Complex((1 + 0.2 * mode) * c + (2 - r) * x + 3 * s * x * x,
                       0.5 * r - (1.5 + mode) * x * c + 0.4 * x * x);
    };
    CVec6 Q = CVec6::Zero();
    for (int mode = 0; mode < 6; ++mode)
        for (int r = 0; r < 3; ++r) {
            const Complex second = f(mode, r, w2, b2);
            Q[mode] += (r == 1 ? -2e4 : 3e4) * f(mode, r, w1, b1) *
                       (of == Of::differences ? std::conj(second) : second);
        }
    return Q;
}

struct Headings {
    std::vector<double> all;
    bool crossed = true;
};

Qtf qtf_of_formula(Of of, const Headings& headings, double from = 0.1, double to = 1.7,
                   int n = 17) {
    Qtf qtf;
    for (int i = 0; i < n; ++i)
        qtf.frequencies.push_back(from + (to - from) * i / (n - 1) + 0.01 * (i % 2));  // uneven
    for (const double b1 : headings.all)
        for (const double b2 : headings.all) {
            if (!headings.crossed && b1 != b2) continue;
            QtfPair& pair = qtf.pairs.emplace_back();
            pair.heading_1 = b1;
            pair.heading_2 = b2;
            for (const double w1 : qtf.frequencies)
                for (const double w2 : qtf.frequencies)
                    pair.values.push_back(formula(of, w1, w2, b1, b2));
            pair.given.assign(pair.values.size(), 1);
        }
    return qtf;
}

std::vector<WaveComponent> sea_of(const std::vector<WaveTrain>& trains) {
    Environment e;
    e.seabed.depth = 1500;
    e.waves = trains;
    return Sea(e, 0, 0).components();
}

/// The double sum as it is written: over all ordered pairs of components.
Vec6 double_sum(Of of, const std::vector<WaveComponent>& components,
                const std::vector<Complex>& phases,
                const std::function<CVec6(const WaveComponent&, const WaveComponent&)>& Q) {
    Vec6 force = Vec6::Zero();
    for (std::size_t m = 0; m < components.size(); ++m)
        for (std::size_t n = 0; n < components.size(); ++n) {
            const Complex other = of == Of::differences ? std::conj(phases[n]) : phases[n];
            force += (phases[m] * other * Q(components[m], components[n])).real();
        }
    return force;
}

/// Largest sum of amplitudes times coefficients: what rounding is measured against.
double scale(Of of, const std::vector<WaveComponent>& components) {
    double amplitudes = 0;
    for (const WaveComponent& c : components) amplitudes += c.amplitude;
    return amplitudes * amplitudes * formula(of, 1.5, 1.5, 0, 0).norm();
}

TEST(FullQtf, IsTheDoubleSumOverAllPairsOfComponents) {  // K:11, K:12
    for (const Of of : {Of::differences, Of::sums}) {
        const auto components = sea_of({paper_sea(3)});
        const QuadraticLoad quadratic(qtf_of_formula(of, {{0.0}}), of, components);
        std::vector<Complex> phases(components.size());
        for (const WavePosition at : {WavePosition{}, WavePosition{31.0, -4.0, 0.0}})
            for (const double t : {0.0, 17.3, 4321.5}) {
                WavePhases(components).set(t, at, phases);
                const Vec6 pairs = double_sum(of, components, phases,
                                              [&](const WaveComponent& a, const WaveComponent& b) {
                                                  return formula(of, a.omega, b.omega, 0, 0);
                                              });
                EXPECT_LT((quadratic.load(phases, 0) - pairs).norm(),
                          1e-12 * scale(of, components));
                EXPECT_GT(pairs.norm(), 1e-5 * scale(of, components));
            }
    }
}

/// Amplitude of cos and sin at a frequency that fits `periods` times into T.
Complex harmonic(const std::function<double(double)>& f, double T, int periods, int n = 400) {
    Complex sum = 0;
    for (int i = 0; i < n; ++i) sum += f(i * T / n) * std::polar(1.0, -2 * M_PI * periods * i / n);
    return (periods == 0 ? 1.0 : 2.0) * sum / static_cast<double>(n);
}

TEST(FullQtf, TwoWavesForceAtTheirDifferenceTheirSumAndTheirDoubles) {
    const double T = 2 * M_PI / 0.1, w1 = 0.8, w2 = 0.5;  // all of them fit into T
    const auto components =
        sea_of({{.type = WaveType::airy, .H = 3, .T = 2 * M_PI / w2},
                {.type = WaveType::airy, .H = 4, .T = 2 * M_PI / w1, .phase = 40 * degree}});
    const double a2 = 1.5, a1 = 2.0;
    const Complex e1 = std::polar(1.0, components[1].phase);
    ASSERT_NEAR(components[1].omega, w1, 1e-12);
    std::vector<Complex> phases(2);
    const auto at = [&](const QuadraticLoad& load, int mode) {
        return [&, mode](double t) {
            WavePhases(components).set(t, {}, phases);
            return load.load(phases, 0)[mode];
        };
    };
    const QuadraticLoad slow(qtf_of_formula(Of::differences, {{0.0}}), Of::differences, components);
    const QuadraticLoad fast(qtf_of_formula(Of::sums, {{0.0}}), Of::sums, components);
    for (const int mode : {0, 2, 4}) {
        const auto D = [&](double x, double y) {
            return formula(Of::differences, x, y, 0, 0)[mode];
        };
        const auto S = [&](double x, double y) { return formula(Of::sums, x, y, 0, 0)[mode]; };
        const double tiny = 1e-10 * std::abs(S(w1, w1));
        EXPECT_NEAR(
            std::abs(harmonic(at(slow, mode), T, 0) - (a1 * a1 * D(w1, w1) + a2 * a2 * D(w2, w2))),
            0, tiny);
        EXPECT_NEAR(std::abs(harmonic(at(slow, mode), T, 3) - 2 * a1 * a2 * e1 * D(w1, w2)), 0,
                    tiny);
        EXPECT_NEAR(std::abs(harmonic(at(slow, mode), T, 13)), 0, tiny);
        EXPECT_NEAR(std::abs(harmonic(at(fast, mode), T, 13) - 2 * a1 * a2 * e1 * S(w1, w2)), 0,
                    tiny);
        EXPECT_NEAR(std::abs(harmonic(at(fast, mode), T, 16) - a1 * a1 * e1 * e1 * S(w1, w1)), 0,
                    tiny);
        EXPECT_NEAR(std::abs(harmonic(at(fast, mode), T, 10) - a2 * a2 * S(w2, w2)), 0, tiny);
        EXPECT_NEAR(std::abs(harmonic(at(fast, mode), T, 0)), 0, tiny);
        EXPECT_NEAR(std::abs(harmonic(at(fast, mode), T, 3)), 0, tiny);
    }
}

TEST(FullQtf, TurnsWithWavesAndHull) {
    // The same sea from 25 deg, met by a hull that has yawed 25 deg: the same force, turned.
    const double turn = 25 * degree;
    WaveTrain train = paper_sea(5);
    const auto ahead = sea_of({train});
    train.heading = turn;
    const auto turned = sea_of({train});
    for (const Of of : {Of::differences, Of::sums}) {
        const Qtf qtf = qtf_of_formula(of, {{-60 * degree, 0.0, 60 * degree}});
        const QuadraticLoad first(qtf, of, ahead), second(qtf, of, turned);
        std::vector<Complex> phases(ahead.size()), others(ahead.size());
        WavePhases(ahead).set(77, {12, 5, 0}, phases);
        const Vec3 place = turned_by_yaw(Vec3(12, 5, 0), turn);
        WavePhases(turned).set(77, {place.x(), place.y(), turn}, others);
        const Vec6 force = first.load(phases, 0);
        EXPECT_LT((second.load(others, turn) - turned_by_yaw(force, turn)).norm(),
                  1e-9 * force.norm());
        // Not turned, it feels something else: the function of 25 deg.
        EXPECT_GT((second.load(others, 0) - force).norm(), 1e-2 * force.norm());
    }
}

std::vector<WaveComponent> two_headings() {
    WaveTrain swell = paper_sea(8);
    swell.components = 20;
    WaveTrain wind_sea = swell;
    wind_sea.seed = 9;
    wind_sea.heading = 60 * degree;
    return sea_of({swell, wind_sea});
}

TEST(FullQtf, CrossedSeasTakeTheFilesOwnPairsOfHeadings) {
    const auto components = two_headings();
    std::vector<Complex> phases(components.size());
    WavePhases(components).set(33, {}, phases);
    for (const Of of : {Of::differences, Of::sums}) {
        const std::vector<double> headings{-60 * degree, 0.0, 60 * degree};
        const QuadraticLoad quadratic(qtf_of_formula(of, {headings}), of, components);
        EXPECT_TRUE(quadratic.crosses_headings());
        const Vec6 pairs =
            double_sum(of, components, phases, [&](const WaveComponent& a, const WaveComponent& b) {
                return formula(of, a.omega, b.omega, a.heading, b.heading);
            });
        EXPECT_LT((quadratic.load(phases, 0) - pairs).norm(), 1e-12 * scale(of, components));

        const QuadraticLoad equal(qtf_of_formula(of, {headings, false}), of, components);
        EXPECT_FALSE(equal.crosses_headings());
        const Vec6 mean = double_sum(
            of, components, phases, [&](const WaveComponent& a, const WaveComponent& b) -> CVec6 {
                return 0.5 * (formula(of, a.omega, b.omega, a.heading, a.heading) +
                              formula(of, a.omega, b.omega, b.heading, b.heading));
            });
        EXPECT_LT((equal.load(phases, 0) - mean).norm(), 1e-12 * scale(of, components));
        EXPECT_GT((mean - pairs).norm(), 1e-4 * scale(of, components));
    }
}

TEST(FullQtf, IsNewmansForceForNewmansFunction) {
    // Q = (D_i + D_j)/2 with D straight in frequency: both are exact.
    const auto components = sea_of({paper_sea(2)});
    const auto D = [](double w) { return Vec6(Vec6::LinSpaced(1, 6) * (5e3 + 4e4 * w)); };
    WaveTable<Vec6> drift;
    Qtf qtf;
    drift.headings.resize(1);
    qtf.pairs.resize(1);
    for (double w = 0.1; w < 2.2; w += 0.1) qtf.frequencies.push_back(w);
    drift.frequencies = qtf.frequencies;
    for (const double a : qtf.frequencies) {
        drift.headings[0].values.push_back(D(a));
        for (const double b : qtf.frequencies)
            qtf.pairs[0].values.emplace_back((0.5 * (D(a) + D(b))).cast<Complex>());
    }
    qtf.pairs[0].given.assign(qtf.pairs[0].values.size(), 1);
    const ComponentTable<Vec6> table(drift, components);
    const QuadraticLoad quadratic(qtf, Of::differences, components);
    const ComponentTable<Vec6> diagonal(quadratic.diagonal(), components);
    std::vector<Complex> phases(components.size());
    for (const double t : {0.0, 250.0}) {
        WavePhases(components).set(t, {7, 3, 0.02}, phases);
        const DriftLoad newman = drift_load(table, components, phases, 0.02);
        EXPECT_LT((quadratic.load(phases, 0.02) - newman.slow).norm(), 1e-9 * newman.slow.norm());
        EXPECT_LT((drift_load(diagonal, components, phases, 0.02).mean - newman.mean).norm(),
                  1e-11 * newman.mean.norm());
    }
}

/// A surge QTF like a hull's: a drift that grows to a plateau, turning and falling off the
/// diagonal.
Complex hull_like(double w1, double w2) {
    const double w = 0.5 * (w1 + w2), mu = w1 - w2;
    return 1e5 / (1 + std::pow(0.7 / w, 6)) * std::polar(std::exp(-8 * mu * mu), 2 * mu);
}

Qtf hull_like_qtf() {
    Qtf qtf;
    qtf.pairs.resize(1);
    for (double w = 0.15; w < 2.3; w += 0.05) qtf.frequencies.push_back(w);
    for (const double a : qtf.frequencies)
        for (const double b : qtf.frequencies) {
            CVec6 Q = CVec6::Zero();
            Q[0] = hull_like(a, b);
            qtf.pairs[0].values.push_back(Q);
        }
    qtf.pairs[0].given.assign(qtf.pairs[0].values.size(), 1);
    return qtf;
}

double jonswap(double w) {  // the paper's sea, factor of validation section C
    const double wp = 2 * M_PI / 15.6, sigma = w <= wp ? 0.07 : 0.09;
    return 0.749141 * 5 / 16 * 15.2 * 15.2 * std::pow(wp, 4) * std::pow(w, -5) *
           std::exp(-1.25 * std::pow(wp / w, 4)) *
           std::pow(2.4, std::exp(-0.5 * std::pow((w - wp) / (sigma * wp), 2)));
}

TEST(FullQtf, MeanAndVarianceAreThoseOfTheSpectrum) {  // validation section C
    // mean 2 int S D dw; variance int S_F dmu, S_F(mu) = 8 int S(w) S(w + mu) |Q(w + mu, w)|^2 dw
    const Qtf qtf = hull_like_qtf();
    double mean = 0, variance = 0;
    const double dw = 0.004;
    for (double w = 0.202; w < 2.02; w += dw) {
        mean += 2 * jonswap(w) * hull_like(w, w).real() * dw;
        for (double mu = dw / 2; w + mu < 2.02; mu += dw)
            variance +=
                8 * jonswap(w) * jonswap(w + mu) * std::norm(hull_like(w + mu, w)) * dw * dw;
    }
    double found_mean = 0, found_variance = 0;
    const int seas = 12, n = 3000;
    for (int seed = 1; seed <= seas; ++seed) {
        const auto components = sea_of({paper_sea(static_cast<std::uint64_t>(seed))});
        const QuadraticLoad quadratic(qtf, Of::differences, components);
        const ComponentTable<Vec6> diagonal(quadratic.diagonal(), components);
        std::vector<Complex> phases(components.size());
        WavePhases(components).set(0, {}, phases);
        const double constant = drift_load(diagonal, components, phases, 0).mean[0];
        // A hundred components sample the spectrum within 1 %, the interpolation within 0.2 %.
        EXPECT_NEAR(constant / mean, 1, 0.01);
        found_mean += constant / seas;
        for (int i = 0; i < n; ++i) {
            WavePhases(components).set(3.7 * i, {}, phases);
            found_variance += std::pow(quadratic.load(phases, 0)[0] - constant, 2) / (n * seas);
        }
    }
    EXPECT_NEAR(found_mean / mean, 1, 0.005);
    // Of 12 seas of 3 h, some thousand independent maxima of the envelope: 5 % or so.
    EXPECT_NEAR(found_variance / variance, 1, 0.1);
}

TEST(FullQtf, InterpolationFallsWithTheFileStep) {
    // Cubic in both directions: halving the step of the file makes the error eight times less or
    // better (16 in the limit of smooth functions).
    const std::vector<WaveComponent> two{{.amplitude = 1, .omega = 0.63},
                                         {.amplitude = 1, .omega = 0.87}};
    double before = 0;
    for (const int n : {12, 23, 45}) {
        Qtf qtf;
        qtf.pairs.resize(1);
        for (int i = 0; i < n; ++i) qtf.frequencies.push_back(0.2 + 1.1 * i / (n - 1));
        for (const double a : qtf.frequencies)
            for (const double b : qtf.frequencies)
                qtf.pairs[0].values.emplace_back(CVec6::Constant(hull_like(a, b)));
        qtf.pairs[0].given.assign(qtf.pairs[0].values.size(), 1);
        const QuadraticLoad quadratic(qtf, Of::differences, two);
        const double off =
            (quadratic.load({Complex(1, 0), Complex(0, 0)}, 0)[0] - hull_like(0.63, 0.63).real()) +
            (quadratic.load({Complex(0, 0), Complex(1, 0)}, 0)[0] - hull_like(0.87, 0.87).real());
        if (before != 0) {
            EXPECT_LT(std::abs(off), std::abs(before) / 6) << n;
        }
        before = off;
    }
    EXPECT_LT(std::abs(before), 1e-3 * 1e5);
}

HydroData data_with_qtf() {
    HydroData data = spar_data();
    data.difference = qtf_of_formula(Of::differences, {{0.0}}, 0.1, 2.5, 25);
    data.sum = qtf_of_formula(Of::sums, {{0.0}}, 0.1, 2.5, 25);
    return data;
}

Case case_with_qtf() {
    Case c = spar_case();
    c.environment.waves = {paper_sea(4)};
    c.platform->hydrodynamics.drift = Drift::full_qtf;
    c.analysis.dynamics.ramp = 100;
    return c;
}

TEST(FullQtf, ActsOnTheHullAsDriftAndWave2) {
    const HydroData data = data_with_qtf();
    const Case c = case_with_qtf();
    const Hull hull(c, &data);
    const auto& components = hull.sea().components();
    std::vector<Complex> phases(components.size());
    State s = hull.start({.position = {3, 1, 0}}, {.position = {3, 1, 0}});
    const auto sum_at = [&](Of of, double t) {
        WavePhases(components).set(t, {3, 1, 0}, phases);
        return double_sum(of, components, phases,
                          [&](const WaveComponent& a, const WaveComponent& b) {
                              return formula(of, a.omega, b.omega, 0, 0);
                          });
    };
    HullLoads loads = hull.loads(500, s);
    EXPECT_LT((loads[Load::drift] - sum_at(Of::differences, 500)).norm(),
              1e-10 * loads[Load::drift].norm());
    EXPECT_LT((loads[Load::wave2] - sum_at(Of::sums, 500)).norm(),
              1e-10 * loads[Load::wave2].norm());
    // The mean alone in statics, and from the start; the rest with the ramp.
    Statics with{.current = false, .wind_mean = false, .drift_mean = true}, without = with;
    without.drift_mean = false;
    const PlatformMotion pose{.position = {3, 1, 0}};
    const Vec6 mean = hull.static_load(pose, with) - hull.static_load(pose, without);
    Vec6 expected = Vec6::Zero();
    for (const WaveComponent& a : components)
        expected +=
            a.amplitude * a.amplitude * formula(Of::differences, a.omega, a.omega, 0, 0).real();
    EXPECT_LT((mean - expected).norm(), 1e-9 * expected.norm());
    loads = hull.loads(0, s);
    EXPECT_LT((loads[Load::drift] - expected).norm(), 1e-9 * expected.norm());
    EXPECT_EQ(loads[Load::wave2].norm(), 0);
    loads = hull.loads(50, s);  // half of the ramp
    EXPECT_LT((loads[Load::drift] - 0.5 * (expected + sum_at(Of::differences, 50))).norm(),
              1e-9 * loads[Load::drift].norm());
}

TEST(FullQtf, WhatTheFilesDoNotHoldIsRefused) {
    const auto said = [](const Case& c, const HydroData& data) -> std::string {
        try {
            const Hull hull(c, &data);
            return "accepted";
        } catch (const RunError& e) {
            EXPECT_EQ(e.code(), ExitCode::input);
            return e.what();
        }
    };
    Case c = case_with_qtf();
    EXPECT_THAT(said(c, spar_data()), testing::HasSubstr("found none of them"));
    HydroData narrow = data_with_qtf();
    narrow.difference = qtf_of_formula(Of::differences, {{0.0}}, 0.5, 0.9, 9);
    EXPECT_THAT(said(c, narrow), testing::HasSubstr("% of the waves' energy lies outside"));
    c.environment.waves[0].heading = 10 * degree;
    EXPECT_THAT(said(c, data_with_qtf()), testing::HasSubstr("has only 0.00 deg"));
}

}  // namespace
}  // namespace hawser::master
