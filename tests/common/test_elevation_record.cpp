// A measured elevation as components: what comes out at the gauge is what was measured there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "environment/elevation_record.hpp"
#include "environment/random.hpp"
#include "environment/sea.hpp"
#include "environment/wave_trains.hpp"

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi;

/// N samples of noise about 0.3 m, from t0 every dt.
WaveTrain measured(std::size_t N, double t0, double dt, double band_min, double band_max) {
    WaveTrain train{.type = WaveType::elevation_file, .heading = 2.2};
    Random random(3);
    double eta = 0.0;
    for (std::size_t n = 0; n < N; ++n) {
        eta = 0.7 * eta + random.uniform() - 0.4;
        train.record.push_back({t0 + dt * static_cast<double>(n), eta});
    }
    train.band_min = band_min;
    train.band_max = band_max;
    return train;
}

double mean(const WaveTrain& train) {
    double sum = 0.0;
    for (const auto& [t, eta] : train.record) sum += eta;
    return sum / static_cast<double>(train.record.size());
}

// The whole band: the Fourier sum is the record, to the rounding of a sum of some 100 terms and of
// phases k x of some thousand.
TEST(ElevationRecord, ComesBackWhereAndWhenItWasMeasured) {
    for (const std::size_t N : {200u, 201u})
        for (const double h : {15.0, 400.0}) {
            Environment e;
            e.seabed.depth = h;
            e.waves = {measured(N, -20.0, 0.5, 1e-3, 2 * pi)};
            e.waves[0].record_x = 35.0;
            e.waves[0].record_y = -60.0;
            const Sea sea(e, 0.0, 0.0);
            EXPECT_EQ(sea.components().size(), N / 2);
            for (const auto& [t, eta] : e.waves[0].record)
                EXPECT_NEAR(sea.elevation(t, 35.0, -60.0), eta - mean(e.waves[0]), 1e-9);
        }
}

// A sinusoid of whole periods in the record is one component; elsewhere in its direction it comes
// later by k d/w.
TEST(ElevationRecord, FindsAmplitudePhaseAndTravel) {
    WaveTrain train{.type = WaveType::elevation_file, .heading = 0.0};
    const double w = 2 * pi * 12 / 120.0;
    for (int n = 0; n < 480; ++n)
        train.record.push_back({10 + 0.25 * n, 1.7 * std::cos(w * (10 + 0.25 * n) + 0.4)});
    train.band_min = 0.3, train.band_max = 2.0;
    const auto harmonics = record_harmonics(train);
    for (const Harmonic& h : harmonics) {
        if (std::abs(h.omega - w) > 1e-9) {
            EXPECT_LT(h.amplitude, 1e-12);
            continue;
        }
        EXPECT_NEAR(h.amplitude, 1.7, 1e-12);
        EXPECT_NEAR(std::remainder(h.phase - 0.4, 2 * pi), 0.0, 1e-11);
    }
    EXPECT_NEAR(kept_by_band(train), 1.0, 1e-12);
    EXPECT_NEAR(significant_height(train), 4 * 1.7 / std::sqrt(2), 1e-11);
    EXPECT_NEAR(peaks_of(train).highest, w, 1e-9);
    Environment e;
    e.seabed.depth = 40;
    e.waves = {train};
    const Sea sea(e, 0.0, 0.0);
    for (const double t : {12.0, 40.0, 71.5}) {
        double wave_number_of_w = 0.0;
        for (const WaveComponent& c : sea.components())
            if (std::abs(c.omega - w) < 1e-9) wave_number_of_w = c.k;
        EXPECT_NEAR(sea.elevation(t, 25.0, 3.0),
                    1.7 * std::cos(w * t + 0.4 - wave_number_of_w * 25.0), 1e-10);
    }
}

// Parseval: what the band holds is its part of the variance; outside it nothing is left.
// An odd number: at the highest frequency of an even one the samples see the crests alone.
TEST(ElevationRecord, BandKeepsItsShareOfTheVariance) {
    const WaveTrain all = measured(255, 0.0, 0.4, 1e-3, pi / 0.4 * (1 + 1e-12));
    EXPECT_NEAR(kept_by_band(all), 1.0, 1e-12);
    WaveTrain low = all, high = all;
    low.band_max = 2.0;
    high.band_min = std::nextafter(2.0, 3.0);
    EXPECT_NEAR(kept_by_band(low) + kept_by_band(high), 1.0, 1e-12);
    EXPECT_GT(kept_by_band(low), 0.2);
    for (const Harmonic& h : record_harmonics(low)) EXPECT_LE(h.omega, 2.0);
}

}  // namespace
}  // namespace hawser
