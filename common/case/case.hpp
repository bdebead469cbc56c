// One simulation as plain values: what the case file says, every default filled in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/analysis.hpp"
#include "case/environment.hpp"
#include "case/lines.hpp"
#include "case/output.hpp"
#include "case/platform.hpp"

namespace hawser {

struct Case {
    std::string name;  ///< stem of the file name
    std::string title, description;
    Environment environment;
    std::optional<Platform> platform;
    std::vector<LineType> line_types;
    std::vector<Line> lines;  ///< line order: as declared, families expanded
    Analysis analysis;
    Output output;

    bool operator==(const Case&) const = default;
};

}  // namespace hawser
