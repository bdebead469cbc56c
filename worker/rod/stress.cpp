#include "rod/stress.hpp"

#include <cmath>
#include <limits>

namespace hawser::worker {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double between(double a, double b, double fraction) { return a + fraction * (b - a); }

}  // namespace

StressSection<double> stress_section(const Case& input, const Line& line, double arc_length,
                                     bool next) {
    std::size_t j = 0;
    double start = 0.0;
    for (; j + 1 < line.sections.size(); ++j) {
        const double end = start + line.sections[j].length;
        if (next ? arc_length < end : arc_length <= end) break;
        start = end;
    }
    const Section& section = line.sections[j];
    const LineType& type = input.line_types[static_cast<std::size_t>(section.type)];
    const LineType& last = section.type_at_end < 0
                               ? type
                               : input.line_types[static_cast<std::size_t>(section.type_at_end)];
    const double x = section.length > 0.0 ? (arc_length - start) / section.length : 0.0;

    StressSection<double> s{.area = nan,
                            .inner_radius = 0.0,
                            .outer_radius = 0.0,
                            .second_moment = 1.0,
                            .concentration = 1.0,
                            .contents_weight = 0.0,
                            .yield = nan,
                            .breaking_load = type.breaking_load.value_or(nan),
                            .no_wall = nan};
    if (type.wall) {
        const PipeWall &a = *type.wall, &b = last.wall ? *last.wall : a;
        const double outer = 0.5 * between(a.outer_diameter, b.outer_diameter, x);
        const double inner = 0.5 * between(a.inner_diameter, b.inner_diameter, x);
        s.outer_radius = outer;
        s.inner_radius =
            outer - between(a.thickness_factor, b.thickness_factor, x) * (outer - inner);
        s.area = M_PI * (std::pow(s.outer_radius, 2) - std::pow(s.inner_radius, 2));
        s.second_moment = M_PI / 4 * (std::pow(s.outer_radius, 4) - std::pow(s.inner_radius, 4));
        s.concentration = between(a.concentration, b.concentration, x);
        s.contents_weight =
            between(a.contents_density, b.contents_density, x) * input.environment.water.gravity;
        s.yield = a.yield.value_or(nan);
        s.no_wall = 0.0;
    } else if (type.section_area > 0.0) {
        s.area = type.section_area;
    }
    return s;
}

}  // namespace hawser::worker
