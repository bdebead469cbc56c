#include "offset_curve.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "line_selection.hpp"
#include "pose.hpp"
#include "static_start.hpp"

namespace hawser::master {

namespace {

constexpr double alike = 1e-6;  // of symmetric lines the first in line order is named
constexpr double stride = 5.0;  // on the way to an offset that is not reached at once [m]
constexpr Statics still_water{.current = false, .wind_mean = false, .drift_mean = false};

using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

/// The curve's own axes: the offset, and the motions that are free beside it.
struct Axes {
    Vec6 along = Vec6::Zero(), across = Vec6::Zero();
    Columns free;

    Axes(double heading, const FreeMotions& f) : free(6, 0) {
        along.head<2>() << std::cos(heading), std::sin(heading);
        across.head<2>() << -along[1], along[0];
        if (f.transverse) add(across);
        for (const auto& [is_free, motion] :
             {std::pair(f.heave, 2), {f.roll, 3}, {f.pitch, 4}, {f.yaw, 5}})
            if (is_free) add(Vec6::Unit(motion));
    }

 private:
    void add(const Vec6& motion) {
        free.conservativeResize(6, free.cols() + 1);
        free.rightCols<1>() = motion;
    }
};

/// How the platform goes on along the curve per metre of offset.
Vec6 tangent(const Axes& axes, const Mat6& K, double length) {
    if (axes.free.cols() == 0) return axes.along;
    Vec6 scale = Vec6::Ones();  // rotations as lengths
    scale.tail<3>().setConstant(1.0 / length);
    const Columns F = scale.asDiagonal() * axes.free;
    const Eigen::MatrixXd Kq = F.transpose() * K * F;
    const Eigen::VectorXd q =
        Kq.completeOrthogonalDecomposition().solve(F.transpose() * K * axes.along);
    return axes.along - F * q;
}

OffsetPoint point_of(const OffsetCurve& curve, const Axes& axes, double offset,
                     const Equilibrium& at, const Vec6& moves) {
    OffsetPoint point{.offset = offset, .pose = at.pose};
    point.across = axes.across.head<3>().dot(at.pose.position);
    for (const int i : curve.lines) {
        const LineLoad& line = at.lines.lines[static_cast<std::size_t>(i)];
        point.restoring -= line.wrench.dot(axes.along);
        point.transverse += line.wrench.dot(axes.across);
        point.yaw_moment += line.wrench[5];
        point.slope += axes.along.dot(line.stiffness * moves);
        if (point.least_line < 0 || line.end_tension < (1.0 - alike) * point.least)
            point.least = line.end_tension, point.least_line = i;
        if (point.greatest_line < 0 || line.end_tension > (1.0 + alike) * point.greatest)
            point.greatest = line.end_tension, point.greatest_line = i;
    }
    return point;
}

OffsetCurve empty_curve(const Case& input, const StaticsRequest& request) {
    OffsetCurve curve;
    curve.heading = request.heading;
    curve.lines = lines_called(request.lines, input);
    const bool all = curve.lines.size() == input.lines.size();
    curve.free = request.free.value_or(FreeMotions{.heave = all});
    const Held held = input.platform->held();
    curve.free.heave = curve.free.heave && !held[2];
    curve.free.roll = curve.free.roll && !held[3];
    curve.free.pitch = curve.free.pitch && !held[4];
    curve.free.yaw = curve.free.yaw && !held[5];
    return curve;
}

}  // namespace

OffsetCurve offset_curve(const Case& input, const StaticsRequest& request, const Hull& hull,
                         Lines& lines, const Describe& describe) {
    OffsetCurve curve = empty_curve(input, request);
    const Axes axes(curve.heading, curve.free);
    StaticPlatform body = platform_at_rest(input, hull, still_water);
    body.free = axes.free * axes.free.transpose();
    body.held = {};
    const NewtonLimits limits{.tolerance = input.analysis.statics.tolerance,
                              .max_iterations = input.analysis.statics.max_iterations};

    Equilibrium at;  // the last point; before the first one the design position
    Vec6 moves = axes.along;
    double reached = 0.0;
    const auto go_to = [&](double offset) {
        const PlatformMotion start = displaced(at.pose, (offset - reached) * moves);
        at = find_equilibrium(body, lines, start, false, limits, describe);
        Mat6 K = body.stiffness(at.pose);
        for (const LineLoad& line : at.lines.lines) K += line.stiffness;
        moves = tangent(axes, K, body.length);
        reached = offset;
    };
    for (const double offset : request.offsets) {
        try {
            try {
                go_to(offset);
            } catch (const RunError&) {  // by and by
                const int n = static_cast<int>(std::ceil(std::abs(offset - reached) / stride));
                const double from = reached;
                for (int i = 1; i <= n; ++i) go_to(from + (offset - from) * i / n);
                if (n == 0) throw;
            }
        } catch (const RunError& error) {
            curve.ends = fmt::format("at an offset of {:g} m towards {:g} deg: {}", offset,
                                     request.heading * 180.0 / M_PI, error.what());
            if (curve.points.empty()) throw RunError(error.code(), curve.ends);
            return curve;
        }
        curve.points.push_back(point_of(curve, axes, offset, at, moves));
    }
    return curve;
}

}  // namespace hawser::master
