// Mean and slow drift, and the slow position that keeps the mean from being counted twice: K:8.
#include <gtest/gtest.h>

#include "drift.hpp"
#include "spar_hull.hpp"
#include "wave_phases.hpp"

namespace hawser::master {
namespace {

/// Mean surge force (first order and drift) on the free hull in a regular wave, over D(w) a^2. A
/// soft spring, 157 s, keeps the hull from drifting away.
double mean_force_over_drift(double omega, std::optional<WavePhase> phase,
                             Drift drift = Drift::newman) {
    const double amplitude = 2.0, ramp = 300, stiffness = 3.2e5;
    Case c = spar_case();
    c.platform->mass = 100530.965 * 1025;
    c.platform->hydrodynamics.added_mass_frequency.reset();
    c.platform->hydrodynamics.drift = drift;
    c.platform->hydrodynamics.wave_phase = phase;
    c.environment.waves = {regular_wave(omega, amplitude)};
    c.analysis.dynamics.ramp = ramp;
    const Hull hull(c, &spar_data());
    const int periods = 60, from = static_cast<int>(std::ceil(1200 * omega / (2 * M_PI)));
    const int steps_a_period = 40;  // RK4 at 40 steps a period: 1e-5
    const double step = 2 * M_PI / omega / steps_a_period;
    double sum = 0;
    const int last = (from + periods) * steps_a_period;
    const ComponentTable<Vec6> table(spar_data().mean_drift, hull.sea().components());
    const double D = table.at(0, table.weights(0))[0];
    // From the offset that the spring gives at the mean drift; the slow ramp does the rest.
    const double at_rest = drift == Drift::none ? 0 : D * amplitude * amplitude / stiffness;
    const PlatformMotion offset{.position = {at_rest, 0, 0}};
    run(
        hull, hull.start(offset, offset), step, last,
        [&, i = 0](double, const State&, const HullLoads& loads) mutable {
            if (i++ >= from * steps_a_period) sum += loads[Load::wave1][0] + loads[Load::drift][0];
        },
        [&](double, const State& y) {
            Vec6 spring = Vec6::Zero();
            spring[0] = -stiffness * y[0];
            return spring;
        });
    return sum / (periods * steps_a_period) / (D * amplitude * amplitude);
}

TEST(SlowPhase, FreeHullFeelsTheMeanDriftOnce) {  // K:8 and its table
    EXPECT_NEAR(mean_force_over_drift(0.6, WavePhase::slow), 1, 0.03);
    EXPECT_NEAR(mean_force_over_drift(0.8, WavePhase::slow), 1, 0.03);
}

TEST(SlowPhase, InstantaneousPhaseCountsPartOfTheDriftTwice) {  // K:8: 1.25 and 0.21 of D on top
    EXPECT_NEAR(mean_force_over_drift(0.6, WavePhase::instantaneous), 2.25, 0.03);
    EXPECT_NEAR(mean_force_over_drift(0.8, WavePhase::instantaneous), 1.21, 0.02);
}

// 1/256 of the wave motion is left in the slow position; what it makes of D is in the test above.
TEST(SlowPhase, WithoutDriftTheFirstOrderForceHasNoMeanUnlessTheCaseAsksForIt) {  // K:8
    EXPECT_NEAR(mean_force_over_drift(0.6, std::nullopt, Drift::none), 0, 0.03);
    EXPECT_NEAR(mean_force_over_drift(0.6, WavePhase::instantaneous, Drift::none), 1.25, 0.05);
}

TEST(SlowPhase, FilterIsAButterworthOfOrderFour) {  // K:8
    const double cutoff = 0.1;
    for (const double w : {0.02, 0.1, 0.4}) {
        State s = State::Zero();
        double largest = 0;
        const double h = 0.05;
        for (int i = 0; i < 20000; ++i) {
            const auto rate = [&](double t, State y) {
                y[0] = std::sin(w * t);
                State r = State::Zero();
                add_slow_motion_to(r, y, cutoff);
                return r;
            };
            const double t = i * h;
            const State k1 = rate(t, s), k2 = rate(t + h / 2, s + h / 2 * k1),
                        k3 = rate(t + h / 2, s + h / 2 * k2), k4 = rate(t + h, s + h * k3);
            s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            if (t > 600) largest = std::max(largest, std::abs(slow_position(s).x));
        }
        // 0.7654 and 1.8478 have four digits; the peak is read from samples.
        EXPECT_NEAR(largest * std::sqrt(1 + std::pow(w / cutoff, 8)), 1, 2e-3) << w;
    }
}

std::vector<WaveComponent> components_of_paper_sea(std::uint64_t seed) {
    Environment e;
    e.seabed.depth = 1500;
    e.waves = {paper_sea(seed)};
    return Sea(e, 0, 0).components();
}

struct PaperSea {
    std::vector<WaveComponent> components = components_of_paper_sea(1);
    ComponentTable<Vec6> table{spar_data().mean_drift, components};
    HeadingWeights ahead = table.weights(0);
    [[nodiscard]] double D(std::size_t i) const { return table.at(static_cast<int>(i), ahead)[0]; }
    [[nodiscard]] DriftLoad at(double t) const {
        std::vector<Complex> phases(components.size());
        WavePhases(components).set(t, {}, phases);
        return drift_load(table, components, phases, 0);
    }
};

TEST(NewmanDrift, IsTheExactDoubleSumOverDifferenceFrequencies) {  // Newman 1974
    const PaperSea sea;
    for (const double t : {0.0, 17.3, 1234.5}) {
        double pairs = 0;
        for (std::size_t i = 0; i < sea.components.size(); ++i)
            for (std::size_t j = 0; j < sea.components.size(); ++j) {
                const WaveComponent &a = sea.components[i], &b = sea.components[j];
                pairs += a.amplitude * b.amplitude * 0.5 * (sea.D(i) + sea.D(j)) *
                         std::cos((a.omega - b.omega) * t + a.phase - b.phase);
            }
        EXPECT_NEAR(sea.at(t).slow[0], pairs, 1e-10 * std::abs(sea.at(0).mean[0]) * 100);
    }
}

TEST(NewmanDrift, MeanIsTwiceTheIntegralOfSpectrumTimesDrift) {  // validation rows B2, C
    const PaperSea sea;
    double sum = 0;  // each component carries S dw = a^2/2
    for (std::size_t i = 0; i < sea.components.size(); ++i)
        sum += 2 * (sea.components[i].amplitude * sea.components[i].amplitude / 2) * sea.D(i);
    EXPECT_NEAR(sea.at(55).mean[0], sum, 1e-9 * sum);
    // 0.597 MN with the integral (cases/truss_spar/README.md), a hundred components for it.
    EXPECT_NEAR(sea.at(0).mean[0], 0.597e6, 0.005e6);
    double mean = 0, power = 0;  // in time: 3 h, 0.5 % of the standard deviation or so
    const int n = 10800;
    for (int i = 0; i < n; ++i) {
        const double f = sea.at(i * 1.0).slow[0];
        mean += f / n;
        power += f * f / n;
    }
    const double deviation = std::sqrt(power - mean * mean);
    EXPECT_NEAR(mean, sum, 0.05 * deviation);
}

TEST(NewmanDrift, LowFrequenciesHaveThePowerOfPinkstersSpectrum) {  // validation section C
    // Power of the difference frequencies below mu_max, by lines and by the continuous spectrum
    // S_F(mu) = 8 int S(w) S(w + mu) D(w + mu/2)^2 dw; 20 seas, each some hundred pairs.
    const double mu_max = 0.08;
    const int seas = 20;
    double lines = 0;
    for (int seed = 1; seed <= seas; ++seed) {
        const auto components = components_of_paper_sea(static_cast<std::uint64_t>(seed));
        const ComponentTable<Vec6> table(spar_data().mean_drift, components);
        const HeadingWeights ahead = table.weights(0);
        for (std::size_t i = 0; i < components.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                if (std::abs(components[i].omega - components[j].omega) > mu_max) continue;
                const double T = 0.5 * (table.at(static_cast<int>(i), ahead)[0] +
                                        table.at(static_cast<int>(j), ahead)[0]);
                lines += 2 * std::pow(components[i].amplitude * components[j].amplitude * T, 2);
            }
    }
    lines /= seas;
    const auto S = [](double w) {  // JONSWAP of the paper's sea, factor of validation section C
        const double wp = 2 * M_PI / 15.6, sigma = w <= wp ? 0.07 : 0.09;
        return 0.749141 * 5 / 16 * 15.2 * 15.2 * std::pow(wp, 4) * std::pow(w, -5) *
               std::exp(-1.25 * std::pow(wp / w, 4)) *
               std::pow(2.4, std::exp(-0.5 * std::pow((w - wp) / (sigma * wp), 2)));
    };
    std::vector<WaveComponent> grid;
    for (double w = 0.2; w < 1.6; w += 0.001) grid.push_back({.omega = w});
    const ComponentTable<Vec6> table(spar_data().mean_drift, grid);
    const auto D = [&](double w) {
        return table.at(static_cast<int>(std::lround((w - 0.2) / 0.001)), table.weights(0))[0];
    };
    double power = 0;
    const double dw = 0.004, dmu = 0.004;
    for (double mu = dmu / 2; mu < mu_max; mu += dmu)
        for (double w = 0.202; w < 1.4; w += dw)
            power += 8 * S(w) * S(w + mu) * std::pow(D(w + mu / 2), 2) * dw * dmu;
    // Newman's mean of the diagonals against D at the mean frequency differs at the heave peak.
    EXPECT_NEAR(lines / power, 1, 0.15) << lines << " " << power;
}

}  // namespace
}  // namespace hawser::master
