// Several platforms in one time loop: joined by lines, and not.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "doubles.hpp"
#include "joint_equilibrium.hpp"
#include "paper_loop.hpp"

namespace hawser::master {
namespace {

using test::Body;
using test::coordinates;

/// A massless spring between the surges of two bodies, and one from each to the ground.
class SpringBetween final : public Lines {
 public:
    SpringBetween(double between, double ground) : k_(between), ground_(ground) {
        reply_.lines.resize(3);
        reply_.lines[0].second.platform = 1;
        reply_.lines[2].platform = 1;
    }
    void send(const Order& order) override { order_ = order; }
    const Reply& receive() override { return at(order_.to[0], order_.to[1]); }
    const Reply& at(const PlatformMotion& one, const PlatformMotion& two) {
        const Vec6 a = coordinates(one), b = coordinates(two);
        reply_.lines[0].wrench = k_ * (b - a);
        reply_.lines[0].second.wrench = k_ * (a - b);
        reply_.lines[1].wrench = -ground_ * a;
        reply_.lines[2].wrench = -ground_ * b;
        return reply_;
    }

 private:
    double k_, ground_;
    Order order_;
    Reply reply_;
};

JointState both(const State& one, const State& two) {
    JointState y(2 * state_numbers);
    y << one, two;
    return y;
}

State moving(double x, double v) {
    State y = State::Zero();
    y.head<6>().setConstant(x);
    y.segment<6>(6).setConstant(v);
    return y;
}

constexpr double m1 = 3.0, m2 = 1.0;

JointState run(double between, double ground, const JointState& y, double D, int n) {
    Body one, two;
    one.masses.setConstant(m1);
    two.masses.setConstant(m2);
    SpringBetween lines(between, ground);
    const Reply start = lines.at(motion_of(state_of(y, 0)), motion_of(state_of(y, 1)));
    PaperRate<Body, JointState> rate({&one, &two}, lines, start);
    return paper_loop(rate, y, D, [n](int step, double, const JointState&) { return step < n; });
}

/// Of free bodies: the distance swings with k (1/m1 + 1/m2), the centre of mass moves on.
double error_of_free_pair(double D, double* momentum) {
    const double k = 2.0, w = std::sqrt(k * (1 / m1 + 1 / m2)), t = 8.0;
    const JointState end = run(k, 0.0, both(moving(1.0, 0.1), moving(-0.5, 0.1)), D,
                               static_cast<int>(std::lround(t / D)));
    const double apart = end[0] - end[state_numbers];
    *momentum = m1 * end[6] + m2 * end[state_numbers + 6];
    const double centre = (m1 * end[0] + m2 * end[state_numbers]) / (m1 + m2);
    EXPECT_NEAR(centre, (m1 - 0.5 * m2) / (m1 + m2) + 0.1 * t, 1e-12);
    const double speed = end[6] - end[state_numbers + 6];
    // amplitude and phase together: one may cancel the other in the distance alone
    return std::hypot(apart - 1.5 * std::cos(w * t), speed / w + 1.5 * std::sin(w * t));
}

TEST(SeveralPlatforms, ASpringBetweenTwoKeepsMomentumAndTheFourthOrder) {  // P:3
    double momentum = 0.0;
    const double e1 = error_of_free_pair(0.2, &momentum);
    EXPECT_NEAR(momentum, 0.1 * (m1 + m2), 1e-13);
    const double e2 = error_of_free_pair(0.1, &momentum), e3 = error_of_free_pair(0.05, &momentum);
    EXPECT_LT(e1, 2e-2);
    EXPECT_NEAR(std::log2(e1 / e2), 4.0, 0.3);
    EXPECT_NEAR(std::log2(e2 / e3), 4.0, 0.2);
}

TEST(SeveralPlatforms, WithoutALineBetweenThemEachHasTheBitsItHasAlone) {
    const State start = moving(0.7, -0.2);
    const double D = 0.13;
    const int n = 40;
    Body body;
    body.masses.setConstant(m1);
    test::SpringLines alone({Vec6::Constant(1.7)});
    Reply first;
    first.lines.resize(1);
    first.lines[0].wrench = -1.7 * start.head<6>();
    PaperRate<Body> rate(body, alone, first);
    const State single =
        paper_loop(rate, start, D, [](int step, double, const State&) { return step < n; });
    const JointState pair = run(0.0, 1.7, both(start, moving(3.0, 1.0)), D, n);
    EXPECT_EQ(state_of(pair, 0), single);
}

TEST(SeveralPlatforms, EachTakesTheLinesThatTouchIt) {
    SpringBetween lines(2.0, 0.5);
    const State one = moving(1.0, 0.0), two = moving(4.0, 0.0);
    const Reply& reply = lines.at(motion_of(one), motion_of(two));
    EXPECT_EQ(total_wrench(reply, 0), Vec6(Vec6::Constant(2.0 * 3.0 - 0.5)));
    EXPECT_EQ(total_wrench(reply, 1), Vec6(Vec6::Constant(-2.0 * 3.0 - 2.0)));
    EXPECT_EQ(total_wrench(reply, 2), Vec6(Vec6::Zero()));
}

/// Springs with tension at rest: between the two, and from each to an anchor of its own.
class TautSprings final : public Lines {
 public:
    double between = 2.0, apart = 90.0, one = 0.4, two = 0.3;
    bool broken = false;
    int orders = 0;
    void send(const Order& order) override { order_ = order, ++orders; }
    const Reply& receive() override {
        const Vec6 a = coordinates(order_.to[0]), b = coordinates(order_.to[1]);
        reply_.lines.assign(3, LineLoad{});
        LineLoad& line = reply_.lines[0];
        line.second.platform = 1;
        const double k = broken ? 0.0 : between;
        // in surge with its length at rest, in the other motions without
        line.wrench = k * (b - a) - k * apart * Vec6::Unit(0);
        line.second.wrench = -line.wrench;
        line.stiffness = line.second.stiffness = k * Mat6::Identity();
        line.second.on_first = line.second.of_first = -k * Mat6::Identity();
        reply_.lines[1].wrench = -one * a;
        reply_.lines[1].stiffness = one * Mat6::Identity();
        reply_.lines[2].platform = 1;
        reply_.lines[2].wrench = -two * (b - 100.0 * Vec6::Unit(0));
        reply_.lines[2].stiffness = two * Mat6::Identity();
        return reply_;
    }

 private:
    Order order_;
    Reply reply_;
};

TEST(JointEquilibrium, TwoPlatformsOnSpringsRestWhereTheClosedFormSays) {  // K:25
    // one a = k (b - a - l) + f1,  two (b - 100) = -k (b - a - l) + f2
    TautSprings lines;
    const double f1 = 1.5, f2 = -0.7;
    const auto platform = [](const char* name, double f) {
        return StaticPlatform{
            .name = name,
            .load = [f](const PlatformMotion&) { return Vec6(f * Vec6::Unit(0)); },
            .stiffness = [](const PlatformMotion&) { return Mat6(Mat6::Zero()); },
            .force = 1.0,
            .length = 1.0};
    };
    PerPlatform<PlatformMotion> start{};
    start[1].position.x() = 100.0;
    const auto describe = [](const Status&, const PerPlatform<PlatformMotion>&) {
        return std::string("a line failed");
    };
    const JointEquilibrium at = find_joint_equilibrium({platform("big", f1), platform("small", f2)},
                                                       lines, start, false, {}, describe);
    Eigen::Matrix2d K;
    K << lines.one + lines.between, -lines.between, -lines.between, lines.two + lines.between;
    const double T0 = -lines.between * lines.apart;
    const Eigen::Vector2d x = K.inverse() * Eigen::Vector2d(f1 + T0, f2 - T0 + 100.0 * lines.two);
    EXPECT_NEAR(at.pose[0].position.x(), x[0], 1e-9);
    EXPECT_NEAR(at.pose[1].position.x(), x[1], 1e-9);
    EXPECT_LE(at.iterations, 3);  // linear: one step in two parts, for it is limited, one to see it
    // what the ground takes is what acts from outside
    EXPECT_NEAR(lines.one * x[0] + lines.two * (x[1] - 100.0), f1 + f2, 1e-9);
}

TEST(JointEquilibrium, SaysWhichPlatformNothingHolds) {
    TautSprings lines;
    lines.broken = true, lines.two = 0.0;
    const auto platform = [](const char* name, double f) {
        return StaticPlatform{
            .name = name,
            .load = [f](const PlatformMotion&) { return Vec6(f * Vec6::Unit(1)); },
            .stiffness = [](const PlatformMotion&) { return Mat6(Mat6::Zero()); },
            .force = 1.0,
            .length = 1.0};
    };
    const auto describe = [](const Status&, const PerPlatform<PlatformMotion>&) {
        return std::string("a line failed");
    };
    try {
        find_joint_equilibrium({platform("held", 0.1), platform("adrift", 0.1)}, lines, {}, false,
                               {}, describe);
        FAIL() << "nothing holds the second";
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("adrift: no static equilibrium"),
                  std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("nothing holds it in sway"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace hawser::master
