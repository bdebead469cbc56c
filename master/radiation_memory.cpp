#include "radiation_memory.hpp"

#include <array>
#include <cmath>

namespace hawser::master {

using ConstVec6 = Eigen::Map<const Vec6>;

Vec6 FittedMemory::load(const double* x) const {
    Vec6 load = Vec6::Zero();
    for (const Oscillator& o : fit_.oscillators) {
        load -= o.first * ConstVec6(x) + o.second * ConstVec6(x + 6);
        x += 12;
    }
    return load;
}

void FittedMemory::add_rates_to(double* rates, const double* x, const Vec6& velocity) const {
    for (const Oscillator& o : fit_.oscillators) {
        const ConstVec6 x1(x), x2(x + 6);
        Eigen::Map<Vec6>{rates} += -o.a * x1 + o.b * x2 + 2.0 * velocity;
        Eigen::Map<Vec6>{rates + 6} += -o.b * x1 - o.a * x2;
        x += 12, rates += 12;
    }
}

DiscreteMemory::DiscreteMemory(const Retardation& K, double D, double duration) : D_(D) {
    const int steps = std::max(1, static_cast<int>(std::ceil(duration / D)));
    half_ = weights(K, D, steps, 0.5);
    whole_ = weights(K, D, steps, 1.0);
    velocity_.assign(static_cast<std::size_t>(steps) + 1, Vec6::Zero());
    rate_ = velocity_;
}

auto DiscreteMemory::weights(const Retardation& K, double D, int steps, double c) -> Weights {
    // Gauss-Legendre, five points an interval: exact for v times a K that is a polynomial of degree
    // 6
    constexpr std::array<double, 5> x = {0.04691007703066802, 0.23076534494715845, 0.5,
                                         0.76923465505284155, 0.95308992296933198};
    constexpr std::array<double, 5> g = {0.11846344252809454, 0.23931433524968324,
                                         0.28444444444444444, 0.23931433524968324,
                                         0.11846344252809454};
    const auto n = static_cast<std::size_t>(steps) + 1;
    Weights out{.now = Mat6::Zero(),
                .velocity = std::vector<Mat6>(n, Mat6::Zero()),
                .rate = std::vector<Mat6>(n, Mat6::Zero()),
                .first_velocity = {},
                .first_rate = {}};
    // Of each step apart: its share as the older and as the newer end of an interval.
    std::vector<Mat6> older(n, Mat6::Zero()), older_rate = older;
    for (std::size_t i = 0; i < x.size(); ++i) {  // from the last step (y = 0) to now (y = 1)
        const double y = x[i];
        const Mat6 W = g[i] * c * D * K.at((1.0 - y) * c * D);
        out.now += y * y * W;
        older[0] += (1.0 - y * y) * W;
        older_rate[0] += c * (y - y * y) * W;
    }
    for (std::size_t k = 0; k + 1 < n;
         ++k)  // from the step k + 1 before (y = 0) to the step k before
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double y = x[i], y2 = y * y, y3 = y2 * y;
            const Mat6 W = g[i] * D * K.at((c + static_cast<double>(k) + 1.0 - y) * D);
            older[k + 1] += (1.0 - 3.0 * y2 + 2.0 * y3) * W;
            older_rate[k + 1] += (y - 2.0 * y2 + y3) * W;
            out.velocity[k] += (3.0 * y2 - 2.0 * y3) * W;
            out.rate[k] += (y3 - y2) * W;
        }
    out.first_velocity = older, out.first_rate = older_rate;
    for (std::size_t k = 0; k < n; ++k) out.velocity[k] += older[k], out.rate[k] += older_rate[k];
    return out;
}

void DiscreteMemory::remember(double t, const Vec6& velocity, const Vec6& rate) {
    t_ = t;
    newest_ = (newest_ + 1) % velocity_.size();
    velocity_[newest_] = velocity;
    rate_[newest_] = D_ * rate;
    count_ = std::min(count_ + 1, velocity_.size());
}

Vec6 DiscreteMemory::load(double t, const Vec6& velocity) const {
    if (count_ == 0) return Vec6::Zero();  // at rest until the first step
    const Weights& w = t - t_ < 0.75 * D_ ? half_ : whole_;
    Vec6 load = -w.now * velocity;
    std::size_t at = newest_;
    for (std::size_t k = 0; k < count_; ++k) {
        const bool first = k + 1 == count_;
        load -= (first ? w.first_velocity : w.velocity)[k] * velocity_[at] +
                (first ? w.first_rate : w.rate)[k] * rate_[at];
        at = at == 0 ? velocity_.size() - 1 : at - 1;
    }
    return load;
}

}  // namespace hawser::master
