#include "drift.hpp"

#include "yaw_axes.hpp"

namespace hawser::master {

DriftLoad drift_load(const ComponentTable<Vec6>& table,
                     const std::vector<WaveComponent>& components,
                     const std::vector<Complex>& phases, double yaw) {
    if (table.empty()) return {};
    Vec6 mean = Vec6::Zero(), weighted_re = Vec6::Zero(), weighted_im = Vec6::Zero();
    Complex sum = 0.0;
    HeadingWeights weights;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (i == 0 || components[i].heading != components[i - 1].heading)
            weights = table.weights(components[i].heading - yaw);
        const Vec6 D = table.at(static_cast<int>(i), weights);
        mean += components[i].amplitude * components[i].amplitude * D;
        weighted_re += phases[i].real() * D;
        weighted_im += phases[i].imag() * D;
        sum += phases[i];
    }
    const Vec6 slow = weighted_re * sum.real() + weighted_im * sum.imag();
    return {turned_by_yaw(mean, yaw), turned_by_yaw(slow, yaw)};
}

}  // namespace hawser::master
