#include "io/check_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "case/hydro_of_case.hpp"
#include "io/case_schema.hpp"
#include "io/hydro_file.hpp"

namespace hawser::io {
namespace {

const char* name_of(Severity severity) {
    if (severity == Severity::error) return "error";
    return severity == Severity::warning ? "warning" : "note";
}

/// Problems as JSON, for editors and scripts.
Json json(const std::string& case_file, const Problems& problems) {
    Json list = Json::array();
    for (const Problem& p : problems) {
        Json one = Json::object();
        one.put("severity", name_of(p.severity)).put("file", p.file);
        if (p.line > 0) one.put("line", p.line).put("column", p.column);
        const std::string of = p.subject.empty() ? "" : p.subject + ": ";
        one.put("path", p.path).put("message", of + p.message);
        list.add(std::move(one));
    }
    const auto number = [&](Severity s) {
        return static_cast<int>(std::count_if(problems.begin(), problems.end(),
                                              [s](const Problem& p) { return p.severity == s; }));
    };
    Json report = Json::object();
    report.put("case", case_file)
        .put("valid", !has_errors(problems))
        .put("errors", number(Severity::error))
        .put("warnings", number(Severity::warning))
        .put("problems", std::move(list));
    return report;
}

void print(const Json& report) { fmt::print("{}\n", report.text()); }

/// A valid case whose statics are asked for too.
int check_statics(const CommandLine& line, CaseFile& file, const SolveStatics& solve) {
    const std::string name = line.case_file.string();
    Json report = json(name, file.problems);
    try {
        StaticsFound found = solve(file);
        locate(found.warnings, file);
        Problems all = file.problems;
        all.insert(all.end(), found.warnings.begin(), found.warnings.end());
        if (line.json) {
            report = json(name, all);
            report.put("equilibrium", true).put("statics", found.report);
            print(report);
            return static_cast<int>(ExitCode::done);
        }
        for (const std::string& note : found.notes) fmt::print(stderr, "{}\n", note);
        for (const Problem& warning : found.warnings) fmt::print(stderr, "{}\n", format(warning));
        fmt::print("{}: valid. {} It has a static equilibrium.\n{}", name, count(all), found.text);
        return static_cast<int>(ExitCode::done);
    } catch (const RunError& error) {
        if (line.json) {
            report.put("equilibrium", false).put("reason", error.what());
            print(report);
        } else {
            std::fflush(stdout);
            fmt::print(stderr, "{}: error: {}\n", name, error.what());
            fmt::print(stderr, "{}: its keys are valid ({}), but it {}.\n", name,
                       count(file.problems).substr(0, count(file.problems).size() - 1),
                       error.code() == ExitCode::no_equilibrium ? "has no static equilibrium"
                                                                : "cannot be solved");
        }
        return static_cast<int>(error.code());
    }
}

}  // namespace

namespace {

/// What the files of a platform's database say against the case.
void check_database(const Case& input, const Platform& platform, Problems& found,
                    std::vector<std::string>& notes) {
    if (!platform.hydrodynamics.database) {
        check_size(input, platform, nullptr, found);
        return;
    }
    const HydroDatabase& database = *platform.hydrodynamics.database;
    try {
        const HydroData data = read_hydro(database, input.environment);
        for (const std::string& note : data.notes)
            if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
        for (const HydroDoubt& doubt : data.doubts) {
            Problem problem{Severity::warning, "", doubt.sentence, doubt.file};
            problem.line = doubt.line;
            problem.column = doubt.line > 0 ? 1 : 0;
            if (std::find(found.begin(), found.end(), problem) == found.end())
                found.push_back(std::move(problem));
        }
        if (!database.displaced_volume)
            check_displacement(input, platform, data.displaced_volume, found);
        check_size(input, platform, &data, found);
        check_coverage(input, platform, data, found);
    } catch (const HydroFileError& error) {
        for (const FileProblem& p : error.problems()) {
            Problem problem{Severity::error, "", p.message, p.file};
            problem.line = p.line;
            problem.column = p.line > 0 ? 1 : 0;
            found.push_back(std::move(problem));
        }
    }
}

}  // namespace

CaseFile read_and_check(const std::filesystem::path& path, const Overrides& overrides) {
    CaseFile file = read_case(path, overrides);
    Problems found;
    std::vector<std::string> notes;
    for (int k = 0; k < file.value.platform_count(); ++k)
        check_database(file.value, file.value.platform_at(k), found, notes);
    if (file.value.platform_count() > 0) check_steps_of_waves(file.value, found);
    if (found.empty() && notes.empty()) return file;
    locate(found, file);
    for (const std::string& note : notes) found.push_back({Severity::note, "", note, {}});
    for (Problem& p : found) {
        file.notes.push_back(format(p));
        file.problems.push_back(std::move(p));
    }
    if (!has_errors(file.problems)) return file;
    tidy(file.problems);
    throw InputError(std::move(file.problems));
}

int check_command(const CommandLine& line, const SolveStatics& solve) {
    try {
        CaseFile file = read_and_check(line.case_file, line.overrides);
        if (line.echo && !line.json) {
            std::fputs(file.resolved.c_str(), stdout);
            if (!line.with_statics) return static_cast<int>(ExitCode::done);
        } else if (!line.json) {
            for (const std::string& note : file.notes) fmt::print("{}\n", note);
        }
        if (line.with_statics) return check_statics(line, file, solve);
        if (line.json) {
            print(json(line.case_file.string(), file.problems));
        } else {
            fmt::print("{}: valid. {}\n", line.case_file.string(), count(file.problems));
        }
        return static_cast<int>(ExitCode::done);
    } catch (const InputError& error) {
        if (line.json) {
            print(json(line.case_file.string(), error.problems()));
        } else {
            fmt::print(stderr, "{}\n", error.what());
        }
        return static_cast<int>(error.code());
    } catch (const RunError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.code());
    }
}

int schema_command(const CommandLine& line) {
    const std::string text = line.reference ? reference_case() : case_schema();
    if (line.output_file.empty()) {
        std::fputs(text.c_str(), stdout);
        return static_cast<int>(ExitCode::done);
    }
    std::ofstream file(line.output_file, std::ios::binary);
    file << text;
    file.close();
    if (!file) {
        fmt::print(stderr, "cannot write {}\n", line.output_file.string());
        return static_cast<int>(ExitCode::io);
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace hawser::io
