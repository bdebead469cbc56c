// What statics found so that a line meets its target (case keys `pretension`, `hang_off_angle`,
// `nominal_tension` with `adjust`), and how the case changes with it: every rank applies the same
// numbers.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace hawser {

/// One found quantity of one line.
struct Adjustment {
    enum class Goal { pretension, hang_off_angle, stroke };
    int line = 0;  ///< index into Case::lines
    StaticTarget::Adjust quantity = StaticTarget::Adjust::none;
    int section = 0;           ///< whose length was adjusted
    double before = 0.0;       ///< what the case says [m]
    double found = 0.0;        ///< [m]
    Goal goal = Goal::stroke;  ///< what it was adjusted for
    double target = 0.0;       ///< [N], [rad]; of a stroke its nominal tension [N]

    bool operator==(const Adjustment&) const = default;
};

/// The quantity that a line's target adjusts, as it stands in the case: length of a section, or
/// horizontal distance of end B from the platform's axis [m].
[[nodiscard]] double adjusted_quantity(const Line& line);

/// Gives it another value. With a section's length, what is attached to the line at or beyond the
/// end of that section moves along with it. An end B keeps its azimuth, and one on the bed stays on
/// the bed.
void adjust(Case& input, int line, double value);

/// Puts what was found into the case.
void carry_out(const std::vector<Adjustment>& found, Case& input);

/// For people, e.g. "ttr1: section 5 is 1299.10 m, 0.90 m shorter, for 5338 kN at stroke 0".
[[nodiscard]] std::string note_of(const Adjustment& found, const Case& input);
/// The target alone: "5338 kN at stroke 0".
[[nodiscard]] std::string target_text(const Adjustment& found);
/// The quantity alone: "section 5", "anchor radius".
[[nodiscard]] std::string quantity_text(const Adjustment& found);

}  // namespace hawser
