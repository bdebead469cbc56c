// One way for every message of failure to reach the user.
#pragma once

#include <string>

namespace hawser {

/// Prints to stderr at once. A report of problems has its whole lines already (`file:line: error:
/// ...`), and so has a warning; any other message gets the word in front.
void complain(const std::string& message);

}  // namespace hawser
