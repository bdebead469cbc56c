// Writes a declared case out as a case file: every default filled in, one entry per line.
#pragma once

#include <filesystem>
#include <string>

#include "io/key_reader.hpp"

namespace hawser::io {

/// The resolved text. Comments say where each value comes from: file and line, `default` or `auto`.
std::string echo(const DeclaredCase& declared, const KeyReader& reader,
                 const std::filesystem::path& folder);

/// A text as a YAML scalar: quoted where it must be.
std::string yaml_text(const std::string& text);

}  // namespace hawser::io
