// The case: what is recorded (case key `output`).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/lines.hpp"

namespace hawser {

/// Results of the lines whose name matches `select` (glob: * and ?).
struct LineOutput {
    std::string select = "*";
    bool end_a = true, end_b = false;
    std::vector<double> at_arc = {};  ///< further places, arc length from end A [m]
    /// What is recorded there, of constraints (`guide.force`) and of touchdown: words of the key
    std::vector<std::string> results{"effective_tension"};
    std::vector<std::string> range = {};  ///< quantities of which the course along the line is kept

    bool operator==(const LineOutput&) const = default;
};

/// What constraints report: size of the force and of the moment on the line, tension of a
/// tensioner, gap left, stroke, way slid.
enum class ConstraintResult { force, moment, tension, gap, stroke, slip };

/// A word of `results` that asks for it.
struct ConstraintWord {
    std::string_view word;
    ConstraintType type;
    ConstraintResult result;
};
inline constexpr std::array<ConstraintWord, 16> constraint_words{{
    {"tensioner.tension", ConstraintType::tensioner, ConstraintResult::tension},
    {"tensioner.stroke", ConstraintType::tensioner, ConstraintResult::stroke},
    {"guide.force", ConstraintType::guide, ConstraintResult::force},
    {"guide.gap", ConstraintType::guide, ConstraintResult::gap},
    {"guide.slip", ConstraintType::guide, ConstraintResult::slip},
    {"slider.force", ConstraintType::slider, ConstraintResult::force},
    {"slider.gap", ConstraintType::slider, ConstraintResult::gap},
    {"slider.slip", ConstraintType::slider, ConstraintResult::slip},
    {"pull_tube.force", ConstraintType::pull_tube, ConstraintResult::force},
    {"pull_tube.gap", ConstraintType::pull_tube, ConstraintResult::gap},
    {"pull_tube.slip", ConstraintType::pull_tube, ConstraintResult::slip},
    {"ball_joint.force", ConstraintType::ball_joint, ConstraintResult::force},
    {"flex_joint.force", ConstraintType::flex_joint, ConstraintResult::force},
    {"flex_joint.moment", ConstraintType::flex_joint, ConstraintResult::moment},
    {"clamp.force", ConstraintType::clamp, ConstraintResult::force},
    {"clamp.moment", ConstraintType::clamp, ConstraintResult::moment},
}};

struct Output {
    double interval = 0.0;            ///< sampling [s], a multiple of the platform step (resolved)
    std::optional<double> snapshots;  ///< interval of node positions [s]
    bool platform_motions = true, platform_loads = false, environment = true;
    std::vector<LineOutput> lines;

    bool operator==(const Output&) const = default;
};

/// Does a name match a glob of * and ? ?
[[nodiscard]] constexpr bool matches(std::string_view glob, std::string_view name) {
    if (glob.empty()) return name.empty();
    if (glob.front() == '*')
        return matches(glob.substr(1), name) || (!name.empty() && matches(glob, name.substr(1)));
    return !name.empty() && (glob.front() == '?' || glob.front() == name.front()) &&
           matches(glob.substr(1), name.substr(1));
}

}  // namespace hawser
