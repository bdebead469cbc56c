// What a run tells the world while it lasts: status.json, log.txt, warnings. Rank 0.
#pragma once

#include <string>

#include "io/run_folder.hpp"
#include "roles.hpp"

namespace hawser::master {

class RunReport {
 public:
    explicit RunReport(const RunRequest& request);

    /// status.json: under way (failed, done ...). @param t reached, @param saved_to readable [s]
    void running(double t, double saved_to) { write({}, t, saved_to); }
    void ended(ExitCode code, const std::string& message, double t, double saved_to);

    void log(const std::string& text) { log_.line(text); }
    void warn(const std::string& text);

 private:
    void write(io::RunState state, double t, double saved_to);

    const RunRequest& request_;
    io::RunLog log_;
    double began_;
};

/// Has anybody asked the run to stop? A signal, or a file STOP in its folder.
class StopRequest {
 public:
    explicit StopRequest(const RunRequest& request) : request_(request) {}
    /// Cheap enough for every step: the file is looked for a few times a second only.
    [[nodiscard]] bool made();

 private:
    const RunRequest& request_;
    double last_look_ = 0.0;
};

}  // namespace hawser::master
