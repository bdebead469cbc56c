// The commands that neither run anything nor start MPI.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/case_file.hpp"
#include "io/command_line.hpp"
#include "io/json.hpp"

namespace hawser::io {

/// Reads a case and its hydrodynamic files: every check that needs no simulation. Throws
/// InputError.
CaseFile read_and_check(const std::filesystem::path& path, const Overrides& overrides);

/// What the static solution adds to a check.
struct StaticsFound {
    std::string text;                ///< the summary, for people
    Json report;                     ///< the same as JSON
    std::vector<std::string> notes;  ///< lengths and radii that meet targets
    Problems warnings;               ///< without places
};
using SolveStatics = std::function<StaticsFound(CaseFile&)>;

/// `hawser check`: problems to standard error (with --json to standard output), the resolved case
/// with --echo. With --statics the case is valid only if `solve` finds its equilibrium: it throws
/// RunError. Returns the exit code.
int check_command(const CommandLine& line, const SolveStatics& solve);

/// `hawser schema`. Returns the exit code.
int schema_command(const CommandLine& line);

}  // namespace hawser::io
