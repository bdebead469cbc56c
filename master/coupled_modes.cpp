#include "coupled_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace hawser::master {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>;

Matrix symmetric(const Matrix& K) { return 0.5 * (K + K.transpose()); }

/// m = -dS/d(w^2), the inertia of the lines at rest in everything but what w makes of it.
Matrix line_inertia(const LineStiffness& lines, double omega) {
    constexpr double part = 1e-3;
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
    if (!at.converged)  // among the lines' own resonances
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
