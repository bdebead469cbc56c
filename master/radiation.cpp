#include "radiation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "status.hpp"

namespace hawser::master {

Radiation radiation_at(const HydroData& data, double w) {
    std::vector<double> at = data.frequencies;
    std::vector<Mat6> A = data.added_mass, B = data.damping;
    if (data.added_mass_0 && w >= 0.0 && !at.empty()) {
        at.insert(at.begin(), 0.0);
        A.insert(A.begin(), *data.added_mass_0);
        B.insert(B.begin(), Mat6::Zero());
    }
    if (at.empty() || w < at.front() || w > at.back())
        throw RunError(
            ExitCode::input,
            at.empty()
                ? std::string("platform.hydrodynamics.added_mass: the database has no added mass")
                : fmt::format("platform.hydrodynamics.added_mass: expected a frequency inside the "
                              "database, {:.4g} to {:.4g} rad/s; got {:.4g} rad/s",
                              at.front(), at.back(), w));
    if (at.size() == 1) return {A[0], B[0], w};
    const auto above = std::clamp<std::ptrdiff_t>(
        std::upper_bound(at.begin(), at.end(), w) - at.begin(), 1, std::ssize(at) - 1);
    const auto j = static_cast<std::size_t>(above), i = j - 1;
    const double f = (w - at[i]) / (at[j] - at[i]);
    return {(1 - f) * A[i] + f * A[j], (1 - f) * B[i] + f * B[j], w};
}

Mat6 turned(const Mat6& A, const Mat3& R) {
    Mat6 T;
    for (int i : {0, 3})
        for (int j : {0, 3}) T.block<3, 3>(i, j) = R * A.block<3, 3>(i, j) * R.transpose();
    return T;
}

}  // namespace hawser::master
