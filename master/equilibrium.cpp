#include "equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "motion_names.hpp"
#include "paper_rate.hpp"
#include "pose.hpp"

namespace hawser::master {

namespace {

/// Least-norm solution of K dX = r with rotations measured as lengths; what nothing holds stays.
struct NewtonStep {
    Vec6 dX;
    Vec6 unheld;  ///< part of r that no displacement can balance
};
NewtonStep newton_step(const Mat6& K, const Vec6& r, double length) {
    Vec6 scale = Vec6::Ones();
    scale.tail<3>().setConstant(1.0 / length);
    const Mat6 Ks = scale.asDiagonal() * K * scale.asDiagonal();
    const Vec6 rs = scale.cwiseProduct(r);
    Eigen::JacobiSVD<Mat6> solver(Ks, Eigen::ComputeFullU | Eigen::ComputeFullV);
    solver.setThreshold(1e-9);  // of the stiffest direction; rounding leaves about 1e-12
    const Vec6 x = solver.solve(rs);
    return {scale.cwiseProduct(x), (rs - Ks * x).cwiseQuotient(scale)};
}

/// Shortens a step to the limits.
Vec6 limited(const Vec6& dX, const NewtonLimits& limits) {
    const double longest = dX.head<3>().norm() / limits.longest_step;
    const double widest = dX.tail<3>().norm() / limits.widest_turn;
    return dX / std::max({1.0, longest, widest});
}

[[noreturn]] void fail(const StaticPlatform& platform, const Equilibrium& at, const Vec6& r,
                       const NewtonStep& step) {
    Vec6 relative = r.cwiseAbs();
    relative.tail<3>() /= platform.length;
    int worst = 0;
    relative.maxCoeff(&worst);
    const bool rotates = worst >= 3;
    const bool unheld = std::abs(step.unheld[worst]) > 0.5 * std::abs(r[worst]);
    const std::string cause =
        unheld ? fmt::format(
                     "nothing holds the platform in {} against a mean load; add lines or "
                     "stiffness, or leave the load out of analysis.statics.loads",
                     motion_names[static_cast<std::size_t>(worst)])
               : std::string(
                     "mean loads beyond what the lines can hold, a platform that does not "
                     "stand upright, or a mass that does not float");
    throw RunError(
        ExitCode::no_equilibrium,
        fmt::format("{}: no static equilibrium after {} iterations: {} is out of balance by {:.3g} "
                    "{} at surge {:.2f} m, sway {:.2f} m, heave {:.2f} m, roll {:.2f} deg, pitch "
                    "{:.2f} deg, yaw {:.2f} deg; likely cause: {}",
                    platform.name, at.iterations, motion_names[static_cast<std::size_t>(worst)],
                    r[worst], rotates ? "N.m" : "N", at.pose.position.x(), at.pose.position.y(),
                    at.pose.position.z(), at.pose.angles.x() * 180 / M_PI,
                    at.pose.angles.y() * 180 / M_PI, at.pose.angles.z() * 180 / M_PI, cause));
}

}  // namespace

Equilibrium find_equilibrium(const StaticPlatform& platform, Lines& lines,
                             const PlatformMotion& start, bool current, const NewtonLimits& limits,
                             const Describe& describe) {
    constexpr int most_halvings = 6;
    Equilibrium at{.pose = start, .lines = {}};
    at.lines = lines_at(lines, Poses{start}, current, describe);
    for (;; ++at.iterations) {
        const Mat6 free =
            any(platform.held) ? free_projection(at.pose.angles, platform.held) : platform.free;
        const auto moved_by = [&](const Vec6& step_taken) {
            return with_held(displaced(at.pose, step_taken), start, platform.held);
        };
        const Vec6 r = free * (platform.load(at.pose) + total_wrench(at.lines));
        Mat6 K = platform.stiffness(at.pose);
        for (const LineLoad& line : at.lines.lines) K += line.stiffness;
        K = free * K * free;
        const NewtonStep step = newton_step(K, r, platform.length);
        at.force = r.head<3>().norm();
        at.moment = r.tail<3>().norm();
        const bool balanced = at.force <= limits.tolerance * platform.force &&
                              at.moment <= limits.tolerance * platform.force * platform.length;
        const double correction = std::max(step.dX.head<3>().norm(), step.dX.tail<3>().norm());
        if (balanced && correction <= limits.tolerance) return at;
        const bool stuck = !balanced && correction <= 1e-3 * limits.tolerance;
        if (at.iterations == limits.max_iterations || stuck || !step.dX.allFinite())
            fail(platform, at, r, step);

        Vec6 dX = limited(step.dX, limits);
        PlatformMotion moved = moved_by(dX);
        const Reply* reply = &ask_equilibrium(lines, Poses{moved}, current);
        for (int half = 0; !reply->status.ok() && half < most_halvings; ++half) {
            dX /= 2;
            moved = moved_by(dX);
            reply = &ask_equilibrium(lines, Poses{moved}, current);
        }
        if (!reply->status.ok())
            throw RunError(ExitCode::no_equilibrium, describe(reply->status, Poses{moved}));
        at.pose = moved;
        at.lines = *reply;
    }
}

const Reply& ask_equilibrium(Lines& lines, const Poses& poses, bool current) {
    Order order;
    order.ask = Ask::equilibrium;
    order.current = current;
    order.from = order.to = poses;
    lines.send(order);
    return lines.receive();
}

Reply lines_at(Lines& lines, const Poses& poses, bool current, const Describe& describe) {
    const Reply& reply = ask_equilibrium(lines, poses, current);
    if (!reply.status.ok()) throw RunError(ExitCode::no_equilibrium, describe(reply.status, poses));
    return reply;
}

}  // namespace hawser::master
