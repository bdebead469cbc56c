// Numbers as they stand on the command line, without units.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hawser::io {

/// None unless the whole text is one finite number.
std::optional<double> number_of(const std::string& text);

/// None unless the whole text is numbers with the separator between them.
std::optional<std::vector<double>> numbers_of(const std::string& text, char separator);

}  // namespace hawser::io
