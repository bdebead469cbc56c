#include "io/option_numbers.hpp"

#include <cmath>
#include <sstream>

namespace hawser::io {

std::optional<double> number_of(const std::string& text) {
    std::size_t used = 0;
    try {
        const double value = std::stod(text, &used);
        if (used == text.size() && std::isfinite(value)) return value;
    } catch (const std::exception&) {
    }
    return std::nullopt;
}

std::optional<std::vector<double>> numbers_of(const std::string& text, char separator) {
    std::vector<double> out;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, separator);) {
        const std::optional<double> number = number_of(word);
        if (!number) return std::nullopt;
        out.push_back(*number);
    }
    if (out.empty() || text.back() == separator) return std::nullopt;
    return out;
}

}  // namespace hawser::io
