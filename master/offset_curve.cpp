#include "offset_curve.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "line_selection.hpp"
#include "packing.hpp"
#include "pose.hpp"
#include "static_start.hpp"

namespace hawser::master {

namespace {

constexpr double alike = 1e-6;  // of symmetric lines the first in line order is named
constexpr double stride = 5.0;  // on the way to an offset that is not reached at once [m]
constexpr Statics still_water{.current = false, .wind_mean = false, .drift_mean = false};

/// The curve's own axes, among the motions of all platforms: the offset, and what is free beside
/// it.
struct Axes {
    Vec6 along = Vec6::Zero(), across = Vec6::Zero();
    Eigen::VectorXd offset;  ///< `along` of the platform that is moved
    Eigen::MatrixXd own;     ///< free motions of that platform
    Eigen::MatrixXd free;    ///< of all

    /// @param k       platform that is moved
    /// @param others  do the other platforms settle?
    Axes(double heading, const FreeMotions& f, std::size_t k, const std::vector<Hull>& hulls,
         bool others) {
        along.head<2>() << std::cos(heading), std::sin(heading);
        across.head<2>() << -along[1], along[0];
        std::vector<Vec6> motions;
        if (f.transverse) motions.push_back(across);
        for (const auto& [is_free, motion] :
             {std::pair(f.heave, 2), {f.roll, 3}, {f.pitch, 4}, {f.yaw, 5}})
            if (is_free) motions.push_back(Vec6::Unit(motion));
        own.resize(6, static_cast<Eigen::Index>(motions.size()));
        for (std::size_t i = 0; i < motions.size(); ++i)
            own.col(static_cast<Eigen::Index>(i)) = motions[i];
        const Eigen::Index rows = row_of(hulls.size());
        offset = Eigen::VectorXd::Zero(rows);
        offset.segment<6>(row_of(k)) = along;
        free = Eigen::MatrixXd::Zero(rows, own.cols());
        free.middleRows<6>(row_of(k)) = own;
        for (std::size_t j = 0; others && j < hulls.size(); ++j)
            for (std::size_t i = 0; j != k && i < 6; ++i) {
                if (hulls[j].held()[i]) continue;
                free.conservativeResize(rows, free.cols() + 1);
                free.rightCols<1>() =
                    Eigen::VectorXd::Unit(rows, row_of(j) + static_cast<Eigen::Index>(i));
            }
    }
};

/// How the platforms go on along the curve per metre of offset.
Eigen::VectorXd tangent(const Axes& axes, const Eigen::MatrixXd& K, const Eigen::VectorXd& scale) {
    if (axes.free.cols() == 0) return axes.offset;
    const Eigen::MatrixXd F = scale.asDiagonal() * axes.free;
    const Eigen::MatrixXd Kq = F.transpose() * K * F;
    const Eigen::VectorXd q =
        Kq.completeOrthogonalDecomposition().solve(F.transpose() * K * axes.offset);
    return axes.offset - F * q;
}

/// Force of a line on the platform that is moved, and how it falls with the motions of all.
struct Pull {
    Vec6 load = Vec6::Zero(), falls = Vec6::Zero();
};
Pull pull_of(const LineLoad& line, int k, const Eigen::VectorXd& moves) {
    Pull out;
    if (const Vec6* wrench = line.on(k)) out.load = *wrench;
    for (int j = 0; 6 * j < moves.size(); ++j)
        if (const Mat6* S = line.stiffness_of(k, j)) out.falls += *S * moves.segment<6>(6 * j);
    return out;
}

OffsetPoint point_of(const OffsetCurve& curve, const Case& input, const Axes& axes, double offset,
                     const JointEquilibrium& at, const Eigen::VectorXd& moves) {
    OffsetPoint point{.offset = offset, .pose = at.pose[static_cast<std::size_t>(curve.platform)]};
    point.pose.position -= input.design_of(curve.platform).position;
    point.across = axes.across.head<3>().dot(point.pose.position);
    for (const int i : curve.lines) {
        const LineLoad& line = at.lines.lines[static_cast<std::size_t>(i)];
        if (line.on(curve.platform) == nullptr) continue;
        const Pull pull = pull_of(line, curve.platform, moves);
        point.restoring -= pull.load.dot(axes.along);
        point.transverse += pull.load.dot(axes.across);
        point.yaw_moment += pull.load[5];
        point.slope += axes.along.dot(pull.falls);
        if (point.least_line < 0 || line.end_tension < (1.0 - alike) * point.least)
            point.least = line.end_tension, point.least_line = i;
        if (point.greatest_line < 0 || line.end_tension > (1.0 + alike) * point.greatest)
            point.greatest = line.end_tension, point.greatest_line = i;
    }
    return point;
}

int platform_called(const std::string& name, const Case& input) {
    if (name.empty()) return 0;
    std::string names;
    for (int k = 0; k < input.platform_count(); ++k) {
        if (input.platform_at(k).name == name) return k;
        names += (k > 0 ? ", " : "") + input.platform_at(k).name;
    }
    throw RunError(ExitCode::input,
                   fmt::format("--platform: no platform is called \"{}\", but {}", name, names));
}

OffsetCurve empty_curve(const Case& input, const StaticsRequest& request) {
    OffsetCurve curve;
    curve.platform = platform_called(request.platform, input);
    curve.heading = request.heading;
    curve.lines = lines_called(request.lines, input);
    const std::vector<Touched> touched = touched_platforms(input);
    if (std::none_of(curve.lines.begin(), curve.lines.end(), [&](int i) {
            const Touched& its = touched[static_cast<std::size_t>(i)];
            return its.first == curve.platform || its.second == curve.platform;
        }))
        throw RunError(ExitCode::input,
                       fmt::format("--lines: none called \"{}\" touches {}: name another line, or "
                                   "the platform with --platform",
                                   request.lines, input.platform_at(curve.platform).name));
    const bool all = curve.lines.size() == input.lines.size();
    curve.free = request.free.value_or(FreeMotions{.heave = all});
    const Held held = input.platform_at(curve.platform).held();
    curve.free.heave = curve.free.heave && !held[2];
    curve.free.roll = curve.free.roll && !held[3];
    curve.free.pitch = curve.free.pitch && !held[4];
    curve.free.yaw = curve.free.yaw && !held[5];
    return curve;
}

}  // namespace

OffsetCurve offset_curve(const Case& input, const StaticsRequest& request,
                         const std::vector<Hull>& hulls, Lines& lines, const Describe& describe) {
    OffsetCurve curve = empty_curve(input, request);
    const auto k = static_cast<std::size_t>(curve.platform);
    const bool others = curve.lines.size() == input.lines.size();
    const Axes axes(curve.heading, curve.free, k, hulls, others);
    std::vector<StaticPlatform> bodies = platforms_at_rest(input, hulls, still_water);
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(axes.offset.size());  // rotations as lengths
    Poses design = designs_of(input);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
        scale.segment<3>(row_of(j) + 3).setConstant(1.0 / bodies[j].length);
        if (j == k) {
            bodies[j].free = axes.own * axes.own.transpose();
            bodies[j].held = {};
        } else {
            if (!others) bodies[j].free.setZero();
            if (!others) bodies[j].held = {};
            design[j] = with_held(design[j], hulls[j].held_at(0.0).motion, hulls[j].held());
        }
    }
    const NewtonLimits limits{.tolerance = input.analysis.statics.tolerance,
                              .max_iterations = input.analysis.statics.max_iterations};

    JointEquilibrium at{.pose = design, .lines = {}};  // the last point
    Eigen::VectorXd moves = axes.offset;
    double reached = 0.0;
    const auto go_to = [&](double offset) {
        Poses start = at.pose;
        for (std::size_t j = 0; j < bodies.size(); ++j)
            start[j] = displaced(at.pose[j], (offset - reached) * moves.segment<6>(row_of(j)));
        at = find_joint_equilibrium(bodies, lines, start, false, limits, describe);
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(moves.size(), moves.size());
        for (std::size_t j = 0; j < bodies.size(); ++j)
            K.block<6, 6>(row_of(j), row_of(j)) = bodies[j].stiffness(at.pose[j]);
        add_lines_stiffness(at.lines, K);
        moves = tangent(axes, K, scale);
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
        curve.points.push_back(point_of(curve, input, axes, offset, at, moves));
    }
    return curve;
}

}  // namespace hawser::master
