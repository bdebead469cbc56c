// Rank 0 finds what the static targets ask for, all ranks apply the same numbers.
#include "adjustment.hpp"
#include "complain.hpp"
#include "io/link.hpp"
#include "roles.hpp"
#include "static_targets.hpp"

namespace hawser {

ExitCode meet_targets(Case& input, std::vector<Adjustment>& found, const io::Link& link) {
    int code = 0;
    found.clear();
    if (link.rank() == 0) try {
            found = worker::find_adjustments(input);
        } catch (const RunError& error) {
            complain(error.what());
            code = static_cast<int>(error.code());
        }
    link.broadcast(code);
    if (code != 0) return static_cast<ExitCode>(code);
    // One number per line: where nothing is adjusted it is not looked at.
    std::vector<double> values(input.lines.size(), 0.0);
    for (const Adjustment& a : found) values[static_cast<std::size_t>(a.line)] = a.found;
    link.broadcast(values);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (input.lines[i].target.adjust != StaticTarget::Adjust::none)
            adjust(input.lines[i], input.environment, values[i]);
    return ExitCode::done;
}

}  // namespace hawser
