// Problems of a case as the user sees them: one line each, `file:line:column: error: path: text`.
#pragma once

#include <string>

#include "case/problem.hpp"
#include "status.hpp"

namespace hawser::io {

/// The case cannot be run; the message lists every error and warning and ends with their count.
class InputError : public RunError {
 public:
    explicit InputError(Problems problems);
    [[nodiscard]] const Problems& problems() const { return problems_; }

 private:
    Problems problems_;
};

/// `file:line:column: error: path: message`.
std::string format(const Problem& problem);

/// "3 errors, 1 warning."
std::string count(const Problems& problems);

/// Sorts by place and drops repetitions (one mistake in a family shows in each of its lines).
void tidy(Problems& problems);

bool has_errors(const Problems& problems);

}  // namespace hawser::io
