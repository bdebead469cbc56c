// Natural modes for people (s, m, deg), and for scripts and pictures as JSON with the shapes.
#pragma once

#include <string>

#include "case/case.hpp"
#include "modes_report.hpp"

namespace hawser::io {

std::string modes_text(const Case& input, const ModesReport& report);

/// SI. Shapes of lines: displacement (x, y, z) of each node from end A, largest 1. For pictures
/// also hulls (members, plates, where they rest) and the platforms that lines end at.
std::string modes_json(const Case& input, const ModesReport& report);

/// One row per mode: of the platform, then line by line.
std::string modes_csv(const Case& input, const ModesReport& report);

}  // namespace hawser::io
