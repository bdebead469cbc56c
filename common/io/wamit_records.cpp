#include "io/wamit_records.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace hawser::io {

namespace {
constexpr int most_per_file = 20;

}  // namespace

std::optional<double> fortran_number(std::string word) {
    for (char& c : word)
        if (c == 'D' || c == 'd') c = 'e';
    const char *first = word.data(), *last = first + word.size();
    if (first != last && *first == '+') ++first;
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

void FileProblems::add(const std::filesystem::path& file, int line, std::string message) {
    list_.push_back({file.string(), line, std::move(message)});
}

std::string FileProblems::text() const {
    std::string text;
    std::map<std::string, int> count;
    for (const FileProblem& p : list_) {
        if (++count[p.file] > most_per_file) continue;
        if (!text.empty()) text += '\n';
        text += p.line > 0 ? fmt::format("{}:{}: error: {}", p.file, p.line, p.message)
                           : fmt::format("{}: error: {}", p.file, p.message);
    }
    for (const auto& [file, n] : count)
        if (n > most_per_file)
            text +=
                fmt::format("\n{}: error: {} more problems like these", file, n - most_per_file);
    return text;
}

std::vector<Record> read_records(const std::filesystem::path& file, std::size_t columns,
                                 FileProblems& problems) {
    std::vector<Record> records;
    std::ifstream in(file);
    if (!in) {
        problems.add(file, 0, "cannot be read; expected a WAMIT numeric file");
        return records;
    }
    std::string text;
    for (int line = 1; std::getline(in, text); ++line) {
        std::istringstream words(text);
        Record record{line, {}};
        bool good = true;
        for (std::string word; good && words >> word;) {
            if (const std::optional<double> x = fortran_number(word))
                record.numbers.push_back(*x);
            else if (line == 1 && record.numbers.empty()) {
                good = false;  // the header
            } else {
                problems.add(file, line, fmt::format("expected a number; got \"{}\"", word));
                good = false;
            }
        }
        if (!good || record.numbers.empty()) continue;
        if (record.numbers.size() < columns)
            problems.add(
                file, line,
                fmt::format("expected {} numbers; got {}", columns, record.numbers.size()));
        else
            records.push_back(std::move(record));
    }
    if (in.bad()) problems.add(file, 0, "reading it failed before its end");
    return records;
}

}  // namespace hawser::io
