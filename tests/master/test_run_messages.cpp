// What a run says: progress, failing lines.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "failure_message.hpp"
#include "progress.hpp"
#include "stop_signal.hpp"

namespace hawser::master {
namespace {

TEST(Progress, SaysTimePaceEndSurgeAndTheGreatestTension) {
    EXPECT_EQ(progress_line({.t = 1250.0,
                             .duration = 3600.0,
                             .wall = 541.1,
                             .surge = 31.16,
                             .tension = 5012.3e3,
                             .line = "ml6"}),
              "t 1250.0/3600.0 s  34.7 %  2.31x real time  ETA 00:16:57  surge 31.2 m  "
              "max T 5012 kN (ml6)");
    EXPECT_EQ(progress_line({.t = 5.0,
                             .duration = 10.0,
                             .wall = 0.4,
                             .surge = std::nullopt,
                             .tension = 0.0,
                             .line = ""}),
              "t 5.0/10.0 s  50.0 %  12.5x real time  ETA 00:00:00");
}

Case two_lines() {
    Case c;
    LineType pipe;
    pipe.name = "pipe";
    pipe.mass = 250.0;
    pipe.EA = 4e9;
    c.line_types = {pipe};
    Line line;
    line.name = "scr_oil";
    line.family = "scr";
    line.sections = {{.type = 0, .length = 1000.0, .elements = 100, .growth = 1.0}};
    c.lines = {line, line};
    c.lines[1].name = "scr_gas";
    c.analysis.dynamics.line_step = 0.02;
    return c;
}

TEST(FailureMessage, NamesLineTimeStageResidualPlaceAndCause) {
    const Status status = {.code = Status::Code::not_converged,
                           .line = 1,
                           .arc_length = 583.0,
                           .t = 31.24,
                           .residual = 0.21,
                           .iterations = 30};
    const std::string text = failure_message(status, two_lines(), 3);
    EXPECT_TRUE(text.starts_with(
        "scr_gas, t = 31.24 s, stage 3: Newton's position correction is still 0.21 m after "
        "30 iterations, largest at s = 583 m; likely cause: "))
        << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(failure_message(status, two_lines(), 0).find("stage"), std::string::npos);
}

TEST(FailureMessage, CflIsAxialWaveSpeedTimesStepOverElement) {
    // sqrt(4e9 / 250) = 4000 m/s; 4000 x 0.02 / 10 = 8
    EXPECT_NEAR(largest_cfl(two_lines().lines[0], two_lines()), 8.0, 1e-9);
}

TEST(StopSignalDeathTest, ASecondInterruptEndsAtOnceWithSeven) {
    EXPECT_EXIT(
        {
            watch_stop_signals();
            std::raise(SIGINT);
            std::raise(SIGTERM);
        },
        testing::ExitedWithCode(7), "");
}

TEST(StopSignalDeathTest, AWarningBeforeItDoesNot) {
    EXPECT_EXIT(
        {
            watch_stop_signals();
            std::raise(SIGUSR1);  // as a batch system sends it ahead of the end
            std::raise(SIGUSR1);
            std::raise(SIGTERM);
            std::_Exit(stop_signal() == SIGTERM ? 42 : 1);
        },
        testing::ExitedWithCode(42), "");
}

}  // namespace
}  // namespace hawser::master
