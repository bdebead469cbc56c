#include "ledger.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hawser {

double LedgerTable::largest(int motion) const {
    double greatest = 0.0, upright = 0.0;
    for (std::size_t k = 0; k < components.size(); ++k) {
        if (components[k] == "weight" || components[k] == "hydrostatic") {
            upright += mean[k][motion];
        } else {
            greatest = std::max(greatest, std::abs(mean[k][motion]));
        }
    }
    return std::max(greatest, std::abs(upright));
}

double LedgerTable::residual_fraction(int motion) const {
    const double scale = largest(motion);
    return scale > 0.0 ? std::abs(residual[motion]) / scale : 0.0;
}

bool LedgerTable::is_loaded(int motion) const {
    const int first = motion < 3 ? 0 : 3;
    double greatest = 0.0;
    for (int k = first; k < first + 3; ++k) greatest = std::max(greatest, largest(k));
    return largest(motion) > 1e-6 * greatest;
}

Ledger::Ledger(std::vector<std::string> components)
    : components_(std::move(components)),
      integral_(components_.size(), Vec6::Zero()),
      step_(components_.size(), Vec6::Zero()) {}

void Ledger::at_step(double t, const Vec6& momentum) {
    if (n_ == 0) {
        first_t_ = t;
        first_momentum_ = momentum;
    } else {
        for (std::size_t k = 0; k < step_.size(); ++k) integral_[k] += step_[k];
        turning_ += step_turning_;
    }
    std::fill(step_.begin(), step_.end(), Vec6::Zero());
    step_turning_.setZero();
    last_t_ = t;
    last_momentum_ = momentum;
    ++n_;
}

void Ledger::act(double duration, std::span<const Vec6> loads, const Vec6& momentum,
                 const Vec3& velocity) {
    assert(loads.size() == components_.size());
    for (std::size_t k = 0; k < loads.size(); ++k) step_[k] += duration * loads[k];
    const Vec3 linear = momentum.head<3>();
    step_turning_ += duration * velocity.cross(linear);
}

LedgerTable Ledger::table() const {
    LedgerTable out;
    out.components = components_;
    out.mean.assign(components_.size(), Vec6::Zero());
    out.from = first_t_;
    out.to = last_t_;
    const double T = last_t_ - first_t_;
    if (n_ < 2 || T <= 0.0) return out;
    for (std::size_t k = 0; k < components_.size(); ++k) {
        out.mean[k] = integral_[k] / T;
        out.sum += out.mean[k];
    }
    out.momentum = (last_momentum_ - first_momentum_) / T;
    out.momentum.tail<3>() += turning_ / T;
    out.residual = out.sum - out.momentum;
    return out;
}

}  // namespace hawser
