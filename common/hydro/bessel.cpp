#include "hydro/bessel.hpp"

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>

namespace hawser::hydro {
namespace {

using Fast = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// sum (-sign)^k a_k(m) / x^k, DLMF 10.40.1 and 10.40.2: beyond x = 300 exact to rounding.
double far_series(int m, double x, double sign) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; k < 14; ++k) {
        const double odd = 2.0 * k - 1.0;
        term *= sign * (4.0 * m * m - odd * odd) / (8.0 * k * x);
        sum += term;
    }
    return sum;
}
constexpr double far = 300.0;

double i_scaled(int m, double x) {
    if (x > far) return far_series(m, x, -1.0) / std::sqrt(2.0 * M_PI * x);
    return boost::math::cyl_bessel_i(m, x, Fast()) * std::exp(-x);
}
double k_scaled(int m, double x) {
    if (x > far) return far_series(m, x, 1.0) * std::sqrt(M_PI / (2.0 * x));
    return boost::math::cyl_bessel_k(m, x, Fast()) * std::exp(x);
}

double limit_at_zero() { return 1.0 / (std::pow(2.0, edge_order) * std::tgamma(1.0 + edge_order)); }

// Miller's backward recurrence f_(n-1) = 2 (nu + n) / x f_n + sign f_(n+1) from zero far above the
// wanted orders; returns the sum of weight(n) f_n beside.
template <class Weight>
double recur_down(double x, double sign, int start, std::span<double> out, Weight weight) {
    double above = 0.0, here = 1e-250, sum = 0.0;
    const int size = static_cast<int>(out.size());
    for (int n = start; n >= 0; --n) {
        if (n < size) out[static_cast<std::size_t>(n)] = here;
        sum += weight(n) * here;
        const double below = 2.0 * (edge_order + n) / x * here + sign * above;
        above = here;
        here = below;
        if (std::abs(here) > 1e250) {
            for (int i = n; i < size; ++i) out[static_cast<std::size_t>(i)] *= 1e-250;
            above *= 1e-250;
            here *= 1e-250;
            sum *= 1e-250;
        }
    }
    return sum;
}

}  // namespace

void edge_bessel_j(double x, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0.0);
    if (x < 1e-8) {
        out[0] = limit_at_zero();
        return;
    }
    const double scale = std::pow(x, -edge_order);
    const double j0 = boost::math::cyl_bessel_j(edge_order, x, Fast()) * scale;
    const double j1 = boost::math::cyl_bessel_j(edge_order + 1.0, x, Fast()) * scale;
    const int size = static_cast<int>(out.size());
    if (x > size) {
        out[0] = j0;
        if (size > 1) out[1] = j1;
        for (std::size_t n = 2; n < out.size(); ++n)
            out[n] =
                2.0 * (edge_order + static_cast<double>(n) - 1.0) / x * out[n - 1] - out[n - 2];
        return;
    }
    // One order above what is wanted, so that J_(nu+1) can serve for the scale.
    const double f0_unused = recur_down(
        x, -1.0, size + 40 + static_cast<int>(8.0 * std::cbrt(size)), out, [](int) { return 0.0; });
    (void)f0_unused;
    const bool first = size == 1 || std::abs(j0) >= std::abs(j1);
    const double factor = first ? j0 / out[0] : j1 / out[1];
    for (double& value : out) value *= factor;
}

void edge_bessel_i(double x, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0.0);
    if (x < 1e-8) {
        out[0] = limit_at_zero();
        return;
    }
    // Gegenbauer's addition theorem at zero angle gives the scale, DLMF 10.35 with C_n(1):
    //   e^x = Gamma(nu) (x/2)^-nu sum (nu + n) Gamma(2 nu + n) / (n! Gamma(2 nu)) I_(nu+n)(x)
    const int start = static_cast<int>(out.size()) + 60 +
                      static_cast<int>(9.0 * std::sqrt(x) + 0.2 * x / (1 + 1e-3 * x));
    const double sum = recur_down(x, 1.0, start, out, [](int n) {
        return (edge_order + n) *
               std::exp(std::lgamma(2.0 * edge_order + n) - std::lgamma(n + 1.0));
    });
    const double scale =
        std::tgamma(2.0 * edge_order) / (std::tgamma(edge_order) * std::pow(2.0, edge_order) * sum);
    for (double& value : out) value *= scale;
}

void scaled_bessel_i(double x, std::span<double> out) {
    const std::size_t size = out.size();
    out[0] = i_scaled(0, x);
    if (x >= 60.0) {
        out[1] = i_scaled(1, x);
        for (std::size_t m = 2; m < size; ++m)
            out[m] = out[m - 2] - 2.0 * (static_cast<double>(m) - 1.0) / x * out[m - 1];
        return;
    }
    double ratio = 0.0;  // I_(m+1) / I_m, downwards
    for (std::size_t m = size + 80; m-- > 0;) {
        ratio = 1.0 / (2.0 * (static_cast<double>(m) + 1.0) / x + ratio);
        if (m + 1 < size) out[m + 1] = ratio;
    }
    for (std::size_t m = 1; m < size; ++m) out[m] *= out[m - 1];
}

void scaled_bessel_k(double x, std::span<double> out) {
    out[0] = k_scaled(0, x);
    out[1] = k_scaled(1, x);
    for (std::size_t m = 2; m < out.size(); ++m)
        out[m] = out[m - 2] + 2.0 * (static_cast<double>(m) - 1.0) / x * out[m - 1];
}

void bessel_jy(double x, std::span<double> j, std::span<double> y) {
    for (std::size_t m = 0; m < j.size(); ++m)
        j[m] = boost::math::cyl_bessel_j(static_cast<int>(m), x, Fast());
    for (std::size_t m = 0; m < y.size(); ++m)
        y[m] = m < 2 ? boost::math::cyl_neumann(static_cast<int>(m), x, Fast())
                     : std::max(-1e280,
                                2.0 * (static_cast<double>(m) - 1.0) / x * y[m - 1] - y[m - 2]);
}

}  // namespace hawser::hydro
