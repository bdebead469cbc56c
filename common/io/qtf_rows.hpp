// From rows (two frequencies, two headings, mode, value) in any order to a quadratic transfer
// function over all ordered pairs of frequencies.
#pragma once

#include "hydro_data.hpp"

namespace hawser::io {

struct QtfRow {
    double frequency_1 = 0.0, frequency_2 = 0.0;  ///< [rad/s]
    double heading_1 = 0.0, heading_2 = 0.0;      ///< as in the file [deg]
    int mode = 0;                                 ///< 0 .. 5
    Complex value;
};

/// The function of a file. Files often hold one triangle: where only (m, n) has a value, (n, m)
/// with the headings exchanged takes its conjugate (differences) or the same (sums).
Qtf qtf_of(const std::vector<QtfRow>& rows, bool difference);

/// Adds the mirror images in xz or yz, as for first order.
void mirror(Qtf& qtf, bool about_xz);

}  // namespace hawser::io
