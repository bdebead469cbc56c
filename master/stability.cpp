#include "stability.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>

#include "motion_names.hpp"

namespace hawser::master {

namespace {

constexpr Statics no_mean_loads{.current = false, .wind_mean = false, .drift_mean = false};

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

}  // namespace

double hull_GM(const Hull& hull, int axis, double gravity) {
    const double buoyancy = hull.acting_buoyancy();
    if (buoyancy <= 0.0) return 0.0;
    const Mat6 K = hull.static_stiffness(PlatformMotion{}, no_mean_loads);
    const double z_G = hull.body().centre_of_gravity.z();
    return (K(3 + axis, 3 + axis) + hull.mass() * gravity * z_G) / buoyancy - z_G;
}

Stability stability_of(const Hull& hull, double gravity, const Mat6& K, double length) {
    Stability out;
    const double buoyancy = hull.acting_buoyancy();
    out.hull_GM_roll = hull_GM(hull, 0, gravity);
    out.hull_GM_pitch = hull_GM(hull, 1, gravity);
    if (buoyancy > 0.0) {
        out.GM_roll = K(3, 3) / buoyancy;
        out.GM_pitch = K(4, 4) / buoyancy;
    }
    Vec6 scale = Vec6::Ones();
    scale.tail<3>().setConstant(1.0 / length);
    const Mat6 scaled = scale.asDiagonal() * (0.5 * (K + K.transpose())) * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Mat6> modes(scaled);
    const double least = 1e-9 * modes.eigenvalues().cwiseAbs().maxCoeff();
    for (int i = 0; i < 6; ++i) {
        int motion = 0;
        modes.eigenvectors().col(i).cwiseAbs().maxCoeff(&motion);
        const char* name = motion_names[static_cast<std::size_t>(motion)];
        if (modes.eigenvalues()[i] < -least)
            out.unstable.emplace_back(name);
        else if (modes.eigenvalues()[i] <= least)
            out.unheld.emplace_back(name);
    }
    return out;
}

std::vector<std::string> stability_warnings(const Stability& s, const std::string& name) {
    std::vector<std::string> out;
    if (!s.stable())
        out.push_back(fmt::format(
            "{}: the equilibrium is not stable in {}: the stiffness of platform and lines is "
            "negative there, a run will leave it; look at the centre of gravity (GM of the hull "
            "alone: roll {:.2f} m, pitch {:.2f} m)",
            name, joined(s.unstable), s.hull_GM_roll, s.hull_GM_pitch));
    else if (s.hull_GM_roll < 0.0 || s.hull_GM_pitch < 0.0)
        out.push_back(fmt::format(
            "{}: GM of the hull alone is negative (roll {:.2f} m, pitch {:.2f} m): only the lines "
            "keep it upright",
            name, s.hull_GM_roll, s.hull_GM_pitch));
    return out;
}

}  // namespace hawser::master
