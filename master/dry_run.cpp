// What a run would take, without running it: who computes which lines, memory, size of the output.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>

#include "io/result_fields.hpp"
#include "line_mesh.hpp"
#include "packing.hpp"
#include "roles.hpp"
#include "shares.hpp"

namespace hawser {

namespace {

/// Memory of this process that is in use (Linux).
double resident_megabytes() {
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

std::string megabytes(double bytes) {
    return bytes < 1e6 ? fmt::format("{:.1f} kB", bytes / 1e3)
                       : fmt::format("{:.1f} MB", bytes / 1e6);
}

/// Names of lines, shortened where a rank has many.
std::string names_of(const Case& input, const std::vector<int>& lines) {
    constexpr std::size_t shown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(lines.size(), shown); ++i)
        text += (i > 0 ? " " : "") + input.lines[static_cast<std::size_t>(lines[i])].name;
    if (lines.size() > shown) text += fmt::format(" and {} more", lines.size() - shown);
    return text;
}

std::string steps_of_a_pass(double h, double H) {
    const int n = static_cast<int>(std::ceil(H / h - 1e-9));
    return fmt::format("{} of {:.5g} s", n, H / n);
}

/// Steps of the dynamic lines in the passes of a platform step, by families of the same step; of
/// lines tied to each other the shortest.
std::string line_steps(const Case& input) {
    const Dynamics& dynamics = input.analysis.dynamics;
    std::map<double, std::string, std::greater<>> families;  // by step
    bool still = false;
    for (const std::vector<int>& bundle : bundles_of(input)) {
        double h = dynamics.line_step;
        for (const int i : bundle)
            h = std::min(h, input.lines[static_cast<std::size_t>(i)].time_step.value_or(h));
        for (const int i : bundle) {
            const Line& line = input.lines[static_cast<std::size_t>(i)];
            if (line.model.value_or(dynamics.line_model) != LineModel::dynamic) {
                still = true;
                continue;
            }
            std::string& names = families[h];
            if (!names.ends_with(line.family))  // lines of a family follow each other
                names += (names.empty() ? "" : ", ") + line.family;
        }
    }
    const double D = dynamics.platform_step;
    std::string text;
    for (const auto& [h, names] : families) {
        text += "\nsteps of a line";
        if (families.size() > 1 || still) text += " (" + names + ")";
        text += input.platform ? fmt::format(" in a pass: {} and {}", steps_of_a_pass(h, D / 2),
                                             steps_of_a_pass(h, D))
                               : ": " + steps_of_a_pass(h, D);
    }
    if (still) text += "\nlines without dynamics: one solution a pass";
    return text;
}

}  // namespace

std::string dry_run(const Case& input, int ranks) {
    const std::vector<Pack> packs = packs_of(input);
    const Dynamics& dynamics = input.analysis.dynamics;
    const double D = dynamics.platform_step;
    const std::vector<int> nodes = nodes_per_line(input);
    int elements = 0;
    for (const int n : nodes) elements += n - 1;
    double total = 0.0;
    for (const Pack& pack : packs) total += pack.cost;

    std::string text =
        fmt::format("{}: {} lines, {} elements, {} packs of up to {} lines\n", input.name,
                    input.lines.size(), elements, packs.size(), lanes_per_pack);
    text += fmt::format("{} steps of {:.5g} s to t = {:.5g} s",
                        static_cast<long>(std::ceil(dynamics.duration / D - 1e-9)), D,
                        dynamics.duration);
    text += line_steps(input) + "\n\nallocation\n";
    std::vector<int> busiest(packs.size());
    std::iota(busiest.begin(), busiest.end(), 0);
    const int platforms = input.platform_count();
    const bool several = platforms > 1;
    if (ranks == 1) {
        text += several
                    ? fmt::format("  alone: {} platforms and all lines in one process\n", platforms)
                    : "  alone: platform and all lines in one process\n";
    } else {
        const auto packs_of_rank = packs_of_ranks(input, ranks);
        const auto lines_of_rank = lines_of_ranks(input, ranks);
        double most = -1.0;
        text +=
            several ? fmt::format("  rank 0: {} platforms\n", platforms) : "  rank 0: platform\n";
        for (std::size_t rank = 1; rank < packs_of_rank.size(); ++rank) {
            double cost = 0.0;
            for (const int pack : packs_of_rank[rank])
                cost += packs[static_cast<std::size_t>(pack)].cost;
            if (cost > most) most = cost, busiest = packs_of_rank[rank];
            text += fmt::format(
                "  rank {}: {:5.1f} % of the work, {} pack{}: {}\n", rank,
                total > 0.0 ? 100.0 * cost / total : 0.0, packs_of_rank[rank].size(),
                packs_of_rank[rank].size() == 1 ? "" : "s", names_of(input, lines_of_rank[rank]));
        }
        if (most > 0.0)
            text += fmt::format("  speed-up over one worker at most {:.2f}\n", total / most);
    }

    const double before = resident_megabytes();
    const std::unique_ptr<Lines> lines = make_local_lines(input, busiest, nullptr);
    text += fmt::format("\nmemory\n  lines of the busiest rank: {:.1f} MB; program: {:.1f} MB\n",
                        resident_megabytes() - before, before);

    double sample = sizeof(double), snapshot = sizeof(double);
    for (const io::SeriesField& field : io::result_fields(input, nodes))
        if (field.clock != io::Clock::latest)
            (field.clock == io::Clock::sample ? sample : snapshot) +=
                field.width() *
                static_cast<double>(field.single_precision ? sizeof(float) : sizeof(double));
    const double samples = std::floor(dynamics.duration / input.output.interval + 1e-9) + 1.0;
    text += fmt::format("\noutput\n  {:.0f} samples of {}", samples, megabytes(sample));
    double bytes = samples * sample;
    if (input.output.snapshots) {
        const double n = std::floor(dynamics.duration / *input.output.snapshots + 1e-9) + 1.0;
        text += fmt::format(", {:.0f} snapshots of {}", n, megabytes(snapshot));
        bytes += n * snapshot;
    }
    return text + fmt::format(": {} before compression\n", megabytes(bytes));
}

}  // namespace hawser
