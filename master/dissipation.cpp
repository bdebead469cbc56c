#include "dissipation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "nonnegative.hpp"

namespace hawser::master {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Negative damping that is rounding, part of the largest damping.
constexpr double no_damping = 1e-6;

/// Where damping is looked at: so many frequencies up to so many times the last datum.
constexpr int looks = 600;
constexpr double beyond = 3.0;

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

}  // namespace

double look_spacing(const Samples& s) { return beyond * last_of(s) / looks; }

Damping damping_of(const Samples& s, const std::vector<Poles>& poles, const MatrixXd& C) {
    Damping out;
    std::vector<Dip> lowest;
    std::vector<double> value;
    VectorXd w(1);
    for (int k = 1; k <= looks; ++k) {
        w[0] = k * look_spacing(s);
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

}  // namespace hawser::master
