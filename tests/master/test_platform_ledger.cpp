// The platform's load ledger beside the time loop: it closes, and it does not where a load is
// wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "doubles.hpp"
#include "paper_loop.hpp"
#include "platform_ledger.hpp"

namespace hawser::master {
namespace {

constexpr double D = 0.2;

/// A hull with radiation and damping on two families of springs; G is off O.
Case sprung_case() {
    Case c;
    c.environment.seabed.depth = 100.0;
    Platform& p = c.platform.emplace();
    p.mass = 1e6;
    p.centre_of_gravity = {0.5, -0.3, -4};
    p.radii_of_gyration = {10, 12, 8};
    p.linear_damping.diagonal() << 1e4, 1e4, 1e4, 1e6, 1e6, 1e6;
    HydroMatrix& matrix = p.hydrodynamics.matrix.emplace();
    matrix.added_mass.diagonal() << 5e5, 6e5, 7e5, 4e7, 5e7, 1e7;
    matrix.damping.diagonal() << 1e5, 1e5, 2e5, 2e6, 2e6, 2e6;
    c.lines.resize(2);
    c.lines[0].family = "mooring";
    c.lines[1].family = "riser";
    c.analysis.dynamics.platform_step = D;
    return c;
}

/// What a ledger is told instead of the truth.
using Fault = std::function<void(HullLoads&, Reply&)>;

LedgerTable ledger_with(const Fault& fault) {
    const Case input = sprung_case();
    const Hull hull(input, nullptr);
    Vec6 stiffness;
    stiffness << 5e5, 4e5, 1e7, 3e8, 3e8, 5e7;
    test::SpringLines lines({0.7 * stiffness, 0.3 * stiffness});
    Order to;  // the springs' answer at the start
    to.to[0] = {.position = {2, -1, 0.5},
                .angles = {0.05, -0.08, 0.1},
                .velocity = {0.5, 0.3, 0},
                .angle_rates = {0.01, -0.02, 0.03}};
    lines.send(to);
    PaperRate<Hull> rate(hull, lines, lines.receive());
    PlatformLedger ledger(input);
    rate.watch([&](int stage, double t, const State& s) {
        HullLoads loads = rate.loads();
        Reply reply = rate.reply();
        if (fault) fault(loads, reply);
        ledger.add(stage, t, loads, reply, hull.momentum(s), motion_of(s).velocity);
    });
    paper_loop(rate, hull.start(to.to[0], to.to[0]), D,
               [](int step, double, const State&) { return step < 150; });
    return ledger.table();
}

/// A ledger with a fault has as much more residual as the fault is in the mean, and says so.
void expect_shown(const Fault& fault, const Vec6& error, std::initializer_list<int> motions) {
    const LedgerTable right = ledger_with({}), wrong = ledger_with(fault);
    const Vec6 more = wrong.residual - right.residual;
    for (int k = 0; k < 6; ++k)  // rounding of sums of 1e7 N
        EXPECT_NEAR(more[k], error[k], 1e-9 * (std::abs(error[k]) + right.largest(k))) << k;
    for (const int k : motions) {
        EXPECT_GT(wrong.residual_fraction(k), large_residual) << k;
        EXPECT_LT(right.residual_fraction(k), large_residual / 10) << k;
    }
}

TEST(PlatformLedger, ClosesWithTheLoadsOfTheFourEvaluations) {  // P:2, P:3
    const LedgerTable table = ledger_with({});
    EXPECT_EQ(table.from, 0.0);
    EXPECT_NEAR(table.to, 30.0, 1e-12);
    // turning by 0.1 rad with some 2 rad/s: 0.1 (w D)^4 / 100 at the most
    for (int k = 0; k < 6; ++k) {
        EXPECT_LT(table.residual_fraction(k), large_residual / 10) << k;
        EXPECT_GT(table.largest(k), 100.0) << k;
    }
}

TEST(PlatformLedger, ShowsALoadThatIsMissing) {
    const Vec6 radiation = ledger_with({}).mean[static_cast<std::size_t>(Load::radiation)];
    const auto fault = [](HullLoads& loads, Reply&) { loads[Load::radiation].setZero(); };
    expect_shown(fault, -radiation, {0, 1, 3, 4});
}

TEST(PlatformLedger, ShowsALoadThatIsCountedTwice) {
    const Vec6 damping = ledger_with({}).mean[static_cast<std::size_t>(Load::damping)];
    const auto fault = [](HullLoads& loads, Reply&) { loads[Load::damping] *= 2.0; };
    expect_shown(fault, damping, {0, 1});
}

TEST(PlatformLedger, ShowsAWrongMomentArm) {
    const Vec3 arm(0, 0, 5);  // the mooring's loads as if its fairleads were 5 m higher
    const Vec3 force = ledger_with({}).mean[load_count - 1].head<3>();
    Vec6 error = Vec6::Zero();
    error.tail<3>() = arm.cross(force);
    const auto fault = [&](HullLoads&, Reply& lines) {
        const Vec3 pull = lines.lines[0].wrench.head<3>();
        lines.lines[0].wrench.tail<3>() += arm.cross(pull);
    };
    expect_shown(fault, error, {3, 4});
}

TEST(PlatformLedger, ShowsAFamilyOfLinesThatIsLeftOut) {
    const LedgerTable right = ledger_with({});
    ASSERT_EQ(right.components[load_count], "riser");
    const auto fault = [](HullLoads&, Reply& lines) { lines.lines[1].wrench.setZero(); };
    expect_shown(fault, -right.mean[load_count], {0, 1, 2, 3, 4, 5});
}

TEST(PlatformLedger, HasHullLoadsAndFamiliesAndBeginsWhenTheStatisticsDo) {
    Case c;
    c.lines.resize(3);
    c.lines[0].family = c.lines[1].family = "scr";
    c.lines[2].family = "wave1";  // a family may be called like a load
    c.analysis.dynamics.statistics_from = 1.0;
    c.analysis.dynamics.platform_step = 2.0;
    PlatformLedger ledger(c);
    Reply reply;
    reply.lines.resize(3);
    for (int i = 0; i < 3; ++i) reply.lines[std::size_t(i)].wrench.setConstant(std::pow(10.0, i));
    const auto add = [&](int stage, double t, double load, double momentum) {
        HullLoads loads;
        loads[Load::wave1] = load * Vec6::Ones();
        loads[Load::lines] = 1e9 * Vec6::Ones();  // not counted twice
        ledger.add(stage, t, loads, reply, momentum * Vec6::Ones(), Vec3::Zero());
    };
    add(0, -1.0, 1e9, 1e9);
    for (const int stage : {1, 2, 3}) add(stage, 1.0, 1e9, 1e9);  // of a step that began before
    EXPECT_FALSE(ledger.started());
    add(4, 1.0, 6.0, 0.0);
    add(1, 2.0, 3.0, 1e9);
    add(2, 2.0, -6.0, 1e9);
    add(3, 3.0, 12.0, 1e9);
    EXPECT_FALSE(ledger.started());
    add(4, 3.0, 1e9, 8.0);
    ASSERT_TRUE(ledger.started());
    const LedgerTable table = ledger.table();
    ASSERT_EQ(table.components.size(), load_count + 1U);
    EXPECT_EQ(table.components[load_count - 1], "scr");
    EXPECT_EQ(table.components[load_count], "wave1");
    // (6 + 2 x 3 - 2 x 6 + 12) / 6
    EXPECT_LT((table.mean[0] - 2.0 * Vec6::Ones()).norm(), 1e-14);
    EXPECT_LT((table.mean[load_count - 1] - 11.0 * Vec6::Ones()).norm(), 1e-13);
    EXPECT_LT((table.mean[load_count] - 100.0 * Vec6::Ones()).norm(), 1e-12);
    EXPECT_EQ(table.momentum, Vec6(4.0 * Vec6::Ones()));
    EXPECT_EQ(table.from, 1.0);
    EXPECT_EQ(table.to, 3.0);
}

}  // namespace
}  // namespace hawser::master
