// The load ledger, P:2 integrated over a run, against a body whose motion is known in closed form.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ledger.hpp"

namespace {

using namespace hawser;

// A body of mass m turns about the vertical with w = w0 sin(nu t), while its point O moves on
// x_O = (a cos(u t), b sin(u t), 0) and its centre of gravity lies at the distance c from O. Loads
// about O are those that the equation of motion K:4 asks for:
//     p = m (v_O + w x r),  L = m r x v_O + I_O w,  F = dp/dt,  M_O = dL/dt + v_O x p
struct Known {
    double m = 3.0, c = 2.0, I_O = 20.0, a = 5.0, b = 3.0, u = 0.4, w0 = 0.8, nu = 0.9;

    struct State {
        Vec3 velocity;
        Vec6 momentum, load;
    };
    [[nodiscard]] State at(double t) const {
        const double w = w0 * std::sin(nu * t), dw = w0 * nu * std::cos(nu * t);
        const double angle = -w0 / nu * std::cos(nu * t);
        const Vec3 W(0, 0, w), dW(0, 0, dw), r(c * std::cos(angle), c * std::sin(angle), 0);
        const Vec3 v(-a * u * std::sin(u * t), b * u * std::cos(u * t), 0);
        const Vec3 dv(-a * u * u * std::cos(u * t), -b * u * u * std::sin(u * t), 0);
        const Vec3 dr = W.cross(r), ddr = dW.cross(r) + W.cross(dr);
        State s;
        s.velocity = v;
        s.momentum << m * (v + dr), m * r.cross(v) + I_O * W;
        const Vec3 force = m * (dv + ddr);
        const Vec3 dL = m * (dr.cross(v) + r.cross(dv)) + I_O * dW;
        s.load << force, dL + v.cross(m * (v + dr));
        return s;
    }
};

LedgerTable ledger_of(const Known& body, double step, double duration) {
    Ledger ledger({"push", "weight", "hydrostatic"});
    const int steps = static_cast<int>(std::lround(duration / step));
    for (int i = 0; i <= steps; ++i) {
        const Known::State s = body.at(i * step);
        const Vec6 up = 1000.0 * Vec6::Unit(2);
        const std::array<Vec6, 3> loads{s.load, -up, up};
        ledger.add(i * step, loads, s.momentum, s.velocity);
    }
    return ledger.table();
}

// Both sides are integrals of smooth functions by the trapezoid rule: the residual is its error,
// which falls with the square of the step.
TEST(Ledger, ClosesForAClosedFormMotionWithTheSquareOfTheStep) {
    const Known body;
    const LedgerTable coarse = ledger_of(body, 0.2, 37.0), fine = ledger_of(body, 0.1, 37.0);
    for (const int k : {0, 1, 5}) {
        EXPECT_LT(std::abs(fine.residual[k]), 2e-3) << k;  // loads are of order 1 to 10
        EXPECT_NEAR(coarse.residual[k] / fine.residual[k], 4.0, 0.1) << k;
        EXPECT_GT(std::abs(fine.momentum[k]), 0.01) << k;  // the momentum side is not idle
    }
    EXPECT_DOUBLE_EQ(fine.from, 0.0);
    EXPECT_NEAR(fine.to, 37.0, 1e-12);
}

// The same loads with O taken for fixed: the mean of v_O x p is then missing, here 0.022 N.m, far
// above the trapezoid error of this step.
TEST(Ledger, TakesAngularMomentumAboutTheMovingPoint) {
    const Known body;
    Ledger fixed({"push"});
    for (int i = 0; i <= 3700; ++i) {
        const Known::State s = body.at(0.01 * i);
        const std::array<Vec6, 1> loads{s.load};
        fixed.add(0.01 * i, loads, s.momentum, Vec3::Zero());
    }
    const double right = std::abs(ledger_of(body, 0.01, 37.0).residual[5]);
    EXPECT_LT(right, 1e-5);
    EXPECT_GT(std::abs(fixed.table().residual[5]), 1e3 * right);
}

TEST(Ledger, CountsWeightAndBuoyancyAsOne) {
    const LedgerTable t = ledger_of(Known{}, 0.1, 37.0);
    EXPECT_LT(t.largest(2), 1e-9);  // 1000 N up and 1000 N down are nothing together
    EXPECT_NEAR(t.largest(0), std::abs(t.mean[0][0]), 1e-15);
    EXPECT_NEAR(t.residual_fraction(0), std::abs(t.residual[0] / t.mean[0][0]), 1e-15);
}

TEST(Ledger, WeighsStepsOfUnequalLength) {
    Ledger ledger({"push"});
    for (const double t : {0.0, 1.0, 4.0}) {  // load t, mean over [0, 4] is 2
        const std::array<Vec6, 1> loads{Vec6::Constant(t)};
        ledger.add(t, loads, Vec6::Zero(), Vec3::Zero());
    }
    EXPECT_DOUBLE_EQ(ledger.table().mean[0][0], 2.0);
}

TEST(Ledger, OfOneStateIsEmpty) {
    Ledger ledger({"push"});
    const std::array<Vec6, 1> loads{Vec6::Ones()};
    ledger.add(0.0, loads, Vec6::Ones(), Vec3::Ones());
    EXPECT_TRUE(ledger.table().mean[0].isZero());
    EXPECT_TRUE(ledger.table().residual.isZero());
}

}  // namespace
