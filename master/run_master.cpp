// Rank 0's part of a run, beside run_worker: the two go through the same agreements in step.
#include <memory>
#include <vector>

#include "complain.hpp"
#include "hulls.hpp"
#include "io/rank_times.hpp"
#include "io/run_folder.hpp"
#include "simulation.hpp"

namespace hawser {

namespace {

/// What goes wrong in a rank's set-up is said there and becomes an exit code all ranks agree on.
template <class Work>
ExitCode attempt(const io::Link& link, Work&& work) {
    ExitCode code = ExitCode::done;
    try {
        work();
    } catch (const RunError& error) {
        complain(error.what());
        code = error.code();
    }
    return io::agree(link, code);
}

}  // namespace

ExitCode run_master(const Case& input, const RunRequest& request, io::Link& link) {
    std::vector<master::Hull> hulls;
    ExitCode code = attempt(link, [&] {
        hulls = master::hulls_of(input);
        io::prepare_run_folder(request.folder, request.force);
    });
    if (code != ExitCode::done) return code;

    std::unique_ptr<master::Simulation> simulation;
    code = attempt(link, [&] {
        simulation = std::make_unique<master::Simulation>(input, request, link, hulls);
    });
    return code == ExitCode::done ? simulation->run() : code;
}

}  // namespace hawser
