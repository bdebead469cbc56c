#include "case/wave_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/elevation_record.hpp"
#include "environment/spectra.hpp"
#include "environment/wave_trains.hpp"

namespace hawser {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double height_tolerance = 0.01;    // of the humps together against Hs
constexpr double interval_tolerance = 0.01;  // of a record's intervals

/// One train of the list, its path and what is to be said about it.
class Train {
 public:
    Train(WaveTrain& wave, std::size_t i, const Given& given, Problems& problems)
        : wave_(wave),
          path_(fmt::format("environment.waves[{}]", i)),
          given_(given),
          problems_(problems) {}

    void complete() {
        const double low = wave_.range_min, high = wave_.range_max;
        if (low >= high) error(".range", "the lowest frequency must be below the highest");
        if (wave_.band_max != 0.0 && wave_.band_min >= wave_.band_max)
            error(".band", "the lowest frequency must be below the highest");
        if (wave_.spreading && wave_.components < wave_.spreading->directions)
            error(".components",
                  fmt::format("{} components cannot have {} directions: each has one",
                              wave_.components, wave_.spreading->directions));
        switch (wave_.type) {
            case WaveType::jonswap:
                return gamma();
            case WaveType::ochi_hubble:
                return humps();
            case WaveType::white_noise:
                return cut();
            case WaveType::spectrum_file:
                return spectrum();
            case WaveType::elevation_file:
                return record();
            case WaveType::components:
                return list();
            default:
                return;
        }
    }

 private:
    bool given(const char* key) const { return given_.contains(path_ + key); }
    void error(const char* key, const std::string& message) {
        problems_.push_back({Severity::error, path_ + key, message, {}});
    }
    void note(const char* key, const std::string& message) {
        problems_.push_back({Severity::note, path_ + key, message, {}});
    }

    void gamma() {
        if (wave_.gamma) return;
        wave_.gamma = dnv_gamma(wave_.Hs, wave_.Tp);
        if (!std::isnan(*wave_.gamma))
            note(".gamma", fmt::format("auto: {:.4g} (DNV-RP-C205)", *wave_.gamma));
    }

    void humps() {
        if (!given(".humps")) {
            if (std::isnan(wave_.Hs)) return;
            const OchiHubble likely = most_probable_ochi_hubble(wave_.Hs);
            wave_.humps = {likely.humps[0], likely.humps[1]};
            note(
                ".humps",
                fmt::format("auto: the most probable, Hs {:.3g} and {:.3g} m, Tp {:.3g} and {:.3g} "
                            "s, lambda {:.3g} and {:.3g}",
                            wave_.humps[0].Hs, wave_.humps[1].Hs, wave_.humps[0].Tp,
                            wave_.humps[1].Tp, wave_.humps[0].lambda, wave_.humps[1].lambda));
            return;
        }
        if (wave_.humps.size() != 2)
            return error(".humps", fmt::format("expected two rows; got {}", wave_.humps.size()));
        const double both = std::hypot(wave_.humps[0].Hs, wave_.humps[1].Hs);
        if (std::abs(both / wave_.Hs - 1.0) > height_tolerance)
            error(".humps",
                  fmt::format("{:.4g} m together, sqrt(Hs1^2 + Hs2^2), but Hs is {:.4g} m", both,
                              wave_.Hs));
    }

    void cut() {  // equal energy would be equal spacing, which repeats
        if (!given(".discretisation"))
            wave_.discretisation = Discretisation::equal_frequency_random;
        else if (wave_.discretisation == Discretisation::equal_energy)
            error(".discretisation",
                  "equal_energy spaces white noise equally, so that it repeats: use "
                  "equal_frequency_random");
    }

    void spectrum() {
        const auto& rows = wave_.spectrum;
        if (rows.empty()) return;  // said by who read the file
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i][0] <= 0.0 || (i > 0 && rows[i][0] <= rows[i - 1][0]))
                return error(".spectrum",
                             fmt::format("frequencies must be positive and ascend; row "
                                         "{} has {:.6g} rad/s",
                                         i + 1, rows[i][0]));
            if (rows[i][1] < 0.0)
                return error(".spectrum", fmt::format("row {} has a negative density", i + 1));
        }
        if (rows.size() < 2 || TabulatedSpectrum{rows}.energy() <= 0.0)
            error(".spectrum", "expected at least two rows and some energy");
    }

    void record() {
        const auto& rows = wave_.record;
        if (rows.empty()) return;
        if (rows.size() < 4) return error(".record", "expected at least four samples");
        const double t0 = rows.front()[0];
        const double dt = (rows.back()[0] - t0) / static_cast<double>(rows.size() - 1);
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (!(std::abs(rows[i][0] - t0 - static_cast<double>(i) * dt) <=
                  interval_tolerance * dt))
                return error(".record", fmt::format("times must be at equal intervals, here {:.6g} "
                                                    "s; sample {} is at {:.6g} s",
                                                    dt, i + 1, rows[i][0]));
        if (!(wave_.band_min < wave_.band_max)) return;
        if (wave_.band_max > pi / dt * (1.0 + 1e-9))
            return error(
                ".band",
                fmt::format("samples every {:.6g} s tell nothing above {:.4g} rad/s", dt, pi / dt));
        const std::size_t n = record_harmonics(wave_).size();
        if (n == 0)
            return error(".band", fmt::format("no frequency of a record of {:.6g} s lies in it",
                                              rows.back()[0] - t0));
        note(".band", fmt::format("{} components, which hold {:.2f} % of the record's variance", n,
                                  100.0 * kept_by_band(wave_)));
    }

    void list() {
        for (std::size_t i = 0; i < wave_.list.size(); ++i) {
            if (wave_.list[i].frequency <= 0.0)
                error(".list", fmt::format("row {}: the frequency must be above 0", i + 1));
            if (wave_.list[i].amplitude < 0.0)
                error(".list",
                      fmt::format("row {}: the amplitude is negative; turn the phase", i + 1));
        }
        if (wave_.list.empty() && given(".list")) error(".list", "expected at least one row");
    }

    WaveTrain& wave_;
    std::string path_;
    const Given& given_;
    Problems& problems_;
};

/// Of one train: height [m] and period [s] where it has them.
struct Steepness {
    double height, period, limit;
};

/// Regular: breaking limit 0.142. Sea state: DNV-RP-C205 3.5.5.6 for the peak period, 1/15 below 8
/// s to 1/25 above 15 s, with 5 % to spare.
Steepness steepness_of(const WaveTrain& w) {
    if (w.type == WaveType::airy) return {w.H, w.T, 0.142};
    return {w.Hs, w.Tp,
            1.05 * std::lerp(1.0 / 15.0, 1.0 / 25.0, std::clamp((w.Tp - 8.0) / 7.0, 0.0, 1.0))};
}

}  // namespace

void complete_waves(std::vector<WaveTrain>& waves, const Given& given, Problems& problems) {
    for (std::size_t i = 0; i < waves.size(); ++i) {
        Train(waves[i], i, given, problems).complete();
        const std::string key = fmt::format("environment.waves[{}].stretching", i);
        if (!given.contains(key)) waves[i].stretching = waves[0].stretching;
        if (waves[i].stretching != waves[0].stretching)
            problems.push_back({Severity::error,
                                key,
                                "one surface has one stretching: all trains must have the same",
                                {}});
    }
}

void check_waves(const Case& input, Problems& problems) {
    const double g = input.environment.water.gravity, depth = input.environment.seabed.depth;
    const std::vector<WaveTrain>& waves = input.environment.waves;
    const auto say = [&](Severity severity, const std::string& path, const std::string& message) {
        problems.push_back({severity, path, message, {}});
    };
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const WaveTrain& w = waves[i];
        const std::string path = fmt::format("environment.waves[{}]", i);
        if (w.type == WaveType::airy || w.Tp > 0.0) {
            const auto [height, period, limit] = steepness_of(w);
            const double steepness = 2.0 * pi * height / (g * period * period);
            if (steepness > limit)
                say(Severity::warning, path,
                    fmt::format("steepness {:.3f} is above {:.3f}: the waves would break",
                                steepness, limit));
            const double q = period / std::sqrt(height);
            if (w.type == WaveType::jonswap && (q < 3.6 || q > 5.0))
                say(Severity::warning, path,
                    fmt::format("Tp/sqrt(Hs) = {:.2f}: a jonswap spectrum is meant for 3.6 to 5",
                                q));
        }
        const double height = w.type == WaveType::airy ? w.H : significant_height(w);
        if (height > 0.78 * depth)
            say(Severity::error, path,
                fmt::format("{:.6g} m high waves break in {:.6g} m of water", height, depth));
        for (std::size_t j = 0; j < i; ++j)
            if (is_random(w) && is_random(waves[j]) && w.seed == waves[j].seed)
                say(Severity::warning, path + ".seed",
                    fmt::format(
                        "the same as of waves[{}]: the phases of the two trains are the same "
                        "numbers, so they are not independent",
                        j));
        if (w.type == WaveType::elevation_file && w.record.size() > 1) {
            const double from = w.record.front()[0], to = w.record.back()[0];
            const double end = input.analysis.dynamics.duration;
            if (from > 0.0 || to < end)
                say(Severity::warning, path,
                    fmt::format(
                        "the record goes from {:.6g} to {:.6g} s, the run from 0 to {:.6g} s: "
                        "outside, the record repeats",
                        from, to, end));
        }
    }
}

double expected_crest(const std::vector<WaveTrain>& waves) {
    double regular = 0.0, square = 0.0;
    for (const WaveTrain& w : waves) {
        if (w.type == WaveType::airy)
            regular += w.H / 2.0;
        else
            square += significant_height(w) * significant_height(w);
    }
    return regular + 0.93 * std::sqrt(square);  // 1.86 Hs/2 in three hours
}

}  // namespace hawser
