#include "io/history_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <vector>

namespace hawser::io {

namespace {

/// The numbers of one line; nothing where something else stands there.
std::optional<std::vector<double>> numbers_of(std::string line) {
    line.erase(std::min(line.find('#'), line.size()));
    std::vector<double> out;
    const char* at = line.data();
    const char* const end = at + line.size();
    const auto separates = [](char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';';
    };
    while (true) {
        while (at != end && separates(*at)) ++at;
        if (at == end) return out;
        if (*at == '+') ++at;
        double x = 0.0;
        const auto [next, error] = std::from_chars(at, end, x);
        if (error != std::errc() || !std::isfinite(x) || (next != end && !separates(*next)))
            return {};
        out.push_back(x);
        at = next;
    }
}

}  // namespace

SixSeries read_six_series(const std::string& path, const std::string& key, Problems& problems) {
    SixSeries rows;
    std::ifstream file(path);
    if (!file) {
        problems.push_back({Severity::error, key, fmt::format("cannot read {}", path), {}});
        return rows;
    }
    const auto wrong = [&](int line, const std::string& what) {
        problems.push_back({Severity::error, key, what, path, line, 1});
        return SixSeries{};
    };
    std::string text;
    for (int line = 1; std::getline(file, text); ++line) {
        const auto x = numbers_of(text);
        if (!x) return wrong(line, "expected numbers");
        if (x->empty()) continue;
        if (x->size() != 7)
            return wrong(line, fmt::format("expected 7 numbers, a time and six motions or loads; "
                                           "got {}",
                                           x->size()));
        if (!rows.empty() && (*x)[0] <= rows.back()[0])
            return wrong(line, "times must ascend from row to row");
        std::array<double, 7> row{};
        std::copy(x->begin(), x->end(), row.begin());
        rows.push_back(row);
    }
    if (rows.size() < 2)
        problems.push_back(
            {Severity::error, key, fmt::format("{}: expected at least two rows", path), {}});
    return rows;
}

void read_histories(Platform& platform, double duration, Problems& problems) {
    for (std::size_t i = 0; i < platform.forces.size(); ++i) {
        AppliedForce& f = platform.forces[i];
        if (!f.path.empty())
            f.rows = read_six_series(
                f.path, fmt::format("{}.forces[{}].file", platform.key_path, i), problems);
    }
    if (!platform.prescribed || platform.prescribed->path.empty()) return;
    PrescribedMotion& motion = *platform.prescribed;
    const std::string key = platform.key_path + ".prescribed_motion.file";
    motion.rows = read_six_series(motion.path, key, problems);
    if (motion.rows.size() < 2) return;
    for (auto& row : motion.rows)
        for (std::size_t k = 4; k < 7; ++k) row[k] *= M_PI / 180.0;
    const double first = motion.rows.front()[0], last = motion.rows.back()[0];
    if (first > 0.0 || last < duration)
        problems.push_back(
            {Severity::error,
             key,
             fmt::format("{} tells the motion from {:g} to {:g} s; the run goes from "
                         "0 to {:g} s",
                         motion.path, first, last, duration),
             {}});
}

}  // namespace hawser::io
