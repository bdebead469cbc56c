// Reads case files. The only user of yaml-cpp.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "case/problem.hpp"
#include "io/case_tree.hpp"
#include "io/problems.hpp"

namespace hawser::io {

struct CaseFile {
    Case value;
    std::string resolved;            ///< the same case as one file with every default filled in
    std::vector<std::string> notes;  ///< warnings and values chosen for the user, formatted
    Problems problems;               ///< the same, with their places
    std::vector<std::pair<std::string, std::string>> sources;  ///< file name, text
    std::string file;                                          ///< its path
    Places places;                                             ///< where each key stands
};

/// Gives problems that know a key only the place of that key, or of the nearest above it.
void locate(Problems& problems, const CaseFile& file);

/// Key path and value as on the command line: {"environment.waves[0].Hs", "12 m"}.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Reads a case file and everything it includes; `overrides` are set last. Throws InputError with
/// all problems, RunError (ExitCode::io) if the file itself cannot be read.
CaseFile read_case(const std::filesystem::path& path, const Overrides& overrides = {});

/// Reads the resolved text of a case, on every rank: gives the same Case to the bit. Paths of data
/// files are taken from `folder`.
CaseFile read_resolved_case(const std::string& name, const std::string& text,
                            const std::filesystem::path& folder);

}  // namespace hawser::io
