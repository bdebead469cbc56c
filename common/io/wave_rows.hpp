// From rows (frequency, heading, mode, value) in any order to a table over frequency and heading:
// headings reduced to one turn, mirrored by symmetry, ordered so that no range is cut.
#pragma once

#include <complex>

#include "hydro_data.hpp"
#include "io/wamit_records.hpp"

namespace hawser::io {

struct WaveRow {
    int line = 0;
    double frequency = 0.0;  ///< [rad/s]
    double heading = 0.0;    ///< as in the file [deg]
    int mode = 0;            ///< 0 .. 5
    Complex value;
};

/// Frequencies that differ by less than the digits of a file count as one.
bool same_frequency(double a, double b);
/// Ascending, without repetition.
std::vector<double> distinct_frequencies(std::vector<double> all);

/// Where w stands among them; it must be there.
std::size_t place_of_frequency(const std::vector<double>& frequencies, double w);

/// The table of a file. A pair (frequency, heading) of which no row exists while others of that
/// frequency or heading do is a problem; a missing mode is zero.
WaveTable<CVec6> table_of(const std::vector<WaveRow>& rows, const std::filesystem::path& file,
                          FileProblems& problems);

/// The same of values that are real.
WaveTable<Vec6> real_part(const WaveTable<CVec6>& table);

/// Signs of the six modes mirrored in xz, or in yz.
Vec6 mirror_sign(bool about_xz);

/// Adds the mirror images in the plane xz (heading -b; sway, roll, yaw change sign) or yz (180 - b;
/// surge, pitch, yaw change sign) of headings that are not there.
template <class Value>
void mirror(WaveTable<Value>& table, bool about_xz);

/// True for headings over exactly half a turn, 0 to 180 deg, at whose ends sway, roll and yaw
/// vanish beside surge, heave and pitch.
bool looks_symmetric_about_xz(const WaveTable<CVec6>& table);

}  // namespace hawser::io
