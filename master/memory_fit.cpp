#include "memory_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "nonnegative.hpp"
#include "status.hpp"

namespace hawser::master {

namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rms error that "auto" is content with.
constexpr double good_fit = 0.005;

/// Negative damping that is rounding, part of the largest damping.
constexpr double no_damping = 1e-6;

/// Where the damping of a fit is looked at: so many frequencies up to so many times the last datum.
constexpr int looks = 600;
constexpr double beyond = 3.0;

struct Poles {
    double a, b;
};

/// What is fitted: entries (i, j) of the upper triangle that matter, scaled, one column each.
struct Samples {
    VectorXd frequencies, weights;
    std::vector<std::pair<int, int>> entries;
    MatrixXcd values;  ///< frequencies x entries
    Vec6 scale;        ///< sqrt of the size of each motion's entry
    double largest = 0.0;
};

double last_of(const Samples& s) { return s.frequencies[s.frequencies.size() - 1]; }

/// A resonance narrower than this the data do not show, and a look would miss it.
double slowest_decay(const Samples& s) { return beyond * last_of(s) / looks; }

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

/// N x (N - 1): the combinations of the N basis functions that vanish at w = 0.
MatrixXd at_rest_at_zero(const std::vector<Poles>& poles) {
    const VectorXd zero = VectorXd::Zero(1);
    const MatrixXd row = basis(zero, poles).real();
    const Eigen::HouseholderQR<MatrixXd> qr(row.transpose());
    const MatrixXd Q = qr.householderQ();
    return Q.rightCols(Q.cols() - 1);
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
    // Each motion is seen on the scale of its own radiation, but what hardly makes waves (heave of
    // a spar, whose added mass the radiation hardly changes) not below a part of its inertia.
    constexpr double least_share = 0.01, least_scale = 1e-2;
    Vec6 size = Vec6::Zero();
    for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
        const double w = data.frequencies[i];
        const Mat6 change = w * (data.added_mass[i] - infinite);
        const Vec6 Z = data.damping[i].diagonal().cwiseAbs2() + change.diagonal().cwiseAbs2();
        const Vec6 inertia = least_share * w * infinite.diagonal().cwiseAbs();
        const double weight = 1.0 / std::sqrt(1.0 + std::pow(w * D, 8));
        size = size.cwiseMax(weight * Z.cwiseSqrt().cwiseMax(inertia));
    }
    s.scale = size.cwiseSqrt();
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
    const MatrixXcd numerator = phi * at_rest_at_zero(poles).cast<Complex>();
    const Eigen::Index N = phi.cols(), M = numerator.cols(), m = s.values.cols();
    MatrixXd equations(N * m, N);
    VectorXd right(N * m);
    for (Eigen::Index e = 0; e < m; ++e) {
        MatrixXcd A(phi.rows(), M + N + 1);
        A << numerator, -(s.values.col(e).asDiagonal() * phi), s.values.col(e);
        const MatrixXd rows = stacked(s.weights.cast<Complex>().asDiagonal() * A);
        const MatrixXd R =
            rows.householderQr().matrixQR().topRows(M + N).template triangularView<Eigen::Upper>();
        equations.middleRows(e * N, N) = R.block(M, M, N, N);
        right.segment(e * N, N) = R.block(M, M + N, N, 1);
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
        p.a = std::max(p.a, slowest_decay(s));
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

struct Dip {
    double frequency;
    Vec6 motion;  ///< eigenvector of the least damping there
};

struct Damping {
    double least = 0.0, most = 0.0;  ///< eigenvalues of Re H over all frequencies, scaled
    std::vector<Dip> dips;           ///< where it goes below zero
};

Damping damping_of(const Samples& s, const std::vector<Poles>& poles, const MatrixXd& C) {
    Damping out;
    std::vector<Dip> lowest;
    std::vector<double> value;
    VectorXd w(1);
    for (int k = 1; k <= looks; ++k) {
        w[0] = beyond * last_of(s) * k / looks;
        const Eigen::SelfAdjointEigenSolver<Mat6> modes(damping_at(s, basis(w, poles).real(), C));
        value.push_back(modes.eigenvalues()[0]);
        lowest.push_back({w[0], modes.eigenvectors().col(0)});
        out.least = std::min(out.least, value.back());
        out.most = std::max(out.most, modes.eigenvalues()[5]);
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
        const bool dips = (k == 0 || value[k] <= value[k - 1]) &&
                          (k + 1 == value.size() || value[k] <= value[k + 1]);
        if (dips && value[k] < -no_damping * out.most) out.dips.push_back(lowest[k]);
    }
    return out;
}

/// Changes the coefficients least, in the norm of the fit, so that no motion gains energy:
///
///     least |A C - A C_start|  with  u^T Re H(w) u >= 0
///
/// for the motion u and frequency w of every dip below zero, found one set after another.
void make_dissipative(const Samples& s, const std::vector<Poles>& poles, const MatrixXd& A,
                      const MatrixXd& T, MatrixXd& C) {
    const Eigen::Index N = T.cols(), m = C.cols();
    // y = U T^T C, U^T U = gram: distances in y are those of the fit
    MatrixXd gram = T.transpose() * A.transpose() * A * T;
    gram.diagonal().array() += 1e-12 * gram.trace();
    const Eigen::LLT<MatrixXd> llt(gram);
    const VectorXd start = MatrixXd(llt.matrixU() * (T.transpose() * C)).reshaped();
    std::vector<VectorXd> rows;  // of unit length
    std::vector<double> least;
    VectorXd pull, w(1);
    for (int round = 0; round < 60; ++round) {
        const Damping now = damping_of(s, poles, C);
        if (now.dips.empty()) return;
        for (const Dip& dip : now.dips) {
            w[0] = dip.frequency;
            const VectorXd phi =
                llt.matrixL().solve(T.transpose() * basis(w, poles).real().transpose());
            VectorXd row(N * m);
            for (std::size_t e = 0; e < s.entries.size(); ++e) {
                const auto [i, j] = s.entries[e];
                row.segment(static_cast<Eigen::Index>(e) * N, N) =
                    (i == j ? 1.0 : 2.0) * dip.motion[i] * dip.motion[j] * phi;
            }
            // a trace above zero, so that the next look between two cuts is done with
            const double trace = no_damping * now.most * std::min(1.0, dip.frequency / last_of(s));
            least.push_back(trace / row.norm());
            rows.push_back(row.normalized());
        }
        const auto n = std::ssize(rows);
        MatrixXd G(N * m, n);
        VectorXd lack(n);
        for (Eigen::Index k = 0; k < n; ++k) {
            G.col(k) = rows[static_cast<std::size_t>(k)];
            lack[k] = least[static_cast<std::size_t>(k)] - G.col(k).dot(start);
        }
        pull.conservativeResizeLike(VectorXd::Zero(n));
        solve_nonnegative(G.transpose() * G, lack, pull);
        const VectorXd y = start + G * pull;
        C = T * llt.matrixU().solve(y.reshaped(N, m));
    }
}

MatrixXd weighted(const Samples& s, const MatrixXcd& m) {
    return stacked(s.weights.cast<Complex>().asDiagonal() * m);
}

/// Poles moved a dozen times; those with the least error on the way.
std::vector<Poles> settled(const Samples& s, std::vector<Poles> poles, double fastest) {
    const MatrixXd Z = weighted(s, s.values);
    std::vector<Poles> best = poles;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 12; ++i) {
        poles = moved(s, poles, fastest);
        const MatrixXd A = weighted(s, basis(s.frequencies, poles)) * at_rest_at_zero(poles);
        const double error = (A * A.colPivHouseholderQr().solve(Z) - Z).norm();
        if (error < least) least = error, best = poles;
    }
    return best;
}

MemoryFit fit_of(const Samples& s, const std::vector<Poles>& poles) {
    const MatrixXcd phi = basis(s.frequencies, poles);
    const MatrixXd A = weighted(s, phi), Z = weighted(s, s.values), T = at_rest_at_zero(poles);
    MatrixXd C = T * MatrixXd(A * T).colPivHouseholderQr().solve(Z);
    make_dissipative(s, poles, A, T, C);

    MemoryFit fit;
    fit.rms_error = (A * C - Z).norm() / Z.norm();
    const MatrixXcd error =
        s.weights.cast<Complex>().asDiagonal() * (phi * C.cast<Complex>() - s.values);
    fit.largest_error = error.cwiseAbs().maxCoeff() / s.largest;
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
