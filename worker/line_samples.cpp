#include "line_samples.hpp"

#include <cmath>

#include "line_mesh.hpp"

namespace hawser::worker {

namespace {

constexpr double degrees = 180.0 / M_PI;

using Quads = RodPack<Quad>;

/// Result of one rod at one end [N, deg, N.m]; directions are those of increasing arc length.
Vec3 end_result(const Quads& rod, int lane, bool end_a, io::EndResult result) {
    const Vec3 u = end_a ? rod.direction_a(lane) : rod.direction_b(lane);
    switch (result) {
        case io::EndResult::effective_tension:
            return {end_a ? rod.tension_a(lane) : rod.tension_b(lane), 0, 0};
        case io::EndResult::declination:
            return {degrees * std::atan2(std::hypot(u.x(), u.y()), -u.z()), 0, 0};
        case io::EndResult::azimuth:
            return {degrees * std::atan2(u.y(), u.x()), 0, 0};
        case io::EndResult::force:
            return end_a ? rod.force_on_support_a(lane) : rod.force_on_support_b(lane);
        case io::EndResult::moment:
            return end_a ? rod.moment_on_support_a(lane) : rod.moment_on_support_b(lane);
    }
    return Vec3::Zero();
}

bool is_vector(io::EndResult result) {
    return result == io::EndResult::force || result == io::EndResult::moment;
}

}  // namespace

LineSamples::LineSamples(const Case& input, const std::vector<Quads>& packs,
                         io::SeriesWriter* results)
    : results_(results) {
    if (!results_) return;
    for (const bool end_a : {true, false}) {
        for (const io::EndResult result : io::end_results) {
            Channel channel{.field = results_->find(io::end_path(end_a, result)),
                            .end_a = end_a,
                            .result = result,
                            .rods = {}};
            if (channel.field < 0) continue;
            std::vector<int> columns;
            for (std::size_t p = 0; p < packs.size(); ++p) {
                for (int lane = 0; lane < static_cast<int>(packs[p].lines().size()); ++lane) {
                    const int line = packs[p].lines()[static_cast<std::size_t>(lane)];
                    if (!io::is_recorded(input.output,
                                         input.lines[static_cast<std::size_t>(line)].name, end_a,
                                         result))
                        continue;
                    channel.rods.emplace_back(p, lane);
                    const int width = is_vector(result) ? 3 : 1;
                    for (int k = 0; k < width; ++k) columns.push_back(width * line + k);
                }
            }
            results_->provide(channel.field, columns);
            ends_.push_back(channel);
        }
    }
    node_field_ = results_->find("/lines/nodes/position");
    if (node_field_ < 0) return;
    std::vector<int> first(1, 0);
    for (const Line& line : input.lines)
        first.push_back(first.back() + mesh_of(line).elements() + 1);
    std::vector<int> columns;
    for (const Quads& pack : packs)
        for (const int line : pack.lines())
            for (int c = 3 * first[static_cast<std::size_t>(line)];
                 c < 3 * first[static_cast<std::size_t>(line) + 1]; ++c)
                columns.push_back(c);
    results_->provide(node_field_, columns);
    values_.reserve(columns.size() + 3 * input.lines.size());
}

void LineSamples::put_ends(const std::vector<Quads>& packs) {
    for (const Channel& channel : ends_) {
        values_.clear();
        for (const auto& [p, lane] : channel.rods) {
            const Vec3 value = end_result(packs[p], lane, channel.end_a, channel.result);
            values_.push_back(value.x());
            if (is_vector(channel.result))
                values_.push_back(value.y()), values_.push_back(value.z());
        }
        results_->put(channel.field, values_);
    }
}

void LineSamples::put_nodes(const std::vector<Quads>& packs) {
    if (node_field_ < 0) return;
    values_.clear();
    for (const Quads& pack : packs) {
        for (int lane = 0; lane < static_cast<int>(pack.lines().size()); ++lane) {
            for (int n = 0; n <= pack.elements(); ++n) {
                const Vec3 x = pack.node_position(lane, n);
                values_.push_back(x.x()), values_.push_back(x.y()), values_.push_back(x.z());
            }
        }
    }
    results_->put(node_field_, values_);
}

}  // namespace hawser::worker
