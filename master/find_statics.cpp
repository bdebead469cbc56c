// `hawser statics`: the equilibrium that starts a run, looked at closely. One process.
#include <memory>
#include <optional>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "io/hydro_file.hpp"
#include "offset_curve.hpp"
#include "paper_rate.hpp"
#include "stability.hpp"
#include "static_start.hpp"
#include "statics_report.hpp"

namespace hawser {

StaticsReport find_statics(const Case& input, const StaticsRequest& request) {
    using namespace master;
    StaticsReport report;
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
            hydro = io::read_hydro(*database, input.environment.water);
        Hull hull(input, hydro ? &*hydro : nullptr);
        Case at_rest = input;
        at_rest.platform->initial = PlatformMotion{};
        const StaticStart start = static_start(at_rest, hull, *lines);
        report.warnings = start.notes;
        PlatformAtRest& p = report.platform.emplace();
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
