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
    // A line that is its own family is in the path.
    const std::string own = "lines." + p.subject;
    const bool named = p.subject.empty() || p.path == own || p.path.starts_with(own + ".");
    return fmt::format("{}{}{}: {}{}{}{}{}", place, place.empty() ? "" : ": ", kind, p.path,
                       p.path.empty() ? "" : ": ", named ? "" : p.subject, named ? "" : ": ",
                       p.message);
}

std::string count(const Problems& problems) {
    const auto number = [&](Severity s, const char* noun) {
        const auto n = std::count_if(problems.begin(), problems.end(),
                                     [s](const Problem& p) { return p.severity == s; });
        return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
    };
    return number(Severity::error, "error") + ", " + number(Severity::warning, "warning") + ".";
}

namespace {

/// A message without its numbers.
std::string shape(const std::string& message) {
    std::string text;
    for (const char c : message) {
        if (std::string_view("0123456789.-+e").find(c) == std::string_view::npos) text += c;
    }
    return text;
}

/// What is said of several lines of a family, but for the numbers, is said of the first.
void say_once(Problems& problems) {
    Problems said;
    std::vector<int> others;
    for (Problem& p : problems) {
        const auto same = [&p](const Problem& q) {
            return !p.subject.empty() && !q.subject.empty() &&
                   std::tie(p.file, p.line, p.column, p.severity, p.path) ==
                       std::tie(q.file, q.line, q.column, q.severity, q.path) &&
                   shape(p.message) == shape(q.message);
        };
        const auto before = std::find_if(said.begin(), said.end(), same);
        if (before == said.end()) {
            said.push_back(std::move(p));
            others.push_back(0);
        } else {
            ++others[static_cast<std::size_t>(before - said.begin())];
        }
    }
    for (std::size_t i = 0; i < said.size(); ++i) {
        if (others[i] > 0) {
            said[i].subject += fmt::format(" and {} other line{} of this family", others[i],
                                           others[i] == 1 ? "" : "s");
        }
    }
    problems = std::move(said);
}

}  // namespace

void tidy(Problems& problems) {
    say_once(problems);
    const auto place = [](const Problem& p) {
        return std::tie(p.file, p.line, p.column, p.severity, p.path, p.message, p.subject);
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
