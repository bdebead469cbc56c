#include "applied_force.hpp"

#include <algorithm>
#include <cmath>

#include "environment/ramp.hpp"
#include "point_load.hpp"

namespace hawser::master {

namespace {

/// Rows whose first number is the time, straight between and constant outside.
template <std::size_t n>
std::array<double, n> row_at(const std::vector<std::array<double, n>>& rows, double t) {
    if (t <= rows.front()[0]) return rows.front();
    if (t >= rows.back()[0]) return rows.back();
    const auto next = std::upper_bound(rows.begin(), rows.end(), t,
                                       [](double x, const auto& row) { return x < row[0]; });
    const std::array<double, n>&b = *next, &a = *(next - 1);
    const double q = (t - a[0]) / (b[0] - a[0]);
    std::array<double, n> out{};
    for (std::size_t i = 0; i < n; ++i) out[i] = (1.0 - q) * a[i] + q * b[i];
    return out;
}

Vec6 load_of(const AppliedForce& f, double t, double harmonic, const Mat3& R) {
    Vec3 force = f.force.value_or(Vec3::Zero()), moment = f.moment.value_or(Vec3::Zero());
    if (!f.rows.empty()) {
        const std::array<double, 7> row = row_at(f.rows, t);
        force = {row[1], row[2], row[3]};
        moment = {row[4], row[5], row[6]};
    }
    double factor = 1.0;
    if (!f.factor.empty()) factor = row_at(f.factor, t)[1];
    if (f.period) factor = harmonic * std::cos(2.0 * M_PI * t / *f.period + f.phase);
    if (f.on_platform_axes) force = R * force, moment = R * moment;
    Vec6 load = Vec6::Zero();
    add_point_load_to(load, R * f.position, factor * force);
    load.tail<3>() += factor * moment;
    return load;
}

}  // namespace

Vec6 AppliedForces::load(double t, const Mat3& R) const {
    Vec6 sum = Vec6::Zero();
    for (const AppliedForce& f : forces_) sum += load_of(f, t, ramp_factor(t, ramp_), R);
    return sum;
}

Vec6 AppliedForces::static_load(const Mat3& R) const {
    Vec6 sum = Vec6::Zero();
    for (const AppliedForce& f : forces_) sum += load_of(f, 0.0, 0.0, R);
    return sum;
}

}  // namespace hawser::master
