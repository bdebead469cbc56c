#include "hydro/radial.hpp"

#include <cmath>
#include <vector>

#include "hydro/bessel.hpp"

namespace hawser::hydro {
namespace {

using Eigen::Index;

struct Pair {  // a function and its derivative by its argument
    double value, slope;
};

/// e^-x I_m and its derivative without that of the exponential; likewise e^x K_m.
Pair growing(int m, double x, std::vector<double>& work) {
    scaled_bessel_i(x, work);
    const auto i = static_cast<std::size_t>(m);
    return {work[i], work[i + 1] + m / x * work[i]};
}
Pair decaying(int m, double x, std::vector<double>& work) {
    scaled_bessel_k(x, work);
    const auto i = static_cast<std::size_t>(m);
    return {work[i], -work[i + 1] + m / x * work[i]};
}

// From two solutions f, g at outer and inner radius (values and slopes by r).
void set_ring(Radial& r, Index j, double outer, double inner, Pair fo, Pair fi, Pair go, Pair gi) {
    // q_o = A fo' + B go', q_i = A fi' + B gi'
    const double det = fo.slope * gi.slope - go.slope * fi.slope;
    r.oo[j] = outer * (fo.value * gi.slope - go.value * fi.slope) / det;
    r.oi[j] = outer * (go.value * fo.slope - fo.value * go.slope) / det;
    r.ii[j] = -inner * (gi.value * fo.slope - fi.value * go.slope) / det;
}

void set_constant(Radial& r, Index j, const Column& c, int m) {
    const double o = c.outer, i = c.inner;
    if (m == 0) {
        if (i > 0.0) r.ii[j] = i * i * std::log(o / i);
    } else if (i == 0.0) {
        r.oo[j] = o * o / m;
    } else {
        const double s = std::pow(i / o, m);  // f = (r/o)^m, g = (i/r)^m
        set_ring(r, j, o, i, {1.0, m / o}, {s, m * s / i}, {s, -m * s / o}, {1.0, -m / i});
    }
}

void set_propagating(Radial& r, Index j, const Column& c, double k, int m) {
    std::vector<double> J(static_cast<std::size_t>(m) + 2), Y(J.size());
    const auto at = [&](double radius, Pair& f, Pair& g) {
        const double x = k * radius;
        bessel_jy(x, J, Y);
        const auto i = static_cast<std::size_t>(m);
        f = {J[i], k * (-J[i + 1] + m / x * J[i])};
        g = {Y[i], k * (-Y[i + 1] + m / x * Y[i])};
    };
    Pair fo{}, fi{}, go{}, gi{};
    at(c.outer, fo, go);
    if (c.inner == 0.0) {
        r.oo[j] = c.outer * fo.value / fo.slope;
        return;
    }
    at(c.inner, fi, gi);
    set_ring(r, j, c.outer, c.inner, fo, fi, go, gi);
}

void set_decaying(Radial& r, Index j, const Column& c, double k, int m, std::vector<double>& work) {
    const double xo = k * c.outer, xi = k * c.inner;
    if (c.inner == 0.0) {
        const Pair f = growing(m, xo, work);
        r.oo[j] = c.outer * f.value / (k * f.slope);
    } else if (c.outer == 0.0) {
        const Pair g = decaying(m, xi, work);
        r.ii[j] = -c.inner * g.value / (k * g.slope);
    } else {
        Pair fo = growing(m, xo, work), fi = growing(m, xi, work);
        Pair go = decaying(m, xo, work), gi = decaying(m, xi, work);
        // each divided by its largest value
        const double fade = std::exp(xi - xo), f = fo.value, g = gi.value;
        fo = {1.0, k * fo.slope / f};
        fi = {fi.value / f * fade, k * fi.slope / f * fade};
        go = {go.value / g * fade, k * go.slope / g * fade};
        gi = {1.0, k * gi.slope / g};
        set_ring(r, j, c.outer, c.inner, fo, fi, go, gi);
    }
}

Radial zeros(Index n) {
    return {Eigen::ArrayXd::Zero(n), Eigen::ArrayXd::Zero(n), Eigen::ArrayXd::Zero(n)};
}

}  // namespace

Radial radial_of(const Column& column, const ColumnModes& modes, int m) {
    Radial r = zeros(modes.size());
    std::vector<double> work(static_cast<std::size_t>(m) + 2);
    for (Index j = 0; j < modes.size(); ++j) {
        const bool special = j == 0 && modes.first != ColumnModes::First::decaying;
        if (!special)
            set_decaying(r, j, column, modes.k[j], m, work);
        else if (modes.first == ColumnModes::First::constant)
            set_constant(r, j, column, m);
        else if (column.outer > 0.0)
            set_propagating(r, j, column, modes.k[j], m);
    }
    return r;
}

Radial radial_far(const Column& column, const ColumnModes& modes, int m) {
    Radial r = zeros(modes.size());
    const double third = 0.375 - 0.5 * m * m;
    const Eigen::ArrayXd& k = modes.k;
    if (column.outer > 0.0)
        r.oo = column.outer / k + 0.5 / k.square() + third / (column.outer * k.cube());
    if (column.inner > 0.0)
        r.ii = column.inner / k - 0.5 / k.square() + third / (column.inner * k.cube());
    return r;
}

}  // namespace hawser::hydro
