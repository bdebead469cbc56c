// Statistics of a time series, as pure functions of its samples.
#pragma once

#include <cstdint>
#include <span>

namespace hawser {

/// Sample statistics. Without samples n = 0 and everything else is NaN.
struct Statistics {
    std::int64_t n = 0;             ///< samples that count
    double mean, std;               ///< std = sqrt(mean of (x - mean)^2), divided by n
    double min, t_min, max, t_max;  ///< extremes and the times [s] at which they first occur
    double skewness,
        kurtosis;  ///< third and fourth central moment over std^3, std^4; Gaussian: 0, 3
    double tz;     ///< mean period of up-crossings of the mean [s]; NaN with fewer than two
};

/// Does what happens at t count, from a time on? Times are multiples of steps: a rounding early
/// is not early.
[[nodiscard]] inline bool counts(double t, double from) { return t >= from - 1e-9; }

/// Statistics of x over the times t >= from. Values that are not finite are left out.
///
///     tz = (t_last - t_first) / (crossings - 1)      crossings interpolated linearly
///
/// @param t  ascending times [s]
/// @param x  as many values, any unit
[[nodiscard]] Statistics statistics_of(std::span<const double> t, std::span<const double> x,
                                       double from);

}  // namespace hawser
