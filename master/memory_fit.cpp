#include "memory_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "dissipation.hpp"
#include "vector_fitting.hpp"

namespace hawser::master {

namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rms error that "auto" is content with.
constexpr double good_fit = 0.005;

MemoryFit fit_of(const Samples& s, const std::vector<Poles>& poles) {
    const MatrixXcd phi = basis(s.frequencies, poles);
    const MatrixXd A = weighted(s, phi), Z = weighted(s, s.values), T = at_rest_at_zero(poles);
    MatrixXd C = T * MatrixXd(A * T).colPivHouseholderQr().solve(Z);
    make_dissipative(s, poles, A, T, C);

    MemoryFit fit;
    fit.rms_error = (A * C - Z).norm() / Z.norm();
    const MatrixXcd error =
        s.weights.cast<Complex>().asDiagonal() * (phi * C.cast<Complex>() - s.values);
    Eigen::Index at = 0, entry = 0;
    fit.largest_error = error.cwiseAbs().maxCoeff(&at, &entry) / s.largest;
    fit.worst_frequency = s.frequencies[at];
    std::tie(fit.worst_row, fit.worst_column) = s.entries[static_cast<std::size_t>(entry)];
    const Damping damping = damping_of(s, poles, C);
    fit.least_damping = damping.most > 0.0 ? damping.least / damping.most : 0.0;
    for (std::size_t p = 0; p < poles.size(); ++p) {
        Oscillator o{.a = poles[p].a, .b = poles[p].b};
        for (std::size_t e = 0; e < s.entries.size(); ++e) {
            const auto [i, j] = s.entries[e];
            const double size = s.scale[i] * s.scale[j];
            const auto row = static_cast<Eigen::Index>(2 * p),
                       column = static_cast<Eigen::Index>(e);
            o.first(i, j) = o.first(j, i) = size * C(row, column);
            o.second(i, j) = o.second(j, i) = size * C(row + 1, column);
        }
        fit.oscillators.push_back(o);
    }
    return fit;
}

/// Fits of one oscillator, of two, and so on. The poles before and one more are tried as well, and
/// a fit that is no better than the one before is not taken.
class Ladder {
 public:
    Ladder(const Samples& s, double D)
        : s_(s), fastest_(2.0 / D), last_(std::min(last_of(s), fastest_)) {}

    const MemoryFit& next() {
        const int order = ++order_;
        const std::vector<Poles> before = poles_;
        std::vector<Poles> spread;
        for (int p = 1; p <= order; ++p) {
            const double b = last_ * p / (order + 0.5);
            spread.push_back({0.2 * b, b});
        }
        spread = settled(s_, std::move(spread), fastest_);
        take_if_better(spread);
        if (order > 1) {
            std::vector<Poles> more = before;
            more.push_back({0.5 * last_, 0.5 * last_});
            take_if_better(more);
        }
        return fit_;
    }

 private:
    void take_if_better(const std::vector<Poles>& poles) {
        MemoryFit fit = fit_of(s_, poles);
        if (order_ == 1 || fit.rms_error < fit_.rms_error) fit_ = std::move(fit), poles_ = poles;
    }

    const Samples& s_;
    double fastest_, last_;
    int order_ = 0;
    std::vector<Poles> poles_;
    MemoryFit fit_;
};

}  // namespace

CMat6 MemoryFit::at(double w) const {
    CMat6 H = CMat6::Zero();
    for (const Oscillator& o : oscillators) {
        const Complex s(o.a, w), determinant = s * s + o.b * o.b;
        H += (2.0 * s / determinant) * o.first.cast<Complex>() -
             (2.0 * o.b / determinant) * o.second.cast<Complex>();
    }
    return H;
}

MemoryFit fit_memory(const HydroData& data, const Mat6& infinite, double D,
                     std::optional<int> order) {
    const Samples samples = samples_of(data, infinite, D);
    if (samples.entries.empty()) return {};
    // More numbers than data cannot be told.
    const int most = std::clamp(static_cast<int>(std::ssize(samples.frequencies)) / 2, 1,
                                order.value_or(most_oscillators));
    Ladder ladder(samples, D);
    std::vector<MemoryFit> fits;
    for (int n = 1; n <= most; ++n) {
        fits.push_back(ladder.next());
        if (!order && fits.back().rms_error < good_fit) break;
    }
    if (order || fits.back().rms_error < good_fit) return fits.back();
    constexpr double worth_it = 1.1;  // what more oscillators must gain
    return *std::find_if(fits.begin(), fits.end(), [&](const MemoryFit& f) {
        return f.rms_error < worth_it * fits.back().rms_error;
    });
}

}  // namespace hawser::master
