#include "recorder.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "io/result_fields.hpp"

namespace hawser::master {

namespace {

/// Steps of D between records. @param interval a multiple of D (the check insists)
int steps_between(double interval, double D) {
    return std::max(1, static_cast<int>(std::lround(interval / D)));
}

/// Rotations in degrees, as results have them.
Vec6 in_degrees(const Vec6& v) {
    Vec6 out = v;
    out.tail<3>() *= 180.0 / M_PI;
    return out;
}

}  // namespace

Recorder::Recorder(const Case& input, const Sea& sea, io::SeriesWriter& results)
    : sea_(sea), results_(results) {
    const double D = input.analysis.dynamics.platform_step;
    sample_every_ = steps_between(input.output.interval, D);
    snapshot_every_ = input.output.snapshots ? steps_between(*input.output.snapshots, D) : 0;
    for (int k = 0; k < input.platform_count(); ++k) {
        const Platform& p = input.platform_at(k);
        const std::string root = io::platform_path(p);
        Columns its{.design = p.position,
                    .position = declare(root + "position", 6),
                    .velocity = declare(root + "velocity", 6),
                    .acceleration = declare(root + "acceleration", 6),
                    .elevation = declare(root + "elevation", 1),
                    .loads = {}};
        for (const std::string_view name : io::load_names)
            its.loads.push_back(declare(root + "loads/" + std::string(name), 6));
        platforms_.push_back(std::move(its));
    }
    elevation_ = declare("/environment/elevation", 1);
    elevation_of_trains_ = declare("/environment/elevation_of_trains", sea.trains());
    trains_.resize(static_cast<std::size_t>(sea.trains()));
    wind_speed_ = declare("/environment/wind_speed", 1);
    if (const auto& wind = input.environment.wind) {
        double height = wind->reference_height;  // else of the first platform that feels it
        for (int k = input.platform_count() - 1; k >= 0; --k)
            if (const auto& area = input.platform_at(k).wind) height = area->centre_height;
        wind_.emplace(*wind, input.analysis.dynamics.ramp, height);
    }
}

int Recorder::declare(const std::string& path, int columns) {
    const int field = results_.find(path);
    if (field < 0) return field;
    std::vector<int> all(static_cast<std::size_t>(columns));
    std::iota(all.begin(), all.end(), 0);
    results_.provide(field, all);
    return field;
}

void Recorder::put(int field, const Vec6& values) {
    if (field >= 0) results_.put(field, {values.data(), 6});
}

void Recorder::sample(double t) {
    results_.add_time(io::Clock::sample, t);
    if (elevation_ >= 0) {
        const double eta = sea_.elevation(t, 0.0, 0.0);
        results_.put(elevation_, {&eta, 1});
    }
    for (const Columns& its : platforms_) {
        if (its.elevation < 0) continue;
        const double eta = sea_.elevation(t, its.design.x(), its.design.y());
        results_.put(its.elevation, {&eta, 1});
    }
    if (elevation_of_trains_ >= 0) {
        for (int i = 0; i < sea_.trains(); ++i)
            trains_[static_cast<std::size_t>(i)] = sea_.elevation_of_train(i, t, 0.0, 0.0);
        results_.put(elevation_of_trains_, trains_);
    }
    if (wind_speed_ >= 0) {
        const double speed = wind_->speed(t);
        results_.put(wind_speed_, {&speed, 1});
    }
}

void Recorder::platform(std::size_t k, const State& y, const Vec6& acceleration,
                        const HullLoads& loads) {
    const Columns& its = platforms_[k];
    Vec6 position = y.segment<6>(0);
    position.head<3>() -= its.design;
    put(its.position, in_degrees(position));
    put(its.velocity, in_degrees(y.segment<6>(6)));
    put(its.acceleration, in_degrees(acceleration));
    for (std::size_t i = 0; i < its.loads.size(); ++i)
        if (its.loads[i] >= 0) put(its.loads[i], i < loads.by.size() ? loads.by[i] : loads.total());
}

}  // namespace hawser::master
