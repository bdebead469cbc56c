#include "line_selection.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include "status.hpp"

namespace hawser::master {

std::vector<int> lines_called(const std::string& glob, const Case& input) {
    std::vector<int> lines;
    for (std::size_t i = 0; i < input.lines.size(); ++i)
        if (fnmatch(glob.c_str(), input.lines[i].name.c_str(), 0) == 0)
            lines.push_back(static_cast<int>(i));
    if (lines.empty() && !input.lines.empty())
        throw RunError(ExitCode::input, fmt::format("no line is called \"{}\"; the first is \"{}\"",
                                                    glob, input.lines.front().name));
    return lines;
}

}  // namespace hawser::master
