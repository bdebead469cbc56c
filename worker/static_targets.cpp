#include "static_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "packing.hpp"
#include "rod/rod_group.hpp"
#include "status.hpp"

namespace hawser::worker {

namespace {

using Goal = Adjustment::Goal;

constexpr double close_enough = 1e-7;       // relative tension, angle [rad], stroke [m]
constexpr double first_move = 1e-3;         // of the quantity, between the first two trials
constexpr double longest_move = 0.1;        // of the quantity, in one trial
constexpr double least = 0.05, most = 5.0;  // of the case's value: beyond is out of reach
constexpr int most_trials = 80;

/// The static line at trial values of its adjusted quantity.
class TrialLine {
 public:
    TrialLine(const Case& input, int line)
        : input_(input), sea_(still(input), 0.0, 0.0), line_(line) {
        for (const std::vector<int>& bundle : bundles_of(input))
            if (std::find(bundle.begin(), bundle.end(), line) != bundle.end()) bundle_ = bundle;
        const Line& its = input.lines[static_cast<std::size_t>(line)];
        found_ = {.line = line,
                  .quantity = its.target.adjust,
                  .section = its.target.section,
                  .before = adjusted_quantity(its)};
        if (its.target.pretension) {
            found_.goal = Goal::pretension;
            found_.target = *its.target.pretension;
        } else if (its.target.hang_off_angle) {
            found_.goal = Goal::hang_off_angle;
            found_.target = *its.target.hang_off_angle;
        } else {
            const auto& all = its.constraints;
            const auto tensioner = std::find_if(all.begin(), all.end(), [](const auto& c) {
                return c.type == ConstraintType::tensioner;
            });
            if (tensioner == all.end())
                throw RunError(ExitCode::input,
                               fmt::format("{}: {} is to be adjusted, but there is neither a "
                                           "pretension, a hang-off angle nor a tensioner to meet",
                                           its.name, quantity_text(found_)));
            tensioner_ = static_cast<int>(tensioner - all.begin());
            found_.target = tensioner->nominal_tension;
        }
    }

    [[nodiscard]] const Adjustment& asked() const { return found_; }

    /// How far the goal is missed at this value; empty where there is no static solution. Of
    /// tensions the logarithm: it is nearly straight in the stretch of a taut line.
    std::optional<double> miss(double value) {
        adjust(input_, line_, value);
        for (const bool guessed : {true, false}) {  // from the last shape, else from the catenary
            if (guessed && shapes_.empty()) continue;
            std::vector<RodPack<Single>> rods;
            rods.reserve(bundle_.size());  // the group refers to them
            for (const int line : bundle_) rods.emplace_back(input_, sea_, std::vector<int>{line});
            for (std::size_t i = 0; guessed && i < rods.size(); ++i)
                rods[i].set_guess(0, shapes_[i]);
            RodGroup<Single> group{std::span(rods)};
            if (!group.equilibrium(rods.front().design(), false).ok()) continue;
            shapes_.clear();
            for (const RodPack<Single>& rod : rods) shapes_.push_back(rod.found_shape(0));
            return miss_of(rods[its_place()]);
        }
        return {};
    }

    /// The goal's own quantity at the trial that came nearest, for people.
    [[nodiscard]] std::string best() const {
        if (!best_) return "no static solution was found";
        const double value = *best_;
        const std::string got =
            found_.goal == Goal::stroke       ? fmt::format("a stroke of {:.4g} m", value)
            : found_.goal == Goal::pretension ? fmt::format("{:.5g} kN", value / 1e3)
                                              : fmt::format("{:.4g} deg", value * 180.0 / M_PI);
        return fmt::format("the nearest is {} at {:.6g} m", got, best_at_);
    }

 private:
    static Environment still(const Case& input) {
        Environment water = input.environment;
        water.waves.clear();
        water.current.reset();
        return water;
    }

    [[nodiscard]] std::size_t its_place() const {
        return static_cast<std::size_t>(std::find(bundle_.begin(), bundle_.end(), line_) -
                                        bundle_.begin());
    }

    double miss_of(const RodPack<Single>& rod) {
        double value = 0.0, miss = 0.0;
        if (found_.goal == Goal::stroke) {
            value = miss = rod.constraint_opening(0, tensioner_);
        } else if (found_.goal == Goal::hang_off_angle) {
            const Vec3 u = rod.direction_a(0);
            value = std::atan2(std::hypot(u.x(), u.y()), -u.z());
            miss = value - found_.target;
        } else {
            value = rod.tension_a(0);
            constexpr double knee = 0.05;  // below it a straight line of the same slope
            const double q = value / found_.target;
            miss = q > knee ? std::log(q) : std::log(knee) + (q - knee) / knee;
        }
        if (!best_ || std::abs(miss) < least_miss_) {
            least_miss_ = std::abs(miss);
            best_ = value;
            best_at_ = adjusted_quantity(input_.lines[static_cast<std::size_t>(line_)]);
        }
        return miss;
    }

    Case input_;
    Sea sea_;
    int line_;
    int tensioner_ = -1;
    Adjustment found_;
    std::vector<int> bundle_;  ///< the line and all that it is tied to
    std::vector<std::vector<CatenaryNode>> shapes_;
    std::optional<double> best_;
    double best_at_ = 0.0, least_miss_ = 0.0;
};

[[noreturn]] void out_of_reach(const TrialLine& trial, const Case& input, const char* cause) {
    const Adjustment& a = trial.asked();
    throw RunError(
        ExitCode::no_equilibrium,
        fmt::format("{}: its static target of {} is out of reach by adjusting {}, {:.6g} m in the "
                    "case: {}; likely cause: {}",
                    input.lines[static_cast<std::size_t>(a.line)].name, target_text(a),
                    quantity_text(a), a.before, trial.best(), cause));
}

/// Root of the miss: secants, kept inside the bracket once there is one; a trial without a static
/// solution goes half the way back.
double meet(TrialLine& trial, const Case& input) {
    struct Point {
        double x, y;
    };
    const double x0 = trial.asked().before;
    std::optional<Point> last;
    for (const double factor : {1.0, 0.995, 1.005, 0.99, 1.01, 0.98, 1.02, 0.95, 1.05}) {
        if (const auto y = trial.miss(x0 * factor)) {
            last = Point{x0 * factor, *y};
            break;
        }
    }
    if (!last)
        out_of_reach(trial, input,
                     "a line too short or too long for its ends, or a platform or anchor in the "
                     "wrong place");
    std::optional<Point> before, low, high;  // the trial before; the bracket: y < 0, y > 0
    for (int i = 0; i < most_trials; ++i) {
        if (std::abs(last->y) <= close_enough) return last->x;
        (last->y < 0.0 ? low : high) = *last;
        double x = 0.0;
        if (!before) {
            x = last->x + first_move * x0;
        } else {
            const double slope = (last->y - before->y) / (last->x - before->x);
            if (slope == 0.0)
                out_of_reach(trial, input, "the quantity adjusted does not change the target");
            x = last->x - last->y / slope;
        }
        if (low && high) {
            const double a = std::min(low->x, high->x), b = std::max(low->x, high->x);
            if (!(x > a && x < b)) x = 0.5 * (a + b);
            if (b - a < 1e-12 * x0)
                out_of_reach(trial, input, "the line jumps from one shape to another there");
        }
        x = std::clamp(x, last->x - longest_move * x0, last->x + longest_move * x0);
        if (x < least * x0 || x > most * x0)
            out_of_reach(trial, input,
                         "the target cannot be had with any sensible value of what is adjusted");
        std::optional<double> y = trial.miss(x);
        for (int half = 0; half < 20 && !y; ++half) {
            x = 0.5 * (x + last->x);
            y = trial.miss(x);
        }
        if (!y || x == last->x)
            out_of_reach(trial, input,
                         "there is no static solution nearer to it: the line would be too short, "
                         "too long or slack");
        before = last;
        last = Point{x, *y};
    }
    out_of_reach(trial, input, "the quantity adjusted hardly changes the target");
}

}  // namespace

std::vector<Adjustment> find_adjustments(const Case& input) {
    std::vector<Adjustment> found;
    for (int i = 0; i < static_cast<int>(input.lines.size()); ++i) {
        const Line& line = input.lines[static_cast<std::size_t>(i)];
        if (line.target.adjust == StaticTarget::Adjust::none) continue;
        TrialLine trial(input, i);
        Adjustment a = trial.asked();
        a.found = meet(trial, input);
        found.push_back(a);
    }
    return found;
}

}  // namespace hawser::worker
