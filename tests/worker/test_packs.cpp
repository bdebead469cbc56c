// Packs of rods: a rod's bits do not depend on its neighbours, failures are told by line, place and
// time, steps are halved where Newton's iteration fails (sections 4.4 and 5.4).
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Four lines of one layout: taut, slack on the bed with a finer step, at another heading, and
/// another.
Case four_lines() {
    LineEnd top = moving(fixed_at({0, 0, -100}), {-4, 1, 3}, 10);
    Case input = standing_line(top, 2055);
    input.environment.seabed.depth = 1500;
    input.environment.current = Current{.heading = 0.4, .profile = {{.depth = 0, .speed = 0.6}}};
    input.environment.waves = {WaveTrain{.type = WaveType::airy, .H = 8, .T = 11, .heading = 0.3}};
    input.analysis.dynamics.ramp = 5.0;
    input.line_types[1].viscoelastic = Viscoelastic{7.0632e8, 4.5126e8, 20};
    for (LineType& type : input.line_types) type.damping_ratio = 0.01;
    for (int i = 1; i < 4; ++i) input.lines.push_back(input.lines[0]);
    for (std::size_t i = 0; i < 4; ++i) {
        Line& line = input.lines[i];
        line.name = "line_" + std::to_string(i);
        const double heading = 1.1 * static_cast<double>(i),
                     span = i == 1 ? 1900 : 2050 - 5.0 * static_cast<double>(i);
        line.end_b = anchored_at({span * std::cos(heading), span * std::sin(heading), -1500});
    }
    input.lines[1].time_step = 0.013;
    input.lines[2].time_step = 0.007;
    return input;
}

/// All numbers of one lane of a state.
template <class V>
std::vector<double> numbers(const RodState<V>& state, int lane) {
    std::vector<double> out;
    for (const V& v : state.block()) out.push_back(v[lane]);
    return out;
}
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}

TEST(RodPack, ARodsBitsDoNotDependOnItsNeighbours) {  // acceptance 6
    const Case input = four_lines();
    const Sea sea(input.environment, 5.0, 1.0);
    RodPack<Quad> together(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(together.equilibrium({}, true).ok());
    ASSERT_TRUE(run(together, 6, 0.5).ok());
    const std::vector<std::vector<int>> others = {{0}, {1}, {2}, {3}, {3, 0}, {2, 1, 0}};
    for (const std::vector<int>& lines : others) {
        RodPack<Quad> pack(input, sea, lines);
        ASSERT_TRUE(pack.equilibrium({}, true).ok());
        ASSERT_TRUE(run(pack, 6, 0.5).ok());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            EXPECT_TRUE(same_bits(numbers(pack.kept(), static_cast<int>(i)),
                                  numbers(together.kept(), lines[i])))
                << "line " << lines[i] << " in a pack of " << lines.size();
            EXPECT_EQ(pack.tension_a(static_cast<int>(i)), together.tension_a(lines[i]));
        }
    }
}

TEST(RodPack, ItsStiffnessDoesNotDependOnItsNeighbours) {
    Case input = four_lines();
    for (Line& line : input.lines) line.end_a.kind = EndKind::platform, line.end_a.motion.reset();
    const Sea sea(input.environment, 5.0, 1.0);
    RodPack<Quad> together(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(together.equilibrium({}, true).ok());
    for (int line = 0; line < 4; ++line) {
        RodPack<Quad> alone(input, sea, {line});
        ASSERT_TRUE(alone.equilibrium({}, true).ok());
        EXPECT_EQ(alone.stiffness(0, Vec3::Zero()), together.stiffness(line, Vec3::Zero())) << line;
        EXPECT_GT(alone.stiffness(0, Vec3::Zero())(0, 0), 100.0) << line;
    }
}

TEST(RodPack, OneRodAgreesWithALaneOfFour) {  // acceptance 6: 1e-9
    const Case input = four_lines();
    const Sea sea(input.environment, 5.0, 1.0);
    for (const int line : {0, 1, 2}) {
        RodPack<Single> alone(input, sea, {line});
        RodPack<Quad> lane(input, sea, {line});
        ASSERT_TRUE(alone.equilibrium({}, true).ok());
        ASSERT_TRUE(lane.equilibrium({}, true).ok());
        EXPECT_NEAR(alone.tension_a(0), lane.tension_a(0), 1e-9 * lane.tension_a(0));
        ASSERT_TRUE(run(alone, 6, 0.5).ok());
        ASSERT_TRUE(run(lane, 6, 0.5).ok());
        EXPECT_NEAR(alone.tension_a(0), lane.tension_a(0), 1e-9 * lane.tension_a(0)) << line;
        for (int n = 0; n <= lane.elements(); ++n)
            EXPECT_LT((alone.node_position(0, n) - lane.node_position(0, n)).norm(), 1e-9 * 2500)
                << line;
    }
}

TEST(RodPack, PassesBeforeTheLastLeaveNoTrace) {  // P:3: the rods keep the final pass
    const Case input = four_lines();
    const Sea sea(input.environment, 5.0, 1.0);
    RodPack<Quad> once(input, sea, {0, 1, 2, 3}), often(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(once.equilibrium({}, true).ok());
    ASSERT_TRUE(often.equilibrium({}, true).ok());
    const PlatformMotion still;
    for (int k = 0; k < 4; ++k) {
        const double t = 0.5 * k;
        for (const double H : {0.25, 0.25, 0.5})
            ASSERT_TRUE(often.pass(t, t + H, MotionSpline(t, still, t + H, still)).ok());
        for (RodPack<Quad>* pack : {&once, &often}) {
            ASSERT_TRUE(pack->pass(t, t + 0.5, MotionSpline(t, still, t + 0.5, still)).ok());
            pack->keep();
        }
    }
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(same_bits(numbers(once.kept(), i), numbers(often.kept(), i))) << i;
}

/// Carries the end of line 2, of purely elastic rope, further off than any stretch reaches.
Case with_absurd_motion() {
    Case input = four_lines();
    input.line_types.push_back(input.line_types[1]);
    input.line_types[2].viscoelastic.reset();
    input.line_types[2].damping_ratio.reset();
    input.lines[2].sections[1].type = 2;
    input.lines[2].end_a.motion =
        EndMotion{.amplitude = {0, 0, 3e4}, .period = {1, 1, 40}, .phase = Vec3::Zero()};
    return input;
}

TEST(RodPack, AFailingLineIsNamedWithPlaceAndTimeAndHarmsNoOther) {  // section 5.4
    const Case input = with_absurd_motion();
    const Sea sea(input.environment, 5.0, 1.0);
    RodPack<Quad> all(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(all.equilibrium({}, true).ok());
    Status status;
    double t = 0.0;
    const PlatformMotion still;
    for (; t < 20; t += 0.5) {
        status = all.pass(t, t + 0.5, MotionSpline(t, still, t + 0.5, still));
        if (!status.ok()) break;
        all.keep();
    }
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.line, 2);
    // where the stretch law ends, at twice the length (R:6), not later
    const double chord = (all.node_position(2, 0) - all.node_position(2, all.elements())).norm();
    EXPECT_LT(chord, 2.2 * input.lines[2].length());
    EXPECT_GT(status.t, t);
    EXPECT_LE(status.t, t + 0.5);
    EXPECT_GE(status.arc_length, 0.0);
    EXPECT_LE(status.arc_length, 2499.0);
    // the neighbours have finished the pass as if nothing had happened
    RodPack<Quad> rest(input, sea, {0, 1, 3});
    ASSERT_TRUE(rest.equilibrium({}, true).ok());
    for (double s = 0.0; s <= t; s += 0.5) {
        if (s > 0.0) rest.keep();
        ASSERT_TRUE(rest.pass(s, s + 0.5, MotionSpline(s, still, s + 0.5, still)).ok());
    }
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(same_bits(numbers(rest.state(), i), numbers(all.state(), i == 2 ? 3 : i))) << i;
}

TEST(RodPack, HalvesTheStepWhereNewtonFails) {  // section 5.4
    // three iterations must do: at h = 0.2 the slack line thrown about cannot, at a fraction it can
    Case input = standing_line(moving(fixed_at({0, 0, -100}), {6, 0, 5}, 6), 1990);
    input.analysis.dynamics.line_step = 0.2;
    input.analysis.dynamics.ramp = 2.0;
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    rod.newton = {.tolerance = 1e-6, .max_iterations = 3, .max_halvings = 6};
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Record halved;
    const Status status = run(rod, 8, 0.4, [&](double t) { halved.add(t, rod.tension_a(0)); });
    ASSERT_TRUE(status.ok()) << status.t << " s, " << status.arc_length << " m";
    EXPECT_GT(rod.work().steps, 40);  // 2 a pass and 20 passes if none were halved

    input.analysis.dynamics.line_step = 0.01;
    RodPack<Quad> fine(input, sea, {0});
    ASSERT_TRUE(fine.equilibrium({}, false).ok());
    Record exact;
    ASSERT_TRUE(run(fine, 8, 0.4, [&](double t) { exact.add(t, fine.tension_a(0)); }).ok());
    // h = 0.2 leaves 7 % on a slack line that lifts off (section 14.3)
    EXPECT_LT(rms_difference(halved, exact), 0.15 * exact.deviation());
}

}  // namespace
}  // namespace hawser::worker
