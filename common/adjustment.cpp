#include "adjustment.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser {

double adjusted_quantity(const Line& line) {
    if (line.target.adjust == StaticTarget::Adjust::anchor_radius)
        return std::hypot(line.end_b.position.x() - line.radii_from.x(),
                          line.end_b.position.y() - line.radii_from.y());
    return line.sections.at(static_cast<std::size_t>(line.target.section)).length;
}

void adjust(Case& input, int index, double value) {
    Line& line = input.lines[static_cast<std::size_t>(index)];
    const double change = value - adjusted_quantity(line);
    if (line.target.adjust == StaticTarget::Adjust::anchor_radius) {
        Vec3& b = line.end_b.position;
        const double before = adjusted_quantity(line);
        const double above = b.z() - input.environment.seabed.height(b.x(), b.y());
        b.head<2>() = line.radii_from.head<2>() + value / before * (b - line.radii_from).head<2>();
        if (line.end_b.kind == EndKind::anchor)
            b.z() = input.environment.seabed.height(b.x(), b.y()) + above;
        return;
    }
    double end = 0.0;
    for (int i = 0; i <= line.target.section; ++i)
        end += line.sections[static_cast<std::size_t>(i)].length;
    line.sections[static_cast<std::size_t>(line.target.section)].length = value;
    const double at_least = end - 1e-6;
    for (Attachment& a : line.attachments)
        if (a.arc_length >= at_least) a.arc_length += change;
    for (LineConstraint& c : line.constraints)
        if (c.arc_length && *c.arc_length >= at_least) *c.arc_length += change;
    for (Line& other : input.lines)
        for (LineConstraint& c : other.constraints)
            if (c.other_line == index && c.other_arc >= at_least) c.other_arc += change;
    if (line.fail && line.fail->arc_length >= at_least) line.fail->arc_length += change;
}

void carry_out(const std::vector<Adjustment>& found, Case& input) {
    for (const Adjustment& a : found) adjust(input, a.line, a.found);
}

std::string quantity_text(const Adjustment& a) {
    return a.quantity == StaticTarget::Adjust::anchor_radius
               ? "anchor radius"
               : fmt::format("section {}", a.section + 1);
}

std::string target_text(const Adjustment& a) {
    if (a.goal == Adjustment::Goal::hang_off_angle)
        return fmt::format("{:.4g} deg at end A", a.target * 180.0 / M_PI);
    return fmt::format("{:.5g} kN at {}", a.target / 1e3,
                       a.goal == Adjustment::Goal::stroke ? "stroke 0" : "end A");
}

std::string note_of(const Adjustment& a, const Case& input) {
    const bool radius = a.quantity == StaticTarget::Adjust::anchor_radius;
    const double more = a.found - a.before;
    const char* way =
        radius ? (more < 0.0 ? "nearer" : "further out") : (more < 0.0 ? "shorter" : "longer");
    constexpr double far = 0.1;  // of what the case says: more is rarely meant
    return fmt::format("{}: {} is {:.3f} m, {:.3f} m {}, for {}{}",
                       input.lines[static_cast<std::size_t>(a.line)].name, quantity_text(a),
                       a.found, std::abs(more), way, target_text(a),
                       std::abs(more) > far * a.before
                           ? "; so far from the case's value that the target, the weight or the "
                             "length of the line may be wrong"
                           : "");
}

}  // namespace hawser
