// A wave train as a sum of Airy components: discretisation of its spectrum.
// Source: linear random waves (DNV-RP-C205 3.3).
#pragma once

#include <vector>

#include "case/environment.hpp"

namespace hawser {

/// One Airy component: eta = A cos(w t - k (x cos b + y sin b) + phase).
struct WaveComponent {
    double amplitude = 0.0;  ///< A [m]
    double omega = 0.0;      ///< w [rad/s]
    double k = 0.0;          ///< wave number [1/m]
    double phase = 0.0;      ///< leads the crest at the origin [rad]
    double heading = 0.0;    ///< b, direction of travel from +x [rad]
};

/// Components of a train, of a spectrum by rising frequency. A regular wave is one component of
/// amplitude H/2; a record has its harmonics (elevation_record.hpp), with the phase that brings
/// them to the place of measurement; a list is what it says.
/// A spectrum is cut to frequency_range() and scaled so that the components carry exactly
/// sum(A^2/2) = Hs^2/16; phases are uniform in [0, 2 pi) from the seed; spread by spreading.hpp.
///
/// * equal_energy: bands of equal energy, A = Hs/sqrt(8 N) each; the frequency is the centroid of
///   the energy in its band, so the mean frequency m1/m0 of the spectrum is kept exactly.
/// * equal_frequency_random: bands of equal width, one uniformly random frequency in each, which
///   carries the energy of its band.
///
/// @param depth, gravity  [m], [m/s2], for the dispersion relation
std::vector<WaveComponent> wave_components(const WaveTrain& train, double depth, double gravity);

}  // namespace hawser
