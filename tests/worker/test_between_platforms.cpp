// Rods between two platforms: loads on both, stiffness for the motions of both, passes, bundles.
#include <gtest/gtest.h>

#include "local_lines.hpp"
#include "packing.hpp"
#include "rod/rod_group.hpp"
#include "rod_cases.hpp"

namespace hawser::worker {
namespace {

constexpr double g = 9.80665;

/// Two platforms 300 m apart.
void add_platforms(Case& input) {
    input.platform.emplace();
    input.further_platforms.resize(1);
    input.further_platforms[0].position = {300.0, 0.0, 0.0};
}

LineEnd on_platform(int k, const Vec3& position, Joint joint = Joint::ball) {
    LineEnd end = testing::fixed_at(position, joint);
    end.kind = EndKind::platform;
    end.platform = k;
    return end;
}

/// A hanging line from the first platform to the second.
Case hanging_between(Joint joint) {
    LineType pipe = testing::plain_type(100.0, 5e8, 1e6);
    pipe.displaced_area = 0.03;
    LineEnd a = on_platform(0, {12.0, 3.0, -20.0}, joint);
    a.rotational_stiffness = 2e5;
    Case input = testing::one_line(pipe, 330.0, 16, a, on_platform(1, {-9.0, 4.0, -15.0}));
    if (joint != Joint::ball) input.lines[0].end_a.direction = Vec3(0.5, 0.05, -0.8).normalized();
    add_platforms(input);
    return input;
}

/// The two design poses with coordinate j of 12 moved by h.
std::array<PlatformMotion, 2> poses(const Case& input, int j = 0, double h = 0.0) {
    std::array<PlatformMotion, 2> out{input.design_of(0), input.design_of(1)};
    PlatformMotion& its = out[static_cast<std::size_t>(j / 6)];
    (j % 6 < 3 ? its.position[j % 6] : its.angles[j % 6 - 3]) += h;
    return out;
}

/// Static loads of one line on both platforms, by the seam.
Reply at_rest(LocalLines& lines, const std::array<PlatformMotion, 2>& at) {
    Order order;
    order.ask = Ask::equilibrium;
    order.current = false;
    for (std::size_t k = 0; k < 2; ++k) order.from[k] = order.to[k] = at[k];
    lines.send(order);
    return lines.receive();
}

using Vec12 = Eigen::Matrix<double, 12, 1>;
Vec12 loads_on_both(const LineLoad& line) {
    Vec12 out = Vec12::Zero();
    for (int k = 0; k < 2; ++k)
        if (const Vec6* wrench = line.on(k)) out.segment<6>(6 * k) = *wrench;
    return out;
}

/// Row by row against central differences of the static loads.
void expect_stiffness_is_the_derivative(const Case& input, std::size_t line) {
    LocalLines lines(input, input.lines.size() == 1 ? std::vector<int>{0} : std::vector<int>{0, 1},
                     nullptr);
    const Reply start = at_rest(lines, poses(input));
    ASSERT_TRUE(start.status.ok());
    const LineLoad& load = start.lines[line];
    Mat12 K = Mat12::Zero();
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            if (const Mat6* part = load.stiffness_of(row, column))
                K.block<6, 6>(6 * row, 6 * column) = *part;
    for (int j = 0; j < 12; ++j) {
        const double h = j % 6 < 3 ? 0.02 : 0.001;
        const Reply up = at_rest(lines, poses(input, j, h));
        ASSERT_TRUE(up.status.ok());
        const Vec12 above = loads_on_both(up.lines[line]);
        const Reply down = at_rest(lines, poses(input, j, -h));
        ASSERT_TRUE(down.status.ok());
        const Vec12 column = (loads_on_both(down.lines[line]) - above) / (2 * h);
        // differences err by h^2 and by the residual left in the statics
        for (int k = 0; k < 12; k += 3)
            EXPECT_LT((K.col(j) - column).segment<3>(k).norm(),
                      3e-4 * column.segment<3>(k).norm() + (k % 6 == 0 ? 1.0 : 60.0))
                << "motion " << j << " rows " << k << "\n"
                << K.col(j).transpose() << "\n"
                << column.transpose();
    }
}

class BetweenPlatforms : public ::testing::TestWithParam<Joint> {};

TEST_P(BetweenPlatforms, StiffnessIsMinusTheDerivativeOfTheLoadsOnBoth) {  // R:25, 12 x 12
    expect_stiffness_is_the_derivative(hanging_between(GetParam()), 0);
}
INSTANTIATE_TEST_SUITE_P(Joints, BetweenPlatforms,
                         ::testing::Values(Joint::ball, Joint::clamped, Joint::flex));

TEST(BetweenPlatforms, AConstraintOnTheSecondPlatformHasItsPartOfTheStiffness) {
    Case input = hanging_between(Joint::ball);
    LineConstraint joint{.type = ConstraintType::ball_joint, .name = "saddle"};
    joint.platform = 1;
    joint.position = {-20.0, 4.0, -30.0};
    joint.arc_length = 312.0;
    input.lines[0].constraints = {joint};
    expect_stiffness_is_the_derivative(input, 0);
}

TEST(BetweenPlatforms, TiedLinesOfTwoPlatformsHaveTheStiffnessOfBoth) {  // R:46
    Case input = hanging_between(Joint::ball);
    input.lines[0].end_b = testing::anchored_at({330.0, 60.0, -260.0});
    input.lines[0].sections[0].length = 400.0;
    Line second = input.lines[0];
    second.name = "second";
    second.end_a = on_platform(1, {-9.0, 4.0, -15.0});
    second.end_b = LineEnd{.kind = EndKind::line};
    second.sections[0].length = 170.0;
    LineConstraint tie{.type = ConstraintType::ball_joint, .name = "end_b", .on_platform = false};
    tie.other_line = 0, tie.other_arc = 200.0, tie.is_end = true, tie.arc_length = 170.0;
    second.constraints = {tie};
    input.lines.push_back(second);
    ASSERT_TRUE(touched_platforms(input)[0].two());
    expect_stiffness_is_the_derivative(input, 0);
    expect_stiffness_is_the_derivative(input, 1);
}

TEST(BetweenPlatforms, ALineFromAPlatformToItselfHasTheStiffnessOfBothItsEnds) {
    for (const Joint joint : {Joint::ball, Joint::clamped}) {
        Case input = hanging_between(joint);
        input.lines[0].end_b = on_platform(0, {291.0, 4.0, -15.0});
        ASSERT_FALSE(touched_platforms(input)[0].two());
        expect_stiffness_is_the_derivative(input, 0);
    }
}

TEST(BetweenPlatforms, AnEndBAloneOnAPlatformHasItsStiffness) {
    Case input = hanging_between(Joint::ball);
    input.lines[0].end_a = testing::fixed_at({12.0, 3.0, -20.0});
    expect_stiffness_is_the_derivative(input, 0);
}

TEST(BetweenPlatforms, ALightHawserThatDipsIntoTheSeaIsFoundFromEitherEnd) {
    // 78 N/m in air and 14 N/m in water: catenaries of elements that are wet or dry have gaps
    LineType rope = testing::plain_type(8.0, 2e6);
    rope.displaced_area = M_PI / 4 * 0.09 * 0.09;
    for (const double above : {1.0, 2.0, 3.0, 4.0}) {
        for (const double higher : {0.0, 1.0, 2.0}) {
            const LineEnd near = on_platform(0, {12.0, 0.0, above});
            const LineEnd far = on_platform(1, {-7.0, 0.0, above + higher});
            std::array<Vec12, 2> loads;
            for (const std::size_t turned : {0U, 1U}) {
                Case input =
                    testing::one_line(rope, 285.0, 50, turned ? far : near, turned ? near : far);
                add_platforms(input);
                LocalLines lines(input, {0}, nullptr);
                const Reply reply = at_rest(lines, poses(input));
                ASSERT_TRUE(reply.status.ok()) << above << " + " << higher << " turned " << turned;
                loads[turned] = loads_on_both(reply.lines[0]);
            }
            // the static residual is 1e-6 m of a line that gives 0.1 m per kN and less
            EXPECT_LT((loads[0] - loads[1]).norm(), 1e-3 * loads[0].norm()) << above << higher;
        }
    }
}

TEST(BetweenPlatforms, BothLoadsAndTheWeightInWaterBalance) {
    const Case input = hanging_between(Joint::flex);
    LocalLines lines(input, {0}, nullptr);
    auto at = poses(input, 1, 7.0);
    at[1].angles = {0.05, -0.08, 0.1};
    const Reply reply = at_rest(lines, at);
    ASSERT_TRUE(reply.status.ok());
    const LineLoad& line = reply.lines[0];
    const Vec6 &one = *line.on(0), &two = *line.on(1);
    const double weight = (100.0 - 1025.0 * 0.03) * g * 330.0;
    EXPECT_NEAR((one + two).head<2>().norm(), 0.0, 1e-6 * weight);
    EXPECT_NEAR(one[2] + two[2], -weight, 1e-6 * weight);
    EXPECT_GT(one[0], 0.0);  // drawn together
    EXPECT_LT(two[0], 0.0);
    EXPECT_EQ(line.on(2), nullptr);
}

TEST(BetweenPlatforms, AStraightElasticLinePullsBothWithItsTension) {
    // weightless: T = EA (distance/length - 1) along the line, on either platform
    const double EA = 4e7, L = 270.0;
    Case input =
        testing::one_line(testing::plain_type(1e-6, EA), L, 10, on_platform(0, {10.0, 0.0, 0.0}),
                          on_platform(1, {-10.0, 0.0, 0.0}));
    add_platforms(input);
    LocalLines lines(input, {0}, nullptr);
    for (const double apart : {0.0, 6.0}) {
        const Reply reply = at_rest(lines, poses(input, 6, apart));
        ASSERT_TRUE(reply.status.ok());
        const double T = EA * ((280.0 + apart) / L - 1.0), k = EA / L;
        const LineLoad& line = reply.lines[0];
        EXPECT_NEAR((*line.on(0))[0], T, 1e-7 * T);
        EXPECT_NEAR((*line.on(1))[0], -T, 1e-7 * T);
        EXPECT_NEAR((*line.stiffness_of(0, 1))(0, 0), -k, 1e-5 * k);
        EXPECT_NEAR((*line.stiffness_of(1, 1))(0, 0), k, 1e-5 * k);
        EXPECT_NEAR((*line.stiffness_of(1, 0))(1, 1), -T / (280.0 + apart), 1e-4 * T / 280.0);
    }
}

TEST(BetweenPlatforms, AQuasiStaticPassEndsInTheStaticSolution) {
    Case input = hanging_between(Joint::ball);
    input.lines[0].model = LineModel::quasi_static;
    LocalLines passing(input, {0}, nullptr), resting(input, {0}, nullptr);
    const auto start = poses(input), end = poses(input, 6, 3.0);
    ASSERT_TRUE(at_rest(passing, start).status.ok());
    Order order;
    order.ask = Ask::run_to;
    order.t1 = 0.5;
    for (std::size_t k = 0; k < 2; ++k) order.from[k] = start[k], order.to[k] = end[k];
    passing.send(order);
    const Reply moved = passing.receive();
    ASSERT_TRUE(moved.status.ok());
    const Vec12 held = loads_on_both(at_rest(resting, end).lines[0]);
    EXPECT_LT((loads_on_both(moved.lines[0]) - held).norm(), 1e-4 * held.norm());
}

TEST(BetweenPlatforms, ALineOfTheSecondPlatformHasTheBitsItHasOnTheFirst) {
    Case alone = hanging_between(Joint::clamped);
    alone.lines[0].end_b = testing::anchored_at({250.0, 60.0, -120.0});
    alone.further_platforms.clear();
    Case both = alone;
    both.further_platforms.resize(1);  // at the same place, not joined
    both.lines.push_back(both.lines[0]);
    both.lines[1].name = "other";
    both.lines[1].end_a.platform = 1;
    ASSERT_EQ(packs_of(both).size(), 2u);
    LocalLines one(alone, {0}, nullptr), two(both, {0, 1}, nullptr);
    PlatformMotion from, to;
    to.position = {1.0, -0.5, 0.25}, to.angles = {0.01, 0.02, -0.01};
    to.velocity = {1.0, 0.0, 0.5};
    PlatformMotion elsewhere;
    elsewhere.position.x() = 0.75;
    ASSERT_TRUE(at_rest(one, {from, from}).status.ok());
    ASSERT_TRUE(at_rest(two, {elsewhere, from}).status.ok());
    Order order;
    order.ask = Ask::run_to;
    order.t1 = 0.5;
    order.from = {from, from}, order.to = {to, elsewhere};
    one.send(order);
    order.from = {elsewhere, from}, order.to = {from, to};
    two.send(order);
    const Vec6 a = one.receive().lines[0].wrench;
    const LineLoad& b = two.receive().lines[1];
    EXPECT_EQ(b.platform, 1);
    EXPECT_EQ(b.second.platform, -1);
    EXPECT_EQ(a, b.wrench);
}

}  // namespace
}  // namespace hawser::worker
