#include "rod/stress.hpp"

#include <cmath>
#include <limits>

#include "rod/properties.hpp"

namespace hawser::worker {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
    const double x = section.length > 0.0 ? (arc_length - start) / section.length : 0.0;
    const LineType type = line_type_at(input, section, x);

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
        const PipeWall& wall = *type.wall;
        const double outer = 0.5 * wall.outer_diameter, inner = 0.5 * wall.inner_diameter;
        s.outer_radius = outer;
        s.inner_radius = outer - wall.thickness_factor * (outer - inner);
        s.area = M_PI * (std::pow(s.outer_radius, 2) - std::pow(s.inner_radius, 2));
        s.second_moment = M_PI / 4 * (std::pow(s.outer_radius, 4) - std::pow(s.inner_radius, 4));
        s.concentration = wall.concentration;
        s.contents_weight = wall.contents_density * input.environment.water.gravity;
        s.yield = wall.yield.value_or(nan);
        s.no_wall = 0.0;
    } else if (type.section_area > 0.0) {
        s.area = type.section_area;
    }
    return s;
}

}  // namespace hawser::worker
