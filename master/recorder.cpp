#include "recorder.hpp"

#include <cmath>
#include <numeric>

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
    const std::string root = input.platform ? io::platform_path(*input.platform) : "/platform/";
    position_ = declare(root + "position", 6);
    velocity_ = declare(root + "velocity", 6);
    acceleration_ = declare(root + "acceleration", 6);
    for (const std::string_view name : io::load_names)
        loads_.push_back(declare(root + "loads/" + std::string(name), 6));
    elevation_ = declare("/environment/elevation", 1);
    elevation_of_trains_ = declare("/environment/elevation_of_trains", sea.trains());
    trains_.resize(static_cast<std::size_t>(sea.trains()));
    wind_speed_ = declare("/environment/wind_speed", 1);
    if (const auto& wind = input.environment.wind) {
        const bool area = input.platform && input.platform->wind;
        wind_.emplace(*wind, input.analysis.dynamics.ramp,
                      area ? input.platform->wind->centre_height : wind->reference_height);
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

void Recorder::platform(const State& y, const Vec6& acceleration, const HullLoads& loads) {
    put(position_, in_degrees(y.segment<6>(0)));
    put(velocity_, in_degrees(y.segment<6>(6)));
    put(acceleration_, in_degrees(acceleration));
    for (std::size_t i = 0; i < loads_.size(); ++i)
        if (loads_[i] >= 0) put(loads_[i], i < loads.by.size() ? loads.by[i] : loads.total());
}

}  // namespace hawser::master
