#include "rod/modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "status.hpp"

namespace hawser::worker {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Multipliers count in units that make their rows as large as the others.
Eigen::VectorXd scaling(const Sparse& J) {
    double sum = 0.0;
    int n = 0;
    for (Eigen::Index i = 6; i < J.rows(); i += 7) sum += std::abs(J.coeff(i, i)), ++n;
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(J.rows());
    if (sum > 0.0)
        for (Eigen::Index i = 6; i < J.rows(); i += 7) scale[i] = 1.0 / std::sqrt(sum / n);
    return scale;
}

/// Numbers in -1 ... 1, the same every time, for starting vectors.
class Numbers {
 public:
    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1.0;
    }

 private:
    unsigned long long state_ = 20110619;
};

/// Makes the columns of X orthonormal in M and takes what belongs to them along: M X, and M U with
/// X = (J + shift M)^-1 M U. Twice, for a rigid mode may be a million times the others.
void orthonormalise(Eigen::MatrixXd& X, Eigen::MatrixXd& MX, Eigen::MatrixXd& MU) {
    for (Eigen::Index k = 0; k < X.cols(); ++k) {
        for (int twice = 0; twice < 2; ++twice) {
            for (Eigen::Index j = 0; j < k; ++j) {
                const double c = X.col(j).dot(MX.col(k));
                X.col(k) -= c * X.col(j), MX.col(k) -= c * MX.col(j), MU.col(k) -= c * MU.col(j);
            }
            const double size = 1.0 / std::sqrt(X.col(k).dot(MX.col(k)));
            X.col(k) *= size, MX.col(k) *= size, MU.col(k) *= size;
        }
    }
}

}  // namespace

Eigenmodes lowest_modes(const SmallMotion& motion, int count) {
    const Eigen::Index n = motion.mass.rows();
    Eigen::Index massive = 0;
    for (Eigen::Index i = 0; i < n; ++i) massive += motion.mass.coeff(i, i) > 0.0;
    const Eigen::Index wanted = std::min<Eigen::Index>(count, massive);
    const Eigen::Index m = std::min<Eigen::Index>(2 * wanted + 8, massive);

    // A small shift keeps a rod that nothing holds in some direction solvable.
    constexpr double shift = 1e-6;  // [rad2/s2], a period of 6000 s
    const Eigen::VectorXd scale = scaling(motion.stiffness);
    Sparse J = motion.stiffness + shift * motion.mass;
    J = Sparse(scale.asDiagonal() * J * scale.asDiagonal());
    Eigen::SparseLU<Sparse> solver(J);
    if (solver.info() != Eigen::Success)
        throw RunError(ExitCode::no_equilibrium, "modes: the stiffness is singular");

    Numbers numbers;
    Eigen::MatrixXd U(n, m);
    for (Eigen::Index k = 0; k < m; ++k)
        for (Eigen::Index i = 0; i < n; ++i) U(i, k) = numbers.next();
    Eigenmodes out;
    out.omega_squared = Eigen::VectorXd::Zero(m);
    Eigen::MatrixXd MU = motion.mass * U;
    bool close = false;
    for (int iteration = 0; iteration < 300; ++iteration) {
        const Eigen::MatrixXd solved = solver.solve(Eigen::MatrixXd(scale.asDiagonal() * MU));
        Eigen::MatrixXd X = scale.asDiagonal() * solved;
        Eigen::MatrixXd MX = motion.mass * X;
        orthonormalise(X, MX, MU);
        // Ritz: X^T (J + shift M) X = X^T M U
        const Eigen::MatrixXd A = X.transpose() * MU, B = X.transpose() * MX;
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
            0.5 * (A + A.transpose()), 0.5 * (B + B.transpose()));
        const Eigen::VectorXd found = ritz.eigenvalues().array() - shift;
        U = X * ritz.eigenvectors();
        MU = MX * ritz.eigenvectors();
        const Eigen::VectorXd change = (found - out.omega_squared).head(wanted).cwiseAbs();
        const bool settled =
            (change.array() <= 1e-12 * found.head(wanted).array().abs() + 1e-14).all();
        // rounding may keep the last digits of the highest from standing still
        close = (change.array() <= 1e-6 * found.head(wanted).array().abs() + 1e-10).all();
        out.omega_squared = found;
        if (settled) break;
    }
    if (!close) throw RunError(ExitCode::no_equilibrium, "modes: their iteration does not settle");
    out.omega_squared.conservativeResize(wanted);
    out.shapes = U.leftCols(wanted);
    return out;
}

template <class V>
std::vector<RodMode> rod_modes(RodPack<V>& pack, int lane, const Case& input, int count) {
    using T = LaneTraits<V>;
    const auto N = static_cast<std::size_t>(pack.elements());
    const Line& line =
        input.lines[static_cast<std::size_t>(pack.lines()[static_cast<std::size_t>(lane)])];
    const Vec3 along =
        plane_of(line, pack.node_position(lane, 0), pack.node_position(lane, static_cast<int>(N)));
    const Vec3 normal = Vec3::UnitZ().cross(along);

    // Parts of a motion along the rod and out of its plane, slopes with positions: a mode whose
    // half wave is an element stands still at the nodes
    const SmallMotion motion = pack.small_motion(lane);
    Eigenmodes found;
    try {
        found = lowest_modes(motion, count);
    } catch (const RunError& error) {
        throw RunError(ExitCode::no_equilibrium, line.name + ": " + error.what());
    }
    const Eigen::Index rows = motion.mass.rows();
    std::vector<Vec3> tangent;
    for (std::size_t n = 0; n <= N; ++n) {
        const Vector<V>& d = pack.kept().nodes()[n].d;
        tangent.push_back(
            Vec3(T::get(d.x, lane), T::get(d.y, lane), T::get(d.z, lane)).normalized());
    }
    const auto part = [&](const Eigen::MatrixXd& x, const auto& direction) {
        Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows, x.cols());
        for (std::size_t n = 0; n <= N; ++n) {
            const Vec3& k = direction(n);
            const auto first = static_cast<Eigen::Index>(7 * n);
            for (const Eigen::Index row : {first, first + 3})
                out.middleRows<3>(row) = k * (k.transpose() * x.middleRows<3>(row));
        }
        return out;
    };
    const auto axial_part = [&](const Eigen::MatrixXd& x) {
        return part(x, [&](std::size_t n) { return tangent[n]; });
    };
    const auto outward_part = [&](const Eigen::MatrixXd& x) {
        return part(x, [&](std::size_t) -> const Vec3& { return normal; });
    };
    const auto at = [&](const Eigen::VectorXd& x, std::size_t n) {
        return Vec3(x.segment<3>(static_cast<Eigen::Index>(7 * n)));
    };

    // Modes of one frequency: turned to move out of the plane as little, and as much, as they can
    const Eigen::Index modes = found.omega_squared.size();
    for (Eigen::Index i = 0; i < modes;) {
        Eigen::Index j = i + 1;
        while (j < modes && std::abs(found.omega_squared[j] - found.omega_squared[i]) <=
                                1e-7 * std::abs(found.omega_squared[i]))
            ++j;
        if (j > i + 1) {
            const Eigen::MatrixXd outward = outward_part(found.shapes.middleCols(i, j - i));
            const Eigen::MatrixXd out_of_plane = outward.transpose() * (motion.mass * outward);
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> turn(out_of_plane);
            found.shapes.middleCols(i, j - i) =
                Eigen::MatrixXd(found.shapes.middleCols(i, j - i) * turn.eigenvectors());
        }
        i = j;
    }

    std::vector<RodMode> out;
    for (Eigen::Index k = 0; k < modes; ++k) {
        const Eigen::VectorXd x = found.shapes.col(k);
        RodMode mode;
        mode.omega_squared = found.omega_squared[k];
        const Eigen::VectorXd axial = axial_part(x), outward = outward_part(x),
                              rest = x - axial - outward;
        const auto energy = [&](const Eigen::VectorXd& y) { return y.dot(motion.mass * y); };
        mode.axial = energy(axial), mode.out_of_plane = energy(outward);
        mode.in_plane = energy(rest);
        const double sum = mode.axial + mode.in_plane + mode.out_of_plane;
        mode.axial /= sum, mode.in_plane /= sum, mode.out_of_plane /= sum;
        std::size_t widest = 0;
        for (std::size_t n = 0; n <= N; ++n)
            if (at(x, n).norm() > at(x, widest).norm() * (1.0 + 1e-6)) widest = n;
        const double most = std::max({mode.axial, mode.in_plane, mode.out_of_plane});
        mode.kind = most == mode.axial      ? RodMode::Kind::axial
                    : most == mode.in_plane ? RodMode::Kind::in_plane
                                            : RodMode::Kind::out_of_plane;
        Eigen::Index sign = 0;
        const Vec3 peak = at(x, widest);
        peak.cwiseAbs().maxCoeff(&sign);
        const double factor = 1.0 / std::copysign(peak.norm(), peak[sign]);
        for (std::size_t n = N + 1; n-- > 0;) mode.shape.push_back(factor * at(x, n));
        out.push_back(std::move(mode));
    }
    return out;
}

template std::vector<RodMode> rod_modes(RodPack<Single>&, int, const Case&, int);
template std::vector<RodMode> rod_modes(RodPack<Quad>&, int, const Case&, int);

}  // namespace hawser::worker
