#include "io/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <string_view>
#include <vector>

#include "io/files.hpp"

namespace hawser::io {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 6> own_files{"result.h5", "summary.txt", "statistics.csv",
                                                    "log.txt",   "status.json", "STOP"};

/// segment_00001.h5 and the like: digits between the two.
bool is_segment(std::string_view name) {
    constexpr std::string_view head = "segment_", tail = ".h5";
    if (!name.starts_with(head) || !name.ends_with(tail)) return false;
    name = name.substr(head.size(), name.size() - head.size() - tail.size());
    return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_own(std::string name) {
    if (name.ends_with(".part")) name.resize(name.size() - 5);
    for (const std::string_view own : own_files) {
        if (name == own) return true;
    }
    return is_segment(name);
}

[[noreturn]] void fail(const fs::path& path, const std::string& words) {
    throw RunError(ExitCode::io, fmt::format("{}: {}", path.string(), words));
}

std::string json_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

/// A JSON number; JSON has no NaN and no infinity.
std::string json_number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "null"; }

std::string host_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "";
    return name.data();
}

const char* name_of(RunState::State state) {
    switch (state) {
        case RunState::State::running:
            return "running";
        case RunState::State::done:
            return "done";
        case RunState::State::stopped:
            return "stopped";
        case RunState::State::failed:
            break;
    }
    return "failed";
}

}  // namespace

fs::path default_run_folder(const std::string& case_name) { return fs::path("runs") / case_name; }

void prepare_run_folder(const fs::path& folder, bool force) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
        fail(folder, "is a file, not a folder; choose another with --out");
    }
    fs::create_directories(folder, error);
    if (error) fail(folder, "cannot make the folder: " + error.message());
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        fail(folder, fmt::format("cannot write in the folder: {}", std::strerror(errno)));
    }
    std::vector<fs::path> own;
    bool result = false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_regular_file() || !is_own(name)) continue;
        own.push_back(entry.path());
        result = result || name == "result.h5" || name == "status.json" || is_segment(name);
    }
    if (result && !force) {
        fail(folder,
             "holds the result of an earlier run; choose another folder with --out, or --force to "
             "replace it");
    }
    for (const fs::path& path : own) {
        if (!fs::remove(path, error) && error) fail(path, "cannot delete: " + error.message());
    }
}

bool stop_requested(const fs::path& folder) {
    return ::access((folder / "STOP").c_str(), F_OK) == 0;
}

std::string to_json(const RunState& s) {
    return fmt::format(
        "{{\"state\": \"{}\", \"exit_code\": {}, \"message\": {}, \"t\": {}, \"saved_to\": {}, "
        "\"wall_s\": {}, \"pid\": {}, \"host\": {}}}\n",
        name_of(s.state), static_cast<int>(s.exit_code), json_text(s.message), json_number(s.t),
        json_number(s.saved_to), json_number(s.wall_s), ::getpid(), json_text(host_name()));
}

void write_status(const fs::path& folder, const RunState& state) {
    write_atomically(folder / "status.json", to_json(state));
}

RunLog::RunLog(const fs::path& folder)
    : file_(std::fopen((folder / "log.txt").c_str(), "a")), path_((folder / "log.txt").string()) {
    if (!file_) fail(path_, std::strerror(errno));
}

void RunLog::line(const std::string& text) {
    if (!file_) return;
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char stamp[32];
    std::strftime(stamp, sizeof stamp, "%Y-%m-%d %H:%M:%SZ", &utc);
    if (std::fprintf(file_.get(), "%s  %s\n", stamp, text.c_str()) < 0 ||
        std::fflush(file_.get()) != 0) {
        fail(path_, std::strerror(errno));
    }
}

}  // namespace hawser::io
