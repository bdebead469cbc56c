// A worker's part of a run, beside run_master: the two go through the same agreements in step.
#include <memory>
#include <optional>

#include "complain.hpp"
#include "io/link.hpp"
#include "io/rank_times.hpp"
#include "io/result_fields.hpp"
#include "io/series_file.hpp"
#include "packing.hpp"
#include "roles.hpp"
#include "shares.hpp"
#include "worker_loop.hpp"

namespace hawser {

ExitCode run_worker(const Case& input, const RunRequest& request, io::Link& link) {
    // Rank 0 reads the coefficients and makes the folder.
    if (const ExitCode code = io::agree(link, ExitCode::done); code != ExitCode::done) return code;

    ExitCode code = ExitCode::done;
    std::optional<io::SeriesWriter> results;
    std::unique_ptr<Lines> lines;
    try {
        results.emplace(request.folder, io::result_fields(input, nodes_per_line(input)), link);
        results->reserve(io::segment_samples, io::segment_samples);
        const auto packs = packs_of_ranks(input, link.size());
        lines = make_local_lines(input, packs[static_cast<std::size_t>(link.rank())], &*results);
    } catch (const RunError& error) {
        complain(error.what());
        code = error.code();
    }
    if (code = io::agree(link, code); code != ExitCode::done) return code;

    io::gather_times(link, worker::worker_loop(link, *lines, &*results, input.platform_count(),
                                               joins_platforms(input)));
    int agreed = 0;
    link.broadcast(agreed);
    return static_cast<ExitCode>(agreed);
}

}  // namespace hawser
