// A run whose input is good: static start, time loop, end. The physics and the loops are elsewhere
// (hull.hpp, paper_loop.hpp, lines_loop.hpp); here is the order of things and what is recorded
// when.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hull.hpp"
#include "io/link.hpp"
#include "io/result_file.hpp"
#include "loop_clock.hpp"
#include "paper_rate.hpp"
#include "platform_ledger.hpp"
#include "progress.hpp"
#include "recorded_lines.hpp"
#include "recorder.hpp"
#include "remote_lines.hpp"
#include "roles.hpp"
#include "run_report.hpp"
#include "static_start.hpp"

namespace hawser::master {

class Simulation {
 public:
    /// @param hulls  the platforms of the case, in its order; empty: lines alone
    Simulation(const Case& input, const RunRequest& request, io::Link& link,
               std::vector<Hull>& hulls);

    /// The whole run. Whatever happens in it, every rank is told to stop and the result is closed.
    ExitCode run();

 private:
    std::unique_ptr<Lines> make_lines();

    void coupled();      ///< platforms and lines, P:3
    void lines_alone();  ///< no platform
    void keep_statics(const Poses& platforms, const Reply& lines);
    void keep_impulses(const Reply& lines);
    [[nodiscard]] std::vector<io::Fact> platform_facts(std::size_t k,
                                                       const StaticStart& start) const;
    [[nodiscard]] JointState first_state(const StaticStart& start) const;
    /// The state at t is final, and what led to it.
    void keep_step(int step, double t, const JointState& y,
                   const PaperRate<Hull, JointState>& rate);
    /// Once a step: what the next order carries, what people see, and whether there is one.
    bool go_on(int step, double t, Order& next, const Poses& platforms, const Reply& lines);

    // simulation_end.cpp
    /// All ranks write what they hold; the result is closed, whole or not; all learn the code.
    ExitCode end(ExitCode code, std::string message);
    void write_result(ExitCode code, const std::string& message,
                      const std::vector<io::RankTimes>& times);
    [[nodiscard]] io::RunRecord record(ExitCode code, const std::string& message,
                                       const std::vector<io::RankTimes>& times) const;
    [[nodiscard]] double waited() const { return remote_ != nullptr ? remote_->waited() : 0.0; }

    const Case& input_;
    const RunRequest& request_;
    io::Link& link_;
    std::vector<Hull>& hulls_;
    double D_;
    int n_steps_;
    Sea sea_;
    io::SeriesWriter results_;
    Recorder recorder_;
    RemoteLines* remote_ = nullptr;
    std::unique_ptr<Lines> computed_;
    RecordedLines lines_;
    std::vector<PlatformLedger> ledgers_;
    RunReport report_;
    StopRequest stop_;
    Progress progress_;
    LoopClock clock_;
    std::optional<io::StaticState> statics_;
    std::vector<std::vector<io::Fact>> platform_facts_;
    std::vector<std::string> doubts_;  ///< of the static start
    std::vector<io::ImpulseMismatch> impulses_;
    Order last_;  ///< the order that ends the run, with the flags of the last step
    double t_ = 0.0;
    bool stopped_ = false;
    int segments_ = 0;
    double last_segment_ = 0.0;
};

}  // namespace hawser::master
