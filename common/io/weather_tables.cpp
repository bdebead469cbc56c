#include "io/weather_tables.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

namespace hawser::io {
namespace {

using Rows = std::vector<std::array<double, 2>>;

/// The numbers a line starts with, at most two.
std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    const char *at = line.data(), *end = at + line.size();
    while (numbers.size() < 2) {
        while (at < end && (*at == ' ' || *at == '\t' || *at == ',' || *at == ';' || *at == '+'))
            ++at;
        double x = 0.0;
        const auto [after, error] = std::from_chars(at, end, x);
        if (error != std::errc{} || !std::isfinite(x)) break;
        numbers.push_back(x);
        at = after;
    }
    return numbers;
}

Rows read_rows(const std::string& file, const std::string& path, Problems& problems) {
    Rows rows;
    std::ifstream in(file);
    if (!in) {
        problems.push_back(
            {Severity::error, path + ".file", fmt::format("there is no file {}", file), {}});
        return rows;
    }
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        const std::vector<double> values = numbers_of(line);
        if (values.size() == 2) {
            rows.push_back({values[0], values[1]});
        } else if (!rows.empty() || values.size() == 1) {
            problems.push_back(
                {Severity::error, path + ".file",
                 fmt::format("expected two numbers; got \"{}\"", line.substr(first, 40)), file,
                 number, static_cast<int>(first) + 1});
            return {};
        }
    }
    if (rows.empty())
        problems.push_back({Severity::error,
                            path + ".file",
                            fmt::format("{} holds no rows of numbers", file),
                            {}});
    return rows;
}

/// Fills rows from the file; what they are called in the case.
bool fill(Rows& rows, const std::string& file, const std::string& path, const char* name,
          const std::filesystem::path& folder, bool resolved, Problems& problems) {
    if (!rows.empty()) {
        if (!resolved && !file.empty())
            problems.push_back({Severity::error,
                                path + ".file",
                                fmt::format("given beside `{}`: one of the two", name),
                                {}});
        return false;
    }
    if (file.empty()) {
        problems.push_back(
            {Severity::error, path, fmt::format("expected `file`, or its rows in `{}`", name), {}});
        return false;
    }
    rows = read_rows((folder / file).lexically_normal().string(), path, problems);
    return true;
}

}  // namespace

void read_weather_tables(Environment& environment, const std::filesystem::path& folder,
                         bool resolved, Problems& problems) {
    for (std::size_t i = 0; i < environment.waves.size(); ++i) {
        WaveTrain& train = environment.waves[i];
        const bool spectrum = train.type == WaveType::spectrum_file;
        if (!spectrum && train.type != WaveType::elevation_file) continue;
        Rows& rows = spectrum ? train.spectrum : train.record;
        const bool read = fill(rows, train.file, fmt::format("environment.waves[{}]", i),
                               spectrum ? "spectrum" : "record", folder, resolved, problems);
        if (!read || !train.file_in_hertz) continue;
        constexpr double two_pi = 2.0 * std::numbers::pi;
        for (auto& [frequency, density] : rows) frequency *= two_pi, density /= two_pi;
    }
    if (environment.wind && environment.wind->spectrum == WindSpectrum::time_history)
        (void)fill(environment.wind->history, environment.wind->file, "environment.wind", "history",
                   folder, resolved, problems);
}

}  // namespace hawser::io
