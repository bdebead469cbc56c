#include "io/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace hawser::io {
namespace {

std::string report(const Problems& problems) {
    std::string text;
    for (const Problem& p : problems) {
        if (p.severity != Severity::note) text += format(p) + "\n";
    }
    return text + count(problems) + " Nothing was run.";
}

}  // namespace

InputError::InputError(Problems problems)
    : RunError(ExitCode::input, report(problems)), problems_(std::move(problems)) {}

std::string format(const Problem& p) {
    const char* kind = p.severity == Severity::error     ? "error"
                       : p.severity == Severity::warning ? "warning"
                                                         : "note";
    std::string place = p.file;
    if (p.line > 0) place += fmt::format(":{}:{}", p.line, p.column);
    return fmt::format("{}{}{}: {}{}{}", place, place.empty() ? "" : ": ", kind, p.path,
                       p.path.empty() ? "" : ": ", p.message);
}

std::string count(const Problems& problems) {
    const auto number = [&](Severity s, const char* noun) {
        const auto n = std::count_if(problems.begin(), problems.end(),
                                     [s](const Problem& p) { return p.severity == s; });
        return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
    };
    return number(Severity::error, "error") + ", " + number(Severity::warning, "warning") + ".";
}

void tidy(Problems& problems) {
    const auto place = [](const Problem& p) {
        return std::tie(p.file, p.line, p.column, p.severity, p.path, p.message);
    };
    std::sort(problems.begin(), problems.end(),
              [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
    problems.erase(std::unique(problems.begin(), problems.end()), problems.end());
}

bool has_errors(const Problems& problems) {
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& p) { return p.severity == Severity::error; });
}

}  // namespace hawser::io
