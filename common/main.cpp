// The program: what the command line asks for, who this process is, and the one place where an
// exception becomes a message and an exit code.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "complain.hpp"
#include "io/case_file.hpp"
#include "io/check_command.hpp"
#include "io/command_line.hpp"
#include "io/cylinder_command.hpp"
#include "io/files.hpp"
#include "io/hdf5.hpp"
#include "io/hydro_commands.hpp"
#include "io/link.hpp"
#include "io/modes_text.hpp"
#include "io/run_folder.hpp"
#include "io/statics_text.hpp"
#include "roles.hpp"
#include "stop_signal.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

std::string version_text() {
    return fmt::format("hawser {}\nbuild {}\n{}\nHDF5 {}\nEigen {}.{}.{}\n", HAWSER_VERSION,
                       HAWSER_BUILD, io::mpi_version(), io::hdf5_version(), EIGEN_WORLD_VERSION,
                       EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
}

/// Rank 0 reads and checks; its text of the case and what else all must know goes to every rank,
/// and every rank makes its Case of that same text with the same reader.
class SharedCase {
 public:
    /// Rank 0 only. Throws InputError, RunError.
    void read(const io::CommandLine& line) {
        io::CaseFile file = io::read_and_check(line.case_file, line.overrides);
        name_ = file.value.name;
        data_folder_ = fs::absolute(line.case_file).parent_path().string();
        request.folder = fs::absolute(line.out.empty() ? io::default_run_folder(name_) : line.out);
        request.resolved = std::move(file.resolved);
        request.sources = std::move(file.sources);
        request.notes = std::move(file.notes);
        if (!line.quiet)
            for (const std::string& note : request.notes)
                std::fprintf(stderr, "%s\n", note.c_str());
    }

    void broadcast(const io::Link& link) {
        std::string folder = request.folder.string();
        for (std::string* text : {&name_, &data_folder_, &folder, &request.resolved})
            link.broadcast(*text);
        request.folder = folder;
    }

    [[nodiscard]] Case value() const {
        return io::read_resolved_case(name_, request.resolved, data_folder_).value;
    }

    RunRequest request;

 private:
    std::string name_, data_folder_;
};

/// A case that one process reads, checks and makes ready to compute; its notes go to stderr.
io::CaseFile ready_case(const io::CommandLine& line) {
    io::CaseFile file = io::read_and_check(line.case_file, line.overrides);
    for (const Adjustment& a : meet_targets(file.value, io::Link()))
        file.notes.push_back(note_of(a, file.value));
    for (const std::string& note : file.notes) std::fprintf(stderr, "%s\n", note.c_str());
    return file;
}

/// A warning of the statics as one of the case: of the platform whose name it begins with.
Problem problem_of(const std::string& warning, const Case& input) {
    for (int k = 0; k < input.platform_count(); ++k) {
        const Platform& platform = input.platform_at(k);
        const std::string of = platform.name + ": ";
        if (warning.starts_with(of))
            return {Severity::warning, platform.key_path, warning.substr(of.size()), {}};
    }
    return {Severity::warning, "", warning, {}};
}

/// What `hawser check --statics` adds to a check.
io::StaticsFound solve_statics(io::CaseFile& file) {
    io::StaticsFound found;
    for (const Adjustment& a : meet_targets(file.value, io::Link()))
        found.notes.push_back(note_of(a, file.value));
    const StaticsReport report = find_statics(file.value, {});
    for (const std::string& warning : report.warnings)
        found.warnings.push_back(problem_of(warning, file.value));
    found.text = io::statics_summary(file.value, report);
    found.report = io::statics_json(file.value, report);
    return found;
}

/// `hawser statics`: one process, for it takes seconds.
int statics(const io::CommandLine& line) {
    io::CaseFile file = ready_case(line);
    if (!line.without.empty()) {
        file.value = without_lines(file.value, line.without);
        std::fprintf(stderr, "without %s: the other lines alone\n", line.without.c_str());
    }
    const StaticsReport report = find_statics(file.value, line.statics);
    for (const std::string& warning : report.warnings) complain("warning: " + warning);
    const std::string text = line.json ? io::statics_json(file.value, report).text() + "\n"
                                       : io::statics_text(file.value, report);
    std::fputs(text.c_str(), stdout);
    if (!line.output_file.empty())
        io::write_atomically(line.output_file, io::statics_csv(file.value, report));
    if (!report.curve || report.curve->ends.empty()) return static_cast<int>(ExitCode::done);
    complain(report.curve->ends);
    return static_cast<int>(ExitCode::no_equilibrium);
}

/// `hawser modes`, likewise.
int modes(const io::CommandLine& line) {
    const io::CaseFile file = ready_case(line);
    const ModesReport report = find_modes(file.value, line.modes);
    for (const std::string& warning : report.warnings) complain("warning: " + warning);
    const std::string text =
        line.json ? io::modes_json(file.value, report) : io::modes_text(file.value, report);
    std::fputs(text.c_str(), stdout);
    if (!line.output_file.empty())
        io::write_atomically(line.output_file, io::modes_csv(file.value, report));
    return static_cast<int>(ExitCode::done);
}

ExitCode run(const io::CommandLine& line, io::Link& link) {
    SharedCase shared;
    shared.request.force = line.force;
    shared.request.command = line.text;
    shared.request.version = HAWSER_VERSION;
    shared.request.build = HAWSER_BUILD;
    shared.request.progress = line.progress;
    shared.request.quiet = line.quiet;
    int code = 0;
    if (link.rank() == 0) try {
            shared.read(line);
        } catch (const RunError& error) {  // agreed on, so that nobody waits for a case
            complain(error.what());
            code = static_cast<int>(error.code());
        }
    link.broadcast(code);
    if (code != 0) return static_cast<ExitCode>(code);
    shared.broadcast(link);
    Case input = shared.value();
    try {
        shared.request.adjustments = meet_targets(input, link);
    } catch (const RunError& error) {
        if (link.rank() == 0) complain(error.what());
        return error.code();
    }
    for (const Adjustment& a : shared.request.adjustments) {
        shared.request.notes.push_back(note_of(a, input));
        if (!line.quiet) std::fprintf(stderr, "%s\n", shared.request.notes.back().c_str());
    }
    watch_stop_signals();
    return link.rank() == 0 ? run_master(input, shared.request, link)
                            : run_worker(input, shared.request, link);
}

}  // namespace
}  // namespace hawser

int main(int argc, char** argv) {
    using namespace hawser;
    const io::Launch launch = io::launch();
    const bool speaks = launch.rank == 0;
    std::optional<io::MpiRuntime> mpi;
    std::optional<io::Link> link;
    ExitCode code = ExitCode::bug;
    std::string message;
    try {
        using Command = io::CommandLine::Command;
        const io::CommandLine line = io::parse_command_line(argc, argv);
        if (line.finished) {
            const bool good = *line.finished == ExitCode::done;
            if (speaks) std::fputs(line.message.c_str(), good ? stdout : stderr);
            return static_cast<int>(*line.finished);
        }
        if (!speaks && (line.command != Command::run || line.dry_run)) return 0;
        switch (line.command) {
            case Command::check:
                return io::check_command(line, solve_statics);
            case Command::statics:
                return statics(line);
            case Command::modes:
                return modes(line);
            case Command::hydro_cylinder:
                return io::cylinder_command(line.cylinder, line.out.string(), line.quiet);
            case Command::hydro_info:
                return io::hydro_info_command(line.hydro, line.json);
            case Command::hydro_convert:
                return io::hydro_convert_command(line.hydro, line.out.string(), line.quiet);
            case Command::schema:
                return io::schema_command(line);
            case Command::none:
            case Command::version:
                std::fputs(version_text().c_str(), stdout);
                return 0;
            case Command::run:
                if (line.dry_run) {
                    std::fputs(dry_run(ready_case(line).value, launch.size).c_str(), stdout);
                    return 0;
                }
                if (!launch.alone()) mpi.emplace(&argc, &argv);
                link.emplace(mpi ? mpi->link() : io::Link());
                code = run(line, *link);
                link.reset();
                return static_cast<int>(code);
        }
    } catch (const RunError& error) {
        code = error.code();
        message = error.what();
    } catch (const std::exception& error) {
        message = fmt::format("unexpected: {}; this is a bug of hawser", error.what());
    }
    // Under MPI the others do not know of it: they are ended.
    if (link && !link->alone()) link->fail(code, message);
    complain(message);
    return static_cast<int>(code);
}
