// Steady current as a profile over depth.
#include "environment/current.hpp"

#include <cmath>

namespace hawser {

CurrentProfile::CurrentProfile(const Current& current) {
    for (const CurrentPoint& p : current.profile) {
        const double heading = p.heading.value_or(current.heading);
        points_.push_back(
            {.depth = p.depth, .x = p.speed * std::cos(heading), .y = p.speed * std::sin(heading)});
    }
}

Vec3 CurrentProfile::velocity(double z) const {
    if (points_.empty()) return Vec3::Zero();
    const double depth = -z;
    std::size_t below = 0;  // first point that lies deeper
    while (below < points_.size() && points_[below].depth < depth) ++below;
    if (below == 0) return {points_.front().x, points_.front().y, 0.0};
    if (below == points_.size()) return {points_.back().x, points_.back().y, 0.0};
    const Point& a = points_[below - 1];
    const Point& b = points_[below];
    const double q = (depth - a.depth) / (b.depth - a.depth);
    return {a.x + q * (b.x - a.x), a.y + q * (b.y - a.y), 0.0};
}

}  // namespace hawser
