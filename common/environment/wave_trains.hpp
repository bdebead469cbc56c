// What is asked of a wave train as a whole: its height, its peaks, its range of frequencies.
#pragma once

#include <optional>

#include "case/environment.hpp"

namespace hawser {

/// Is it drawn from a spectrum, with seed?
bool is_random(const WaveTrain& train);

/// 4 sqrt(m0) [m]: of a spectrum as asked for, of a regular wave sqrt(2) H, of a record what its
/// band keeps.
double significant_height(const WaveTrain& train);

/// Frequencies between which a spectrum is cut into components [rad/s].
struct FrequencyRange {
    double from = 0.0, to = 0.0, width = 0.0;
};
FrequencyRange frequency_range(const WaveTrain& train);

/// Peaks of a train [rad/s].
///
/// * highest: where its energy is: the peak of the greatest density; of white noise the middle of
///   the band; of components and records the most energetic neighbourhood, 10 % to either side.
/// * lowest: of two-peaked spectra the lower peak; of white noise the lower end of the band, of a
///   tabulated spectrum, components and records the lowest frequency above which 95 % of the energy
///   lies; else the same.
struct Peaks {
    double highest = 0.0, lowest = 0.0;
};
Peaks peaks_of(const WaveTrain& train);

/// Where the energy of the train of greatest significant height is [rad/s]; none in still water.
std::optional<double> main_peak(const std::vector<WaveTrain>& trains);
/// The lowest of all peaks [rad/s]; none in still water.
std::optional<double> lowest_peak(const std::vector<WaveTrain>& trains);

}  // namespace hawser
