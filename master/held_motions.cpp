#include "held_motions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace hawser::master {

namespace {
using SomeColumns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;
using SomeMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
using SomeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

int number_free(const Held& held) {
    int n = 0;
    for (const bool h : held) n += h ? 0 : 1;
    return n;
}

/// Columns of T that move the free motions.
SomeColumns free_columns(const Mat6& T, const Held& held) {
    SomeColumns columns(6, number_free(held));
    int n = 0;
    for (int i = 0; i < 6; ++i)
        if (!held[static_cast<std::size_t>(i)]) columns.col(n++) = T.col(i);
    return columns;
}
}  // namespace

Mat6 motion_matrix(const Vec3& angles) {
    Mat6 T = Mat6::Identity();
    T.block<3, 3>(3, 3) = angular_velocity_matrix(angles);
    return T;
}

// K:20
HeldSolution solve_held(const Mat6& M, const Vec6& F, const PlatformMotion& m, const Held& held,
                        const Vec6& given) {
    HeldSolution out;
    const Mat6 T = motion_matrix(m.angles);
    for (int i = 0; i < 6; ++i)
        if (held[static_cast<std::size_t>(i)]) out.motions[i] = given[i];
    Vec6 b = Vec6::Zero();
    b.tail<3>() = angular_velocity_matrix_rate(m.angles, m.angle_rates) * m.angle_rates;
    const SomeColumns free = free_columns(T, held);
    const Vec6 led = T * out.motions + b;
    if (free.cols() > 0) {
        const SomeMatrix mass = free.transpose() * M * free;
        const SomeVector y = mass.partialPivLu().solve(free.transpose() * (F - M * led));
        int n = 0;
        for (int i = 0; i < 6; ++i)
            if (!held[static_cast<std::size_t>(i)]) out.motions[i] = y[n++];
    }
    out.acceleration = T * out.motions + b;
    Vec6 L = T.transpose() * (M * out.acceleration - F);
    for (int i = 0; i < 6; ++i)
        if (!held[static_cast<std::size_t>(i)]) L[i] = 0.0;
    out.holding = L;
    out.holding.tail<3>() = T.block<3, 3>(3, 3).transpose().partialPivLu().solve(Vec3(L.tail<3>()));
    return out;
}

Mat6 free_projection(const Vec3& angles, const Held& held) {
    const SomeColumns free = free_columns(motion_matrix(angles), held);
    if (free.cols() == 0) return Mat6::Zero();
    const SomeMatrix gram = free.transpose() * free;
    return free * gram.llt().solve(free.transpose());
}

PlatformMotion with_held(PlatformMotion pose, const PlatformMotion& place, const Held& held) {
    for (std::size_t i = 0; i < 6; ++i) {
        if (!held[i]) continue;
        const auto k = static_cast<Eigen::Index>(i % 3);
        if (i < 3) {
            pose.position[k] = place.position[k];
            pose.velocity[k] = place.velocity[k];
        } else {
            pose.angles[k] = place.angles[k];
            pose.angle_rates[k] = place.angle_rates[k];
        }
    }
    return pose;
}

}  // namespace hawser::master
