// Interpolation of coefficients over heading and frequency.
#include <gtest/gtest.h>

#include "component_table.hpp"
#include "drift.hpp"
#include "excitation.hpp"
#include "radiation.hpp"
#include "spar_hull.hpp"
#include "wave_phases.hpp"

namespace hawser::master {
namespace {

double interpolated(const std::vector<double>& headings, bool full, double b, double (*f)(double)) {
    const HeadingWeights w = heading_weights(headings, full, b);
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += w.weight[k] * f(headings[static_cast<std::size_t>(w.index[k])]);
    return sum;
}

std::vector<double> every(double degrees, double from, double to) {
    std::vector<double> headings;
    for (double b = from; b < to + 1e-9; b += degrees) headings.push_back(b * M_PI / 180);
    return headings;
}

TEST(Headings, FullCircleInterpolatesACosineEverywhere) {
    const auto circle = every(15, -165, 180);
    for (double b = -7; b < 7; b += 0.1)
        // Cubic Hermite with parabola slopes: error h^3 times third derivative, over about 60.
        EXPECT_NEAR(interpolated(circle, true, b, [](double x) { return std::cos(x); }),
                    std::cos(b), 7e-4);
}

TEST(Headings, SlopeIsContinuousAcrossTheSeamAt180) {
    const auto circle = every(15, 0, 345);
    const auto f = [](double x) { return std::sin(2 * x) + std::cos(x); };
    const double h = 1e-4;
    for (const double b : {0.0, M_PI, -M_PI, M_PI / 4}) {
        const double before =
            (interpolated(circle, true, b, f) - interpolated(circle, true, b - h, f)) / h;
        const double after =
            (interpolated(circle, true, b + h, f) - interpolated(circle, true, b, f)) / h;
        EXPECT_NEAR(before, after, 3e-3);  // curvature times h
    }
}

/// A table round the circle without any symmetry.
WaveTable<CVec6> lopsided() {
    WaveTable<CVec6> table;
    table.full_circle = true;
    table.frequencies = {0.4, 0.8};
    for (const double b : every(20, -160, 180)) {
        CVec6 X;
        for (int k = 0; k < 6; ++k)
            X[k] = {std::sin(b + k) + 0.3 * std::cos(2 * b - k), std::cos(b - 0.7 * k) + 0.2 * k};
        table.headings.push_back({b, {X, 1.5 * X}});
    }
    return table;
}

// Yaw may count on: what is felt depends on the angle alone.
TEST(Headings, HullTurnedByWholeTurnsFeelsTheSameExcitationAndDrift) {
    const std::vector<WaveComponent> waves{{1.2, 0.5, 0.03, 0.4, 2.9}, {0.7, 0.7, 0.05, 1.9, -0.6}};
    const ComponentTable<CVec6> table(lopsided(), waves);
    WaveTable<Vec6> drift;
    drift.full_circle = true;
    drift.frequencies = {0.4, 0.8};
    for (const auto& h : lopsided().headings)
        drift.headings.push_back({h.heading, {h.values[0].real(), h.values[1].imag()}});
    const ComponentTable<Vec6> drifts(drift, waves);
    std::vector<Complex> phases(2);
    WavePhases(waves).set(3.0, {.x = 5.0, .y = -2.0}, phases);
    for (double yaw = -3.1; yaw < 3.2; yaw += 0.37) {
        const Vec6 once = excitation_load(table, waves, phases, yaw);
        const DriftLoad drifted = drift_load(drifts, waves, phases, yaw);
        for (const int turns : {-4, -1, 1, 5}) {  // rounding of a yaw of 30 rad
            const double turned = yaw + 2 * M_PI * turns;
            EXPECT_LT((excitation_load(table, waves, phases, turned) - once).norm(), 1e-13 * 60);
            EXPECT_LT((drift_load(drifts, waves, phases, turned).slow - drifted.slow).norm(),
                      1e-13 * 60);
            EXPECT_LT((drift_load(drifts, waves, phases, turned).mean - drifted.mean).norm(),
                      1e-13 * 60);
        }
    }
}

// From a yaw of 170 deg over 180 to that of -170 deg: neither load nor its slope jumps, with each
// wave's own heading passing the seam of the table as well.
TEST(Headings, LoadsAreSmoothAcrossThe180OfYawAndOfTheTable) {
    const std::vector<WaveComponent> waves{{1.0, 0.5, 0.03, 0.4, 0.0}, {1.0, 0.6, 0.04, 2.0, 0.1}};
    const ComponentTable<CVec6> table(lopsided(), waves);
    std::vector<Complex> phases(2);
    WavePhases(waves).set(1.0, {}, phases);
    const double from = 170 * M_PI / 180, step = 2e-4;
    Vec6 before = excitation_load(table, waves, phases, from), slope_before = Vec6::Zero();
    for (int i = 1; i * step < 20 * M_PI / 180; ++i) {
        const double yaw = from + i * step;
        const Vec6 load = excitation_load(table, waves, phases, yaw > M_PI ? yaw - 2 * M_PI : yaw);
        const Vec6 slope = (load - before) / step;
        EXPECT_LT((load - before).norm(), 10 * step) << yaw;
        // The curvature of cubic pieces may jump, the slope not: it changes by 10 or so per rad.
        if (i > 1) {
            EXPECT_LT((slope - slope_before).norm(), 40 * step) << yaw;
        }
        before = load;
        slope_before = slope;
    }
}

TEST(Headings, NothingIsExtrapolated) {
    const auto quadrant = every(15, 0, 90);
    const auto one = [](double) { return 1.0; };
    EXPECT_NEAR(interpolated(quadrant, false, M_PI / 2, one), 1, 1e-15);
    EXPECT_NEAR(interpolated(quadrant, false, 2 * M_PI, one), 1, 1e-15);
    for (const double outside : {-0.01, M_PI / 2 + 0.01, M_PI}) {
        try {
            (void)heading_weights(quadrant, false, outside);
            FAIL() << outside << " rad went through";
        } catch (const RunError& e) {
            EXPECT_NE(std::string(e.what()).find("0.00 to 90.00 deg"), std::string::npos);
        }
    }
}

TEST(Headings, ATableOfOneServesAHullThatYawsALittle) {
    const auto value = [](double) { return 7.0; };
    for (const double b : {-0.08, 0.0, 0.08, 2 * M_PI - 0.05})
        EXPECT_EQ(interpolated({0.0}, false, b, value), 7.0) << b;
    for (const double outside : {-0.09, 0.09, M_PI})
        EXPECT_THROW((void)heading_weights({0.0}, false, outside), RunError) << outside;
}

TEST(Headings, WaveFromOutsideTheDatabaseIsAnErrorOfTheInput) {
    WaveTable<Vec6> quadrant;
    quadrant.frequencies = {0.5, 1.0};
    for (const double b : every(45, 0, 90))
        quadrant.headings.push_back({b, {Vec6::Ones(), Vec6::Ones()}});
    const auto code = [&](double heading) {
        try {
            (void)ComponentTable<Vec6>(quadrant,
                                       {{.amplitude = 1, .omega = 0.7, .heading = heading}});
        } catch (const RunError& e) {
            return e.code();
        }
        return ExitCode::done;
    };
    EXPECT_EQ(code(0.3), ExitCode::done);
    EXPECT_EQ(code(-0.3), ExitCode::input);
}

TEST(Frequencies, WavesOutsideTheDatabaseAreRefused) {
    const std::vector<WaveComponent> fast{{.amplitude = 1, .omega = 0.5},
                                          {.amplitude = 0.2, .omega = 3.0}};
    EXPECT_THROW(ComponentTable<CVec6>(spar_data().excitation, fast), RunError);
    const std::vector<WaveComponent> hardly{{.amplitude = 1, .omega = 0.5},
                                            {.amplitude = 0.05, .omega = 3.0}};
    const ComponentTable<CVec6> table(spar_data().excitation, hardly);
    // Beyond the table its end value is held.
    const auto& first = spar_data().excitation.headings[0];
    EXPECT_LT((table.at(1, table.weights(first.heading)) - first.values.back()).norm(),
              1e-9 * first.values.back().norm());
}

TEST(Radiation, IsInterpolatedLinearlyAndNeverExtrapolated) {
    const HydroData& d = spar_data();
    EXPECT_EQ(radiation_at(d, d.frequencies[7]).added_mass, d.added_mass[7]);
    const Radiation half = radiation_at(d, 0.5 * (d.frequencies[7] + d.frequencies[8]));
    EXPECT_LT((half.damping - 0.5 * (d.damping[7] + d.damping[8])).norm(),
              1e-12 * d.damping[8].norm());
    EXPECT_EQ(radiation_at(d, 0).damping.norm(), 0);
    EXPECT_THROW(radiation_at(d, 2.5), RunError);
}

TEST(Radiation, SparAddedMassAtTheSpectralPeakIsTheDatabases) {  // case notes, section 9.2
    const Radiation r = radiation_at(spar_data(), 2 * M_PI / 15.6);
    EXPECT_NEAR(r.added_mass(0, 0), 9.20e7, 0.01e7);
    EXPECT_NEAR(r.added_mass(2, 2), 4.17e7, 0.01e7);
    EXPECT_NEAR(r.added_mass(4, 4), 2.05e11, 0.01e11);
}

}  // namespace
}  // namespace hawser::master
