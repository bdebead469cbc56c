// How a run ends, whatever the reason: nobody waits for ever, and what there is can be read.
#include <cstdio>

#include "complain.hpp"
#include "io/summary.hpp"
#include "performance.hpp"
#include "simulation.hpp"

namespace hawser::master {

ExitCode Simulation::end(ExitCode code, std::string message) {
    const io::RankTimes mine = clock_.times(waited());
    progress_.finish();
    last_.ask = Ask::stop;
    last_.write_segment = code != ExitCode::io;
    last_.t0 = last_.t1 = t_;
    try {
        lines_.send(last_);
    } catch (const RunError& error) {  // alone: the last segment could not be written
        code = error.code();
        message = error.what();
    }
    const std::vector<io::RankTimes> times = io::gather_times(link_, mine);
    try {
        // Before the segments are joined too: after SIGTERM there may be a second left.
        if (code != ExitCode::done) report_.ended(code, message, t_, results_.saved_to());
        if (results_.segments() > 0) write_result(code, message, times);
        report_.ended(code, message, t_, results_.saved_to());
        report_.log(message);
    } catch (const RunError& error) {
        code = error.code();
        message = error.what();
        try {
            report_.ended(code, message, t_, results_.saved_to());
        } catch (const RunError&) {  // not even that can be written; the message below says why
        }
    }
    if (code == ExitCode::stopped) std::fprintf(stderr, "%s\n", message.c_str());
    if (code != ExitCode::done && code != ExitCode::stopped) complain(message);
    int agreed = static_cast<int>(code);
    link_.broadcast(agreed);
    return code;
}

void Simulation::write_result(ExitCode code, const std::string& message,
                              const std::vector<io::RankTimes>& times) {
    const io::RunRecord run = record(code, message, times);
    const io::ResultDigest digest = io::write_result(request_.folder, run);
    io::write_summary(request_.folder, run, digest);
    if (!request_.quiet) std::printf("%s\n", io::summary_text(run, digest).c_str());
}

io::RunRecord Simulation::record(ExitCode code, const std::string& message,
                                 const std::vector<io::RankTimes>& times) const {
    io::RunRecord r;
    r.input = input_;
    r.resolved = request_.resolved;
    r.sources = request_.sources;
    r.version = request_.version;
    r.build = request_.build;
    r.command = request_.command;
    r.ranks = link_.size();
    r.complete = code == ExitCode::done;
    r.outcome = message;
    r.statics = statics_;
    r.adjustments = request_.adjustments;
    r.impulses = impulses_;
    for (const PlatformLedger& ledger : ledgers_)
        if (ledger.started()) r.ledgers.push_back(ledger.table());
    r.platforms = platform_facts_;
    r.doubts = doubts_;
    r.performance = performance_facts(times, t_, lines_.orders());
    return r;
}

}  // namespace hawser::master
