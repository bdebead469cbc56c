// Lines as elastic catenaries: the solver that follows a moving end, and the lines behind the same
// pack as the rods.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "rod/catenary.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Chain, rope and chain with clumps between them, 60 pieces; lies on the bed where slack.
std::vector<CatenaryElement> mooring() {
    std::vector<CatenaryElement> elements(
        60, {.length = 40, .EA = 4.5e8, .weight_wet = 144, .weight_dry = 560});
    for (int e : {0, 1, 2, 57, 58, 59}) elements[e].weight_wet = 5020, elements[e].EA = 3e9;
    elements[2].point_weight = elements[56].point_weight = 34e3;
    return elements;
}
const Vec3 anchor(2000, 500, -1500);

TEST(CatenaryFollowed, IsTheOneFoundFromNothing) {
    const auto elements = mooring();
    Catenary last = solve_catenary(elements, anchor, {0, 0, -60}, true);
    ASSERT_TRUE(last.found);
    for (const Vec3& a : {Vec3(10, 5, -61), Vec3(40, 20, -65), Vec3(100, 0, -60), Vec3(-40, 0, -58),
                          Vec3(300, 50, -60), Vec3(0, -60, -60)}) {
        Catenary next;
        follow_catenary(elements, anchor, a, true, last.horizontal, last.vertical_a, next);
        const Catenary fresh = solve_catenary(elements, anchor, a, true);
        ASSERT_TRUE(next.found && fresh.found);
        EXPECT_NEAR(next.horizontal, fresh.horizontal, 1e-6 * fresh.horizontal);
        EXPECT_NEAR(next.vertical_a, fresh.vertical_a, 1e-6 * fresh.vertical_a);
        EXPECT_NEAR(next.grounded, fresh.grounded, 1e-3);
        EXPECT_NEAR((next.nodes.back().position - a).norm(), 0, 1e-6);
        last = next;
    }
}

TEST(CatenaryFollowed, StiffnessIsTheDerivativeOfItsPull) {
    const auto elements = mooring();
    for (const Vec3& a : {Vec3(0, 0, -60), Vec3(200, 0, -60)}) {  // taut; with chain on the bed
        const auto pull = [&](const Vec3& at) {
            Catenary c;
            follow_catenary(elements, anchor, at, true, 1e6, 1e6, c);
            const Vec3 out(at.x() - anchor.x(), at.y() - anchor.y(), 0);
            return Vec3(c.horizontal * out.normalized() + c.vertical_a * Vec3::UnitZ());
        };
        Catenary here;
        follow_catenary(elements, anchor, a, true, 1e6, 1e6, here);
        const double scale = here.stiffness.norm(), h = 1e-3;
        for (int j = 0; j < 3; ++j) {
            const Vec3 column =
                (pull(a + h * Vec3::Unit(j)) - pull(a - h * Vec3::Unit(j))) / (2 * h);
            EXPECT_NEAR((here.stiffness.col(j) - column).norm() / scale, 0, 1e-5) << j;
        }
        EXPECT_NEAR((here.stiffness - here.stiffness.transpose()).norm() / scale, 0, 1e-9);
    }
}

TEST(Catenary, ClumpLeavesTheBedWithoutAJump) {
    // 4 t between two chains: while it is lifted the bed carries less and less of it
    std::vector<CatenaryElement> elements(
        40, {.length = 10, .EA = 1e9, .weight_wet = 1000, .weight_dry = 1000});
    elements[19].point_weight = 40e3;
    double last = 0.0, largest = 0.0;
    for (int k = 0; k <= 200; ++k) {
        const Vec3 a(280 + 0.25 * k, 0, 150);
        const Catenary c = solve_catenary(elements, {0, 0, 0}, a, true);
        ASSERT_TRUE(c.found) << a.x();
        EXPECT_NEAR((c.nodes.back().position - a).norm(), 0, 1e-6);
        EXPECT_GT(c.horizontal, last);
        if (k > 0) largest = std::max(largest, c.horizontal / last - 1);
        last = c.horizontal;
    }
    EXPECT_LT(largest, 0.03);
}

Case with_model(Case input, LineModel model) {
    input.analysis.dynamics.line_model = model;
    return input;
}

/// The lying chain of the rods' tests on a platform.
Case chain() {
    LineEnd a;
    a.kind = EndKind::platform;
    Case input = one_line(plain_type(200, 1e9), 500, 40, a, anchored_at({380, 120, -200}), 200);
    input.line_types[0].outer_diameter = 0.0;
    input.environment.seabed.normal_stiffness = 1e7;
    input.lines[0].end_a.position = {3, -2, 0};
    input.lines[0].attachments = {{.arc_length = 100, .mass = 2000, .volume = 0.3}};
    return input;
}

TEST(CatenaryLine, CarriesWhatTheRodsCarryAtRest) {
    const Case input = chain();
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    RodPack<Quad> catenary(with_model(input, LineModel::catenary), sea, {0});
    PlatformMotion at;
    ASSERT_TRUE(rod.equilibrium(at, false).ok());
    ASSERT_TRUE(catenary.equilibrium(at, false).ok());
    for (int k = 1; k <= 8; ++k) {
        PlatformMotion next = at;
        next.position = {2.0 * k, -1.0 * k, 0.5 * k};
        next.angles = {0.01, -0.02, 0.005 * k};
        const double t = k;
        ASSERT_TRUE(catenary.pass(t - 1, t, MotionSpline(t - 1, at, t, next)).ok());
        catenary.keep();
        ASSERT_TRUE(rod.equilibrium(next, false).ok());
        const double T = rod.tension_a(0);
        EXPECT_NEAR(catenary.tension_a(0), T, 1e-3 * T);  // 40 elements, a bed that gives
        EXPECT_NEAR((catenary.pass_wrench(0) - rod.wrench(0, next.position)).head<3>().norm(), 0,
                    1e-3 * T);
        EXPECT_NEAR((catenary.pass_wrench(0) - rod.wrench(0, next.position)).tail<3>().norm(), 0,
                    5e-3 * T);
        for (int n = 0; n <= 40; n += 5)
            EXPECT_NEAR((catenary.node_position(0, n) - rod.node_position(0, n)).norm(), 0, 0.1);
        EXPECT_EQ(LaneTraits<Quad>::get(catenary.kept().head().t, 0), t);
        at = next;
    }
}

TEST(CatenaryLine, StiffnessIsTheDerivativeOfItsLoad) {  // R:21, R:25
    const Case input = with_model(chain(), LineModel::catenary);
    const Sea sea = still_sea(input);
    RodPack<Quad> line(input, sea, {0});
    PlatformMotion at;
    at.position = {5, 3, -1};
    ASSERT_TRUE(line.equilibrium(at, false).ok());
    const Mat6 S = line.stiffness(0, at.position);
    for (int j = 0; j < 6; ++j) {
        const double h = j < 3 ? 1e-3 : 1e-5;
        const auto wrench = [&](double sign) {
            PlatformMotion to = at;
            (j < 3 ? to.position[j] : to.angles[j - 3]) += sign * h;
            EXPECT_TRUE(line.equilibrium(to, false).ok());
            return line.wrench(0, to.position);
        };
        const Vec6 column = -(wrench(1.0) - wrench(-1.0)) / (2 * h);
        EXPECT_NEAR((S.col(j) - column).norm() / S.col(j).norm(), 0, 1e-5) << j;
    }
}

TEST(CatenaryLine, NodesHoldTheTensionOfTheStretchLaw) {  // R:2, R:3
    const Case input = with_model(chain(), LineModel::catenary);
    const Sea sea = still_sea(input);
    RodPack<Single> line(input, sea, {0});
    ASSERT_TRUE(line.equilibrium({}, false).ok());
    const double stretch = vec(line.kept().nodes()[40].d).norm();
    EXPECT_NEAR(line.kept().lambda()[80].now[0] * stretch, line.tension_a(0),
                1e-9 * line.tension_a(0));
    EXPECT_NEAR(stretch, 1 + line.tension_a(0) / 1e9, 1e-12);
}

TEST(CatenaryLine, TooShortALineIsAFailureThatNamesItAndTheTime) {
    const Case input = with_model(chain(), LineModel::catenary);
    const Sea sea = still_sea(input);
    RodPack<Quad> line(input, sea, {0});
    const PlatformMotion at;
    PlatformMotion far;
    far.position = {-500, 0, 0};
    ASSERT_TRUE(line.equilibrium(at, false).ok());
    const auto before = line.kept().block();
    const Status status = line.pass(0, 1, MotionSpline(0, at, 1, far));
    EXPECT_EQ(status.code, Status::Code::no_equilibrium);
    EXPECT_EQ(status.line, 0);
    EXPECT_EQ(status.t, 1.0);
    EXPECT_FALSE(line.equilibrium(far, false).ok());
    EXPECT_EQ(
        std::memcmp(before.data(), line.kept().block().data(), before.size() * sizeof(before[0])),
        0);
}

}  // namespace
}  // namespace hawser::worker
