#include <gtest/gtest.h>

#include <cmath>

#include "equilibrium.hpp"
#include "pose.hpp"

namespace hawser::master {
namespace {

/// Taut springs between body points and the ground, with the exact geometry: force along the
/// spring, tension = k (length - free length).
class GroundSprings final : public Lines {
 public:
    struct Spring {
        Vec3 on_body, on_ground;
        double k, free_length;
    };
    explicit GroundSprings(std::vector<Spring> springs) : springs_(std::move(springs)) {
        reply_.lines.resize(springs_.size());
    }
    static Vec6 wrench(const Spring& s, const PlatformMotion& pose) {
        const Vec3 lever = rotation(pose.angles) * s.on_body;
        const Vec3 d = s.on_ground - pose.position - lever;
        const Vec3 force = s.k * (d.norm() - s.free_length) * d.normalized();
        Vec6 f;
        f << force, lever.cross(force);
        return f;
    }
    void send(const Order& order) override {
        orders.push_back(order);
        pose_ = order.to[0];
    }
    const Reply& receive() override {
        reply_.status = Status{};
        if (std::abs(pose_.position.x() - last_x_) > longest_move)
            reply_.status = {.code = Status::Code::no_equilibrium, .line = 0};
        else
            last_x_ = pose_.position.x();
        for (size_t i = 0; i < springs_.size(); ++i) {
            reply_.lines[i].wrench = wrench(springs_[i], pose_);
            for (int j = 0; j < 6; ++j) {
                const Vec6 e = 1e-5 * Vec6::Unit(j);
                reply_.lines[i].stiffness.col(j) = (wrench(springs_[i], displaced(pose_, -e)) -
                                                    wrench(springs_[i], displaced(pose_, e))) /
                                                   2e-5;
            }
        }
        return reply_;
    }
    std::vector<Order> orders;
    double longest_move = 1e9;

 private:
    std::vector<Spring> springs_;
    PlatformMotion pose_;
    double last_x_ = 0.0;
    Reply reply_;
};

std::string describe(const Status& status, const Poses&) {
    return "line " + std::to_string(status.line);
}

/// A body whose own load is constant: no stiffness.
StaticPlatform pushed(const Vec6& load) {
    return {.name = "spar",
            .load = [load](const PlatformMotion&) { return load; },
            .stiffness = [](const PlatformMotion&) { return Mat6(Mat6::Zero()); },
            .force = 1e6,
            .length = 10.0};
}

std::vector<GroundSprings::Spring> six_springs() {
    const double k = 1e5;
    return {{{10, 0, 0}, {110, 5, -20}, k, 80},     {{10, 0, 0}, {90, -60, -30}, k, 70},
            {{-5, 8, 3}, {-80, 90, -40}, k, 90},    {{-5, 8, 3}, {-90, 20, -20}, k, 60},
            {{-5, -8, -3}, {-70, -90, -30}, k, 85}, {{0, -2, -20}, {3, -4, -120}, k, 60}};
}

TEST(Equilibrium, BalancesPlatformAndLinesInAllSixMotions) {
    GroundSprings lines(six_springs());
    Vec6 load;
    load << 3e6, -1e6, 4e6, 2e6, -3e6, 1e6;
    const Equilibrium at =
        find_equilibrium(pushed(load), lines, PlatformMotion{}, true, NewtonLimits{}, describe);
    Vec6 sum = load;
    for (const auto& spring : six_springs()) sum += GroundSprings::wrench(spring, at.pose);
    // The correction left is 1e-6 m or less and Newton's last step squares the error: far below
    // k * 1e-6 m.
    EXPECT_LT(sum.head<3>().norm(), 0.5);
    EXPECT_LT(sum.tail<3>().norm(), 10.0);
    EXPECT_GT(at.pose.position.x(), 1.0);  // pushed towards +x it goes there
    EXPECT_LE(at.iterations, 15);
    // The lines' last order was for the pose returned: that is where the run starts from.
    EXPECT_EQ(lines.orders.back().to[0], at.pose);
    EXPECT_EQ(lines.orders.back().ask, Ask::equilibrium);
    EXPECT_EQ(at.pose.velocity, Vec3::Zero());
}

TEST(Equilibrium, OfTwoSpringsIsTheirClosedForm) {
    // Along one axis the springs are linear: x = F / (k1 + k2) from the middle.
    GroundSprings lines({{{0, 0, 0}, {500, 0, 0}, 3e4, 400}, {{0, 0, 0}, {-500, 0, 0}, 1e4, 200}});
    Vec6 load = Vec6::Zero();
    load[0] = 2e5;
    const Equilibrium at =
        find_equilibrium(pushed(load), lines, PlatformMotion{}, true, NewtonLimits{}, describe);
    EXPECT_NEAR(at.pose.position.x(), (2e5 + 3e4 * 100 - 1e4 * 300) / 4e4, 1e-6);
}

TEST(Equilibrium, GoesInLimitedSteps) {
    GroundSprings lines({{{0, 0, 0}, {500, 0, 0}, 1e4, 450}, {{0, 0, 0}, {-500, 0, 0}, 1e4, 450}});
    Vec6 load = Vec6::Zero();
    load[0] = 4e5;  // 20 m
    find_equilibrium(pushed(load), lines, PlatformMotion{}, true, NewtonLimits{}, describe);
    for (size_t i = 1; i < lines.orders.size(); ++i)
        EXPECT_LE((lines.orders[i].to[0].position - lines.orders[i - 1].to[0].position).norm(),
                  5.0001);
}

TEST(Equilibrium, TriesALineThatFailsAgainAtHalfTheStep) {
    GroundSprings lines({{{0, 0, 0}, {500, 0, 0}, 1e4, 450}, {{0, 0, 0}, {-500, 0, 0}, 1e4, 450}});
    lines.longest_move = 1.5;  // the lines do not follow further in one order
    Vec6 load = Vec6::Zero();
    load[0] = 4e5;
    const Equilibrium at =
        find_equilibrium(pushed(load), lines, PlatformMotion{}, true, NewtonLimits{}, describe);
    EXPECT_NEAR(at.pose.position.x(), 20.0, 1e-5);
    lines.longest_move = -1.0;  // and now not at all
    try {
        find_equilibrium(pushed(load), lines, PlatformMotion{}, true, NewtonLimits{}, describe);
        FAIL();
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::no_equilibrium);
        EXPECT_STREQ(error.what(), "line 0");
    }
}

TEST(Equilibrium, LeavesAFreePlatformWhereItIsInDirectionsThatNothingHolds) {
    GroundSprings none({});
    StaticPlatform hull = pushed(Vec6::Zero());
    hull.load = [](const PlatformMotion& m) {  // heave spring and a pitch trim of 1e5 N.m
        Vec6 f = Vec6::Zero();
        f[2] = -1e5 * (m.position.z() - 0.3);
        f[3] = -1e8 * m.angles.x();
        f[4] = 1e5 - 1e8 * m.angles.y();
        return f;
    };
    hull.stiffness = [](const PlatformMotion&) {
        Vec6 k;
        k << 0, 0, 1e5, 1e8, 1e8, 0;
        return Mat6(k.asDiagonal());
    };
    PlatformMotion start;
    start.position = {7.0, -2.0, 0.0};
    start.angles.z() = 0.5;
    const Equilibrium at = find_equilibrium(hull, none, start, true, NewtonLimits{}, describe);
    EXPECT_NEAR(at.pose.position.x(), 7.0, 1e-9);
    EXPECT_NEAR(at.pose.position.y(), -2.0, 1e-9);
    EXPECT_NEAR(at.pose.position.z(), 0.3, 1e-6);
    EXPECT_NEAR(at.pose.angles.y(), 1e-3, 1e-6);
    EXPECT_NEAR(at.pose.angles.z(), 0.5, 1e-5);
}

TEST(Equilibrium, SaysWhatNothingHolds) {
    GroundSprings none({});
    Vec6 load = Vec6::Zero();
    load[1] = 5e4;
    try {
        find_equilibrium(pushed(load), none, PlatformMotion{}, true, NewtonLimits{}, describe);
        FAIL();
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::no_equilibrium);
        EXPECT_NE(std::string(error.what()).find("nothing holds the platform in sway"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace hawser::master
