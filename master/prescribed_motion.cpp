#include "prescribed_motion.hpp"

#include <algorithm>
#include <cmath>

#include "environment/ramp.hpp"

namespace hawser::master {

namespace {

/// Slope at row `at` of the polynomial through rows first ... first + n - 1 (Lagrange).
double slope_at(const SixSeries& rows, std::size_t first, std::size_t n, std::size_t at,
                std::size_t column) {
    double slope = 0.0;
    for (std::size_t j = first; j < first + n; ++j) {
        double weight = 0.0;
        for (std::size_t l = first; l < first + n; ++l) {
            if (l == j) continue;
            double term = 1.0 / (rows[j][0] - rows[l][0]);
            for (std::size_t k = first; k < first + n; ++k)
                if (k != j && k != l)
                    term *= (rows[at][0] - rows[k][0]) / (rows[j][0] - rows[k][0]);
            weight += term;
        }
        slope += weight * rows[j][column];
    }
    return slope;
}

/// Slopes that make the second derivative continuous; the end slopes are given.
std::vector<double> spline_slopes(const SixSeries& rows, std::size_t column) {
    const std::size_t n = rows.size(), some = std::min<std::size_t>(4, n);
    std::vector<double> m(n), above(n);
    m[0] = slope_at(rows, 0, some, 0, column);
    m[n - 1] = slope_at(rows, n - some, some, n - 1, column);
    for (std::size_t k = 1; k + 1 < n; ++k) {  // elimination downwards
        const double before = rows[k][0] - rows[k - 1][0], after = rows[k + 1][0] - rows[k][0];
        const double right = 3.0 * (after * (rows[k][column] - rows[k - 1][column]) / before +
                                    before * (rows[k + 1][column] - rows[k][column]) / after);
        const double pivot = 2.0 * (before + after) - after * above[k - 1];
        above[k] = before / pivot;
        m[k] = (right - after * m[k - 1]) / pivot;
    }
    for (std::size_t k = n - 1; k-- > 1;) m[k] -= above[k] * m[k + 1];
    return m;
}

/// Puts value, rate and second derivative of motion i in their places.
void put(LedMotion& led, std::size_t i, double x, double v, double a) {
    const auto k = static_cast<Eigen::Index>(i % 3);
    (i < 3 ? led.motion.position : led.motion.angles)[k] = x;
    (i < 3 ? led.motion.velocity : led.motion.angle_rates)[k] = v;
    (i < 3 ? led.acceleration.position : led.acceleration.angles)[k] = a;
}

}  // namespace

PrescribedPath::PrescribedPath(const PrescribedMotion& motion, double ramp)
    : given_(motion), ramp_(ramp) {
    if (given_.rows.empty()) return;
    slopes_.resize(given_.rows.size());
    for (std::size_t i = 0; i < 6; ++i) {
        const std::vector<double> m = spline_slopes(given_.rows, i + 1);
        for (std::size_t k = 0; k < m.size(); ++k) slopes_[k][i] = m[k];
    }
}

LedMotion PrescribedPath::at(double t) const {
    if (!given_.rows.empty()) return of_file(t);
    LedMotion led;
    const Ramp r = ramp_with_rates(t, ramp_);
    for (std::size_t i = 0; i < 6; ++i) {
        if (!given_.harmonic[i]) continue;
        const HarmonicMotion& h = *given_.harmonic[i];
        const double w = 2.0 * M_PI / h.period;
        const double s = h.amplitude * std::sin(w * t + h.phase);
        const double c = w * h.amplitude * std::cos(w * t + h.phase);
        put(led, i, h.mean + r.value * s, r.rate * s + r.value * c,
            r.second * s + 2.0 * r.rate * c - r.value * w * w * s);
    }
    return led;
}

LedMotion PrescribedPath::of_file(double t) const {
    const SixSeries& rows = given_.rows;
    const auto next = std::upper_bound(rows.begin() + 1, rows.end() - 1, t,
                                       [](double x, const auto& row) { return x < row[0]; });
    const auto k = static_cast<std::size_t>(next - rows.begin()) - 1;
    const double h = rows[k + 1][0] - rows[k][0], q = t - rows[k][0];
    LedMotion led;
    for (std::size_t i = 0; i < 6; ++i) {
        const double d = (rows[k + 1][i + 1] - rows[k][i + 1]) / h;
        const double m0 = slopes_[k][i], m1 = slopes_[k + 1][i];
        const double a2 = (3.0 * d - 2.0 * m0 - m1) / h, a3 = (m0 + m1 - 2.0 * d) / (h * h);
        put(led, i, rows[k][i + 1] + q * (m0 + q * (a2 + q * a3)),
            m0 + q * (2.0 * a2 + 3.0 * q * a3), 2.0 * a2 + 6.0 * q * a3);
    }
    return led;
}

}  // namespace hawser::master
