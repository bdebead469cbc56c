// A measured elevation at one point as a sum of harmonics. Discrete Fourier transform; the record
// repeats after its length, so it holds for runs inside its window.
#pragma once

#include <vector>

#include "case/environment.hpp"

namespace hawser {

/// amplitude cos(omega t + phase), t on the record's clock, which is the run's.
struct Harmonic {
    double omega = 0.0, amplitude = 0.0, phase = 0.0;
};

/// Harmonics of the record inside the train's band, by rising frequency. With N samples from t0 at
/// intervals dt and w_m = 2 pi m/(N dt), m = 1 ... N/2:
///
///     X_m = sum_n eta_n exp(-2 pi i m n/N)      A_m = 2 |X_m|/N (m = N/2: |X_m|/N)
///     eta(t) = sum_m A_m cos(w_m (t - t0) + arg X_m)
///
/// With the whole band the sum passes through every sample less the mean, which is left out.
std::vector<Harmonic> record_harmonics(const WaveTrain& train);

/// Share of the record's variance that the band keeps, 0 to 1.
double kept_by_band(const WaveTrain& train);

}  // namespace hawser
