#include "nonnegative.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>
#include <vector>

namespace hawser::master {

void solve_nonnegative(const Eigen::MatrixXd& K, const Eigen::VectorXd& d, Eigen::VectorXd& x) {
    const Eigen::Index n = d.size();
    std::vector<Eigen::Index> active;
    for (Eigen::Index i = 0; i < n; ++i)
        if (x[i] > 0.0) active.push_back(i);
    const double small = 1e-12 * d.cwiseAbs().maxCoeff();
    const auto free_answer = [&] {
        Eigen::MatrixXd part = K(active, active);
        part.diagonal() *= 1.0 + 1e-10;
        return Eigen::VectorXd(part.ldlt().solve(Eigen::VectorXd(d(active))));
    };
    for (Eigen::Index round = 0; round < 3 * n + 10; ++round) {
        while (!active.empty()) {  // drop those that would pull
            const Eigen::VectorXd z = free_answer();
            double part = 1.0;
            for (std::size_t i = 0; i < active.size(); ++i)
                if (const auto k = static_cast<Eigen::Index>(i); z[k] <= 0.0)
                    part = std::min(part, x[active[i]] / (x[active[i]] - z[k]));
            std::vector<Eigen::Index> kept;
            for (std::size_t i = 0; i < active.size(); ++i) {
                const auto k = static_cast<Eigen::Index>(i);
                double& value = x[active[i]];
                const bool goes = z[k] <= 0.0 && value / (value - z[k]) <= part;
                value = goes ? 0.0 : value + part * (z[k] - value);
                if (!goes) kept.push_back(active[i]);
            }
            const bool whole = kept.size() == active.size();
            active = std::move(kept);
            if (whole) break;
        }
        Eigen::VectorXd slope = d - K * x;
        for (const Eigen::Index i : active) slope[i] = 0.0;
        Eigen::Index steepest = 0;
        if (slope.maxCoeff(&steepest) <= small) return;
        active.push_back(steepest);
    }
}

}  // namespace hawser::master
