// What a run says: progress, failing lines, the ledger's components.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "failure_message.hpp"
#include "platform_ledger.hpp"
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

TEST(PlatformLedger, HasHullLoadsAndFamiliesAndBeginsWhenTheStatisticsDo) {
    Case c = two_lines();
    c.lines.push_back(c.lines[0]);
    c.lines[2].family = "wave1";  // a family may be called like a load
    c.analysis.dynamics.statistics_from = 1.0;
    PlatformLedger ledger(c);
    HullLoads loads;
    loads[Load::wave1] = 3.0 * Vec6::Ones();
    loads[Load::lines] = 1e9 * Vec6::Ones();  // not counted twice
    Reply reply;
    reply.lines.resize(3);
    for (int i = 0; i < 3; ++i) reply.lines[std::size_t(i)].wrench.setConstant(std::pow(10.0, i));
    ledger.add(0.5, loads, reply, 1e9 * Vec6::Ones(), Vec3::Zero());
    EXPECT_FALSE(ledger.started());
    ledger.add(1.0, loads, reply, Vec6::Zero(), Vec3::Zero());
    ledger.add(3.0, loads, reply, 8.0 * Vec6::Ones(), Vec3::Zero());
    ASSERT_TRUE(ledger.started());
    const LedgerTable table = ledger.table();
    ASSERT_EQ(table.components.size(), 12U);
    EXPECT_EQ(table.components[10], "scr");
    EXPECT_EQ(table.components[11], "wave1");
    EXPECT_EQ(table.mean[0], Vec6(3.0 * Vec6::Ones()));
    EXPECT_EQ(table.mean[10], Vec6(11.0 * Vec6::Ones()));
    EXPECT_EQ(table.mean[11], Vec6(100.0 * Vec6::Ones()));
    EXPECT_EQ(table.momentum, Vec6(4.0 * Vec6::Ones()));
    EXPECT_EQ(table.from, 1.0);
    EXPECT_EQ(table.to, 3.0);
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
