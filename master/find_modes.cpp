// `hawser modes`: natural modes of every line and of the platforms with their lines. One process.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "hulls.hpp"
#include "line_selection.hpp"
#include "modes_report.hpp"
#include "packing.hpp"
#include "static_start.hpp"

namespace hawser {

ModesReport find_modes(const Case& input, const ModesRequest& request) {
    using namespace master;
    ModesReport report;
    const std::vector<int> wanted = lines_called(request.lines, input);
    const auto describe = [&](const Status& s, const Poses& poses) {
        return failure_message(s, input, 0, poses);
    };
    const std::unique_ptr<RestingLines> lines = make_resting_lines(input);
    if (!input.platform) {
        lines_at(*lines, {}, input.analysis.statics.current, describe);
    } else {
        std::vector<Hull> hulls = hulls_of(input);
        Case at_rest = input;
        leave_out_initial(at_rest);
        StaticStart start = static_start(at_rest, hulls, *lines);
        report.warnings = std::move(start.notes);
        for (const Hull& hull : hulls) report.platforms.push_back(hull.name());
        report.coupled = std::move(start.modes);
        report.rest.assign(start.equilibrium.begin(),
                           start.equilibrium.begin() + static_cast<long>(hulls.size()));
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
