#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "force_fit.hpp"

namespace hawser {
namespace {

/// The fit's value at the end of the pass for a history f(q), q = i/n.
template <class F>
double fitted(ForceFit fit, int n, F&& f) {
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) sum += fit_weight(fit, i, n) * f(double(i) / n);
    return sum;
}

TEST(ForceFit, InstantaneousIsTheLastValue) {
    for (int n : {1, 2, 25}) EXPECT_EQ(fitted(ForceFit::instantaneous, n, exp), exp(1.0));
}

TEST(ForceFit, IsTheLeastSquaresPolynomialAtTheEnd) {  // P:4
    for (const auto& [fit, degree] :
         {std::pair{ForceFit::linear_fit, 1}, std::pair{ForceFit::quadratic_fit, 2}})
        for (int n = degree; n <= 40; n += 3) {
            Eigen::MatrixXd A(n + 1, degree + 1);
            Eigen::VectorXd f(n + 1);
            for (int i = 0; i <= n; ++i) {
                const double q = double(i) / n;
                f[i] = std::sin(9.0 * q + 1.0);
                for (int k = 0; k <= degree; ++k) A(i, k) = std::pow(q, k);
            }
            const Eigen::VectorXd c = A.colPivHouseholderQr().solve(f);
            EXPECT_NEAR(fitted(fit, n, [](double q) { return std::sin(9.0 * q + 1.0); }), c.sum(),
                        1e-12);  // conditioning of the powers, below 1e3
        }
}

TEST(ForceFit, IsExactForItsOwnDegreeAndNotBeyond) {
    const auto line = [](double q) { return 3.0 - 2.0 * q; };
    const auto parabola = [](double q) { return 3.0 - 2.0 * q + 5.0 * q * q; };
    const auto cubic = [](double q) { return q * q * q; };
    EXPECT_NEAR(fitted(ForceFit::linear_fit, 13, line), 1.0, 1e-14);
    EXPECT_GT(std::abs(fitted(ForceFit::linear_fit, 13, parabola) - 6.0), 0.1);
    EXPECT_NEAR(fitted(ForceFit::quadratic_fit, 13, parabola), 6.0, 1e-14);
    EXPECT_GT(std::abs(fitted(ForceFit::quadratic_fit, 13, cubic) - 1.0), 0.01);
}

TEST(ForceFit, WithTooFewValuesPassesThroughThem) {
    EXPECT_NEAR(fitted(ForceFit::linear_fit, 1, exp), exp(1.0), 1e-15);
    EXPECT_NEAR(fitted(ForceFit::quadratic_fit, 1, exp), exp(1.0), 1e-15);
    EXPECT_NEAR(fitted(ForceFit::quadratic_fit, 2, exp), exp(1.0), 1e-15);
}

TEST(ForceFit, TakesTheSawtoothOutOfTheForce) {
    // (-1)^i rides on a constant: with 25 values fitted, what is left is of the order 1/n.
    double left = 0.0;
    for (int i = 0; i <= 25; ++i)
        left += fit_weight(ForceFit::linear_fit, i, 25) * (i % 2 ? 1 : -1);
    EXPECT_LT(std::abs(left), 3.0 / 25);
}

}  // namespace
}  // namespace hawser
