// One simulation as plain values: what the case file says, every default filled in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/analysis.hpp"
#include "case/environment.hpp"
#include "case/lines.hpp"
#include "case/output.hpp"
#include "case/platform.hpp"

namespace hawser {

struct Case {
    std::string name;  ///< stem of the file name
    std::string title, description;
    Environment environment;
    std::optional<Platform> platform;         ///< the only one, or the first of several
    std::vector<Platform> further_platforms;  ///< of several the others, in the order of the file
    std::vector<LineType> line_types;
    std::vector<Line> lines;  ///< line order: as declared, families expanded
    Analysis analysis;
    Output output;

    bool operator==(const Case&) const = default;

    [[nodiscard]] int platform_count() const {
        return platform ? 1 + static_cast<int>(further_platforms.size()) : 0;
    }
    /// @param k  0 ... platform_count() - 1, as LineEnd::platform counts
    [[nodiscard]] const Platform& platform_at(int k) const {
        return k == 0 ? *platform : further_platforms[static_cast<std::size_t>(k - 1)];
    }
    /// Where platform k is built to be; the origin where there is none.
    [[nodiscard]] PlatformMotion design_of(int k) const {
        PlatformMotion at;
        if (k < platform_count()) at.position = platform_at(k).position;
        return at;
    }
    /// Where an end of a line is on world axes, its platform as designed; of an end that is free or
    /// on another line: nowhere in particular.
    [[nodiscard]] Vec3 place_of(const LineEnd& end) const {
        if (end.kind != EndKind::platform) return end.position;
        return design_of(end.platform).position + end.position;
    }
    /// The same of a point on the axes of a constraint.
    [[nodiscard]] Vec3 place_of(const LineConstraint& c, const Vec3& point) const {
        return c.on_platform ? Vec3(design_of(c.platform).position + point) : point;
    }
};

}  // namespace hawser
