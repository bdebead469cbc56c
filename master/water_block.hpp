// A block of points with the water's motion there, allocated once: what Sea::sample fills.
#pragma once

#include <vector>

#include "environment/sea.hpp"

namespace hawser::master {

struct WaterBlock {
    std::vector<double> x, y, z, ux, uy, uz, ax, ay, az, eta;

    explicit WaterBlock(std::size_t n = 0)
        : x(n), y(n), z(n), ux(n), uy(n), uz(n), ax(n), ay(n), az(n), eta(n) {}

    [[nodiscard]] int size() const { return static_cast<int>(x.size()); }
    void place(std::size_t i, const Vec3& p) { x[i] = p.x(), y[i] = p.y(), z[i] = p.z(); }
    [[nodiscard]] Vec3 velocity(std::size_t i) const { return {ux[i], uy[i], uz[i]}; }
    [[nodiscard]] Vec3 acceleration(std::size_t i) const { return {ax[i], ay[i], az[i]}; }

    /// Waves and current at every point.
    void sample(const Sea& sea, double t) {
        sea.sample(t, size(), x.data(), y.data(), z.data(), results(0));
    }
    /// Waves and current at point i alone.
    void sample_one(const Sea& sea, double t, std::size_t i) {
        sea.sample(t, 1, x.data() + i, y.data() + i, z.data() + i, results(i));
    }
    /// Current alone: still water, eta = 0.
    void sample_current(const Sea& sea) {
        sea.sample_current(size(), x.data(), y.data(), z.data(), results(0));
    }

 private:
    [[nodiscard]] WaterKinematics results(std::size_t i) {
        return {ux.data() + i, uy.data() + i, uz.data() + i, ax.data() + i,
                ay.data() + i, az.data() + i, eta.data() + i};
    }
};

}  // namespace hawser::master
