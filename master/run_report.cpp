#include "run_report.hpp"

#include "clocks.hpp"
#include "complain.hpp"
#include "stop_signal.hpp"

namespace hawser::master {

RunReport::RunReport(const RunRequest& request)
    : request_(request), log_(request.folder), began_(wall_seconds()) {
    for (const std::string& note : request.notes) log_.line(note);
}

void RunReport::ended(ExitCode code, const std::string& message, double t, double saved_to) {
    using State = io::RunState::State;
    io::RunState state;
    state.state = code == ExitCode::done      ? State::done
                  : code == ExitCode::stopped ? State::stopped
                                              : State::failed;
    state.exit_code = code;
    state.message = message;
    write(state, t, saved_to);
}

void RunReport::warn(const std::string& text) {
    if (!request_.quiet) complain("warning: " + text);
    log_.line("warning: " + text);
}

void RunReport::write(io::RunState state, double t, double saved_to) {
    state.t = t;
    state.saved_to = saved_to;
    state.wall_s = wall_seconds() - began_;
    io::write_status(request_.folder, state);
}

bool StopRequest::made() {
    if (stop_signal() != 0) return true;
    const double now = wall_seconds();
    if (now - last_look_ < 0.2) return false;
    last_look_ = now;
    return io::stop_requested(request_.folder);
}

}  // namespace hawser::master
