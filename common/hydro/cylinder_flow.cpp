#include "hydro/cylinder_flow.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hydro/bessel.hpp"
#include "hydro/edge_functions.hpp"

namespace hawser::hydro {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::MatrixXd;

constexpr int chunk = 512;

/// The part of the motions' potential that meets moving floors and ceilings, H:8: its projection
/// and that of its radial derivative at radius r, modes x motions.
struct LidPotential {
    MatrixX2d value, slope;
};

LidPotential lid_potential(const Column& c, const ColumnModes& modes, double r, int m) {
    LidPotential p{MatrixX2d::Zero(modes.size(), 2), MatrixX2d::Zero(modes.size(), 2)};
    const double t = c.moving_top ? 1.0 : 0.0, b = c.moving_bottom ? 1.0 : 0.0;
    if (m > 1 || (t == 0.0 && b == 0.0)) return p;
    const Index motion = m;  // heave, or pitch behind surge
    for (Index j = 0; j < modes.size(); ++j) {
        if (j == 0 && modes.first == ColumnModes::First::constant) {
            const double H = c.z.length(), scale = std::sqrt(H) * (t - b);
            p.value(j, motion) =
                m == 0 ? scale * (H / 6 - r * r / (4 * H)) : -scale * r * (H / 6 - r * r / (8 * H));
            p.slope(j, motion) =
                m == 0 ? -scale * r / (2 * H) : -scale * (H / 6 - 3 * r * r / (8 * H));
            continue;
        }
        const double P = (t * modes.top[j] - b * modes.bottom[j]) / modes.curvature(j);
        p.value(j, motion) = m == 0 ? P : -r * P;
        p.slope(j, motion) = m == 0 ? 0.0 : -P;
    }
    return p;
}

double hypot_power(double outer, double inner, int n) {
    return std::pow(outer, n) - std::pow(inner, n);
}

}  // namespace

CylinderFlow::CylinderFlow(const Hull& hull, Resolution resolution) : water_(partition_of(hull)) {
    double finest = hull.depth;
    for (const Opening& o : water_.openings) {
        finest = std::min(finest, o.edge_gap);
        double n = 5.0 + 2.5 * std::sqrt(o.half / o.edge_gap);
        if (o.end == Opening::End::both_edges) n *= 2.0;
        if (o.end == Opening::End::surface) n += 0.5 * resolution.largest_K * o.half;
        offset_.push_back(functions_);
        count_.push_back(static_cast<int>(std::ceil(resolution.level * n)));
        functions_ += count_.back();
    }
    unknowns_ = functions_;
    double k = 4.0 * resolution.largest_K;
    k = std::max(k, resolution.level * 20.0 / finest);
    for (const Column& c : water_.columns) {
        k = std::max(k, 20.0 / (c.inner > 0.0 ? c.inner : c.outer));
        if (c.inner > 0.0 && c.outer > 0.0) k = std::max(k, 18.0 / (c.outer - c.inner));
    }
    for (const Column& c : water_.columns) {
        const double per_wave_number = c.z.length() / M_PI;
        const int most = c.opening >= 0 ? count_[static_cast<std::size_t>(c.opening)] : 0;
        heads_.push_back(std::max(static_cast<int>(std::ceil(k * per_wave_number)), 2 * most) + 2);
        ends_.push_back(heads_.back() * 64);
        constants_.push_back(c.surface ? -1 : unknowns_++);
    }
    add_tails();
}

CylinderFlow::Sums CylinderFlow::empty() const {
    Sums s;
    s.A = MatrixXd::Zero(unknowns_, unknowns_);
    s.rhs = MatrixXd::Zero(unknowns_, 2);
    return s;
}

CylinderFlow::Projected CylinderFlow::projected(std::size_t column, ColumnModes modes,
                                                bool odd) const {
    const Column& c = water_.columns[column];
    Projected p;
    const auto of = [&](int opening) {
        const auto i = static_cast<std::size_t>(opening);
        return project(water_.openings[i], count_[i], modes, odd);
    };
    if (c.opening >= 0) p.outer = of(c.opening);
    int rows = 0;
    for (int o = c.first_opening; o < c.first_opening + c.openings; ++o)
        rows += count_[static_cast<std::size_t>(o)];
    p.inner.resize(rows, modes.size());
    rows = 0;
    for (int o = c.first_opening; o < c.first_opening + c.openings; ++o) {
        p.inner.middleRows(rows, count_[static_cast<std::size_t>(o)]) = of(o);
        rows += count_[static_cast<std::size_t>(o)];
    }
    p.walls = MatrixX2d::Zero(modes.size(), 2);
    for (const Span wall : c.walls) p.walls += wall_moments(modes, wall);
    p.modes = std::move(modes);
    return p;
}

void CylinderFlow::add(std::size_t column, const Projected& p, const Radial& r, int m, bool matrix,
                       Sums& sums) const {
    const Column& c = water_.columns[column];
    const bool has_outer = c.opening >= 0, has_inner = c.openings > 0;
    const Index o = has_outer ? offset_[static_cast<std::size_t>(c.opening)] : 0;
    const Index i = has_inner ? offset_[static_cast<std::size_t>(c.first_opening)] : 0;
    const Index no = p.outer.rows(), ni = p.inner.rows();
    if (matrix) {
        if (has_outer)
            sums.A.block(o, o, no, no).noalias() +=
                p.outer * r.oo.matrix().asDiagonal() * p.outer.transpose();
        if (has_inner)
            sums.A.block(i, i, ni, ni).noalias() +=
                p.inner * r.ii.matrix().asDiagonal() * p.inner.transpose();
        if (has_outer && has_inner) {
            const MatrixXd cross = p.outer * r.oi.matrix().asDiagonal() * p.inner.transpose();
            sums.A.block(o, i, no, ni) += cross;
            sums.A.block(i, o, ni, no) += cross.transpose();
        }
    }
    if (m > 1) return;
    const Index n = p.modes.size();
    MatrixX2d D_o = MatrixX2d::Zero(n, 2), P_o = D_o, D_i = D_o, P_i = D_o, W = D_o;
    if (c.outer > 0.0) {
        const LidPotential lid = lid_potential(c, p.modes, c.outer, m);
        P_o = lid.value;
        D_o = -lid.slope;
    }
    if (c.inner > 0.0) {
        const LidPotential lid = lid_potential(c, p.modes, c.inner, m);
        P_i = lid.value;
        if (m == 1) W = p.walls;
        D_i = W - lid.slope;
    }
    const auto times = [](const ArrayXd& a, const MatrixX2d& b) -> MatrixX2d {
        return a.matrix().asDiagonal() * b;
    };
    const MatrixX2d on_outer = times(r.oo, D_o) + times(r.oi, D_i) + c.outer * P_o;
    const MatrixX2d on_inner = times(r.oi, D_o) + times(r.ii, D_i) - c.inner * P_i;
    if (has_outer) sums.rhs.middleRows(o, no).noalias() -= p.outer * on_outer;
    if (has_inner) sums.rhs.middleRows(i, ni).noalias() -= p.inner * on_inner;
    sums.direct += D_o.transpose() * times(r.oo, D_o) + D_o.transpose() * times(r.oi, D_i) +
                   D_i.transpose() * times(r.oi, D_o) + D_i.transpose() * times(r.ii, D_i) +
                   c.outer * P_o.transpose() * D_o - c.inner * P_i.transpose() * D_i -
                   c.inner * W.transpose() * P_i;
    const int constant = constants_[column];
    if (!matrix || m != 0 || constant < 0 || p.modes.first != ColumnModes::First::constant) return;
    if (has_outer) sums.A.col(constant).segment(o, no) += c.outer * p.outer.col(0);
    if (has_inner) sums.A.col(constant).segment(i, ni) -= c.inner * p.inner.col(0);
    sums.A.row(constant) = sums.A.col(constant).transpose();
    sums.rhs.row(constant) -= c.outer * D_o.row(0) - c.inner * D_i.row(0);
}

// Integral of the lid potential itself over floor and ceiling, divided by 2 pi (heave) or pi
// (pitch). It is taken off `direct`, which the force subtracts.
void CylinderFlow::add_lids(std::size_t column, double K, int m, Eigen::Matrix2d& direct) const {
    const Column& c = water_.columns[column];
    const double t = c.moving_top ? 1.0 : 0.0, b = c.moving_bottom ? 1.0 : 0.0, H = c.z.length();
    if (m > 1 || (t == 0.0 && b == 0.0)) return;
    const double r2 = hypot_power(c.outer, c.inner, 2) / 2,
                 r4 = hypot_power(c.outer, c.inner, 4) / 4,
                 r6 = hypot_power(c.outer, c.inner, 6) / 6;
    double sum = 0.0;
    if (c.surface) {
        const double height = c.z.low + (std::isinf(K) ? 0.0 : 1.0 / K);
        sum = b * height * (m == 0 ? r2 : r4);
    } else if (m == 0) {
        sum = -t * (t * H / 2 * r2 - (t - b) * r4 / (4 * H)) +
              b * (-b * H / 2 * r2 - (t - b) * r4 / (4 * H));
    } else {
        sum = -t * (t * H / 2 * r4 - (t - b) * r6 / (8 * H)) +
              b * (-b * H / 2 * r4 - (t - b) * r6 / (8 * H));
    }
    direct(m, m) -= sum;
}

// The sums beyond each column's head, at K = 0 and for large k r: their dependence on the frequency
// is gone, and that on m is m^2 times one matrix.
void CylinderFlow::add_tails() {
    for (auto& kind : tail_)
        for (Sums& s : kind) s = empty();
    for (std::size_t i = 0; i < water_.columns.size(); ++i) {
        const Column& c = water_.columns[i];
        for (int begin = heads_[i]; begin < ends_[i]; begin += chunk) {
            const Projected p =
                projected(i, closed_modes(c.z, begin, std::min(ends_[i], begin + chunk)), false);
            for (int m = 0; m < 2; ++m)
                add(i, p, radial_far(c, p.modes, m), m, true, tail_[c.surface ? 1 : 0][m]);
        }
    }
}

void CylinderFlow::add_tail(bool surface, int m, Sums& sums) const {
    const Sums* tail = tail_[surface ? 1 : 0];
    sums.A += tail[0].A + m * m * (tail[1].A - tail[0].A);
    if (m > 1) return;
    sums.rhs += tail[m].rhs;
    sums.direct += tail[m].direct;
}

// At infinite frequency nothing can be borrowed from the rigid lid's tail.
void CylinderFlow::add_infinite_surface(std::size_t i, int m, Sums& sums) const {
    const Column& c = water_.columns[i];
    for (int begin = 1; begin < ends_[i]; begin += chunk) {
        const int end = std::min(ends_[i], begin + chunk);
        const Projected p = projected(i, surface_modes(c.z, infinite_frequency, end, begin), true);
        const bool far = begin > heads_[i];
        add(i, p, far ? radial_far(c, p.modes, m) : radial_of(c, p.modes, m), m, true, sums);
    }
}

const CylinderFlow::Sums& CylinderFlow::closed(int m) {
    const auto found = closed_.find(m);
    if (found != closed_.end()) return found->second;
    Sums sums = empty();
    add_tail(false, m, sums);
    for (std::size_t i = 0; i < water_.columns.size(); ++i) {
        const Column& c = water_.columns[i];
        if (c.surface) continue;
        if (closed_columns_.size() <= i) closed_columns_.resize(i + 1);
        Projected& p = closed_columns_[i];
        if (p.modes.size() == 0) p = projected(i, closed_modes(c.z, 0, heads_[i]), false);
        add(i, p, radial_of(c, p.modes, m), m, true, sums);
        add_lids(i, 0.0, m, sums.direct);
        if (m > 0) sums.A(constants_[i], constants_[i]) = 1.0;  // the unknown is not used
    }
    return closed_.emplace(m, std::move(sums)).first->second;
}

const std::vector<CylinderFlow::Projected>& CylinderFlow::surface_columns(double K) {
    if (K == K_) return surface_;
    K_ = K;
    surface_.clear();
    for (std::size_t i = 0; i < water_.columns.size(); ++i) {
        const Column& c = water_.columns[i];
        surface_.push_back(c.surface ? projected(i, surface_modes(c.z, K, heads_[i]), false)
                                     : Projected{});
    }
    return surface_;
}

FarWaves CylinderFlow::far_waves(double K) {
    const ColumnModes& modes = surface_columns(K).back().modes;
    const double k = modes.k[0], kh = k * modes.z.length();
    return {K, k, water_.columns.back().inner, modes.top[0],
            0.5 + (kh > 300.0 ? 0.0 : kh / std::sinh(2.0 * kh))};
}

Complex outgoing_ratio(int m, double x) {
    // H_m / H_m', H_m = J_m - i Y_m; beyond the cut of Y the ratio is that of small arguments
    std::vector<double> J(static_cast<std::size_t>(m) + 2), Y(J.size());
    bessel_jy(x, J, Y);
    const auto i = static_cast<std::size_t>(m);
    const Complex H(J[i], -Y[i]), H1(J[i + 1], -Y[i + 1]);
    return H / (static_cast<double>(m) / x * H - H1);
}

AzimuthFlow CylinderFlow::solve(int m, double K) {
    AzimuthFlow flow;
    flow.motions = m == 0 ? 1 : m == 1 ? 2 : 0;
    Sums sums = closed(m);
    const bool waves = !std::isinf(K);
    if (waves) {
        surface_columns(K);
        add_tail(true, m, sums);
    }
    for (std::size_t i = 0; i < water_.columns.size(); ++i) {
        const Column& c = water_.columns[i];
        if (!c.surface) continue;
        if (waves)
            add(i, surface_[i], radial_of(c, surface_[i].modes, m), m, true, sums);
        else
            add_infinite_surface(i, m, sums);
        add_lids(i, K, m, sums.direct);
    }

    // The propagating mode outside is all that is complex.
    const Column& outside = water_.columns.back();
    const double R = outside.inner;
    Eigen::VectorXcd u = Eigen::VectorXcd::Zero(unknowns_);
    Eigen::RowVector2cd W = Eigen::RowVector2cd::Zero();
    Complex S = 0.0;
    if (waves) {
        const Projected& p = surface_.back();
        if (outside.openings > 0)
            u.segment(offset_[static_cast<std::size_t>(outside.first_opening)], p.inner.rows()) =
                p.inner.col(0).cast<Complex>();
        if (m == 1) W = p.walls.row(0).cast<Complex>();
        S = -R * outgoing_ratio(m, p.modes.k[0] * R) / p.modes.k[0];
    }
    Eigen::MatrixXcd A = sums.A.cast<Complex>();
    A.noalias() += S * u * u.transpose();
    Eigen::MatrixXcd rhs(unknowns_, 3);
    rhs.leftCols(2) = sums.rhs.cast<Complex>() - S * u * W;
    rhs.col(2) = R * u;
    const Eigen::MatrixXcd x = unknowns_ > 0 ? Eigen::MatrixXcd(A.partialPivLu().solve(rhs)) : rhs;

    const double turn = m == 0 ? 2.0 * M_PI : M_PI;
    flow.force = turn * (rhs.leftCols(2).transpose() * x.leftCols(2) - sums.direct.cast<Complex>() -
                         S * W.transpose() * W);
    flow.exciting = turn * (rhs.leftCols(2).transpose() * x.col(2) + R * W.transpose());
    flow.radiated = (u.transpose() * x.leftCols(2) + W).transpose();
    flow.scattered = (u.transpose() * x.col(2)).value();
    return flow;
}

}  // namespace hawser::hydro
