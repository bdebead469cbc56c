#include "hydro/column_modes.hpp"

#include <cmath>

#include "environment/dispersion.hpp"

namespace hawser::hydro {
namespace {

ColumnModes sized(Span z, Eigen::Index n) {
    ColumnModes m;
    m.z = z;
    for (Eigen::ArrayXd* a : {&m.k, &m.c, &m.top, &m.bottom}) *a = Eigen::ArrayXd::Zero(n);
    return m;
}

// What y = j pi - delta lacks of a multiple of pi in y tan y = -K H: delta = atan(K H / y).
double lag_of_root(int j, double KH) {
    double delta = std::atan(KH / (j * M_PI));
    for (int i = 0; i < 30; ++i) {
        const double y = j * M_PI - delta;
        const double step = (delta - std::atan(KH / y)) / (1.0 - KH / (y * y + KH * KH));
        delta -= step;
        if (std::abs(step) < 1e-15) break;
    }
    return delta;
}

}  // namespace

ColumnModes closed_modes(Span z, int begin, int end) {
    ColumnModes m = sized(z, end - begin);
    const double H = z.length();
    if (begin == 0) m.first = ColumnModes::First::constant;
    for (int l = begin; l < end; ++l) {
        const Eigen::Index i = l - begin;
        m.k[i] = l * M_PI / H;
        m.c[i] = std::sqrt((l == 0 ? 1.0 : 2.0) / H);
        m.bottom[i] = m.c[i];
        m.top[i] = l % 2 == 0 ? m.c[i] : -m.c[i];
    }
    return m;
}

ColumnModes surface_modes(Span z, double K, int end, int begin) {
    const double H = z.length();
    if (std::isinf(K)) {
        ColumnModes m = sized(z, end - begin);
        for (int j = begin; j < end; ++j) {
            const Eigen::Index i = j - begin;
            m.k[i] = (j - 0.5) * M_PI / H;
            m.c[i] = m.bottom[i] = std::sqrt(2.0 / H);
        }
        return m;
    }
    ColumnModes m = sized(z, end);
    m.first = ColumnModes::First::propagating;
    const double k = wave_number(std::sqrt(K), H, 1.0), tanh = K / k;
    m.k[0] = k;
    m.c[0] = 1.0 / std::sqrt(0.5 * (H * (1.0 - tanh * tanh) + tanh / k));
    m.top[0] = m.c[0];
    m.bottom[0] = m.c[0] / std::cosh(std::min(k * H, 700.0));
    for (int j = 1; j < end; ++j) {
        const double kj = (j * M_PI - lag_of_root(j, K * H)) / H;
        m.k[j] = kj;
        m.c[j] = m.bottom[j] = 1.0 / std::sqrt(0.5 * (H - K / (kj * kj + K * K)));
        m.top[j] = (j % 2 == 0 ? 1.0 : -1.0) * m.c[j] / std::sqrt(1.0 + K * K / (kj * kj));
    }
    return m;
}

Eigen::MatrixX2d wall_moments(const ColumnModes& m, Span wall) {
    Eigen::MatrixX2d W(m.size(), 2);
    const double H = m.z.length(), low = wall.low - m.z.low, high = wall.high - m.z.low;
    for (Eigen::Index j = 0; j < m.size(); ++j) {
        const double k = m.k[j];
        if (j == 0 && m.first == ColumnModes::First::constant) {
            W(j, 0) = m.c[j] * wall.length();
            W(j, 1) = m.c[j] * 0.5 * (wall.high * wall.high - wall.low * wall.low);
        } else if (j == 0 && m.first == ColumnModes::First::propagating) {
            const double scale = m.c[j] / (1.0 + std::exp(-2.0 * k * H));
            const auto up = [&](double x) { return std::exp(k * (x - H)); };
            const auto down = [&](double x) { return std::exp(-k * (x + H)); };
            const auto sinh = [&](double x) { return scale * (up(x) - down(x)); };
            const auto cosh = [&](double x) { return scale * (up(x) + down(x)); };
            W(j, 0) = (sinh(high) - sinh(low)) / k;
            W(j, 1) = (wall.high * sinh(high) - wall.low * sinh(low)) / k -
                      (cosh(high) - cosh(low)) / (k * k);
        } else {
            const double sh = std::sin(k * high), sl = std::sin(k * low);
            W(j, 0) = m.c[j] * (sh - sl) / k;
            W(j, 1) = m.c[j] * ((wall.high * sh - wall.low * sl) / k +
                                (std::cos(k * high) - std::cos(k * low)) / (k * k));
        }
    }
    return W;
}

}  // namespace hawser::hydro
