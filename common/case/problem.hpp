// What is wrong or doubtful in a case: collected, never thrown one by one.
#pragma once

#include <string>
#include <vector>

namespace hawser {

enum class Severity { error, warning, note };

struct Problem {
    Severity severity = Severity::error;
    std::string path;     ///< of the key: lines.mooring.sections[1].type
    std::string message;  ///< found, expected, hint
    std::string file;     ///< empty: not known yet
    int line = 0, column = 0;
    /// Which of several things under one key: the line of a family. The same said of several is
    /// said once.
    std::string subject = {};

    bool operator==(const Problem&) const = default;
};

using Problems = std::vector<Problem>;

}  // namespace hawser
