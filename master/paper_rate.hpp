// One evaluation of P:2 in the paper's scheme: a pass of the lines and the platform's equation of
// motion at its end. P:2, P:3.
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

#include "lines.hpp"
#include "state.hpp"

namespace hawser::master {

/// A line that failed ends the run; the status says which and why.
struct LinesFailed : std::runtime_error {
    LinesFailed(Status what, int in_stage)
        : std::runtime_error("lines failed"), status(what), stage(in_stage) {}
    Status status;
    int stage;  ///< of the Runge-Kutta step, 1 to 4; 0: outside of a step
};

/// Sum of the lines' loads on the platform [N, N.m about O], always in line order: the same bits
/// for any number of ranks.
[[nodiscard]] inline Vec6 total_wrench(const Reply& reply) {
    Vec6 sum = Vec6::Zero();
    for (const LineLoad& line : reply.lines) sum += line.wrench;
    return sum;
}

/// The rate of change of the platform's state and all that led to it. `Platform` is a Hull or a
/// test double: `loads(t, s)` gives every load but the lines', `rate(t, s, loads, lines,
/// &acceleration)` solves the equation of motion.
template <class Platform>
class PaperRate {
 public:
    using Loads = decltype(std::declval<const Platform&>().loads(0.0, std::declval<State>()));
    /// Sees every evaluation that succeeds, in order: its stage (0: the static start, 1 to 4), its
    /// time [s] and its state. What led to it: loads(), reply() ...
    using Watch = std::function<void(int stage, double t, const State& s)>;

    /// @param static_reply the lines' loads at the static start, t = 0
    PaperRate(const Platform& platform, Lines& lines, const Reply& static_reply)
        : platform_(platform), lines_(lines), reply_(static_reply), wrench_(total_wrench(reply_)) {}

    /// At the static start: no pass, the lines' loads are the static ones.
    [[nodiscard]] State at_start(const State& y) {
        loads_ = platform_.loads(0.0, y);
        return watched(0, 0.0, y);
    }

    /// The state with every motion that is held or led in its place (K:20); unchanged where the
    /// platform knows of none.
    [[nodiscard]] State led(double t, State s) const {
        if constexpr (requires { platform_.led(t, s); }) return platform_.led(t, s);
        return s;
    }

    /// Sends the lines from their kept state at t0, where the platform is y, along the spline to s
    /// at t1; loads the hull meanwhile; solves the equation of motion at (t1, s).
    /// @param stage which evaluation of the step, 1 to 4, for messages
    [[nodiscard]] State operator()(int stage, double t0, const State& y, double t1,
                                   const State& at_t1) {
        const State s = led(t1, at_t1);
        next_.ask = Ask::run_to;
        next_.t0 = t0;
        next_.t1 = t1;
        next_.from = motion_of(y);
        next_.to = motion_of(s);
        lines_.send(next_);
        next_ = Order{};
        try {
            loads_ = platform_.loads(t1, s);
        } catch (...) {
            lines_.receive();  // every order is answered, also when the hull fails meanwhile
            throw;
        }
        const Reply& reply = lines_.receive();
        if (!reply.status.ok()) throw LinesFailed(reply.status, stage);
        reply_.lines = reply.lines;
        wrench_ = total_wrench(reply);
        return watched(stage, t1, s);
    }

    /// The pass that ended last is the one the lines keep: a flag in the next order, no message.
    void keep() { next_.keep_previous = true; }

    void watch(Watch watch) { watch_ = std::move(watch); }

    /// Flags that the next order carries (the recorder sets them).
    [[nodiscard]] Order& next() { return next_; }

    // Of the evaluation that was last.
    [[nodiscard]] const Loads& loads() const { return loads_; }
    [[nodiscard]] const Reply& reply() const { return reply_; }
    [[nodiscard]] const Vec6& lines_wrench() const { return wrench_; }
    [[nodiscard]] const Vec6& acceleration() const { return acceleration_; }

 private:
    /// The equation of motion, told to the watcher.
    State watched(int stage, double t, const State& s) {
        State rate = platform_.rate(t, s, loads_, wrench_, &acceleration_);
        if (watch_) watch_(stage, t, s);
        return rate;
    }

    const Platform& platform_;
    Lines& lines_;
    Order next_;
    Loads loads_{};
    Reply reply_;
    Vec6 wrench_, acceleration_ = Vec6::Zero();
    Watch watch_;
};

}  // namespace hawser::master
