#include "failure_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "line_mesh.hpp"
#include "statics_diagnosis.hpp"

namespace hawser::master {

double largest_cfl(const Line& line, const Case& input) {
    const LineMesh mesh = mesh_of(line);
    const double longest = input.analysis.dynamics.line_step;
    const double h = std::min(line.time_step.value_or(longest), longest);
    double largest = 0.0;
    for (int e = 0; e < mesh.elements(); ++e) {
        const auto i = static_cast<std::size_t>(e);
        const Section& section = line.sections[static_cast<std::size_t>(mesh.section[i])];
        const LineType& type = input.line_types[static_cast<std::size_t>(section.type)];
        const double length = mesh.arc_length[i + 1] - mesh.arc_length[i];
        largest = std::max(largest, std::sqrt(type.EA / type.mass) * h / length);
    }
    return largest;
}

std::string failure_message(const Status& status, const Case& input, int stage,
                            const PerPlatform<PlatformMotion>& poses) {
    const bool known = status.line >= 0 && status.line < static_cast<int>(input.lines.size());
    const Line* line = known ? &input.lines[static_cast<std::size_t>(status.line)] : nullptr;
    const std::string name = known ? line->name : "lines";
    const std::string where = fmt::format("s = {:.0f} m", status.arc_length);
    std::string when = fmt::format("{}, t = {:.2f} s", name, status.t);
    if (stage > 0) when += fmt::format(", stage {}", stage);
    const std::string cfl =
        known ? fmt::format("largest element CFL number {:.2g}", largest_cfl(*line, input)) : "";
    const bool in_motion = status.t > 0.0;  // a line without dynamics
    if (in_motion && status.code == Status::Code::no_equilibrium)
        return fmt::format(
            "{}: no static solution there, largest position correction {:.2g} m at {}; likely "
            "cause: a line pulled taut beyond its length or gone slack, which a line without "
            "inertia cannot follow; give it the model dynamic",
            when, status.residual, where);
    if (in_motion && status.code == Status::Code::false_equilibrium)
        return fmt::format(
            "{}: the static solution is compressed or folded, largest correction at {}; likely "
            "cause: the platform comes down on the line faster than a line without inertia can "
            "follow; give it the model dynamic",
            when, where);
    if (status.code == Status::Code::not_finite && status.t == 0.0 && stage == 0 && known)
        return fmt::format(
            "{}: no static solution after {} iterations, a number is not finite at {}; likely "
            "cause: {}",
            name, status.iterations, where, static_failure_cause(*line, input, poses));
    switch (status.code) {
        case Status::Code::ok:
            return when + ": no failure";
        case Status::Code::not_converged:
            return fmt::format(
                "{}: Newton's position correction is still {:.2g} m after {} iterations, largest "
                "at {}; likely cause: a "
                "step too long for what happens there ({}); try a shorter "
                "analysis.dynamics.steps.lines or steps.platform, or shorter elements",
                when, status.residual, status.iterations, where, cfl);
        case Status::Code::not_finite:
            return fmt::format(
                "{}: a number is not finite at {}; likely cause: an unstable coupling or a load "
                "without bound ({}); try a shorter analysis.dynamics.steps.platform, or look at "
                "the stiffness and mass of the line there",
                when, where, cfl);
        case Status::Code::no_equilibrium:
            if (!(status.residual > 0.0) && line)  // there was nothing to start from
                return fmt::format("{}: no static solution; likely cause: {}", name,
                                   static_failure_cause(*line, input, poses));
            return fmt::format(
                "{}: no static solution after {} iterations, largest position correction {:.2g} m "
                "at {}; likely cause: {}",
                name, status.iterations, status.residual, where,
                line ? static_failure_cause(*line, input, poses) : "");
        case Status::Code::false_equilibrium:
            return fmt::format(
                "{}: no static solution: what was found is not a hanging line (compressed more "
                "than it "
                "can stand, folded, or stretched beyond reason); likely cause: {}",
                name, line ? static_failure_cause(*line, input, poses) : "");
    }
    return when;
}

}  // namespace hawser::master
