#include "natural_periods.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace hawser::master {

std::array<std::optional<double>, 6> natural_periods(const Mat6& K, const Mat6& M) {
    const Mat6 symmetric = 0.5 * (K + K.transpose());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> modes(symmetric, M);
    const Vec6& squares = modes.eigenvalues();  // w^2

    // The pair of mode and motion with the greatest share first.
    std::vector<std::tuple<double, int, int>> shares;  // share, mode, motion
    for (int mode = 0; mode < 6; ++mode) {
        const Vec6 x = modes.eigenvectors().col(mode), energy = x.cwiseProduct(Vec6(M * x));
        for (int motion = 0; motion < 6; ++motion)
            shares.emplace_back(energy[motion], mode, motion);
    }
    std::sort(shares.begin(), shares.end(), std::greater<>());
    std::array<std::optional<double>, 6> periods;
    std::array<bool, 6> mode_given{}, motion_given{};
    for (const auto& [share, mode, motion] : shares) {
        const auto i = static_cast<std::size_t>(mode), j = static_cast<std::size_t>(motion);
        if (mode_given[i] || motion_given[j]) continue;
        mode_given[i] = motion_given[j] = true;
        // a mode without stiffness: rounding leaves about 1e-12 of the stiffest
        if (squares[mode] > 1e-9 * squares[5]) periods[j] = 2.0 * M_PI / std::sqrt(squares[mode]);
    }
    return periods;
}

}  // namespace hawser::master
