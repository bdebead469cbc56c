// One evaluation of P:2 in the paper's scheme: a pass of the lines and the platform's equation of
// motion at its end. P:2, P:3.
#pragma once

#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

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

/// Sum of the lines' loads on platform k [N, N.m about its O], always in line order: the same bits
/// for any number of ranks.
[[nodiscard]] inline Vec6 total_wrench(const Reply& reply, int k = 0) {
    Vec6 sum = Vec6::Zero();
    for (const LineLoad& line : reply.lines)
        if (const Vec6* wrench = line.on(k)) sum += *wrench;
    return sum;
}

/// The rate of change of the state of one platform or of several and all that led to it.
/// `Platform` is a Hull or a test double: `loads(t, s)` gives every load but the lines',
/// `rate(t, s, loads, lines, &acceleration)` solves the equation of motion. Platforms act on each
/// other by lines alone.
/// @tparam Y  State of one platform, or JointState of several
template <class Platform, class Y = State>
class PaperRate {
 public:
    using Loads = decltype(std::declval<const Platform&>().loads(0.0, std::declval<State>()));
    /// Sees every evaluation that succeeds, in order: its stage (0: the static start, 1 to 4), its
    /// time [s] and its state. What led to it: loads(), reply() ...
    using Watch = std::function<void(int stage, double t, const Y& s)>;

    /// @param static_reply the lines' loads at the static start, t = 0
    PaperRate(const Platform& platform, Lines& lines, const Reply& static_reply)
        : PaperRate(std::vector<const Platform*>{&platform}, lines, static_reply) {}
    /// @param platforms  in the order of the case, at most most_platforms
    PaperRate(std::vector<const Platform*> platforms, Lines& lines, const Reply& static_reply)
        : platforms_(std::move(platforms)), lines_(lines), reply_(static_reply) {
        acceleration_.fill(Vec6::Zero());
        add_up(reply_);
    }

    /// At the static start: no pass, the lines' loads are the static ones.
    [[nodiscard]] Y at_start(const Y& y) {
        load(0.0, y);
        return watched(0, 0.0, y);
    }

    /// The state with every motion that is held or led in its place (K:20); unchanged where the
    /// platform knows of none.
    [[nodiscard]] Y led(double t, Y s) const {
        if constexpr (requires(State one) { platforms_[0]->led(t, one); })
            for (std::size_t k = 0; k < platforms_.size(); ++k)
                set_state(s, k, platforms_[k]->led(t, state_of(s, static_cast<int>(k))));
        return s;
    }

    /// Sends the lines from their kept state at t0, where the platform is y, along the spline to s
    /// at t1; loads the hull meanwhile; solves the equation of motion at (t1, s).
    /// @param stage which evaluation of the step, 1 to 4, for messages
    [[nodiscard]] Y operator()(int stage, double t0, const Y& y, double t1, const Y& at_t1) {
        const Y s = led(t1, at_t1);
        next_.ask = Ask::run_to;
        next_.t0 = t0;
        next_.t1 = t1;
        for (std::size_t k = 0; k < platforms_.size(); ++k) {
            next_.from[k] = motion_of(state_of(y, static_cast<int>(k)));
            next_.to[k] = motion_of(state_of(s, static_cast<int>(k)));
        }
        lines_.send(next_);
        next_ = Order{};
        try {
            load(t1, s);
        } catch (...) {
            lines_.receive();  // every order is answered, also when the hull fails meanwhile
            throw;
        }
        const Reply& reply = lines_.receive();
        if (!reply.status.ok()) throw LinesFailed(reply.status, stage);
        reply_.lines = reply.lines;
        add_up(reply);
        return watched(stage, t1, s);
    }

    /// The pass that ended last is the one the lines keep: a flag in the next order, no message.
    void keep() { next_.keep_previous = true; }

    void watch(Watch watch) { watch_ = std::move(watch); }

    /// Flags that the next order carries (the recorder sets them).
    [[nodiscard]] Order& next() { return next_; }

    // Of the evaluation that was last, of platform k.
    [[nodiscard]] const Loads& loads(std::size_t k = 0) const { return loads_[k]; }
    [[nodiscard]] const Reply& reply() const { return reply_; }
    [[nodiscard]] const Vec6& lines_wrench(std::size_t k = 0) const { return wrench_[k]; }
    [[nodiscard]] const Vec6& acceleration(std::size_t k = 0) const { return acceleration_[k]; }

 private:
    void load(double t, const Y& s) {
        for (std::size_t k = 0; k < platforms_.size(); ++k)
            loads_[k] = platforms_[k]->loads(t, state_of(s, static_cast<int>(k)));
    }
    void add_up(const Reply& reply) {
        for (std::size_t k = 0; k < platforms_.size(); ++k)
            wrench_[k] = total_wrench(reply, static_cast<int>(k));
    }
    State rate_of(std::size_t k, double t, const State& s) {
        return platforms_[k]->rate(t, s, loads_[k], wrench_[k], &acceleration_[k]);
    }

    /// The equations of motion, told to the watcher.
    Y watched(int stage, double t, const Y& s) {
        Y rate = s;  // of its size
        for (std::size_t k = 0; k < platforms_.size(); ++k)
            set_state(rate, k, rate_of(k, t, state_of(s, static_cast<int>(k))));
        if (watch_) watch_(stage, t, s);
        return rate;
    }

    static void set_state(Y& of, std::size_t k, const State& one) {
        if constexpr (std::is_same_v<Y, State>)
            of = one;
        else
            of.template segment<state_numbers>(static_cast<Eigen::Index>(k) * state_numbers) = one;
    }

    std::vector<const Platform*> platforms_;
    Lines& lines_;
    Order next_;
    PerPlatform<Loads> loads_{};
    Reply reply_;
    PerPlatform<Vec6> wrench_, acceleration_;
    Watch watch_;
};

}  // namespace hawser::master
