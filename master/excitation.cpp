#include "excitation.hpp"

#include "yaw_axes.hpp"

namespace hawser::master {

Vec6 excitation_load(const ComponentTable<CVec6>& table,
                     const std::vector<WaveComponent>& components,
                     const std::vector<Complex>& phases, double yaw) {
    Vec6 force = Vec6::Zero();
    if (table.empty()) return force;
    HeadingWeights weights;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (i == 0 || components[i].heading != components[i - 1].heading)
            weights = table.weights(components[i].heading - yaw);
        const CVec6 X = table.at(static_cast<int>(i), weights);
        for (int k = 0; k < 6; ++k)  // real part of the product
            force[k] += X[k].real() * phases[i].real() - X[k].imag() * phases[i].imag();
    }
    return turned_by_yaw(force, yaw);
}

}  // namespace hawser::master
