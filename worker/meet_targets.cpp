// Rank 0 finds what the static targets ask for, all ranks apply the same numbers.
#include "adjustment.hpp"
#include "io/link.hpp"
#include "roles.hpp"
#include "static_targets.hpp"

namespace hawser {

std::vector<Adjustment> meet_targets(Case& input, const io::Link& link) {
    std::vector<Adjustment> found;
    std::string why;
    int code = 0;
    if (link.rank() == 0) try {
            found = worker::find_adjustments(input);
        } catch (const RunError& error) {
            why = error.what();
            code = static_cast<int>(error.code());
        }
    link.broadcast(code);
    if (code != 0) throw RunError(static_cast<ExitCode>(code), why);
    // One number per line: where nothing is adjusted it is not looked at.
    std::vector<double> values(input.lines.size(), 0.0);
    for (const Adjustment& a : found) values[static_cast<std::size_t>(a.line)] = a.found;
    link.broadcast(values);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (input.lines[i].target.adjust != StaticTarget::Adjust::none)
            adjust(input, static_cast<int>(i), values[i]);
    return found;
}

}  // namespace hawser
