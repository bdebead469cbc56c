#include "memory_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "status.hpp"

namespace hawser::master {

namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Negative damping that is rounding, part of the largest damping.
constexpr double no_damping = 1e-6;

struct Poles {
    double a, b;
};

/// What is fitted: entries (i, j) of the upper triangle that matter, scaled, one column each.
struct Samples {
    VectorXd frequencies, weights;
    std::vector<std::pair<int, int>> entries;
    MatrixXcd values;  ///< frequencies x entries
    Vec6 scale;        ///< sqrt of the added mass of each motion
    double largest = 0.0;
};

/// Columns 2 (s + a)/((s + a)^2 + b^2) and -2 b/((s + a)^2 + b^2) of each pair, at s = i w.
MatrixXcd basis(const VectorXd& w, const std::vector<Poles>& poles) {
    MatrixXcd out(w.size(), 2 * std::ssize(poles));
    for (Eigen::Index k = 0; k < w.size(); ++k)
        for (std::size_t p = 0; p < poles.size(); ++p) {
            const Complex s(poles[p].a, w[k]);
            const Complex determinant = s * s + poles[p].b * poles[p].b;
            const auto column = static_cast<Eigen::Index>(2 * p);
            out(k, column) = 2.0 * s / determinant;
            out(k, column + 1) = -2.0 * poles[p].b / determinant;
        }
    return out;
}

MatrixXd stacked(const MatrixXcd& m) {
    MatrixXd out(2 * m.rows(), m.cols());
    out << m.real(), m.imag();
    return out;
}

Samples samples_of(const HydroData& data, const Mat6& infinite, double D) {
    Samples s;
    const auto n = std::ssize(data.frequencies);
    if (n < 8)
        throw RunError(ExitCode::input,
                       fmt::format("platform.hydrodynamics.added_mass.convolution: expected a "
                                   "database of at least 8 frequencies; found {}",
                                   n));
    // Motions of one kind that hardly move water (yaw of a spar) are seen on the scale of the rest.
    constexpr double least_scale = 1e-2;
    s.scale = infinite.diagonal().cwiseAbs().cwiseSqrt();
    for (int kind : {0, 3}) {
        const double top = s.scale.segment<3>(kind).maxCoeff();
        s.scale.segment<3>(kind) =
            s.scale.segment<3>(kind).cwiseMax(top > 0.0 ? least_scale * top : 1.0);
    }
    const bool with_zero = data.frequencies.front() > 0.0;  // H(0) = 0
    const Eigen::Index first = with_zero ? 1 : 0;
    s.frequencies = VectorXd::Zero(first + n);
    s.weights = VectorXd::Ones(first + n);
    std::vector<CMat6> all(static_cast<std::size_t>(first + n), CMat6::Zero());
    for (Eigen::Index k = first; k < first + n; ++k) {
        const auto i = static_cast<std::size_t>(k - first);
        const double w = data.frequencies[i];
        s.frequencies[k] = w;
        s.weights[k] = 1.0 / std::sqrt(1.0 + std::pow(w * D, 8));
        const CMat6 Z = data.damping[i].cast<Complex>() +
                        Complex(0.0, w) * (data.added_mass[i] - infinite).cast<Complex>();
        const CMat6 scaled = s.scale.cwiseInverse().asDiagonal() * (0.5 * (Z + Z.transpose())) *
                             s.scale.cwiseInverse().asDiagonal();
        all[static_cast<std::size_t>(k)] = scaled;
        s.largest = std::max(s.largest, s.weights[k] * scaled.cwiseAbs().maxCoeff());
    }
    constexpr double matters = 1e-3;
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) {
            double top = 0.0;
            for (Eigen::Index k = 0; k < first + n; ++k)
                top =
                    std::max(top, s.weights[k] * std::abs(all[static_cast<std::size_t>(k)](i, j)));
            if (top > matters * s.largest) s.entries.emplace_back(i, j);
        }
    s.values.resize(first + n, std::ssize(s.entries));
    for (Eigen::Index k = 0; k < first + n; ++k)
        for (std::size_t e = 0; e < s.entries.size(); ++e)
            s.values(k, static_cast<Eigen::Index>(e)) =
                all[static_cast<std::size_t>(k)](s.entries[e].first, s.entries[e].second);
    return s;
}

/// Better poles: the zeros of sigma in  sigma(s) H(s) = sum of the basis, sigma = 1 + the same.
std::vector<Poles> moved(const Samples& s, const std::vector<Poles>& poles, double fastest) {
    const MatrixXcd phi = basis(s.frequencies, poles);
    const Eigen::Index N = phi.cols(), m = s.values.cols();
    MatrixXd equations(N * m, N);
    VectorXd right(N * m);
    for (Eigen::Index e = 0; e < m; ++e) {
        MatrixXcd A(phi.rows(), 2 * N + 1);
        A << phi, -(s.values.col(e).asDiagonal() * phi), s.values.col(e);
        const MatrixXd rows = stacked(s.weights.cast<Complex>().asDiagonal() * A);
        const MatrixXd R =
            rows.householderQr().matrixQR().topRows(2 * N).template triangularView<Eigen::Upper>();
        equations.middleRows(e * N, N) = R.block(N, N, N, N);
        right.segment(e * N, N) = R.block(N, 2 * N, N, 1);
    }
    const VectorXd scale = equations.colwise().norm().cwiseMax(1e-300);
    const VectorXd c = (equations * scale.cwiseInverse().asDiagonal())
                           .colPivHouseholderQr()
                           .solve(right)
                           .cwiseQuotient(scale);
    MatrixXd A = MatrixXd::Zero(N, N);
    VectorXd b = VectorXd::Zero(N);
    for (std::size_t p = 0; p < poles.size(); ++p) {
        const auto i = static_cast<Eigen::Index>(2 * p);
        A.block<2, 2>(i, i) << -poles[p].a, poles[p].b, -poles[p].b, -poles[p].a;
        b[i] = 2.0;
    }
    const Eigen::VectorXcd zeros = (A - b * c.transpose()).eigenvalues();
    std::vector<Poles> out;
    std::vector<double> real;
    for (Eigen::Index i = 0; i < zeros.size(); ++i) {
        if (zeros[i].imag() > 1e-9)
            out.push_back({std::abs(zeros[i].real()), zeros[i].imag()});
        else if (zeros[i].imag() >= -1e-9)
            real.push_back(std::abs(zeros[i].real()));
    }
    std::sort(real.begin(), real.end());
    for (std::size_t i = 0; i + 1 < real.size(); i += 2)  // two real ones make a slow pair
        out.push_back({0.5 * (real[i] + real[i + 1]),
                       std::max(0.5 * (real[i + 1] - real[i]), 0.01 * fastest)});
    for (Poles& p : out) {
        p.a = std::max(p.a, 1e-3 * fastest);
        const double size = std::hypot(p.a, p.b);
        if (size > fastest) p.a *= fastest / size, p.b *= fastest / size;
    }
    std::sort(out.begin(), out.end(), [](const Poles& x, const Poles& y) { return x.b < y.b; });
    return out;
}

/// Re H at one frequency from the coefficients (basis x entries), scaled.
Mat6 damping_at(const Samples& s, const MatrixXd& real_basis, const MatrixXd& coefficients) {
    Mat6 out = Mat6::Zero();
    const MatrixXd row = real_basis * coefficients;
    for (std::size_t e = 0; e < s.entries.size(); ++e) {
        const auto [i, j] = s.entries[e];
        out(i, j) = out(j, i) = row(0, static_cast<Eigen::Index>(e));
    }
    return out;
}

struct Damping {
    double least = 0.0, most = 0.0;  ///< eigenvalues of Re H over all frequencies, scaled
    std::vector<std::pair<double, Vec6>> negative;  ///< frequency and motion of each dip below zero
};

Damping damping_of(const Samples& s, const std::vector<Poles>& poles, const MatrixXd& C) {
    constexpr int points = 600;
    const double top = 3.0 * s.frequencies[s.frequencies.size() - 1];
    Damping out;
    std::vector<std::pair<double, Vec6>> lowest;
    std::vector<double> value;
    VectorXd w(1);
    for (int k = 0; k <= points; ++k) {
        w[0] = top * k / points;
        const Eigen::SelfAdjointEigenSolver<Mat6> modes(damping_at(s, basis(w, poles).real(), C));
        value.push_back(modes.eigenvalues()[0]);
        lowest.emplace_back(w[0], modes.eigenvectors().col(0));
        out.least = std::min(out.least, value.back());
        out.most = std::max(out.most, modes.eigenvalues()[5]);
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
        const bool dips = (k == 0 || value[k] <= value[k - 1]) &&
                          (k + 1 == value.size() || value[k] <= value[k + 1]);
        if (dips && value[k] < -no_damping * out.most) out.negative.push_back(lowest[k]);
    }
    return out;
}

/// Changes the coefficients least, in the norm of the fit, so that no motion gains energy: the
/// damping of each motion and frequency where it dipped below zero is set to a trace above it.
void make_dissipative(const Samples& s, const std::vector<Poles>& poles, const MatrixXd& gram,
                      MatrixXd& C) {
    const Eigen::Index N = C.rows(), m = C.cols();
    const auto inverse = gram.ldlt();
    const MatrixXd start = C;
    std::vector<std::pair<double, Vec6>> held;
    VectorXd w(1);
    for (int round = 0; round < 40; ++round) {
        const Damping now = damping_of(s, poles, C);
        if (now.negative.empty()) return;
        if (2 * (std::ssize(held) + std::ssize(now.negative)) > N * m)
            return;  // nothing left to fit
        held.insert(held.end(), now.negative.begin(), now.negative.end());
        // u^T Re H(w) u = trace, one row each, over all coefficients
        const auto n = std::ssize(held);
        MatrixXd rows(N * m, n);
        VectorXd lack(n);
        for (Eigen::Index k = 0; k < n; ++k) {
            const auto& [frequency, u] = held[static_cast<std::size_t>(k)];
            w[0] = frequency;
            const MatrixXd phi = basis(w, poles).real();
            for (std::size_t e = 0; e < s.entries.size(); ++e) {
                const auto [i, j] = s.entries[e];
                const double share = (i == j ? 1.0 : 2.0) * u[i] * u[j];
                rows.block(static_cast<Eigen::Index>(e) * N, k, N, 1) = share * phi.transpose();
            }
            lack[k] = 10.0 * no_damping * now.most - u.dot(damping_at(s, phi, start) * u);
        }
        MatrixXd spread(N * m, n);
        for (Eigen::Index e = 0; e < m; ++e)
            spread.middleRows(e * N, N) = inverse.solve(rows.middleRows(e * N, N));
        const VectorXd pull =
            (rows.transpose() * spread).completeOrthogonalDecomposition().solve(lack);
        C = start + (spread * pull).reshaped(N, m);
    }
}

MemoryFit fit_of_order(const Samples& s, int order, double D) {
    const double fastest = 2.0 / D;
    const double last = std::min(s.frequencies[s.frequencies.size() - 1], fastest);
    std::vector<Poles> poles;
    for (int p = 1; p <= order; ++p) {
        const double b = last * p / (order + 0.5);
        poles.push_back({0.2 * b, b});
    }
    for (int i = 0; i < 12; ++i) poles = moved(s, poles, fastest);

    const MatrixXcd phi = basis(s.frequencies, poles);
    const MatrixXd A = stacked(s.weights.cast<Complex>().asDiagonal() * phi);
    const MatrixXd Z = stacked(s.weights.cast<Complex>().asDiagonal() * s.values);
    MatrixXd C = A.colPivHouseholderQr().solve(Z);
    MatrixXd gram = A.transpose() * A;
    gram.diagonal().array() += 1e-10 * gram.trace();
    make_dissipative(s, poles, gram, C);

    MemoryFit fit;
    const MatrixXd error = A * C - Z;
    fit.rms_error = error.norm() / Z.norm();
    const MatrixXcd complex_error =
        s.weights.cast<Complex>().asDiagonal() * (phi * C.cast<Complex>() - s.values);
    fit.largest_error = complex_error.cwiseAbs().maxCoeff() / s.largest;
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
    if (order) return fit_of_order(samples, *order, D);
    constexpr double good = 0.005;
    MemoryFit best;
    for (const int n : {3, 4, 5, 6, 8, 10, most_oscillators}) {
        if (4 * n > 2 * std::ssize(samples.frequencies)) break;
        MemoryFit fit = fit_of_order(samples, n, D);
        if (best.oscillators.empty() || fit.rms_error < best.rms_error) best = std::move(fit);
        if (best.rms_error < good) break;
    }
    return best;
}

}  // namespace hawser::master
