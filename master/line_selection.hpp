// Lines that a command names by a glob.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace hawser::master {

/// Indices of the lines whose name the glob matches, in line order. Throws RunError (input) if
/// there are lines and it matches none, before anything has been computed.
std::vector<int> lines_called(const std::string& glob, const Case& input);

}  // namespace hawser::master
