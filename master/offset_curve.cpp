#include "offset_curve.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <cmath>

#include "equilibrium.hpp"

namespace hawser::master {

namespace {
constexpr double alike = 1e-6;  // of symmetric lines the first in line order is named
}

OffsetCurve offset_curve(const Case& input, const StaticsRequest& request, Lines& lines,
                         const Describe& describe) {
    OffsetCurve curve;
    curve.heading = request.heading;
    for (int i = 0; i < static_cast<int>(input.lines.size()); ++i)
        if (fnmatch(request.lines.c_str(), input.lines[static_cast<std::size_t>(i)].name.c_str(),
                    0) == 0)
            curve.lines.push_back(i);
    if (curve.lines.empty())
        throw RunError(ExitCode::input,
                       fmt::format("no line is called \"{}\"; the first is \"{}\"", request.lines,
                                   input.lines.empty() ? "" : input.lines.front().name));
    Vec6 along = Vec6::Zero();
    along.head<3>() << std::cos(request.heading), std::sin(request.heading), 0.0;
    const Vec3 across(-along[1], along[0], 0.0);
    for (const double offset : request.offsets) {
        PlatformMotion pose;
        pose.position = offset * along.head<3>();
        const Reply reply = lines_at(lines, pose, false, describe);
        OffsetPoint point{.offset = offset};
        for (const int i : curve.lines) {
            const LineLoad& line = reply.lines[static_cast<std::size_t>(i)];
            point.restoring -= line.wrench.dot(along);
            point.transverse += line.wrench.head<3>().dot(across);
            point.yaw_moment += line.wrench[5];
            point.slope += along.dot(line.stiffness * along);
            if (point.least_line < 0 || line.end_tension < (1.0 - alike) * point.least)
                point.least = line.end_tension, point.least_line = i;
            if (point.greatest_line < 0 || line.end_tension > (1.0 + alike) * point.greatest)
                point.greatest = line.end_tension, point.greatest_line = i;
        }
        curve.points.push_back(point);
    }
    return curve;
}

}  // namespace hawser::master
