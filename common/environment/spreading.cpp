// Sectors of equal energy of the cos-2s distribution.
#include "environment/spreading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "environment/random.hpp"

namespace hawser {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

double cos2s_density(double s, double angle) {
    const double c = std::abs(std::cos(0.5 * angle));
    if (std::abs(angle) > pi || c == 0.0) return 0.0;
    return std::exp(std::lgamma(s + 1.0) - std::lgamma(s + 0.5) + 2.0 * s * std::log(c)) /
           (2.0 * std::sqrt(pi));
}

std::vector<double> spread_directions(const Spreading& spreading) {
    // Running integrals of D, D cos and D sin in narrow cells, midpoint rule.
    constexpr std::size_t cells = 40000;
    const double width = 2.0 * pi / cells;
    const auto M = static_cast<std::size_t>(spreading.directions);
    std::vector<double> energy(cells), angle(cells);
    double all = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
        angle[i] = -pi + (static_cast<double>(i) + 0.5) * width;
        energy[i] = cos2s_density(spreading.s, angle[i]);
        all += energy[i];
    }
    std::vector<double> re(M, 0.0), im(M, 0.0);
    double below = 0.0;
    const double share = all / static_cast<double>(M);
    std::size_t sector = 0;
    for (std::size_t i = 0; i < cells; ++i) {
        double left = energy[i];
        while (sector + 1 < M && below + left > static_cast<double>(sector + 1) * share) {
            const double part = static_cast<double>(sector + 1) * share - below;
            re[sector] += part * std::cos(angle[i]);
            im[sector] += part * std::sin(angle[i]);
            below += part;
            left -= part;
            ++sector;
        }
        re[sector] += left * std::cos(angle[i]);
        im[sector] += left * std::sin(angle[i]);
        below += left;
    }
    std::vector<double> directions(M);
    for (std::size_t j = 0; j < M; ++j) directions[j] = std::atan2(im[j], re[j]);
    for (std::size_t j = 0; j < M / 2; ++j) {  // the two sides alike to the last bit
        const double half = 0.5 * (directions[M - 1 - j] - directions[j]);
        directions[j] = -half;
        directions[M - 1 - j] = half;
    }
    if (M % 2 == 1) directions[M / 2] = 0.0;
    return directions;
}

void spread_components(const Spreading& spreading, std::uint64_t seed,
                       std::vector<WaveComponent>& components) {
    const std::vector<double> directions = spread_directions(spreading);
    const std::size_t M = directions.size();
    Random random(seed ^ 0xd1b54a32d192ed03u);  // apart from phases and frequencies
    std::vector<std::size_t> order(M);
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (i % M == 0) {
            std::iota(order.begin(), order.end(), std::size_t{0});
            for (std::size_t j = M - 1; j > 0; --j)
                std::swap(
                    order[j],
                    order[static_cast<std::size_t>(random.uniform() * static_cast<double>(j + 1))]);
        }
        components[i].heading += directions[order[i % M]];
    }
}

}  // namespace hawser
