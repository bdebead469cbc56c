#include "joint_equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion_names.hpp"
#include "paper_rate.hpp"
#include "pose.hpp"

namespace hawser::master {

namespace {

/// A platform that is led may weigh nothing.
double force_of(const StaticPlatform& platform) {
    return platform.force > 0.0 ? platform.force : 1.0;
}

/// Least-norm solution of K dX = r in the scaled coordinates; what nothing holds stays.
struct NewtonStep {
    Eigen::VectorXd dX, unheld;  ///< unheld: part of r that no displacement can balance
};
NewtonStep newton_step(const Eigen::MatrixXd& K, const Eigen::VectorXd& r,
                       const Eigen::VectorXd& scale) {
    const Eigen::MatrixXd Ks = scale.asDiagonal() * K * scale.asDiagonal();
    const Eigen::VectorXd rs = scale.cwiseProduct(r);
    Eigen::JacobiSVD<Eigen::MatrixXd> solver(Ks, Eigen::ComputeFullU | Eigen::ComputeFullV);
    solver.setThreshold(1e-9);  // of the stiffest direction; rounding leaves about 1e-12
    const Eigen::VectorXd x = solver.solve(rs);
    return {scale.cwiseProduct(x), (rs - Ks * x).cwiseQuotient(scale)};
}

/// All of a step is shortened alike, to the limits of the platform that would go furthest.
double part_within(const Eigen::VectorXd& dX, const NewtonLimits& limits) {
    double excess = 1.0;
    for (Eigen::Index row = 0; row < dX.size(); row += 6)
        excess = std::max({excess, dX.segment<3>(row).norm() / limits.longest_step,
                           dX.segment<3>(row + 3).norm() / limits.widest_turn});
    return 1.0 / excess;
}

double longest(const Eigen::VectorXd& dX) {
    double most = 0.0;
    for (Eigen::Index row = 0; row < dX.size(); row += 3)
        most = std::max(most, dX.segment<3>(row).norm());
    return most;
}

/// @param start  where the motions that are held stay
Poses displaced_all(const std::vector<StaticPlatform>& platforms, const Poses& poses,
                    const Eigen::VectorXd& dX, const Poses& start) {
    Poses out = poses;
    for (std::size_t k = 0; k < platforms.size(); ++k)
        out[k] = with_held(displaced(poses[k], Vec6(dX.segment<6>(row_of(k)))), start[k],
                           platforms[k].held);
    return out;
}

bool balanced(const std::vector<StaticPlatform>& platforms, const Eigen::VectorXd& r,
              double tolerance) {
    for (std::size_t k = 0; k < platforms.size(); ++k) {
        const double force = tolerance * platforms[k].force;
        if (r.segment<3>(row_of(k)).norm() > force) return false;
        if (r.segment<3>(row_of(k) + 3).norm() > force * platforms[k].length) return false;
    }
    return true;
}

[[noreturn]] void fail(const std::vector<StaticPlatform>& platforms, const JointEquilibrium& at,
                       const Eigen::VectorXd& r, const NewtonStep& step,
                       const Eigen::VectorXd& scale) {
    Eigen::VectorXd relative = r.cwiseProduct(scale).cwiseAbs();
    for (std::size_t k = 0; k < platforms.size(); ++k)  // as parts of each platform's own loads
        relative.segment<6>(row_of(k)) /= std::sqrt(force_of(platforms[k]));
    Eigen::Index worst = 0;
    relative.maxCoeff(&worst);
    const auto k = static_cast<std::size_t>(worst / 6);
    const auto motion = static_cast<std::size_t>(worst % 6);
    const bool unheld = std::abs(step.unheld[worst]) > 0.5 * std::abs(r[worst]);
    const std::string cause =
        unheld ? fmt::format(
                     "nothing holds it in {} against a mean load, neither a line to the "
                     "ground nor another platform",
                     motion_names[motion])
               : std::string(
                     "mean loads beyond what the lines can hold, a platform that does not "
                     "stand upright, or a mass that does not float");
    const Vec3& x = at.pose[k].position;
    throw RunError(
        ExitCode::no_equilibrium,
        fmt::format("{}: no static equilibrium of the {} platforms after {} iterations: {} is out "
                    "of balance by {:.3g} {} at x {:.2f} m, y {:.2f} m, z {:.2f} m; likely "
                    "cause: {}",
                    platforms[k].name, platforms.size(), at.iterations, motion_names[motion],
                    r[worst], motion < 3 ? "N" : "N.m", x.x(), x.y(), x.z(), cause));
}

}  // namespace

void add_lines_stiffness(const Reply& lines, Eigen::MatrixXd& K) {
    const auto platforms = static_cast<std::size_t>(K.rows() / 6);
    for (const LineLoad& line : lines.lines)
        for (std::size_t i = 0; i < platforms; ++i)
            for (std::size_t j = 0; j < platforms; ++j)
                if (const Mat6* part = line.stiffness_of(static_cast<int>(i), static_cast<int>(j)))
                    K.block<6, 6>(row_of(i), row_of(j)) += *part;
}

Eigen::VectorXd scales_of(const std::vector<StaticPlatform>& platforms) {
    Eigen::VectorXd scale(row_of(platforms.size()));
    for (std::size_t k = 0; k < platforms.size(); ++k) {
        const double one = 1.0 / std::sqrt(force_of(platforms[k]));
        scale.segment<3>(row_of(k)).setConstant(one);
        scale.segment<3>(row_of(k) + 3).setConstant(one / platforms[k].length);
    }
    return scale;
}

Eigen::MatrixXd free_projection(const std::vector<StaticPlatform>& platforms, const Poses& poses) {
    const Eigen::Index rows = row_of(platforms.size());
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(rows, rows);
    for (std::size_t k = 0; k < platforms.size(); ++k)
        free.block<6, 6>(row_of(k), row_of(k)) =
            any(platforms[k].held) ? free_projection(poses[k].angles, platforms[k].held)
                                   : platforms[k].free;
    return free;
}

JointEquilibrium find_joint_equilibrium(const std::vector<StaticPlatform>& platforms, Lines& lines,
                                        const Poses& start, bool current,
                                        const NewtonLimits& limits, const Describe& describe) {
    constexpr int most_halvings = 6;
    const std::size_t count = platforms.size();
    if (count == 1) {
        Equilibrium one =
            find_equilibrium(platforms.front(), lines, start[0], current, limits, describe);
        return {.pose = {one.pose}, .lines = std::move(one.lines), .iterations = one.iterations};
    }
    const Eigen::VectorXd scale = scales_of(platforms);
    JointEquilibrium at{.pose = start, .lines = lines_at(lines, start, current, describe)};
    for (;; ++at.iterations) {
        Eigen::VectorXd r(row_of(count));
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(row_of(count), row_of(count));
        add_lines_stiffness(at.lines, K);
        for (std::size_t k = 0; k < count; ++k) {
            r.segment<6>(row_of(k)) =
                platforms[k].load(at.pose[k]) + total_wrench(at.lines, static_cast<int>(k));
            K.block<6, 6>(row_of(k), row_of(k)) += platforms[k].stiffness(at.pose[k]);
        }
        const Eigen::MatrixXd free = free_projection(platforms, at.pose);
        r = free * r;
        K = free * K * free;
        const NewtonStep step = newton_step(K, r, scale);
        const bool rests = balanced(platforms, r, limits.tolerance);
        const double correction = longest(step.dX);
        if (rests && correction <= limits.tolerance) return at;
        const bool stuck = !rests && correction <= 1e-3 * limits.tolerance;
        if (at.iterations == limits.max_iterations || stuck || !step.dX.allFinite())
            fail(platforms, at, r, step, scale);

        Eigen::VectorXd dX = part_within(step.dX, limits) * step.dX;
        Poses moved = displaced_all(platforms, at.pose, dX, start);
        const Reply* reply = &ask_equilibrium(lines, moved, current);
        for (int half = 0; !reply->status.ok() && half < most_halvings; ++half) {
            dX /= 2;
            moved = displaced_all(platforms, at.pose, dX, start);
            reply = &ask_equilibrium(lines, moved, current);
        }
        if (!reply->status.ok())
            throw RunError(ExitCode::no_equilibrium, describe(reply->status, moved));
        at.pose = moved;
        at.lines = *reply;
    }
}

}  // namespace hawser::master
