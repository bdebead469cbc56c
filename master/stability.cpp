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
    const Mat6 K = hull.static_stiffness(hull.design(), no_mean_loads);
    const double z_G = hull.body().centre_of_gravity.z();
    return (K(3 + axis, 3 + axis) + hull.mass() * gravity * z_G) / buoyancy - z_G;
}

std::vector<Stability> stability_of(const std::vector<Hull>& hulls, double gravity,
                                    const Eigen::MatrixXd& K,
                                    const std::vector<StaticPlatform>& at_rest) {
    std::vector<Stability> out(hulls.size());
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        const double buoyancy = hulls[k].acting_buoyancy();
        out[k].hull_GM_roll = hull_GM(hulls[k], 0, gravity);
        out[k].hull_GM_pitch = hull_GM(hulls[k], 1, gravity);
        if (buoyancy <= 0.0) continue;
        out[k].GM_roll = K(row_of(k) + 3, row_of(k) + 3) / buoyancy;
        out[k].GM_pitch = K(row_of(k) + 4, row_of(k) + 4) / buoyancy;
    }
    const Eigen::VectorXd scale = scales_of(at_rest);
    const Eigen::MatrixXd scaled =
        scale.asDiagonal() * (0.5 * (K + K.transpose())) * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled);
    const double least = 1e-9 * modes.eigenvalues().cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < K.rows(); ++i) {
        Eigen::Index row = 0;
        modes.eigenvectors().col(i).cwiseAbs().maxCoeff(&row);
        Stability& its = out[static_cast<std::size_t>(row / 6)];
        const char* name = motion_names[static_cast<std::size_t>(row % 6)];
        if (modes.eigenvalues()[i] < -least)
            its.unstable.emplace_back(name);
        else if (modes.eigenvalues()[i] <= least)
            its.unheld.emplace_back(name);
    }
    return out;
}

std::vector<std::string> stability_warnings(const Stability& s, const std::string& name) {
    std::vector<std::string> out;
    if (!s.stable())
        out.push_back(fmt::format(
            "{}: the equilibrium is not stable in {}: the stiffness of platform and lines is "
            "negative there; a run leaves it once anything pushes that way, and stands there only "
            "while nothing does; look at the centre of gravity (GM of the hull alone: roll "
            "{:.2f} m, pitch {:.2f} m)",
            name, joined(s.unstable), s.hull_GM_roll, s.hull_GM_pitch));
    else if (s.hull_GM_roll < 0.0 || s.hull_GM_pitch < 0.0)
        out.push_back(fmt::format(
            "{}: GM of the hull alone is negative (roll {:.2f} m, pitch {:.2f} m): only the lines "
            "keep it upright",
            name, s.hull_GM_roll, s.hull_GM_pitch));
    return out;
}

}  // namespace hawser::master
