// The rod element: internal force and constraint are the gradient of one function, the Jacobian is
// their derivative: R:9 to R:15.
#include <gtest/gtest.h>

#include <cmath>

#include "full_element.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

constexpr double L = 12.0, EA = 5e8, EI = 3e7, mass = 100.0, gravity = 9.80665;

/// A bent, twisted and stretched element as 15 numbers, and back.
Vector15 bent() {
    Vector15 x;
    x << 1.0, 2.0, -30.0, 0.93, 0.21, 0.35, 2.1e6, 11.4, 5.1, -26.5, 0.86, 0.40, 0.38, 2.4e6, 2.2e6;
    return x;
}
TrialNode<Single> node_of(const Vector15& x, int first) {
    return node_at(x.segment<3>(first), x.segment<3>(first + 3));
}
FullElement assemble(const Vector15& x) {
    return full_element(dry_element(L, EA, EI, mass, gravity), node_of(x, 0), node_of(x, 7),
                        {x[6], x[14], x[13]}, elastic(EA));
}

/// int 1/2 B r''^2 + 1/2 lambda r'.r' - 1/2 int G^2 dlambda + w z ds, R:6: its gradient in r is the
/// force balance, its gradient in lambda is the stretch constraint. Simpson's rule, 200 intervals.
double potential(const Vector15& x) {
    const Vec3 ra = x.segment<3>(0), da = x.segment<3>(3), rb = x.segment<3>(7),
               db = x.segment<3>(10);
    const int n = 200;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) {
        const double q = static_cast<double>(i) / n, s = 1.0 / EA;
        const auto A = hermite(q);
        const auto a1 = reduced_slope(q), a2 = reduced_curvature(q), P = quadratic(q);
        const Vec3 r = A[0] * ra + L * A[1] * da + A[2] * rb + L * A[3] * db;
        const Vec3 slope = (a1[0] * (rb - ra) + a1[1] * L * da + a1[2] * L * db) / L;
        const Vec3 curvature = (a2[0] * (rb - ra) + a2[1] * L * da + a2[2] * L * db) / (L * L);
        const double lambda = P[0] * x[6] + P[1] * x[14] + P[2] * x[13];
        const double complementary = 0.5 / (s * (1.0 - s * lambda)) - 0.5 / s;
        const double density = 0.5 * EI * curvature.squaredNorm() +
                               0.5 * lambda * slope.squaredNorm() - complementary +
                               mass * gravity * r.z();
        sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * density;
    }
    return sum * L / (3 * n);
}

/// Size of a typical change of each coefficient, so that one tolerance serves all.
double size_of(int i) { return i == 6 || i >= 13 ? 1e5 : 0.05; }

TEST(RodElement, ResidualIsTheGradientOfOnePotential) {  // R:9, R:10, R:11, R:12
    const Vector15 x = bent();
    const FullElement e = assemble(x);
    for (int i = 0; i < 15; ++i) {
        // five-point difference: the potential is of fourth order in the coefficients
        const double h = size_of(i);
        const auto at = [&](double k) {
            Vector15 y = x;
            y[i] += k * h;
            return potential(y);
        };
        const double work = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / 12.0;
        // 1e-7 of the work of 1 MN over 0.05 m: cancellation in differences of 1e8 N.m
        EXPECT_NEAR(e.R[i] * h, work, 5e-3) << i;
    }
}

TEST(RodElement, JacobianIsSymmetricAndTheDerivativeOfTheResidual) {  // R:13, R:14, R:15
    const Vector15 x = bent();
    const Matrix15 J = assemble(x).J;
    for (int k = 0; k < 15; ++k) {
        const double h = 1e-3 * size_of(k);
        Vector15 up = x, down = x;
        up[k] += h, down[k] -= h;
        const Vector15 column = (assemble(up).R - assemble(down).R) / (2 * h);
        for (int i = 0; i < 15; ++i)
            // work of two typical changes; central difference, rounding 1e-16/1e-3
            EXPECT_NEAR(J(i, k) * size_of(i) * size_of(k), column[i] * size_of(i) * size_of(k),
                        1e-7 * 5e4)
                << i << ", " << k;
    }
    EXPECT_GT(J.norm(), 0.0);
}

TEST(RodElement, MovesWithARigidMotionWithoutChange) {
    const Vector15 x = bent();
    const Eigen::Matrix3d Q = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()).matrix();
    Vector15 y = x;
    for (const int i : {0, 3, 7, 10}) y.segment<3>(i) = Q * x.segment<3>(i);
    for (const int i : {0, 7}) y.segment<3>(i) += Vec3(100, -50, 20);
    const auto weightless = [](const Vector15& z) {
        return full_element(dry_element(L, EA, EI, mass), node_of(z, 0), node_of(z, 7),
                            {z[6], z[14], z[13]}, elastic(EA))
            .R;
    };
    const Vector15 Rx = weightless(x), Ry = weightless(y);
    for (const int i : {0, 3, 7, 10})
        EXPECT_LT((Ry.segment<3>(i) - Q * Rx.segment<3>(i)).norm(), 1e-9 * Rx.norm()) << i;
    for (const int i : {6, 13, 14}) EXPECT_NEAR(Ry[i], Rx[i], 1e-9) << i;
    // internal forces balance, and so do their moments with the moments on the slopes
    EXPECT_LT((Rx.segment<3>(0) + Rx.segment<3>(7)).norm(), 1e-9 * Rx.norm());
    Vec3 moment = Vec3::Zero();
    for (const int i : {0, 3, 7, 10}) {
        const Vec3 position = x.segment<3>(i), force = Rx.segment<3>(i);
        moment += position.cross(force);
    }
    EXPECT_LT(moment.norm(), 1e-9 * Rx.norm() * L);
}

TEST(RodElement, TensionFollowsTheExactStretchLaw) {  // R:6: T = EA e at any strain
    for (const double strain : {0.001, 0.05, -0.02}) {
        const double T = EA * strain, lambda = T / (1 + strain);
        const Vec3 u = Vec3(2, -1, 2) / 3;
        const FullElement e = full_element(
            dry_element(L, EA, EI, mass), node_at({0, 0, 0}, (1 + strain) * u),
            node_at(L * (1 + strain) * u, (1 + strain) * u), {lambda, lambda, lambda}, elastic(EA));
        EXPECT_LT((e.R.segment<3>(7) - T * u).norm(), 1e-9 * EA) << strain;
        for (const int i : {6, 13, 14}) EXPECT_NEAR(e.R[i], 0.0, 1e-12) << strain;
    }
}

TEST(RodElement, InertiaCarriesTheWholeMassInAnyDirection) {  // R:16 with the rigid motions
    const Vector15 x = bent();
    const double a0 = 1234.0;
    const Matrix15 M = (full_element(dry_element(L, EA, EI, mass), node_of(x, 0), node_of(x, 7),
                                     {x[6], x[14], x[13]}, elastic(EA), a0)
                            .J -
                        full_element(dry_element(L, EA, EI, mass), node_of(x, 0), node_of(x, 7),
                                     {x[6], x[14], x[13]}, elastic(EA))
                            .J) /
                       a0;
    const double slope = 0.7;
    for (int c = 0; c < 3; ++c) {
        Vector15 shift = Vector15::Zero(), turn = Vector15::Zero();
        shift[c] = shift[7 + c] = 1.0;
        turn[3 + c] = turn[10 + c] = slope, turn[7 + c] = slope * L;  // about node a
        EXPECT_NEAR(shift.dot(M * shift), mass * L, 1e-8 * mass * L);
        EXPECT_NEAR(shift.dot(M * turn), mass * L * L / 2 * slope, 1e-8 * mass * L * L);
        EXPECT_NEAR(turn.dot(M * turn), mass * L * L * L / 3 * slope * slope,
                    1e-8 * mass * L * L * L);
    }
}

}  // namespace
}  // namespace hawser::worker
