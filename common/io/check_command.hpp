// The commands that neither run anything nor start MPI.
#pragma once

#include "case/case.hpp"
#include "io/case_file.hpp"
#include "io/command_line.hpp"

namespace hawser::io {

/// Reads a case and its hydrodynamic files: every check that needs no simulation. Throws
/// InputError.
CaseFile read_and_check(const std::filesystem::path& path, const Overrides& overrides);

/// `hawser check`: problems to standard error (with --json to standard output), the resolved case
/// with --echo. Returns the exit code.
int check_command(const CommandLine& line);

/// `hawser schema`. Returns the exit code.
int schema_command(const CommandLine& line);

}  // namespace hawser::io
