#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "coupled_modes.hpp"
#include "rigid_body.hpp"

namespace hawser::master {
namespace {

LineStiffness constant(const Mat6& K) {
    return [K](double) { return K; };
}
const LineStiffness none = constant(Mat6::Zero());

TEST(CoupledModes, AreTwoPiRootMassOverStiffnessWithoutCoupling) {
    Vec6 k, m;
    k << 4e5, 3e5, 1e7, 5e9, 6e9, 4e8;
    m << 2e8, 2e8, 1.5e8, 4e11, 4e11, 2e10;
    const auto modes = coupled_modes(k.asDiagonal(), constant(m.asDiagonal()), none);
    for (int i = 0; i < 6; ++i) {
        const CoupledMode& mode = modes[std::size_t(i)];
        EXPECT_EQ(mode.motion, i);
        EXPECT_NEAR(mode.period().value(), 2 * M_PI * std::sqrt(m[i] / k[i]), 1e-9);
        EXPECT_NEAR((mode.shape - Vec6::Unit(i)).norm(), 0.0, 1e-9);
        EXPECT_NEAR(mode.share, 1.0, 1e-12);
        EXPECT_EQ(mode.line_inertia, 0.0);
    }
}

TEST(CoupledModes, DoNotDependOnTheReferencePoint) {
    // A body on springs at its centre of gravity, seen from a point 60 m above.
    RigidBody body{.mass = 1e8, .centre_of_gravity = {0, 0, -60}, .inertia = Mat3::Zero()};
    body.inertia.diagonal() << 7e11, 7e11, 2e10;
    Vec6 k;
    k << 4e5, 3e5, 1e7, 9e9, 8e9, 4e8;
    Mat6 to_G = Mat6::Identity();  // displacement of G from that of O
    to_G.block<3, 3>(0, 3) = -skew(body.centre_of_gravity);
    const Mat6 K = to_G.transpose() * k.asDiagonal() * to_G;
    const auto modes =
        coupled_modes(K, constant(mass_matrix(turned(body, Mat3::Identity()))), none);
    const double m[] = {1e8, 1e8, 1e8, 7e11, 7e11, 2e10};
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(modes[std::size_t(i)].period().value(), 2 * M_PI * std::sqrt(m[i] / k[i]),
                    1e-6);
}

TEST(CoupledModes, AreEmptyWhereNothingHolds) {
    Vec6 k;
    k << 0, 0, 1e7, 5e9, 6e9, 0;
    const auto modes = coupled_modes(k.asDiagonal(), constant(Mat6::Identity() * 1e8), none);
    EXPECT_FALSE(modes[0].period() || modes[1].period() || modes[5].period());
    EXPECT_TRUE(modes[2].period() && modes[3].period() && modes[4].period());
}

/// Springs from points of a spar to the ground, as one matrix about O.
Mat6 springs(const std::vector<std::pair<Vec3, Vec3>>& at) {
    Mat6 K = Mat6::Zero();
    for (const auto& [point, k] : at) {
        Eigen::Matrix<double, 3, 6> B;
        B << Mat3::Identity(), -skew(point);
        K += B.transpose() * k.asDiagonal() * B;
    }
    return K;
}

TEST(CoupledModes, OfASpringMooredSparAreThoseOfItsSixBySixMatrices) {
    RigidBody spar{.mass = 1e8, .centre_of_gravity = {0, 0, -66}, .inertia = Mat3::Zero()};
    spar.inertia.diagonal() << 7e11, 7e11, 2e10;
    const Mat6 M = mass_matrix(turned(spar, Mat3::Identity()));
    Vec6 hydrostatic;
    hydrostatic << 0, 0, 1.26e7, 1.5e10, 1.5e10, 0;
    const Mat6 K = hydrostatic.asDiagonal();
    const Mat6 S = springs({{{20, 0, -60}, {2e5, 1e5, 1e5}},
                            {{-10, 17, -60}, {1e5, 2e5, 1e5}},
                            {{-10, -17, -60}, {1e5, 2e5, 1e5}}});
    const auto modes = coupled_modes(K, constant(M), constant(S));
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> exact(Mat6(K + S), M);
    std::vector<double> got;
    for (const CoupledMode& mode : modes) {
        ASSERT_TRUE(mode.converged);
        got.push_back(mode.omega_squared);
        // it is a solution, and the lines' share of the elastic energy is the springs'
        const Vec6 left = (K + S - mode.omega_squared * M) * mode.shape;
        EXPECT_LT(left.norm(), 1e-8 * ((K + S) * mode.shape).norm() + 1e-3);
        EXPECT_NEAR(mode.line_stiffness,
                    mode.shape.dot(S * mode.shape) / mode.shape.dot((K + S) * mode.shape), 1e-9);
    }
    std::sort(got.begin(), got.end());
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(got[std::size_t(i)] / exact.eigenvalues()[i], 1.0, 1e-9) << i;
}

TEST(CoupledModes, OfAMassOnATendonIsTheRootOfTheFrequencyEquation) {
    // M w^2 = EA k cot(k L), k = w sqrt(m/EA): a heavy tendon, a third of the mass it holds
    const double EA = 6e9, L = 3000, m = 235, M = 2e6;
    const auto cotangent = [&](double w) {
        const double k = std::max(w, 1e-6) * std::sqrt(m / EA);
        return EA * k / std::tan(k * L);
    };
    const LineStiffness tendon = [&](double w) {
        Mat6 S = 1e12 * Mat6::Identity();
        S(2, 2) = cotangent(w);
        return S;
    };
    double low = 0.1, high = M_PI / 2 / L * std::sqrt(EA / m);  // where the cotangent vanishes
    for (int i = 0; i < 100; ++i) {
        const double w = 0.5 * (low + high);
        (cotangent(w) > M * w * w ? low : high) = w;
    }
    const auto modes = coupled_modes(Mat6::Zero(), constant(Mat6::Identity() * M), tendon);
    EXPECT_TRUE(modes[2].converged);
    EXPECT_NEAR(std::sqrt(modes[2].omega_squared), low, 1e-8 * low);
    // Rayleigh: about a third of the tendon moves along
    EXPECT_NEAR(modes[2].line_inertia, m * L / 3 / (M + m * L / 3), 0.02);
    EXPECT_EQ(modes[2].line_stiffness, 1.0);
}

TEST(CoupledModes, AmongTheLinesOwnSwingsAreThoseWithMostOfThePlatform) {  // K:26
    // A mass on a spring carries eleven small ones on springs of their own, S = sum k - k^2/(k - m
    // w^2), whose frequencies lie about its own: an eigenproblem of twelve masses. Of its modes the
    // one with most of the platform is wanted, wherever the small ones lie.
    constexpr int n = 11;
    constexpr double M = 1.0, K = 1.0, m = 0.03;
    for (const double shift : {0.97, 0.985, 1.0, 1.015, 1.03}) {
        Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n + 1, n + 1), stiffness = mass;
        mass(0, 0) = M;
        stiffness(0, 0) = K;
        std::array<double, n> k{};
        for (int i = 0; i < n; ++i) {
            const double w = shift * (0.75 + 0.05 * i);
            k[static_cast<std::size_t>(i)] = m * w * w;
            mass(i + 1, i + 1) = m;
            stiffness(0, 0) += m * w * w;
            stiffness(i + 1, i + 1) = m * w * w;
            stiffness(0, i + 1) = stiffness(i + 1, 0) = -m * w * w;
        }
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> exact(stiffness, mass);
        Eigen::Index wanted = 0;
        exact.eigenvectors().row(0).cwiseAbs().maxCoeff(&wanted);
        const LineStiffness small = [&](double w) {
            Mat6 S = 1e6 * Mat6::Identity();
            S(0, 0) = 0.0;
            for (const double each : k) S(0, 0) += each - each * each / (each - m * w * w);
            return S;
        };
        const auto modes =
            coupled_modes(Vec6::Unit(0).asDiagonal(), constant(Mat6::Identity() * M), small);
        EXPECT_TRUE(modes[0].converged) << shift;
        EXPECT_NEAR(modes[0].omega_squared / exact.eigenvalues()[wanted], 1.0, 1e-8) << shift;
    }
}

}  // namespace
}  // namespace hawser::master
