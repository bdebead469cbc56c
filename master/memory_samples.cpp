#include "memory_samples.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "status.hpp"

namespace hawser::master {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using CMat6 = Eigen::Matrix<Complex, 6, 6>;

double last_of(const Samples& s) { return s.frequencies[s.frequencies.size() - 1]; }

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

MatrixXd at_rest_at_zero(const std::vector<Poles>& poles) {
    const VectorXd zero = VectorXd::Zero(1);
    const MatrixXd row = basis(zero, poles).real();
    const Eigen::HouseholderQR<MatrixXd> qr(row.transpose());
    const MatrixXd Q = qr.householderQ();
    return Q.rightCols(Q.cols() - 1);
}

MatrixXd weighted(const Samples& s, const MatrixXcd& rows) {
    MatrixXd out(2 * rows.rows(), rows.cols());
    out << s.weights.asDiagonal() * rows.real(), s.weights.asDiagonal() * rows.imag();
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

}  // namespace hawser::master
