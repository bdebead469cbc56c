#include "coupled_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace hawser::master {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>;

Matrix symmetric(const Matrix& K) { return 0.5 * (K + K.transpose()); }

/// m = -dS/d(w^2), the inertia of the lines at rest in everything but what w makes of it.
Matrix line_inertia(const LineStiffness& lines, double omega, double part = 1e-3) {
    const double low = omega * (1.0 - part), high = omega * (1.0 + part);
    return (lines(low) - lines(high)) / (high * high - low * low);
}

struct Found {
    double omega_squared = 0.0;
    Vector x;                ///< of norm 1 in M
    Matrix mass, stiffness;  ///< of the lines, there
    Matrix platform_mass;
    bool converged = false;
};

/// Part of a mode of hull and lines that is of the motion `start` of the hull, of the root of the
/// kinetic energy.
double likeness(const Found& at, const Vector& start) {
    const double lines = std::max(0.0, at.x.dot(at.mass * at.x));
    return std::abs(at.x.dot(at.platform_mass * start)) / std::sqrt(1.0 + lines);
}

bool is_among(const Found& at, const std::vector<Found>& before) {
    return std::any_of(before.begin(), before.end(), [&](const Found& other) {
        return std::abs(at.omega_squared - other.omega_squared) < 1e-6 * at.omega_squared &&
               std::abs(other.x.dot(at.platform_mass * at.x)) > 0.9;
    });
}

/// Of all modes of hull and lines near a frequency the one that has most of the motion `start`.
/// Where lines swing by themselves the hull's motion is spread over several modes, and an iteration
/// from one of them to the next need not end at the right one, or at all. D(w) = K + S(w) - w^2 M
/// has one negative eigenvalue more above each mode and one less above each frequency at which the
/// lines swing with their ends held (Wittrick and Williams), so halving an interval in which the
/// count has risen ends at a mode.
std::optional<Found> most_alike(const Matrix& K, const MassAt& mass_at, const LineStiffness& lines,
                                double squared, const Vector& start,
                                const std::vector<Found>& before) {
    constexpr double low = 0.6, high = 1.6;  // of the frequency with the lines' static stiffness
    constexpr int points = 160, halvings = 36;
    const auto dynamic = [&](double w) { return Matrix(K + lines(w) - w * w * mass_at(w)); };
    const auto below_zero = [&](double w) {
        const Eigen::SelfAdjointEigenSolver<Matrix> modes(dynamic(w), Eigen::EigenvaluesOnly);
        return (modes.eigenvalues().array() < 0.0).count();
    };
    std::optional<Found> best;
    const double w0 = std::sqrt(squared), ratio = std::pow(high / low, 1.0 / points);
    double a = low * w0;
    Eigen::Index count = below_zero(a);
    for (int i = 0; i < points; ++i) {
        const double b = a * ratio;
        const Eigen::Index after = below_zero(b);
        if (after > count) {
            double left = a, right = b;
            for (int k = 0; k < halvings; ++k) {
                const double middle = 0.5 * (left + right);
                (below_zero(middle) > count ? right : left) = middle;
            }
            Found at;
            at.omega_squared = left * right;
            at.platform_mass = mass_at(left);
            const Solver modes(dynamic(left), at.platform_mass);
            Eigen::Index nearest = 0;
            modes.eigenvalues().cwiseAbs().minCoeff(&nearest);
            at.x = modes.eigenvectors().col(nearest);  // of norm 1 in M
            at.stiffness = lines(left);
            at.mass = line_inertia(lines, left, 1e-5);
            at.converged = true;
            if (!is_among(at, before) && (!best || likeness(at, start) > likeness(*best, start)))
                best = std::move(at);
        }
        a = b, count = after;
    }
    return best;
}

/// One mode, from its frequency and shape with the lines' static stiffness.
Found improved(const Matrix& K, const MassAt& mass_at, const LineStiffness& lines, double squared,
               const Vector& start, const std::vector<Found>& before) {
    Found at;
    at.omega_squared = squared;
    at.x = start;
    at.platform_mass = mass_at(0.0);
    at.stiffness = lines(0.0);
    at.mass = Matrix::Zero(K.rows(), K.cols());
    at.converged = squared <= 0.0;
    for (int i = 0; i < 50 && !at.converged; ++i) {
        const double omega = std::sqrt(at.omega_squared);
        at.stiffness = lines(omega);
        at.mass = line_inertia(lines, omega);
        at.platform_mass = mass_at(omega);
        const Matrix& M = at.platform_mass;
        Matrix mass = M + at.mass;
        if (Eigen::SelfAdjointEigenSolver<Matrix>(mass).eigenvalues()[0] <= 0.0) mass = M;
        const Matrix extra = mass - M;
        const Solver modes(Matrix(K + at.stiffness + at.omega_squared * extra), mass);
        Eigen::Index nearest = 0;
        double best = -1e300;
        for (Eigen::Index k = 0; k < M.rows(); ++k) {
            const Vector v = modes.eigenvectors().col(k);
            const Vector Mv = M * v / std::sqrt(v.dot(M * v));
            double likeness = std::abs(at.x.dot(Mv));
            for (const Found& other : before)  // of two equal frequencies not the same mode twice
                likeness -= std::abs(other.x.dot(Mv));
            if (likeness > best) best = likeness, nearest = k;
        }
        const Vector v = modes.eigenvectors().col(nearest);
        at.x = v / std::sqrt(v.dot(M * v));
        const double change = modes.eigenvalues()[nearest] - at.omega_squared;
        at.omega_squared += change;
        at.converged = std::abs(change) <= 1e-9 * at.omega_squared;
        if (at.omega_squared <= 0.0) break;
    }
    // among the lines' own resonances
    const bool of_the_lines = !at.converged || at.x.dot(at.mass * at.x) > 1.0;
    if (of_the_lines && squared > 0.0)
        if (std::optional<Found> found = most_alike(K, mass_at, lines, squared, start, before);
            found && (!at.converged || likeness(*found, start) > likeness(at, start)))
            at = std::move(*found);
    if (!at.converged)
        at = {.omega_squared = squared,
              .x = start,
              .mass = Matrix::Zero(K.rows(), K.cols()),
              .stiffness = lines(0.0),
              .platform_mass = mass_at(0.0),
              .converged = false};
    return at;
}

CoupledMode described(const Found& at, const Matrix& K) {
    CoupledMode mode;
    mode.omega_squared = at.omega_squared;
    mode.converged = at.converged;
    const double lines = at.x.dot(at.mass * at.x), kinetic = 1.0 + lines;
    mode.line_inertia = lines / kinetic;
    const double held = at.x.dot((at.stiffness + at.omega_squared * at.mass) * at.x);
    const double elastic = at.x.dot(K * at.x) + held;
    mode.line_stiffness = elastic != 0.0 ? held / elastic : 0.0;
    return mode;
}

}  // namespace

LineStiffness line_stiffness_of(Lines& lines, const Poses& poses, std::size_t platforms) {
    return [&lines, poses, platforms](double omega) {
        Order order;
        order.ask = Ask::impedance;
        order.frequency = omega;
        order.from = order.to = poses;
        lines.send(order);
        Matrix S = Matrix::Zero(row_of(platforms), row_of(platforms));
        add_lines_stiffness(lines.receive(), S);
        return symmetric(S);
    };
}

std::vector<CoupledMode> coupled_modes(const Eigen::MatrixXd& platforms, const MassAt& mass,
                                       const LineStiffness& lines) {
    const Matrix K = symmetric(platforms), M = mass(0.0);
    const Matrix S = lines(0.0);
    const Eigen::Index rows = K.rows();
    const Solver statics(Matrix(K + S), M);
    const double stiffest = statics.eigenvalues()[rows - 1];
    std::vector<Found> found;
    for (Eigen::Index k = 0; k < rows; ++k) {
        double squared = statics.eigenvalues()[k];
        // a mode without stiffness: rounding leaves about 1e-12 of the stiffest
        if (std::abs(squared) <= 1e-9 * stiffest) squared = 0.0;
        const Vector v = statics.eigenvectors().col(k);
        found.push_back(improved(K, mass, lines, squared, v, found));
    }

    // The pair of mode and motion with the greatest share first.
    std::vector<std::tuple<double, Eigen::Index, Eigen::Index>> shares;  // share, mode, motion
    for (Eigen::Index k = 0; k < rows; ++k) {
        const Found& at = found[static_cast<std::size_t>(k)];
        const Vector energy = at.x.cwiseProduct(Vector(at.platform_mass * at.x));
        for (Eigen::Index motion = 0; motion < rows; ++motion)
            shares.emplace_back(energy[motion], k, motion);
    }
    std::sort(shares.begin(), shares.end(), std::greater<>());
    std::vector<CoupledMode> out(static_cast<std::size_t>(rows));
    std::vector<bool> mode_given(out.size()), motion_given(out.size());
    for (const auto& [share, k, motion] : shares) {
        const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(motion);
        if (mode_given[i] || motion_given[j]) continue;
        mode_given[i] = motion_given[j] = true;
        const Found& at = found[i];
        out[j] = described(at, K);
        out[j].platform = static_cast<int>(motion / 6);
        out[j].motion = static_cast<int>(motion % 6);
        out[j].share = share;
        // What is left for the last names may hardly move that way: then of its greatest part
        Eigen::Index main = motion;
        if (share < 1e-9) at.x.cwiseProduct(Vector(M * at.x)).maxCoeff(&main);
        const Vector shape = at.x / at.x[main];
        out[j].shape = shape.segment<6>(motion - motion % 6);
        for (Eigen::Index row = 0; rows > 6 && row < rows; row += 6)
            out[j].all.emplace_back(shape.segment<6>(row));
    }
    return out;
}

}  // namespace hawser::master
