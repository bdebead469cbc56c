#include "coupled_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace hawser::master {

namespace {

using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Mat6>;

Mat6 symmetric(const Mat6& K) { return 0.5 * (K + K.transpose()); }

/// m = -dS/d(w^2), the inertia of the lines at rest in everything but what w makes of it.
Mat6 line_inertia(const LineStiffness& lines, double omega) {
    constexpr double part = 1e-3;
    const double low = omega * (1.0 - part), high = omega * (1.0 + part);
    return (lines(low) - lines(high)) / (high * high - low * low);
}

struct Found {
    double omega_squared = 0.0;
    Vec6 x = Vec6::Zero();                               ///< of norm 1 in M
    Mat6 mass = Mat6::Zero(), stiffness = Mat6::Zero();  ///< of the lines, there
    Mat6 platform_mass = Mat6::Zero();
    bool converged = false;
};

/// One mode, from its frequency and shape with the lines' static stiffness.
Found improved(const Mat6& K, const MassAt& mass_at, const LineStiffness& lines, double squared,
               const Vec6& start, const std::vector<Found>& before) {
    Found at{.omega_squared = squared, .x = start};
    at.platform_mass = mass_at(0.0);
    at.stiffness = lines(0.0);
    at.converged = squared <= 0.0;
    for (int i = 0; i < 50 && !at.converged; ++i) {
        const double omega = std::sqrt(at.omega_squared);
        at.stiffness = lines(omega);
        at.mass = line_inertia(lines, omega);
        at.platform_mass = mass_at(omega);
        const Mat6& M = at.platform_mass;
        Mat6 mass = M + at.mass;
        if (Eigen::SelfAdjointEigenSolver<Mat6>(mass).eigenvalues()[0] <= 0.0) mass = M;
        const Mat6 extra = mass - M;
        const Solver modes(Mat6(K + at.stiffness + at.omega_squared * extra), mass);
        int nearest = 0;
        double best = -1e300;
        for (int k = 0; k < 6; ++k) {
            const Vec6 v = modes.eigenvectors().col(k);
            const Vec6 Mv = M * v / std::sqrt(v.dot(M * v));
            double likeness = std::abs(at.x.dot(Mv));
            for (const Found& other : before)  // of two equal frequencies not the same mode twice
                likeness -= std::abs(other.x.dot(Mv));
            if (likeness > best) best = likeness, nearest = k;
        }
        const Vec6 v = modes.eigenvectors().col(nearest);
        at.x = v / std::sqrt(v.dot(M * v));
        const double change = modes.eigenvalues()[nearest] - at.omega_squared;
        at.omega_squared += change;
        at.converged = std::abs(change) <= 1e-9 * at.omega_squared;
        if (at.omega_squared <= 0.0) break;
    }
    if (!at.converged)  // among the lines' own resonances
        at = {.omega_squared = squared,
              .x = start,
              .stiffness = lines(0.0),
              .platform_mass = mass_at(0.0),
              .converged = false};
    return at;
}

CoupledMode described(const Found& at, const Mat6& K) {
    CoupledMode mode;
    mode.omega_squared = at.omega_squared;
    mode.converged = at.converged;
    mode.shape = at.x;
    const double lines = at.x.dot(at.mass * at.x), kinetic = 1.0 + lines;
    mode.line_inertia = lines / kinetic;
    const double held = at.x.dot((at.stiffness + at.omega_squared * at.mass) * at.x);
    const double elastic = at.x.dot(K * at.x) + held;
    mode.line_stiffness = elastic != 0.0 ? held / elastic : 0.0;
    return mode;
}

}  // namespace

LineStiffness line_stiffness_of(Lines& lines, const PlatformMotion& pose) {
    return [&lines, pose](double omega) {
        Order order;
        order.ask = Ask::impedance;
        order.frequency = omega;
        order.from[0] = order.to[0] = pose;
        lines.send(order);
        Mat6 S = Mat6::Zero();
        for (const LineLoad& line : lines.receive().lines) S += line.stiffness;
        return symmetric(S);
    };
}

std::array<CoupledMode, 6> coupled_modes(const Mat6& platform, const MassAt& mass,
                                         const LineStiffness& lines) {
    const Mat6 K = symmetric(platform), M = mass(0.0);
    const Mat6 S = lines(0.0);
    const Solver statics(Mat6(K + S), M);
    const double stiffest = statics.eigenvalues()[5];
    std::vector<Found> found;
    for (int k = 0; k < 6; ++k) {
        double squared = statics.eigenvalues()[k];
        // a mode without stiffness: rounding leaves about 1e-12 of the stiffest
        if (std::abs(squared) <= 1e-9 * stiffest) squared = 0.0;
        const Vec6 v = statics.eigenvectors().col(k);
        found.push_back(improved(K, mass, lines, squared, v, found));
    }

    // The pair of mode and motion with the greatest share first.
    std::vector<std::tuple<double, int, int>> shares;  // share, mode, motion
    for (int k = 0; k < 6; ++k) {
        const Vec6& x = found[static_cast<std::size_t>(k)].x;
        const Vec6 energy =
            x.cwiseProduct(Vec6(found[static_cast<std::size_t>(k)].platform_mass * x));
        for (int motion = 0; motion < 6; ++motion) shares.emplace_back(energy[motion], k, motion);
    }
    std::sort(shares.begin(), shares.end(), std::greater<>());
    std::array<CoupledMode, 6> out;
    std::array<bool, 6> mode_given{}, motion_given{};
    for (const auto& [share, k, motion] : shares) {
        const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(motion);
        if (mode_given[i] || motion_given[j]) continue;
        mode_given[i] = motion_given[j] = true;
        out[j] = described(found[i], K);
        out[j].motion = motion;
        out[j].share = share;
        // What is left for the last names may hardly move that way: then of its greatest part
        int main = motion;
        if (share < 1e-9) found[i].x.cwiseProduct(Vec6(M * found[i].x)).maxCoeff(&main);
        out[j].shape /= out[j].shape[main];
    }
    return out;
}

}  // namespace hawser::master
