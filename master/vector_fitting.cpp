#include "vector_fitting.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dissipation.hpp"

namespace hawser::master {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A resonance narrower than this the data do not show, and a look would miss it.
double slowest_decay(const Samples& s) { return look_spacing(s); }

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
        const MatrixXd rows = weighted(s, A);
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

}  // namespace

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

}  // namespace hawser::master
