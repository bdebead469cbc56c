// The nearest known word to a mistyped one.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/declared.hpp"

namespace hawser {
namespace {

/// Number of letters to insert, delete, change or swap with their neighbour.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = std::tolower(static_cast<unsigned char>(a[i - 1])) ==
                              std::tolower(static_cast<unsigned char>(b[j - 1]));
            d[i][j] =
                std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
    const std::string* nearest = nullptr;
    std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const bool contained = word.size() >= 3 && candidate.find(word) != std::string::npos;
        const std::size_t d = contained ? 1 : distance(word, candidate);
        if (d < least && d < candidate.size()) {
            least = d;
            nearest = &candidate;
        }
    }
    if (nearest != nullptr) return fmt::format("; did you mean \"{}\"?", *nearest);
    if (known.empty()) return "; none is defined";
    if (known.size() > 12) return {};
    return fmt::format("; known: {}", fmt::join(known, ", "));
}

}  // namespace hawser
