// A run from the checked case to its result: set-up, static start, time loop, finish. The order of
// things and what is told to whom; the physics and the loop are elsewhere (paper_loop.hpp).
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "clocks.hpp"
#include "complain.hpp"
#include "equilibrium.hpp"
#include "failure_message.hpp"
#include "io/hydro_file.hpp"
#include "io/link.hpp"
#include "io/rank_times.hpp"
#include "io/result_fields.hpp"
#include "io/result_file.hpp"
#include "io/run_folder.hpp"
#include "io/summary.hpp"
#include "line_mesh.hpp"
#include "lines_loop.hpp"
#include "packing.hpp"
#include "paper_loop.hpp"
#include "performance.hpp"
#include "platform_ledger.hpp"
#include "progress.hpp"
#include "recorded_lines.hpp"
#include "recorder.hpp"
#include "remote_lines.hpp"
#include "roles.hpp"
#include "shares.hpp"
#include "static_start.hpp"
#include "stop_signal.hpp"

namespace hawser {

namespace master {
namespace {

constexpr int segment_samples = 256;      // samples between segments at most ...
constexpr double segment_seconds = 20.0;  // ... and wall clock

/// Everything of a run once its input has been found good.
class Simulation {
 public:
    Simulation(const Case& input, const RunRequest& request, io::Link& link, Hull* hull)
        : input_(input),
          request_(request),
          link_(link),
          hull_(hull),
          D_(input.analysis.dynamics.platform_step),
          n_steps_(static_cast<int>(std::ceil(input.analysis.dynamics.duration / D_ - 1e-9))),
          sea_(input.environment, input.analysis.dynamics.ramp, 0.0),
          results_(request.folder, io::result_fields(input, nodes_per_line(input)), link),
          recorder_(input, sea_, results_),
          computed_(make_lines()),
          lines_(*computed_, results_),
          ledger_(input),
          log_(request.folder),
          progress_(request.quiet ? ProgressStyle::none : request.progress, link.alone()),
          began_(wall_seconds()) {
        results_.reserve(segment_samples, segment_samples);
        for (const std::string& note : request.notes) log_.line(note);
        report(io::RunState::State::running, ExitCode::done, "");
    }

    ExitCode run() {
        try {
            if (hull_ != nullptr)
                coupled();
            else
                lines_alone();
            if (stopped_)
                end(io::RunState::State::stopped, ExitCode::stopped,
                    fmt::format("stopped at t = {:.2f} s on request", t_));
            else
                end(io::RunState::State::done, ExitCode::done, "done");
        } catch (const LinesFailed& failure) {
            end(io::RunState::State::failed, ExitCode::diverged,
                failure_message(failure.status, input_, failure.stage));
        } catch (const RunError& error) {
            end(io::RunState::State::failed, error.code(), error.what());
        }
        return code_;
    }

 private:
    std::unique_ptr<Lines> make_lines() {
        if (link_.alone()) {
            if (input_.lines.empty()) return std::make_unique<NoLines>();
            std::vector<int> all(packs_of(input_).size());
            for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
            return make_local_lines(input_, all, &results_);
        }
        auto remote = std::make_unique<RemoteLines>(link_, lines_of_ranks(input_, link_.size()));
        remote_ = remote.get();
        return remote;
    }

    void coupled() {
        const StaticStart start = static_start(input_, *hull_, lines_);
        for (const std::string& note : start.notes) warn(note);
        keep_statics(&start.equilibrium, start.lines);
        PaperRate<Hull> rate(*hull_, lines_, start.lines);
        begin_loop();
        paper_loop(rate, hull_->start(start.equilibrium, start.start), D_,
                   [&](int step, double t, const State& y) {
                       const PlatformMotion motion = motion_of(y);
                       if (recorder_.sample_due(step)) {
                           recorder_.sample(t);
                           recorder_.platform(y, rate.acceleration(), rate.loads());
                       }
                       ledger_.add(t, rate.loads(), rate.reply(), hull_->momentum(y),
                                   motion.velocity);
                       next_ = &rate.next();
                       return go_on(step, t, &motion, rate.reply());
                   });
    }

    void lines_alone() {
        const auto describe = [&](const Status& s) { return failure_message(s, input_, 0); };
        const Reply start =
            lines_at(lines_, PlatformMotion{}, input_.analysis.statics.current, describe);
        keep_statics(nullptr, start);
        begin_loop();
        Order next;
        next_ = &next;
        lines_loop(lines_, start, next, D_, [&](int step, double t, const Reply& reply) {
            if (recorder_.sample_due(step)) recorder_.sample(t);
            return go_on(step, t, nullptr, reply);
        });
    }

    /// Once a step: what the next order carries, what people see, and whether there is one.
    bool go_on(int step, double t, const PlatformMotion* motion, const Reply& reply) {
        t_ = t;
        next_->sample = recorder_.sample_due(step);
        next_->snapshot = recorder_.snapshot_due(step);
        if (next_->snapshot) recorder_.snapshot(t);
        const double now = wall_seconds();
        if (results_.segments() > segments_) {
            segments_ = results_.segments();
            log_.line(fmt::format("saved up to t = {:.2f} s", results_.saved_to()));
            report(io::RunState::State::running, ExitCode::done, "");
            last_segment_ = now;
        }
        next_->write_segment =
            results_.pending() >= segment_samples || now - last_segment_ >= segment_seconds;
        if (!request_.quiet) progress_.show(t, n_steps_ * D_, motion, reply, input_);
        const bool last = step == n_steps_;
        if (!last && (stop_signal() != 0 || stop_file(now))) stopped_ = true;
        if (last || stopped_) last_order_ = *next_;
        return !last && !stopped_;
    }

    /// A file STOP in the folder, looked for a few times a second.
    bool stop_file(double now) {
        if (now - last_look_ < 0.2) return false;
        last_look_ = now;
        return io::stop_requested(request_.folder);
    }

    void begin_loop() {
        loop_began_ = last_segment_ = wall_seconds();
        cpu_began_ = user_cpu_seconds();
        waited_before_ = remote_ != nullptr ? remote_->waited() : 0.0;
        in_loop_ = true;
    }

    /// All ranks write what they hold; the result is closed, whole or not.
    void end(io::RunState::State state, ExitCode code, std::string message) {
        const double loop = in_loop_ ? wall_seconds() - loop_began_ : 0.0;
        const double cpu = in_loop_ ? user_cpu_seconds() - cpu_began_ : 0.0;
        const double waited = remote_ != nullptr ? remote_->waited() - waited_before_ : 0.0;
        progress_.finish();
        last_order_.ask = Ask::stop;
        last_order_.write_segment = code != ExitCode::io;
        last_order_.t0 = last_order_.t1 = t_;
        const auto failing = [&](const RunError& error) {
            state = io::RunState::State::failed;
            code = error.code();
            message = error.what();
        };
        try {
            lines_.send(last_order_);
        } catch (const RunError& error) {  // alone: the last segment could not be written
            failing(error);
        }
        const std::vector<io::RankTimes> times =
            io::gather_times(link_, {.user_cpu = cpu, .busy = loop - waited, .waited = waited});
        try {
            report(state, code, message);
            log_.line(message);
            if (results_.segments() > 0) {
                io::RunRecord record = this->record(loop, times);
                record.complete = code == ExitCode::done;
                record.outcome = message;
                io::write_summary(request_.folder, record,
                                  io::write_result(request_.folder, record));
            }
        } catch (const RunError& error) {
            failing(error);
        }
        if (code != ExitCode::done) complain(message);
        if (code == ExitCode::io) try {
                report(state, code, message);
            } catch (const RunError&) {  // the folder cannot be written at all; that has been said
            }
        code_ = code;
        int agreed = static_cast<int>(code_);
        link_.broadcast(agreed);
    }

    io::RunRecord record(double loop, const std::vector<io::RankTimes>& times) const {
        io::RunRecord r;
        r.input = input_;
        r.resolved = request_.resolved;
        r.sources = request_.sources;
        r.version = request_.version;
        r.build = request_.build;
        r.command = request_.command;
        r.ranks = link_.size();
        r.statics = statics_;
        if (hull_ != nullptr) {
            if (ledger_.started()) r.ledger = ledger_.table();
            r.platform = {{"mass", "kg", "mass of the platform", hull_->mass()},
                          {"acting_buoyancy", "N", "buoyancy at the design draft in still water",
                           hull_->acting_buoyancy()}};
        }
        r.performance = performance_facts(times, t_, loop, lines_.orders());
        return r;
    }

    void keep_statics(const PlatformMotion* platform, const Reply& lines) {
        io::StaticState s;
        if (platform != nullptr) s.platform = *platform;
        for (const LineLoad& line : lines.lines) s.end_a_tension.push_back(line.end_tension);
        statics_ = std::move(s);
        log_.line("static start found");
    }

    void warn(const std::string& note) {
        if (!request_.quiet) std::fprintf(stderr, "warning: %s\n", note.c_str());
        log_.line("warning: " + note);
    }

    void report(io::RunState::State state, ExitCode code, const std::string& message) {
        io::write_status(request_.folder, {.state = state,
                                           .exit_code = code,
                                           .message = message,
                                           .t = t_,
                                           .saved_to = results_.saved_to(),
                                           .wall_s = wall_seconds() - began_});
    }

    const Case& input_;
    const RunRequest& request_;
    io::Link& link_;
    Hull* hull_;
    double D_;
    int n_steps_;
    Sea sea_;
    io::SeriesWriter results_;
    Recorder recorder_;
    RemoteLines* remote_ = nullptr;
    std::unique_ptr<Lines> computed_;
    RecordedLines lines_;
    PlatformLedger ledger_;
    io::RunLog log_;
    Progress progress_;
    std::optional<io::StaticState> statics_;
    Order* next_ = nullptr;
    Order last_order_;
    ExitCode code_ = ExitCode::done;
    double t_ = 0.0;
    bool stopped_ = false, in_loop_ = false;
    int segments_ = 0;
    double began_, loop_began_ = 0.0, cpu_began_ = 0.0, waited_before_ = 0.0;
    double last_segment_ = 0.0, last_look_ = 0.0;
};

/// What goes wrong in a rank's set-up is said there and becomes an exit code all ranks agree on.
template <class Work>
ExitCode attempt(const io::Link& link, Work&& work) {
    ExitCode code = ExitCode::done;
    try {
        work();
    } catch (const RunError& error) {
        complain(error.what());
        code = error.code();
    }
    return io::agree(link, code);
}

}  // namespace
}  // namespace master

ExitCode run_master(const Case& input, const RunRequest& request, io::Link& link) {
    std::unique_ptr<master::Hull> hull;
    std::optional<HydroData> hydro;
    std::unique_ptr<master::Simulation> simulation;
    ExitCode code = master::attempt(link, [&] {
        if (input.platform) {
            if (const auto& database = input.platform->hydrodynamics.database)
                hydro = io::read_hydro(*database, input.environment.water);
            hull = std::make_unique<master::Hull>(input, hydro ? &*hydro : nullptr);
        }
        io::prepare_run_folder(request.folder, request.force);
    });
    if (code != ExitCode::done) return code;
    code = master::attempt(link, [&] {
        simulation = std::make_unique<master::Simulation>(input, request, link, hull.get());
    });
    return code == ExitCode::done ? simulation->run() : code;
}

}  // namespace hawser
