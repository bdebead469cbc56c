// The load ledger, P:2 integrated over a run, of a plane body that Runge-Kutta steps really move.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <functional>

#include "ledger.hpp"

namespace {

using namespace hawser;

// A body of mass m in the horizontal plane, its centre of gravity at the distance c from O:
//     p = m (v_O + w x r),  L = m r x v_O + I_O w
// State: velocity of O, angle, w. The load is a function of the number of the evaluation, so that
// it may swing as it likes within a step.
struct Body {
    double m = 3.0, c = 2.0, I_O = 20.0;
    using State = Eigen::Vector4d;

    [[nodiscard]] Vec3 arm(const State& s) const {
        return {c * std::cos(s[2]), c * std::sin(s[2]), 0};
    }
    [[nodiscard]] static Vec3 velocity(const State& s) { return {s[0], s[1], 0}; }
    [[nodiscard]] Vec6 momentum(const State& s) const {
        const Vec3 r = arm(s), v = velocity(s), w = s[3] * Vec3::UnitZ();
        Vec6 p;
        p << m * (v + w.cross(r)), m * r.cross(v) + I_O * w;
        return p;
    }
    /// K:4: m (a + w' x r + w x (w x r)) = F, m r x a + I_O w' = M_O
    [[nodiscard]] State rate(const State& s, const Vec6& load) const {
        const Vec3 r = arm(s);
        Eigen::Matrix3d M;
        M << m, 0, -m * r.y(), 0, m, m * r.x(), -m * r.y(), m * r.x(), I_O;
        const double turn = m * s[3] * s[3];
        const Vec3 a =
            M.partialPivLu().solve(Vec3(load[0] + turn * r.x(), load[1] + turn * r.y(), load[5]));
        return {a.x(), a.y(), s[3], a.z()};
    }
};

const Body::State start(0.5, -1.2, 0.3, 0.4);

/// One evaluation with its weight in the step.
struct Fed {
    double weight;
    Vec6 load, momentum;
    Vec3 velocity;
};
using Load = std::function<Vec6(int evaluation, double t)>;

/// Runs the body with steps D to `end`; `feed` puts each evaluation into the ledger.
LedgerTable run(const Body& body, Ledger ledger, double D, double end, const Load& load,
                const std::function<void(Ledger&, double, const Fed&)>& feed) {
    const int steps = static_cast<int>(std::lround(end / D));
    Body::State y = start;
    int n = 0;
    ledger.at_step(0.0, body.momentum(y));
    for (int i = 0; i < steps; ++i) {
        const auto evaluate = [&](double weight, double t, const Body::State& s) {
            const Vec6 acting = load(n++, t);
            feed(ledger, D, {weight, acting, body.momentum(s), Body::velocity(s)});
            return body.rate(s, acting);
        };
        const double t = i * D;
        const Body::State k1 = evaluate(1.0 / 6, t, y);
        const Body::State k2 = evaluate(1.0 / 3, t + D / 2, y + D / 2 * k1);
        const Body::State k3 = evaluate(1.0 / 3, t + D / 2, y + D / 2 * k2);
        const Body::State k4 = evaluate(1.0 / 6, t + D, y + D * k3);
        y += D / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        ledger.at_step((i + 1) * D, body.momentum(y));
    }
    return ledger.table();
}

void feed_all(Ledger& ledger, double D, const Fed& e) {
    const Vec6 up = 1000.0 * Vec6::Unit(2);
    ledger.act(e.weight * D, std::array<Vec6, 3>{e.load, -up, up}, e.momentum, e.velocity);
}

Vec6 smooth(int, double t) {
    Vec6 load = Vec6::Zero();
    load[0] = 2.0 * std::cos(0.7 * t) + 0.3;
    load[1] = 1.5 * std::sin(0.4 * t);
    load[5] = 2.0 * std::sin(0.9 * t) + 0.02;
    return load;
}

/// Another load at each evaluation, between -1000 and 1000: no quadrature would know its mean.
Vec6 erratic(int evaluation, double) {
    Vec6 load = Vec6::Zero();
    for (const int k : {0, 1, 5}) load[k] = 1000.0 * std::sin(12.9898 * evaluation + 78.233 * k);
    return load;
}

const std::vector<std::string> names{"push", "weight", "hydrostatic"};

// Momentum is a curved function of the state here (the arm turns): the residual is the error of a
// quadrature of fourth order along the steps that were really taken. Over three halvings.
TEST(Ledger, ClosesForATurningBodyWithTheFourthPowerOfTheStep) {
    const Body body;
    const LedgerTable coarse = run(body, Ledger(names), 0.1, 36.0, smooth, feed_all);
    const LedgerTable fine = run(body, Ledger(names), 0.0125, 36.0, smooth, feed_all);
    EXPECT_LT(coarse.residual.norm(), 1e-6);  // loads are of order 1
    EXPECT_NEAR(std::log2(coarse.residual.norm() / fine.residual.norm()) / 3, 4.0, 0.3);
    for (const int k : {0, 1, 5})  // the momentum side is not idle
        EXPECT_GT(std::abs(fine.momentum[k]), 0.01) << k;
    EXPECT_DOUBLE_EQ(fine.from, 0.0);
    EXPECT_NEAR(fine.to, 36.0, 1e-12);
}

// About the centre of gravity momentum is linear in the state: whatever the loads do within a step,
// they explain its change to rounding (1e-16 of 1000, some hundred times).
TEST(Ledger, ClosesToRoundingForLoadsThatJumpFromEvaluationToEvaluation) {
    Body body;
    body.c = 0.0;
    const LedgerTable t = run(body, Ledger(names), 0.5, 50.0, erratic, feed_all);
    EXPECT_LT(t.residual.cwiseAbs().maxCoeff(), 1e-10);
    for (const int k : {0, 1, 5}) EXPECT_GT(std::abs(t.mean[0][k]), 0.1) << k;
}

// Loads that were taken with other weights than those that moved the body do not close: here all
// four count alike.
TEST(Ledger, ShowsLoadsThatCountWithWrongWeights) {
    Body body;
    body.c = 0.0;
    const auto feed = [](Ledger& ledger, double D, const Fed& e) {
        ledger.act(D / 4, std::array<Vec6, 1>{e.load}, e.momentum, e.velocity);
    };
    const LedgerTable t = run(body, Ledger({"push"}), 0.5, 50.0, erratic, feed);
    for (const int k : {0, 1, 5}) EXPECT_GT(std::abs(t.residual[k]), 0.01) << k;
}

// With O taken for fixed the mean of v_O x p is missing: far above the error of this step.
TEST(Ledger, TakesAngularMomentumAboutTheMovingPoint) {
    const Body body;
    const auto fixed = [](Ledger& ledger, double D, const Fed& e) {
        ledger.act(e.weight * D, std::array<Vec6, 1>{e.load}, e.momentum, Vec3::Zero());
    };
    const double right =
        std::abs(run(body, Ledger(names), 0.05, 36.0, smooth, feed_all).residual[5]);
    const double wrong =
        std::abs(run(body, Ledger({"push"}), 0.05, 36.0, smooth, fixed).residual[5]);
    EXPECT_LT(right, 1e-5);
    EXPECT_GT(wrong, 1e-2);
}

TEST(Ledger, CountsWeightAndBuoyancyAsOne) {
    const LedgerTable t = run(Body{}, Ledger(names), 0.1, 36.0, smooth, feed_all);
    EXPECT_LT(t.largest(2), 1e-9);  // 1000 N up and 1000 N down are nothing together
    EXPECT_NEAR(t.largest(0), std::abs(t.mean[0][0]), 1e-15);
    EXPECT_NEAR(t.residual_fraction(0), std::abs(t.residual[0] / t.mean[0][0]), 1e-15);
}

TEST(Ledger, WeighsStepsOfUnequalLength) {
    Ledger ledger({"push"});
    const auto act = [&](double duration, double load) {
        const std::array<Vec6, 1> loads{Vec6::Constant(load)};
        ledger.act(duration, loads, Vec6::Zero(), Vec3::Zero());
    };
    ledger.at_step(0.0, Vec6::Zero());
    act(1.0, 5.0);
    ledger.at_step(1.0, Vec6::Zero());
    act(3.0, 1.0);
    ledger.at_step(4.0, Vec6::Zero());
    EXPECT_DOUBLE_EQ(ledger.table().mean[0][0], 2.0);  // (1 x 5 + 3 x 1) / 4
    act(2.0, 1e9);                                     // a step that fails half way
    EXPECT_DOUBLE_EQ(ledger.table().mean[0][0], 2.0);
}

TEST(Ledger, OfNoStepIsEmpty) {
    Ledger ledger({"push"});
    ledger.at_step(0.0, Vec6::Ones());
    const std::array<Vec6, 1> loads{Vec6::Ones()};
    ledger.act(1.0, loads, Vec6::Ones(), Vec3::Ones());
    EXPECT_TRUE(ledger.table().mean[0].isZero());
    EXPECT_TRUE(ledger.table().residual.isZero());
}

}  // namespace
