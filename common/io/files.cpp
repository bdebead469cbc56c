#include "io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "status.hpp"

namespace hawser::io {
namespace {

[[noreturn]] void fail(const char* call, const std::filesystem::path& path, int error) {
    throw RunError(ExitCode::io, fmt::format("{}: {}: {}", path.string(), call, strerror(error)));
}

void sync(const std::filesystem::path& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_CLOEXEC);
    if (file < 0) fail("open", path, errno);
    const int failed = ::fsync(file);
    const int error = errno;
    ::close(file);
    // Some file systems cannot sync a folder and say EINVAL: there the rename is all there is.
    if (failed != 0 && !(error == EINVAL && (flags & O_DIRECTORY) != 0)) fail("fsync", path, error);
}

}  // namespace

std::filesystem::path part_of(const std::filesystem::path& path) { return path.string() + ".part"; }

void publish(const std::filesystem::path& path) {
    const std::filesystem::path part = part_of(path);
    sync(part, O_RDONLY);
    if (std::rename(part.c_str(), path.c_str()) != 0) fail("rename", part, errno);
    const std::filesystem::path folder = path.parent_path();
    sync(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

void write_atomically(const std::filesystem::path& path, const std::string& text) {
    const std::filesystem::path part = part_of(path);
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) fail("open", part, errno);
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t n = ::write(file, text.data() + done, text.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) {
            const int error = errno;
            ::close(file);
            fail("write", part, error);
        }
        done += static_cast<std::size_t>(n);
    }
    if (::close(file) != 0) fail("close", part, errno);
    publish(path);
}

}  // namespace hawser::io
