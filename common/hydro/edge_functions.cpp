#include "hydro/edge_functions.hpp"

#include <cmath>
#include <vector>

#include "hydro/bessel.hpp"

namespace hawser::hydro {
namespace {

using Eigen::Index;

/// Functions n = first, first + step, ...
struct Orders {
    int first, step;
};
Orders orders_of(const Opening& o, bool odd) {
    if (o.end == Opening::End::both_edges) return {0, 1};
    return {odd && o.end == Opening::End::surface ? 1 : 0, 2};
}

// sign of i^n among real and imaginary parts: n = 0, 1: +; 2, 3: -
double sign_of(int n) { return n / 2 % 2 == 0 ? 1.0 : -1.0; }

void gauss_legendre(std::size_t n, std::vector<double>& x, std::vector<double>& w) {
    x.resize(n);
    w.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        double t = std::cos(M_PI * (static_cast<double>(i) + 0.75) /
                            (static_cast<double>(n) + 0.5)),
               slope = 1.0;
        for (int it = 0; it < 100; ++it) {
            double p = 1.0, before = 0.0;
            for (std::size_t k = 0; k < n; ++k) {
                const double d = static_cast<double>(k);
                const double next = ((2.0 * d + 1.0) * t * p - d * before) / (d + 1.0);
                before = p;
                p = next;
            }
            slope = static_cast<double>(n) * (t * p - before) / (t * t - 1.0);
            const double dt = p / slope;
            t -= dt;
            if (std::abs(dt) < 1e-15) break;
        }
        x[i] = t;
        w[i] = 2.0 / ((1.0 - t * t) * slope * slope);
    }
}

// Under the surface the modes are neither even nor odd about it: the even functions over their half
// are summed by Gauss's rule in t, with x = -cos(t^3), where the edge's singularity is smooth.
Eigen::MatrixXd project_under_surface(const Opening& o, int functions, const ColumnModes& m) {
    const double largest = m.k.maxCoeff() * o.half;
    const auto points = static_cast<std::size_t>(largest + 4.0 * functions) + 60;
    std::vector<double> nodes, weights;
    gauss_legendre(points, nodes, weights);
    const double end = std::cbrt(M_PI / 2.0);
    Eigen::MatrixXd u(functions, static_cast<Index>(points));
    Eigen::MatrixXd Z(static_cast<Index>(points), m.size());
    for (Index q = 0; q < u.cols(); ++q) {
        const double t = 0.5 * end * (nodes[static_cast<std::size_t>(q)] + 1.0), theta = t * t * t;
        const double x = std::cos(theta);
        const double dz = o.half * std::pow(std::sin(theta), 2.0 * edge_order) * 3.0 * t * t * 0.5 *
                          end * weights[static_cast<std::size_t>(q)];
        // C_n / gamma_n with n! Gamma(nu) / (pi 2^(1-nu) Gamma(2 nu + n)), by recurrence in n
        double c = 1.0, before = 0.0,
               over_gamma = std::tgamma(edge_order) / (M_PI * std::pow(2.0, 1.0 - edge_order) *
                                                       std::tgamma(2.0 * edge_order));
        for (int n = 0; n < 2 * functions - 1; ++n) {
            if (n % 2 == 0) u(n / 2, q) = c * over_gamma * dz;
            const double next =
                (2.0 * (n + edge_order) * x * c - (n + 2.0 * edge_order - 1.0) * before) /
                (n + 1.0);
            before = c;
            c = next;
            over_gamma *= (n + 1.0) / (2.0 * edge_order + n);
        }
        const double height = o.centre - o.half * x - m.z.low;
        for (Index j = 0; j < m.size(); ++j) Z(q, j) = m.c[j] * std::cos(m.k[j] * height);
        if (m.first == ColumnModes::First::propagating) {
            const double k = m.k[0], H = m.z.length();
            Z(q, 0) = m.c[0] * (std::exp(k * (height - H)) + std::exp(-k * (height + H))) /
                      (1.0 + std::exp(-2.0 * k * H));
        }
    }
    return u * Z;
}

}  // namespace

Eigen::MatrixXd project(const Opening& o, int functions, const ColumnModes& m, bool odd) {
    if (o.end == Opening::End::surface && m.first == ColumnModes::First::propagating)
        return project_under_surface(o, functions, m);
    const Orders orders = orders_of(o, odd);
    std::vector<double> bessel(
        static_cast<std::size_t>(orders.first + orders.step * (functions - 1) + 1));
    Eigen::MatrixXd U(functions, m.size());
    const double share = o.end == Opening::End::both_edges ? 1.0 : 0.5;
    const double height = o.centre - m.z.low, H = m.z.length();
    for (Index j = 0; j < m.size(); ++j) {
        const double k = m.k[j], scale = share * o.half * m.c[j];
        if (j == 0 && m.first == ColumnModes::First::propagating) {
            edge_bessel_i(k * o.half, bessel);
            const double rest = 1.0 + std::exp(-2.0 * k * H);
            const double up = std::exp(k * (height + o.half - H)) / rest;
            const double down = std::exp(k * (o.half - height - H)) / rest;
            for (int i = 0; i < functions; ++i) {
                const int n = orders.first + orders.step * i;
                U(i, j) = scale * (n % 2 == 0 ? up + down : up - down) *
                          bessel[static_cast<std::size_t>(n)];
            }
            continue;
        }
        edge_bessel_j(k * o.half, bessel);
        const double even = scale * std::cos(k * height), uneven = -scale * std::sin(k * height);
        for (int i = 0; i < functions; ++i) {
            const int n = orders.first + orders.step * i;
            U(i, j) =
                sign_of(n) * (n % 2 == 0 ? even : uneven) * bessel[static_cast<std::size_t>(n)];
        }
    }
    return U;
}

}  // namespace hawser::hydro
