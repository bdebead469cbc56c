#include "statistics.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace hawser {

Statistics statistics_of(std::span<const double> t, std::span<const double> x, double from) {
    assert(t.size() == x.size());
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Statistics s{.n = 0,
                 .mean = nan,
                 .std = nan,
                 .min = nan,
                 .t_min = nan,
                 .max = nan,
                 .t_max = nan,
                 .skewness = nan,
                 .kurtosis = nan,
                 .tz = nan};
    const auto counts = [&](std::size_t i) { return t[i] >= from && std::isfinite(x[i]); };

    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!counts(i)) continue;
        if (s.n == 0 || x[i] < s.min) s.min = x[i], s.t_min = t[i];
        if (s.n == 0 || x[i] > s.max) s.max = x[i], s.t_max = t[i];
        sum += x[i];
        ++s.n;
    }
    if (s.n == 0) return s;
    const double n = static_cast<double>(s.n);
    s.mean = sum / n;

    // Moments about the mean, in a second pass: a small motion about a large mean keeps its digits.
    double m2 = 0.0, m3 = 0.0, m4 = 0.0;
    double first = nan, last = nan, before = nan, t_before = nan;
    int crossings = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!counts(i)) continue;
        const double d = x[i] - s.mean;
        m2 += d * d;
        m3 += d * d * d;
        m4 += d * d * d * d;
        if (before < 0.0 && d >= 0.0) {
            last = t_before + (t[i] - t_before) * before / (before - d);
            if (crossings++ == 0) first = last;
        }
        before = d;
        t_before = t[i];
    }
    m2 /= n, m3 /= n, m4 /= n;
    s.std = std::sqrt(m2);
    if (m2 > 0.0) {
        s.skewness = m3 / (m2 * s.std);
        s.kurtosis = m4 / (m2 * m2);
    }
    if (crossings >= 2) s.tz = (last - first) / (crossings - 1);
    return s;
}

}  // namespace hawser
