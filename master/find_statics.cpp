// `hawser statics`: the equilibrium that starts a run, looked at closely. One process.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "hulls.hpp"
#include "line_selection.hpp"
#include "offset_curve.hpp"
#include "paper_rate.hpp"
#include "stability.hpp"
#include "static_start.hpp"
#include "statics_report.hpp"

namespace hawser {

namespace {

PlatformAtRest found(const master::Hull& hull, std::size_t k, const master::StaticStart& start) {
    const auto which = static_cast<int>(k);
    PlatformAtRest p;
    p.name = hull.name();
    p.position = start.equilibrium[k];
    p.mass = hull.mass();
    p.mass_is_auto = hull.mass_is_auto();
    p.acting_buoyancy = hull.acting_buoyancy();
    p.vertical_line_load = start.vertical_line_load[k];
    p.line_load = master::total_wrench(start.lines, which);
    p.stiffness = start.stiffness.block<6, 6>(master::row_of(k), master::row_of(k));
    for (const LineLoad& line : start.lines.lines)
        if (const Mat6* part = line.stiffness_of(which, which)) p.line_stiffness += *part;
    p.stability = start.stability[k];
    for (std::size_t i = 0; i < 6; ++i) p.periods[i] = start.modes[6 * k + i].period();
    p.added_mass_frequency = hull.radiation().frequency;
    p.iterations = start.iterations;
    return p;
}

}  // namespace

Case without_lines(const Case& input, const std::string& glob) {
    const auto gone = [&](const Line& line) {
        return fnmatch(glob.c_str(), line.name.c_str(), 0) == 0;
    };
    if (std::none_of(input.lines.begin(), input.lines.end(), gone))
        throw RunError(ExitCode::input, fmt::format("--without: no line is called \"{}\"", glob));
    Case left = input;
    left.lines.clear();
    std::vector<int> place;  // of each line among those that are left
    for (const Line& line : input.lines) {
        place.push_back(gone(line) ? -1 : static_cast<int>(left.lines.size()));
        if (!gone(line)) left.lines.push_back(line);
    }
    for (Line& line : left.lines)
        for (LineConstraint& c : line.constraints) {
            if (c.other_line < 0) continue;
            const auto other = static_cast<std::size_t>(c.other_line);
            if (place[other] < 0)
                throw RunError(ExitCode::input,
                               fmt::format("--without: {} is tied to {} by {}", line.name,
                                           input.lines[other].name, c.name));
            c.other_line = place[other];
        }
    std::vector<Platform*> all;
    if (left.platform) all.push_back(&*left.platform);
    for (Platform& platform : left.further_platforms) all.push_back(&platform);
    if (std::all_of(all.begin(), all.end(), [](const Platform* p) { return p->mass.has_value(); }))
        return left;
    const StaticsReport whole = find_statics(input, {});
    for (std::size_t k = 0; k < all.size(); ++k) all[k]->mass = whole.platforms[k].mass;
    return left;
}

StaticsReport find_statics(const Case& input, const StaticsRequest& request) {
    using namespace master;
    StaticsReport report;
    if (!request.offsets.empty()) {
        if (input.lines.empty())
            throw RunError(ExitCode::input, "--offset: there are no lines in this case to pull");
        lines_called(request.lines, input);  // a wrong name at once
    }
    const auto describe = [&](const Status& s, const Poses& poses) {
        return failure_message(s, input, 0, poses);
    };
    const std::unique_ptr<RestingLines> lines = make_resting_lines(input);
    if (!input.platform) {
        if (!request.offsets.empty())
            throw RunError(ExitCode::input,
                           "--offset: there is no platform in this case to be moved");
        lines_at(*lines, {}, input.analysis.statics.current, describe);
        report.lines = lines->at_rest();
    } else {
        std::vector<Hull> hulls = hulls_of(input);
        Case at_rest = input;
        leave_out_initial(at_rest);
        StaticStart start = static_start(at_rest, hulls, *lines);
        for (std::size_t k = 0; k < hulls.size(); ++k)
            report.platforms.push_back(found(hulls[k], k, start));
        report.warnings = std::move(start.notes);
        report.stiffness = std::move(start.stiffness);
        report.lines = lines->at_rest();
        if (!request.offsets.empty())
            report.curve = offset_curve(input, request, hulls, *lines, describe);
    }
    return report;
}

}  // namespace hawser
