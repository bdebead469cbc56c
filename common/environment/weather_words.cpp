#include "environment/weather_words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "environment/wave_trains.hpp"
#include "environment/wind.hpp"

namespace hawser {

namespace {

constexpr double degrees = 180.0 / M_PI;

std::string name_of(const WaveTrain& w) {
    switch (w.type) {
        case WaveType::airy:
            return "regular wave";
        case WaveType::jonswap:
            return w.gamma ? fmt::format("JONSWAP (gamma {:.3g})", *w.gamma) : "JONSWAP";
        case WaveType::pierson_moskowitz:
            return "Pierson-Moskowitz";
        case WaveType::ochi_hubble:
            return "Ochi-Hubble";
        case WaveType::torsethaugen:
            return "Torsethaugen";
        case WaveType::white_noise:
            return fmt::format("white noise ({:.4g} to {:.4g} rad/s)", w.band_min, w.band_max);
        case WaveType::spectrum_file:
            return "spectrum" + (w.file.empty() ? "" : " of " + w.file);
        case WaveType::elevation_file:
            return "elevation" + (w.file.empty() ? "" : " of " + w.file);
        case WaveType::components:
            break;
    }
    return fmt::format("{} listed components", w.list.size());
}

}  // namespace

std::string words_of(const WaveTrain& w) {
    std::string out = name_of(w) + ": ";
    if (w.type == WaveType::airy)
        out += fmt::format("H {:g} m, T {:g} s", w.H, w.T);
    else
        out += fmt::format("Hs {:.4g} m", significant_height(w));
    if (is_random(w) && w.Tp > 0.0) out += fmt::format(", Tp {:g} s", w.Tp);
    out += fmt::format(", towards {:g} deg", w.heading * degrees);
    if (w.spreading)
        out += fmt::format(" (spread, s {:g}, {} directions)", w.spreading->s,
                           w.spreading->directions);
    if (is_random(w)) out += fmt::format(", {} components, seed {}", w.components, w.seed);
    return out;
}

std::string words_of(const Wind& w) {
    const std::string direction = fmt::format("towards {:g} deg", degrees * w.heading);
    if (w.spectrum == WindSpectrum::time_history)
        return fmt::format("{:.4g} m/s on average, {}, as measured{}",
                           WindField(w, 0.0, w.reference_height).mean_speed(), direction,
                           w.file.empty() ? "" : " in " + w.file);
    const char* gusts = w.spectrum == WindSpectrum::npd      ? "NPD gusts"
                        : w.spectrum == WindSpectrum::api    ? "API gusts"
                        : w.spectrum == WindSpectrum::kaimal ? "Kaimal gusts"
                                                             : "constant";
    return fmt::format("{:.4g} m/s at {:g} m ({:g} s mean), {}, {}", w.speed, w.reference_height,
                       w.averaging, direction, gusts);
}

}  // namespace hawser
