// `hawser statics`: the equilibrium that starts a run, looked at closely. One process.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "io/hydro_file.hpp"
#include "line_selection.hpp"
#include "offset_curve.hpp"
#include "paper_rate.hpp"
#include "stability.hpp"
#include "static_start.hpp"
#include "statics_report.hpp"

namespace hawser {

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
    if (left.platform && !left.platform->mass)
        left.platform->mass = find_statics(input, {}).platforms.front().mass;
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
    const auto describe = [&](const Status& s, const PlatformMotion& pose) {
        return failure_message(s, input, 0, pose);
    };
    const std::unique_ptr<RestingLines> lines = make_resting_lines(input);
    if (!input.platform) {
        if (!request.offsets.empty())
            throw RunError(ExitCode::input,
                           "--offset: there is no platform in this case to be moved");
        lines_at(*lines, PlatformMotion{}, input.analysis.statics.current, describe);
        report.lines = lines->at_rest();
    } else {
        std::optional<HydroData> hydro;
        if (const auto& database = input.platform->hydrodynamics.database)
            hydro = io::read_hydro(*database, input.environment);
        Hull hull(input, hydro ? &*hydro : nullptr);
        Case at_rest = input;
        leave_out_initial(*at_rest.platform);
        const StaticStart start = static_start(at_rest, hull, *lines);
        report.warnings = start.notes;
        PlatformAtRest& p = report.platforms.emplace_back();
        p.name = input.platform->name;
        p.position = start.equilibrium;
        p.mass = hull.mass();
        p.mass_is_auto = hull.mass_is_auto();
        p.acting_buoyancy = hull.acting_buoyancy();
        p.vertical_line_load = start.vertical_line_load;
        p.line_load = total_wrench(start.lines);
        p.stiffness = start.stiffness;
        for (const LineLoad& line : start.lines.lines) p.line_stiffness += line.stiffness;
        p.stability = start.stability;
        for (std::size_t i = 0; i < 6; ++i) p.periods[i] = start.modes[i].period();
        p.added_mass_frequency = hull.radiation().frequency;
        p.iterations = start.iterations;
        report.lines = lines->at_rest();
        if (!request.offsets.empty())
            report.curve = offset_curve(input, request, hull, *lines, describe);
    }
    return report;
}

}  // namespace hawser
