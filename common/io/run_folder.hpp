// The folder of a run: what it may hold, how it is opened without harming an earlier result, and
// the small text files that tell how the run is going.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "status.hpp"

namespace hawser::io {

/// runs/<name of the case>
std::filesystem::path default_run_folder(const std::string& case_name);

/// Makes the folder of a run, rank 0 only. An earlier result (result.h5, segments or status.json)
/// is refused with ExitCode::io unless `force`; then the files that this program writes are
/// deleted, by name, and nothing else.
void prepare_run_folder(const std::filesystem::path& folder, bool force);

/// Is there a file named STOP in the folder?
bool stop_requested(const std::filesystem::path& folder);

/// What status.json says.
struct RunState {
    enum class State { running, done, stopped, failed };
    State state = State::running;
    ExitCode exit_code = ExitCode::done;
    std::string message;
    double t = 0.0;         ///< simulated time reached [s]
    double saved_to = 0.0;  ///< up to which everything can be read back [s]
    double wall_s = 0.0;
};

/// With the process and the host that wrote it: a state "running" of a process that is gone means
/// that the run was killed.
std::string to_json(const RunState& state);
/// Writes status.json so that a reader sees the old or the new one, whole.
void write_status(const std::filesystem::path& folder, const RunState& state);

/// log.txt: lines with the wall-clock time in front, each flushed as it is written.
class RunLog {
 public:
    RunLog() = default;  ///< writes nothing
    explicit RunLog(const std::filesystem::path& folder);
    void line(const std::string& text);

 private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    std::string path_;
};

}  // namespace hawser::io
