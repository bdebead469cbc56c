#include "simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <span>

#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "io/result_fields.hpp"
#include "lines_loop.hpp"
#include "motion_names.hpp"
#include "packing.hpp"
#include "paper_loop.hpp"
#include "shares.hpp"

namespace hawser::master {

namespace {
constexpr double segment_seconds = 20.0;  // ... and wall clock
}  // namespace

Simulation::Simulation(const Case& input, const RunRequest& request, io::Link& link,
                       std::vector<Hull>& hulls)
    : input_(input),
      request_(request),
      link_(link),
      hulls_(hulls),
      D_(input.analysis.dynamics.platform_step),
      n_steps_(static_cast<int>(std::ceil(input.analysis.dynamics.duration / D_ - 1e-9))),
      sea_(input.environment, input.analysis.dynamics.ramp, 0.0),
      results_(request.folder, io::result_fields(input, nodes_per_line(input)), link),
      recorder_(input, sea_, results_),
      computed_(make_lines()),
      lines_(*computed_, results_),
      report_(request),
      stop_(request),
      progress_(request.quiet ? ProgressStyle::none : request.progress, link.alone()) {
    for (int k = 0; k < input.platform_count(); ++k) ledgers_.emplace_back(input, k);
    results_.reserve(io::segment_samples, io::segment_samples);
    report_.running(0.0, 0.0);
}

std::unique_ptr<Lines> Simulation::make_lines() {
    if (!link_.alone()) {
        auto remote =
            std::make_unique<RemoteLines>(link_, lines_of_ranks(input_, link_.size()),
                                          input_.platform_count(), touched_platforms(input_));
        remote_ = remote.get();
        return remote;
    }
    if (input_.lines.empty()) return std::make_unique<NoLines>();
    std::vector<int> all(packs_of(input_).size());
    std::iota(all.begin(), all.end(), 0);
    return make_local_lines(input_, all, &results_);
}

ExitCode Simulation::run() {
    try {
        if (!hulls_.empty())
            coupled();
        else
            lines_alone();
        return stopped_
                   ? end(ExitCode::stopped, fmt::format("stopped at t = {:.2f} s on request", t_))
                   : end(ExitCode::done, "done");
    } catch (const LinesFailed& failure) {
        return end(ExitCode::diverged, failure_message(failure.status, input_, failure.stage));
    } catch (const RunError& error) {
        return end(error.code(), error.what());
    }
}

void Simulation::coupled() {
    const StaticStart start = static_start(input_, hulls_, lines_);
    for (const std::string& note : start.notes) report_.warn(note);
    doubts_ = start.notes;
    keep_statics(start.equilibrium, start.at_rest);
    std::vector<const Hull*> platforms;
    for (std::size_t k = 0; k < hulls_.size(); ++k) {
        platform_facts_.push_back(platform_facts(k, start));
        platforms.push_back(&hulls_[k]);
    }
    PaperRate<Hull, JointState> rate(platforms, lines_, start.lines);
    rate.watch([&](int stage, double t, const JointState& y) {
        for (std::size_t k = 0; k < hulls_.size(); ++k) {
            const State s = state_of(y, static_cast<int>(k));
            ledgers_[k].add(stage, t, rate.loads(k), rate.reply(), hulls_[k].momentum(s),
                            motion_of(s).velocity);
        }
    });
    clock_.start(waited());
    paper_loop(rate, first_state(start), D_, [&](int step, double t, const JointState& y) {
        keep_step(step, t, y, rate);
        return go_on(step, t, rate.next(), poses_of(y), rate.reply());
    });
}

void Simulation::lines_alone() {
    const auto describe = [&](const Status& s, const Poses& poses) {
        return failure_message(s, input_, 0, poses);
    };
    const Reply start = lines_at(lines_, {}, input_.analysis.statics.current, describe);
    keep_statics({}, start);
    Order next;
    clock_.start(waited());
    lines_loop(lines_, start, next, D_, [&](int step, double t, const Reply& reply) {
        if (recorder_.sample_due(step)) recorder_.sample(t);
        return go_on(step, t, next, {}, reply);
    });
}

JointState Simulation::first_state(const StaticStart& start) const {
    JointState y(static_cast<Eigen::Index>(hulls_.size()) * state_numbers);
    for (std::size_t k = 0; k < hulls_.size(); ++k)
        y.segment<state_numbers>(static_cast<Eigen::Index>(k) * state_numbers) =
            hulls_[k].start(start.equilibrium[k], start.start[k]);
    return y;
}

void Simulation::keep_step(int step, double t, const JointState& y,
                           const PaperRate<Hull, JointState>& rate) {
    const bool sample = recorder_.sample_due(step);
    if (sample) recorder_.sample(t);
    for (std::size_t k = 0; k < hulls_.size(); ++k) {
        const State its = state_of(y, static_cast<int>(k));
        hulls_[k].remember(t, its, rate.acceleration(k));
        if (sample) recorder_.platform(k, its, rate.acceleration(k), rate.loads(k));
    }
}

void Simulation::keep_statics(const Poses& platforms, const Reply& lines) {
    statics_.emplace();
    statics_->platforms.assign(platforms.begin(),
                               platforms.begin() + static_cast<long>(hulls_.size()));
    for (const LineLoad& line : lines.lines) statics_->end_a_tension.push_back(line.end_tension);
    report_.log("static start found");
    last_segment_ = wall_seconds();
}

void Simulation::keep_impulses(const Reply& lines) {
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const LineLoad& load = lines.lines[i];
        if (load.mismatch_at < 0) continue;
        const Line& line = input_.lines[i];
        const auto c = static_cast<std::size_t>(load.mismatch_at);
        impulses_.push_back({line.name + "/" + line.constraints[c].name, load.impulse_mismatch});
        if (load.impulse_mismatch > io::large_mismatch)
            report_.warn(
                fmt::format("{}: rod and platform took impulses that differ by {:.1f} % (R:40); a "
                            "shorter platform step or force: impulse_matched brings them together",
                            impulses_.back().constraint, 100.0 * load.impulse_mismatch));
    }
}

std::vector<io::Fact> Simulation::platform_facts(std::size_t k, const StaticStart& start) const {
    const Hull& hull = hulls_[k];
    std::vector<io::Fact> facts = {
        {"mass", "kg", "mass of the platform", hull.mass()},
        {"acting_buoyancy", "N", "buoyancy at the design draft in still water",
         hull.acting_buoyancy()}};
    if (!input_.lines.empty())
        facts.push_back({"vertical_line_load", "N", "pull of the lines at the design position",
                         start.vertical_line_load[k]});
    const Stability& stands = start.stability[k];
    if (hull.acting_buoyancy() > 0.0) {
        facts.push_back({"hull_GM_roll", "m", "GM of the hull alone (weight and buoyancy), roll",
                         stands.hull_GM_roll});
        facts.push_back({"hull_GM_pitch", "m", "GM of the hull alone (weight and buoyancy), pitch",
                         stands.hull_GM_pitch});
    }
    const double frequency = hull.radiation().frequency;
    if (frequency > 0.0)
        facts.push_back({"added_mass_frequency", "rad/s",
                         "constant added mass and damping taken at", frequency});
    const MemoryFit& memory = hull.memory();
    if (!memory.oscillators.empty()) {
        facts.push_back({"memory_oscillators", "1", "oscillators that hold the memory of radiation",
                         static_cast<double>(memory.oscillators.size())});
        facts.push_back({"memory_error", "1",
                         "rms error of their fit to the database, part of its rms",
                         memory.rms_error});
    }
    const char* with = input_.lines.empty() ? "" : ", lines with their inertia";
    for (const CoupledMode& mode : start.modes) {
        if (mode.platform != static_cast<int>(k)) continue;
        const std::string motion = motion_names[static_cast<std::size_t>(mode.motion)];
        if (const auto period = mode.period())
            facts.push_back(
                {"period_" + motion, "s", "natural period in " + motion + with, *period});
    }
    return facts;
}

bool Simulation::go_on(int step, double t, Order& next, const Poses& platforms,
                       const Reply& lines) {
    t_ = t;
    next.sample = recorder_.sample_due(step);
    next.snapshot = recorder_.snapshot_due(step);
    if (next.snapshot) recorder_.snapshot(t);
    const double now = wall_seconds();
    if (results_.segments() > segments_) {
        segments_ = results_.segments();
        last_segment_ = now;
        report_.log(fmt::format("saved up to t = {:.2f} s", results_.saved_to()));
        report_.running(t, results_.saved_to());
    }
    next.write_segment =
        results_.pending() >= io::segment_samples || now - last_segment_ >= segment_seconds;
    progress_.show(t, n_steps_ * D_, std::span(platforms).first(hulls_.size()), lines, input_);

    const bool finished = step == n_steps_;
    stopped_ = !finished && stop_.made();
    if (finished || stopped_) {
        last_ = next;
        if (!hulls_.empty()) keep_impulses(lines);
    }
    return !finished && !stopped_;
}

}  // namespace hawser::master
