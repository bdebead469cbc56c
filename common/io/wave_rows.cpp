#include "io/wave_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::io {

namespace {
constexpr double turn = 2.0 * M_PI;
constexpr double degree = M_PI / 180.0;
constexpr double same_heading = 1e-6;  // [rad]

// Into [0, 2 pi); a heading a rounding below a full turn is 0.
double reduced(double heading) {
    const double b = heading - turn * std::floor(heading / turn);
    return b > turn - same_heading ? 0.0 : b;
}

template <class Range>
std::size_t place_of_heading(const Range& headings, double b) {
    for (std::size_t i = 0; i < headings.size(); ++i)
        if (std::abs(headings[i].heading - b) < same_heading) return i;
    return headings.size();
}
}  // namespace

bool same_frequency(double a, double b) { return std::abs(a - b) <= 2e-6 * std::max(a, b); }

std::vector<double> distinct_frequencies(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(), same_frequency), all.end());
    return all;
}

std::size_t place_of_frequency(const std::vector<double>& frequencies, double w) {
    return static_cast<std::size_t>(
        std::lower_bound(frequencies.begin(), frequencies.end(), w * (1 - 4e-6)) -
        frequencies.begin());
}

WaveTable<CVec6> table_of(const std::vector<WaveRow>& rows, const std::filesystem::path& file,
                          FileProblems& problems) {
    WaveTable<CVec6> table;
    for (const WaveRow& row : rows) table.frequencies.push_back(row.frequency);
    table.frequencies = distinct_frequencies(std::move(table.frequencies));
    const std::size_t n = table.frequencies.size();
    std::vector<std::vector<char>> seen;  // by heading and frequency
    for (const WaveRow& row : rows) {
        const double b = reduced(row.heading * degree);
        const std::size_t h = place_of_heading(table.headings, b);
        if (h == table.headings.size()) {
            table.headings.push_back({b, std::vector<CVec6>(n, CVec6::Zero())});
            seen.emplace_back(n, 0);
        }
        const std::size_t f = place_of_frequency(table.frequencies, row.frequency);
        table.headings[h].values[f][row.mode] = row.value;
        seen[h][f] = 1;
    }
    for (std::size_t h = 0; h < seen.size(); ++h)
        for (std::size_t f = 0; f < n; ++f)
            if (seen[h][f] == 0)
                problems.add(
                    file, 0,
                    fmt::format("no rows for period {:.6g} s and heading {:.6g} deg, "
                                "though both occur in the file",
                                turn / table.frequencies[f], table.headings[h].heading / degree));
    return table;
}

WaveTable<Vec6> real_part(const WaveTable<CVec6>& table) {
    WaveTable<Vec6> real;
    real.frequencies = table.frequencies;
    for (const auto& h : table.headings) {
        HeadingData<Vec6>& to = real.headings.emplace_back();
        to.heading = h.heading;
        for (const CVec6& v : h.values) to.values.emplace_back(v.real());
    }
    return real;
}

Vec6 mirror_sign(bool about_xz) {
    Vec6 sign;
    if (about_xz)
        sign << 1, -1, 1, -1, 1, -1;
    else
        sign << -1, 1, 1, 1, -1, -1;
    return sign;
}

template <class Value>
void mirror(WaveTable<Value>& table, bool about_xz) {
    const Value sign = mirror_sign(about_xz).cast<typename Value::Scalar>();
    const std::size_t n = table.headings.size();
    for (std::size_t i = 0; i < n; ++i) {
        HeadingData<Value> image = table.headings[i];
        image.heading = reduced(about_xz ? -image.heading : M_PI - image.heading);
        if (place_of_heading(table.headings, image.heading) < table.headings.size()) continue;
        for (Value& v : image.values) v = v.cwiseProduct(sign).eval();
        table.headings.push_back(std::move(image));
    }
}

bool looks_symmetric_about_xz(const WaveTable<CVec6>& table) {
    bool has_0 = false, has_180 = false;
    double across = 0.0, along = 0.0;  // [N]; moments against moments below
    double across_moment = 0.0, along_moment = 0.0;
    for (const auto& h : table.headings) {
        if (h.heading > M_PI + same_heading) return false;
        const bool at_0 = h.heading < same_heading,
                   at_180 = std::abs(h.heading - M_PI) < same_heading;
        has_0 = has_0 || at_0;
        has_180 = has_180 || at_180;
        if (!at_0 && !at_180) continue;
        for (const CVec6& v : h.values) {
            along = std::max({along, std::abs(v[0]), std::abs(v[2])});
            across = std::max(across, std::abs(v[1]));
            along_moment = std::max(along_moment, std::abs(v[4]));
            across_moment = std::max({across_moment, std::abs(v[3]), std::abs(v[5])});
        }
    }
    return has_0 && has_180 && across <= 1e-3 * along && across_moment <= 1e-3 * along_moment;
}

template void mirror(WaveTable<Vec6>&, bool);
template void mirror(WaveTable<CVec6>&, bool);

}  // namespace hawser::io
