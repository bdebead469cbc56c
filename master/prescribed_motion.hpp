// A platform that goes as told: harmonics, or a file through which a spline of continuous
// acceleration runs (case key `platform.prescribed_motion`). K:21
#pragma once

#include "case/platform.hpp"
#include "frames.hpp"

namespace hawser::master {

/// Motion, its rates and its accelerations: all of one function of time.
struct LedMotion {
    PlatformMotion motion;
    PlatformAcceleration acceleration;
};

class PrescribedPath {
 public:
    /// @param ramp  of the run [s]; brings in the amplitudes, not the means or a file
    PrescribedPath(const PrescribedMotion& motion, double ramp);

    /// K:21. Harmonic: x = mean + r(t) a sin(2 pi t/T + phase). File: cubics between the rows whose
    /// slopes make x'' continuous,
    ///
    ///     h_k m_k-1 + 2 (h_k-1 + h_k) m_k + h_k-1 m_k+1 = 3 (h_k d_k-1 + h_k-1 d_k)
    ///
    /// h: time between rows, d: difference quotients; the first and last slope are those of the
    /// cubic through the four rows at that end. Exact for cubics; x'' has an error of order h^2.
    [[nodiscard]] LedMotion at(double t) const;

 private:
    [[nodiscard]] LedMotion of_file(double t) const;

    PrescribedMotion given_;
    double ramp_;
    std::vector<std::array<double, 6>> slopes_;  ///< at the rows
};

}  // namespace hawser::master
