#include "io/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::io {

std::string number(double x, int decimals) {
    if (!std::isfinite(x)) return "-";
    if (std::abs(x) < 0.5 * std::pow(10.0, -decimals)) x = 0.0;
    return fmt::format("{:.{}f}", x, decimals);
}

std::string digits(double x, int significant) {
    if (!std::isfinite(x)) return "-";
    return fmt::format("{:.{}g}", x == 0.0 ? 0.0 : x, significant);
}

void TextTable::column(const std::string& head, const std::string& units) {
    heads_.push_back(head);
    units_.push_back(units);
}

void TextTable::row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

std::string TextTable::text() const {
    std::vector<std::size_t> width;
    for (std::size_t c = 0; c < heads_.size(); ++c) {
        width.push_back(std::max(heads_[c].size(), units_[c].size()));
        for (const auto& row : rows_) width[c] = std::max(width[c], row[c].size());
    }
    std::string out;
    const auto add = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t c = 0; c < cells.size(); ++c)
            line += c == 0 ? fmt::format("{:<{}}", cells[c], width[c])
                           : fmt::format("  {:>{}}", cells[c], width[c]);
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    };
    add(heads_);
    if (std::any_of(units_.begin(), units_.end(), [](const auto& u) { return !u.empty(); }))
        add(units_);
    for (const auto& row : rows_) add(row);
    return out;
}

std::string title(const std::string& text) {
    return fmt::format("\n{}\n{}\n", text, std::string(text.size(), '-'));
}

}  // namespace hawser::io
