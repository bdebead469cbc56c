// How a run can end, and what a failing rod says about itself.
#pragma once

#include <stdexcept>
#include <string>

namespace hawser {

/// Exit codes of the program (README.md).
enum class ExitCode : int {
    done = 0,
    bug = 1,
    command_line = 2,
    input = 3,
    no_equilibrium = 4,
    diverged = 5,
    io = 6,
    stopped = 7,
};

/// What became of the rods' part of an order. Travels in every reply; trivially copyable.
struct Status {
    enum class Code : int { ok = 0, not_converged, not_finite, no_equilibrium, false_equilibrium };
    Code code = Code::ok;
    int line = -1;            ///< index of the line, in line order; -1: none
    double arc_length = 0.0;  ///< where the residual is largest, from end A [m]
    double t = 0.0;           ///< simulated time [s]
    double residual = 0.0;    ///< largest nodal position correction left [m]
    int iterations = 0;

    [[nodiscard]] bool ok() const { return code == Code::ok; }
};

/// Failure of a run with the exit code it ends with; the message is complete and for the user.
class RunError : public std::runtime_error {
 public:
    RunError(ExitCode code, const std::string& message)
        : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

 private:
    ExitCode code_;
};

}  // namespace hawser
