#include "complain.hpp"

#include <cstdio>

namespace hawser {

void complain(const std::string& message) {
    const bool whole =
        message.find("error: ") != std::string::npos || message.starts_with("warning: ");
    std::fprintf(stderr, "%s%s%s", whole ? "" : "error: ", message.c_str(),
                 message.ends_with('\n') ? "" : "\n");
    std::fflush(stderr);
}

}  // namespace hawser
