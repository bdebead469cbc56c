#include "heading_coefficients.hpp"

#include <algorithm>
#include <cmath>

#include "yaw_axes.hpp"

namespace hawser::master {

namespace {
constexpr double turn = 2.0 * M_PI;
}

HeadingCoefficients::HeadingCoefficients(const HeadingTable& table) : rows_(table) {
    if (rows_.empty()) return;
    if (rows_.back()[0] < 0.75 * turn)
        for (std::size_t i = rows_.size() - 1; i-- > 0;)
            rows_.push_back({turn - rows_[i][0], rows_[i][1], -rows_[i][2], -rows_[i][3]});
    rows_.back()[0] = turn;
    // Slope of the parabola through a row and its two neighbours, round the circle.
    const std::size_t n = rows_.size() - 1;
    slopes_.resize(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const std::size_t k = i % n, before = (k + n - 1) % n;
        const double h0 = rows_[before + 1][0] - rows_[before][0];
        const double h1 = rows_[k + 1][0] - rows_[k][0];
        for (std::size_t c = 0; c < 3; ++c) {
            const double d0 = (rows_[before + 1][c + 1] - rows_[before][c + 1]) / h0;
            const double d1 = (rows_[k + 1][c + 1] - rows_[k][c + 1]) / h1;
            slopes_[i][c] = (h1 * d0 + h0 * d1) / (h0 + h1);
        }
    }
}

Vec3 HeadingCoefficients::at(double heading) const {
    const double b = heading - turn * std::floor(heading / turn);
    const auto next = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, b,
                                       [](double x, const auto& row) { return x < row[0]; });
    const auto k = static_cast<std::size_t>(next - rows_.begin()) - 1;
    const double h = rows_[k + 1][0] - rows_[k][0], q = (b - rows_[k][0]) / h;
    Vec3 C;
    for (std::size_t c = 0; c < 3; ++c) {
        const double x0 = rows_[k][c + 1], x1 = rows_[k + 1][c + 1];
        const double m0 = h * slopes_[k][c], m1 = h * slopes_[k + 1][c];
        C[static_cast<Eigen::Index>(c)] =
            x0 + q * (m0 + q * (3.0 * (x1 - x0) - 2.0 * m0 - m1 + q * (2.0 * (x0 - x1) + m0 + m1)));
    }
    return C;
}

Vec6 HeadingCoefficients::load(const Vec3& u, double yaw, const Vec3& q) const {
    const double square = u.x() * u.x() + u.y() * u.y();
    if (square == 0.0) return Vec6::Zero();
    const Vec3 C = at(std::atan2(u.y(), u.x()) - yaw);
    Vec6 load = Vec6::Zero();
    load.head<3>() = turned_by_yaw(Vec3(q[0] * C[0] * square, q[1] * C[1] * square, 0.0), yaw);
    load[5] = q[2] * C[2] * square;
    return load;
}

}  // namespace hawser::master
