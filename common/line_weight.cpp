#include "line_weight.hpp"

#include <algorithm>

namespace hawser {

double submerged_weight(const Line& line, const Case& input, double from_arc_length) {
    const Water& water = input.environment.water;
    const auto wet = [&](int type) {
        const LineType& t = input.line_types[static_cast<std::size_t>(type)];
        return t.mass - water.density * t.displaced_area;
    };
    double mass = 0.0, start = 0.0;
    for (const Section& section : line.sections) {
        const double above = std::clamp(from_arc_length - start, 0.0, section.length);
        const double low = wet(section.type_at_end < 0 ? section.type : section.type_at_end);
        const double part = section.length > 0.0 ? above / section.length : 0.0;
        const double high = wet(section.type) + part * (low - wet(section.type));
        mass += (section.length - above) * 0.5 * (high + low);
        start += section.length;
    }
    for (const Attachment& a : line.attachments)
        if (a.arc_length >= from_arc_length) mass += a.mass - water.density * a.volume;
    return mass * water.gravity;
}

double greatest_stretch(const Line& line, const Case& input) {
    double sum = 0.0;
    for (const Section& s : line.sections) {
        const std::string& kind = input.line_types[static_cast<std::size_t>(s.type)].category;
        sum += s.length * (kind == "rope" || kind == "general" ? 0.03 : 0.003);
    }
    return sum;
}

}  // namespace hawser
