// Tables for people: columns as wide as what stands in them, heads and units above.
#pragma once

#include <string>
#include <vector>

namespace hawser::io {

/// A number with so many decimals, without "-0.0"; a dash if there is none (NaN).
std::string number(double x, int decimals);

/// A number with so many significant digits, e.g. 1.234e+08; a dash for NaN.
std::string digits(double x, int significant = 5);

class TextTable {
 public:
    /// A column; `units` may be empty. The first column stands at the left, the rest at the right.
    void column(const std::string& head, const std::string& units = "");
    void row(std::vector<std::string> cells);
    [[nodiscard]] std::string text() const;

 private:
    std::vector<std::string> heads_, units_;
    std::vector<std::vector<std::string>> rows_;
};

/// A title underlined, with an empty line above.
std::string title(const std::string& text);

}  // namespace hawser::io
