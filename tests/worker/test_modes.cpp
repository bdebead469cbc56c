// Natural frequencies of rods against closed forms: validation rows A8, A9, A12; structural
// damping R:5.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "full_element.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Frequencies [rad/s] of a straight rod under tension T along x in direction c (0: along it), from
/// the elements' own matrices: the multipliers are eliminated, both ends held (`free_b`: only A).
std::vector<double> frequencies(double length, int N, double EA, double EI, double mass, double T,
                                int c, bool free_b = false) {
    const double strain = T / EA, lambda = T / (1 + strain), L = length / N;
    const int n = 2 * (N + 1), m = 2 * N + 1;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n), M = K, G = Eigen::MatrixXd::Zero(n, m),
                    C = Eigen::MatrixXd::Zero(m, m);
    const Vec3 d = (1 + strain) * Vec3::UnitX();
    const auto a = node_at({0, 0, 0}, d), b = node_at(L * d, d);
    const auto e = dry_element(L, EA, EI, mass);
    const std::array<double, 3> l = {lambda, lambda, lambda};
    const FullElement stiff = full_element(e, a, b, l, elastic(EA));
    const Matrix15 inertia = full_element(e, a, b, l, elastic(EA), 1.0).J - stiff.J;
    const int row[4] = {c, 3 + c, 7 + c, 10 + c}, multiplier[3] = {6, 14, 13};
    for (int k = 0; k < N; ++k) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                K(2 * k + i, 2 * k + j) += stiff.J(row[i], row[j]);
                M(2 * k + i, 2 * k + j) += inertia(row[i], row[j]);
            }
            for (int j = 0; j < 3; ++j) G(2 * k + i, 2 * k + j) += stiff.J(row[i], multiplier[j]);
        }
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                C(2 * k + i, 2 * k + j) += stiff.J(multiplier[i], multiplier[j]);
    }
    K -= G * C.inverse() * G.transpose();
    std::vector<int> free;
    for (int i = 1; i < n; ++i)
        if (i != n - 2 || free_b) free.push_back(i);
    const Eigen::MatrixXd Kf = K(free, free), Mf = M(free, free);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Kf, Mf);
    std::vector<double> out;
    for (int i = 0; i < 12; ++i) out.push_back(std::sqrt(solver.eigenvalues()[i]));
    return out;
}

TEST(TensionedBeam, HasTheFrequenciesOfTheClosedForm) {  // validation row A9
    // w_n = n pi/L sqrt((T + n^2 pi^2 EI/L^2)/m) with L, m of the stretched beam; order 6
    const double L0 = 1500, EA = 4e9, EI = 4.65e7, m0 = 200, T = 2e6, e = T / EA;
    const auto w = frequencies(L0, 40, EA, EI, m0, T, 1);
    for (int n = 1; n <= 10; ++n) {
        // per unstretched length: bending energy 1/2 EI r''^2 ds of R:1, tension T/(1 + e)
        const double k = n * M_PI / L0;
        const double exact = k * std::sqrt((T / (1 + e) + k * k * EI) / m0);
        EXPECT_NEAR(w[static_cast<std::size_t>(n - 1)], exact, 1e-5 * exact) << n;
        const double textbook =
            n * M_PI / L0 / (1 + e) * std::sqrt((T + k * k * EI) / (m0 / (1 + e)));
        if (n <= 3) {
            EXPECT_NEAR(w[static_cast<std::size_t>(n - 1)], textbook, 3e-3 * textbook) << n;
        }
    }
    const double k20 = 5 * M_PI / L0, exact = k20 * std::sqrt((T / (1 + e) + k20 * k20 * EI) / m0);
    const double coarse = frequencies(L0, 10, EA, EI, m0, T, 1)[4] / exact - 1,
                 fine = frequencies(L0, 20, EA, EI, m0, T, 1)[4] / exact - 1;
    EXPECT_GT(coarse / fine, 32);  // order 6 would give 64
}

TEST(AxialTendon, HasTheFrequenciesOfTheClosedForm) {  // validation row A12
    const double L = 3000, area = 0.03, EA = 2.07e11 * area, m = 7850 * area;
    const double T1 = 2 * M_PI / frequencies(L, 20, EA, 1e7, m, 1.0, 0)[0];
    const double T2 = 2 * M_PI / frequencies(L, 20, EA, 1e7, m, 1.0, 0, true)[0];
    EXPECT_NEAR(T1, 1.16843, 1e-5);  // 2 L/c, c = 5135.1 m/s: five digits
    EXPECT_NEAR(T2, 2.33686, 1e-5);
    const double third = frequencies(L, 20, EA, 1e7, m, 1.0, 0)[2];
    EXPECT_NEAR(third, 3 * M_PI / L * std::sqrt(EA / m), 1e-6 * third);
}

TEST(HangingChain, SwingsWithTheBesselFrequencies) {  // validation row A8: 0.5 %
    const double L = 100, g = 9.80665;
    const std::vector<double> j0 = {2.404826, 5.520078, 8.653728, 11.791534};
    for (int n = 0; n < 4; ++n) {
        const double w = j0[static_cast<std::size_t>(n)] / 2 * std::sqrt(g / L);
        Case input = one_line(plain_type(100, 1e10), L, 40, fixed_at({0, 0, 0}), LineEnd{});
        input.environment.water.density = 0.0;
        // trapezoidal-like lengthening (w h)^2/12: below 1e-4
        input.analysis.dynamics.line_step = 2 * M_PI / w / 200;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        // u = a J0(j0 sqrt(s/L)), s from the free end; J0' = -J1, and at s = 0 the slope -a j0^2/4L
        const double j = j0[static_cast<std::size_t>(n)], a = 0.01;
        const auto mode = [&](double s) { return std::cyl_bessel_j(0.0, j * std::sqrt(s / L)); };
        displace(
            rod, L, -w * w, [&](double s) { return Vec3(a * mode(s), 0, 0); },
            [&](double s) {
                const double q = j * std::sqrt(s / L);
                const double slope =
                    q < 1e-9 ? -j * j / (4 * L) : -std::cyl_bessel_j(1.0, q) * j * j / (2 * L * q);
                return Vec3(a * slope, 0, 0);
            });
        Record swing;
        const double interval = 4 * input.analysis.dynamics.line_step;
        ASSERT_TRUE(run(rod, 6.2 * 2 * M_PI / w, interval, [&](double t) {
                        double sum = 0.0;  // projection on the mode
                        for (int i = 0; i <= 40; ++i)
                            sum += mode(L * (40 - i) / 40.0) * rod.node_position(0, i).x();
                        swing.add(t, sum);
                    }).ok());
        EXPECT_NEAR(swing.period(), 2 * M_PI / w, 0.005 * 2 * M_PI / w) << n + 1;
    }
}

struct AxialVibration {
    double ratio, period;  ///< of critical damping; over that of the closed form
};
/// Free axial vibration of a taut rod between fixed ends, started in its first mode; damping
/// ratio from the decay of the tension at end A over ten periods.
AxialVibration vibrate(double asked, int elements) {
    const double L = 1000, EA = 7e8, m = 60, w = M_PI / L * std::sqrt(EA / m), T = 2e6, e0 = T / EA;
    LineType type = plain_type(m, EA);
    type.damping_ratio = asked;
    Case input = one_line(type, L, elements, fixed_at({L * (1 + e0), 0, 0}), fixed_at({0, 0, 0}));
    input.environment.water.gravity = 1e-9;
    input.environment.water.density = 0.0;
    const double h = 2 * M_PI / w / 200;
    input.analysis.dynamics.line_step = h;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    EXPECT_TRUE(rod.equilibrium({}, false).ok());
    const double a = 0.05, k = M_PI / L;
    displace(
        rod, L, -w * w, [&](double s) { return Vec3(a * std::sin(k * s), 0, 0); },
        [&](double s) { return Vec3(a * k * std::cos(k * s), 0, 0); });
    const auto strain = [&](double s) { return e0 + a * k * std::cos(k * s); };
    for (int i = 0; i <= 2 * elements; ++i) {
        const double e = strain(0.5 * L * i / elements);
        rod.kept().lambda()[i].now = rod.kept().lambda()[i].before = EA * e / (1 + e);
    }
    for (int i = 0; i < elements; ++i)
        for (std::size_t g = 0; g < gauss_points; ++g)
            rod.kept().strain()[static_cast<std::size_t>(i) * gauss_points + g].damper =
                strain(L * (i + gauss_xi[g]) / elements);
    Record tension;
    EXPECT_TRUE(run(rod, 10.6 * 2 * M_PI / w, h, [&](double t) {
                    tension.add(t, T - rod.tension_a(0));
                }).ok());
    // peaks, each the vertex of the parabola through three samples
    std::vector<double> peaks;
    const auto& y = tension.y;
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
        if (y[i] > y[i - 1] && y[i] >= y[i + 1] && y[i] > 0)
            peaks.push_back(y[i] - (y[i + 1] - y[i - 1]) * (y[i + 1] - y[i - 1]) /
                                       (8 * (y[i + 1] - 2 * y[i] + y[i - 1])));
    const double decrement =
        std::log(peaks.front() / peaks.back()) / (2 * M_PI * static_cast<double>(peaks.size() - 1));
    return {decrement / std::sqrt(1 + decrement * decrement), tension.period() * w / (2 * M_PI)};
}

TEST(StructuralDamping, DecaysWithTheRatioAskedForWhateverTheMesh) {  // R:5, acceptance 13
    for (const int elements : {10, 40}) {
        for (const double asked : {0.01, 0.05}) {
            const AxialVibration v = vibrate(asked, elements);
            EXPECT_NEAR(v.ratio, asked, 0.01 * asked) << elements;
        }
    }
}

TEST(StructuralDamping, IsAbsentWhenNotAskedFor) {  // and A12 in time: 0.5 %
    const AxialVibration v = vibrate(0.0, 20);
    EXPECT_LT(std::abs(v.ratio), 1e-6);  // of the scheme: third order in w h = 0.03, times 1e-3
    EXPECT_NEAR(v.period, 1.0, 0.005);
}

}  // namespace
}  // namespace hawser::worker
