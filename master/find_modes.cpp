// `hawser modes`: natural modes of every line and of the platform with its lines. One process.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "io/hydro_file.hpp"
#include "line_selection.hpp"
#include "modes_report.hpp"
#include "packing.hpp"
#include "static_start.hpp"

namespace hawser {

ModesReport find_modes(const Case& input, const ModesRequest& request) {
    using namespace master;
    ModesReport report;
    const std::vector<int> wanted = lines_called(request.lines, input);
    const auto describe = [&](const Status& s, const PlatformMotion& pose) {
        return failure_message(s, input, 0, pose);
    };
    const std::unique_ptr<RestingLines> lines = make_resting_lines(input);
    if (!input.platform) {
        lines_at(*lines, PlatformMotion{}, input.analysis.statics.current, describe);
    } else {
        std::optional<HydroData> hydro;
        if (const auto& database = input.platform->hydrodynamics.database)
            hydro = io::read_hydro(*database, input.environment);
        Hull hull(input, hydro ? &*hydro : nullptr);
        Case at_rest = input;
        leave_out_initial(*at_rest.platform);
        const StaticStart start = static_start(at_rest, hull, *lines);
        report.warnings = start.notes;
        report.platforms = {input.platform->name};
        report.coupled.assign(start.modes.begin(), start.modes.end());
    }
    std::vector<LineAtRest> rest = lines->at_rest();
    std::vector<int> tied;
    for (const std::vector<int>& bundle : bundles_of(input))
        if (bundle.size() > 1) tied.insert(tied.end(), bundle.begin(), bundle.end());
    std::sort(tied.begin(), tied.end());
    const int count = request.count > 0 ? request.count : input.analysis.modes;
    for (const int i : wanted) {
        if (std::binary_search(tied.begin(), tied.end(), i))
            report.warnings.push_back(
                fmt::format("{} is tied to another line: modes of such lines are not available in "
                            "this version",
                            input.lines[static_cast<std::size_t>(i)].name));
        else
            report.lines.push_back(
                {.line = i,
                 .modes = lines->modes(i, count),
                 .position = std::move(rest[static_cast<std::size_t>(i)].position),
                 .arc_length = std::move(rest[static_cast<std::size_t>(i)].arc_length)});
    }
    return report;
}

}  // namespace hawser
