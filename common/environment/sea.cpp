// Waves and current at blocks of points.
#include "environment/sea.hpp"

#include "environment/wave_trains.hpp"

namespace hawser {

Sea::Sea(const Environment& environment, double ramp, double depth_filter, bool ramp_current)
    : ramp_(ramp), ramp_current_(ramp_current) {
    std::vector<WaveComponent> components;
    for (const WaveTrain& train : environment.waves) {
        const std::vector<WaveComponent> more =
            wave_components(train, environment.seabed.depth, environment.water.gravity);
        components.insert(components.end(), more.begin(), more.end());
        trains_.emplace_back(more, WaveField::Settings{.depth = environment.seabed.depth});
    }
    peak_frequency_ = lowest_peak(environment.waves).value_or(0.0);
    if (!components.empty()) {
        waves_ =
            WaveField(std::move(components), {.depth = environment.seabed.depth,
                                              .depth_filter = depth_filter,
                                              .stretching = environment.waves.front().stretching});
    }
    if (environment.current) current_ = CurrentProfile(*environment.current);
}

void Sea::sample(double t, int n, const double* x, const double* y, const double* z,
                 const WaterKinematics& out) const {
    const double ramp = ramp_factor(t, ramp_);
    const double current = ramp_current_ ? ramp : 1.0;
    if (!has_waves()) {
        sample_current(n, x, y, z, out);
        for (int i = 0; i < n; ++i) out.ux[i] *= current, out.uy[i] *= current;
        return;
    }
    for (int i = 0; i < n; ++i) {
        const WaveSample wave = waves_.sample(t, ramp, x[i], y[i], z[i]);
        const Vec3 steady = current * current_.velocity(z[i]);
        out.ux[i] = wave.ux + steady.x();
        out.uy[i] = wave.uy + steady.y();
        out.uz[i] = wave.uz;
        out.ax[i] = wave.ax;
        out.ay[i] = wave.ay;
        out.az[i] = wave.az;
        out.eta[i] = wave.eta;
    }
}

void Sea::sample_current(int n, const double* /*x*/, const double* /*y*/, const double* z,
                         const WaterKinematics& out) const {
    for (int i = 0; i < n; ++i) {
        const Vec3 steady = current_.velocity(z[i]);
        out.ux[i] = steady.x();
        out.uy[i] = steady.y();
        out.uz[i] = 0.0;
        out.ax[i] = out.ay[i] = out.az[i] = out.eta[i] = 0.0;
    }
}

double Sea::elevation(double t, double x, double y) const {
    return has_waves() ? waves_.elevation(t, ramp_factor(t, ramp_), x, y) : 0.0;
}

double Sea::elevation_of_train(int train, double t, double x, double y) const {
    return trains_[static_cast<std::size_t>(train)].elevation(t, ramp_factor(t, ramp_), x, y);
}

}  // namespace hawser
