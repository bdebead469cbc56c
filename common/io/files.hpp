// Files written so that a crash leaves the old or the new one, never half of it. POSIX; failures
// are RunError(ExitCode::io) with the path and the system's own words.
#pragma once

#include <filesystem>
#include <string>

namespace hawser::io {

/// Writes `path`.part, syncs it, renames it to `path` and syncs the folder.
void write_atomically(const std::filesystem::path& path, const std::string& text);

/// Renames a finished `path`.part to `path`: syncs the file, renames, syncs the folder.
void publish(const std::filesystem::path& path);

/// The name under which `path` is written until it is published.
std::filesystem::path part_of(const std::filesystem::path& path);

}  // namespace hawser::io
