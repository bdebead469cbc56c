// Static targets: what is found gives the line its tension, angle or stroke; where that cannot be,
// it says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "guided_riser.hpp"
#include "static_targets.hpp"
#include "status.hpp"

namespace hawser::worker {
namespace {

using namespace testing;
using Adjust = StaticTarget::Adjust;

Case riser(double length, double gas_exponent = 1.1) {
    Case input = guided_riser(length, gas_exponent);
    input.lines[0].target = {.adjust = Adjust::section_length, .section = 1};
    return input;
}

TEST(StaticTargets, TensionedRiserStandsAtStrokeZeroWhateverLengthItIsGiven) {
    double first = 0.0;
    for (const double length : {1519.0, 1521.1, 1522.0, 1524.5}) {  // strokes of +2 to -3.4 m
        Case input = riser(length);
        const std::vector<Adjustment> found = find_adjustments(input);
        ASSERT_EQ(found.size(), 1u);
        carry_out(found, input);
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        EXPECT_NEAR(rod.constraint_opening(0, 0), 0.0, 1e-6) << length;
        EXPECT_NEAR(rod.constraint_magnitude(0, 0), 5.338e6, 1.0) << length;
        EXPECT_EQ(found[0].before, length - 212);
        EXPECT_EQ(input.lines[0].sections[1].length, found[0].found);
        if (first == 0.0) first = found[0].found;
        EXPECT_NEAR(found[0].found, first, 1e-5) << length;
    }
}

TEST(StaticTargets, RiserIsShorterThanItsSpanByItsStretch) {
    // Closed form: elongation = int T/EA ds with T falling by the weight below; 0.9 m of 1522 m
    Case input = riser(1522.0);
    carry_out(find_adjustments(input), input);
    const double g = 9.80665, wet = 337.0 * g - 1025 * g * M_PI / 4 * 0.406 * 0.406,
                 dry = 337.0 * g, EA = 6.2e9, top = 5.338e6 - 22 * dry;
    const double stretch = (22 * (5.338e6 + top) / 2 + 1500 * (top + (top - 1500 * wet)) / 2) / EA;
    const double exact = 1522.0 - stretch;  // to first order in the strain of 6e-4
    EXPECT_NEAR(input.lines[0].length(), exact, 2e-3 * stretch);
    EXPECT_NEAR(stretch, 0.9, 0.15);
}

TEST(StaticTargets, LinearTensionerMeetsTheSameLength) {
    const double gas = find_adjustments(riser(1522.0)).at(0).found;
    const double linear = find_adjustments(riser(1522.0, 0.0)).at(0).found;
    EXPECT_NEAR(gas, linear, 1e-6);
}

/// A chain of 500 m that partly lies on the bed, 200 m below its fairlead.
Case chain(double radius) {
    LineType type = plain_type(200, 1e9);
    Case input =
        one_line(type, 500, 40, fixed_at({0, 0, 0}),
                 anchored_at(Vec3(radius * std::cos(0.7), radius * std::sin(0.7), -200)), 200);
    input.environment.water.density = 0.0;
    return input;
}

TEST(StaticTargets, AnchorRadiusGivesThePretensionOfTheCatenary) {
    // On the bed without bending: T_top = H + w h, and the closed form gives the radius for H.
    const double w = 200 * 9.80665, T = 700e3, H = T - w * 200, EA = 1e9;
    const double V = std::sqrt(T * T - H * H), up = V / w;
    const double span = 500 - up + H / w * std::asinh(V / H) + H * 500 / EA;  // elastic catenary
    for (const double start : {380.0, 420.0, 440.0}) {
        Case input = chain(start);
        input.lines[0].target = {.adjust = Adjust::anchor_radius, .pretension = T};
        const std::vector<Adjustment> found = find_adjustments(input);
        // height with stretch is h + int V/T .. dT/EA: 0.2 m of 200; bed penetration 2 cm
        EXPECT_NEAR(found.at(0).found, span, 0.3) << start;
        carry_out(found, input);
        EXPECT_NEAR(
            std::atan2(input.lines[0].end_b.position.y(), input.lines[0].end_b.position.x()), 0.7,
            1e-12);
        EXPECT_EQ(input.lines[0].end_b.position.z(), -200.0);
        const Sea sea = still_sea(input);
        RodPack<Quad> rod(input, sea, {0});
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        EXPECT_NEAR(rod.tension_a(0), T, 1e-6 * T) << start;
    }
}

TEST(StaticTargets, SectionLengthGivesTheHangOffAngle) {
    Case input = chain(400);
    const double angle = 40 * M_PI / 180;
    input.lines[0].target = {
        .adjust = Adjust::section_length, .section = 0, .hang_off_angle = angle};
    carry_out(find_adjustments(input), input);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const Vec3 u = rod.direction_a(0);
    EXPECT_NEAR(std::atan2(std::hypot(u.x(), u.y()), -u.z()), angle, 1e-6);
}

TEST(StaticTargets, AnAnchorStaysOnTheSlopeOfTheBed) {
    Case input = chain(400);
    input.environment.seabed.slope_angle = 0.1;  // rises with x
    input.lines[0].target = {.adjust = Adjust::anchor_radius, .pretension = 7e5};
    Vec3& b = input.lines[0].end_b.position;
    b.z() = -200 + std::tan(0.1) * b.x() + 0.15;  // where the line rests
    adjust(input, 0, 410.0);
    EXPECT_NEAR(b.x(), 410 * std::cos(0.7), 1e-9);
    EXPECT_NEAR(b.z(), -200 + std::tan(0.1) * b.x() + 0.15, 1e-9);
}

TEST(StaticTargets, WhatHangsBeyondTheSectionMovesWithItsEnd) {
    Case input = riser(1522.0);
    input.lines[0].attachments = {{.arc_length = 200, .mass = 1},
                                  {.arc_length = 1510, .mass = 1},
                                  {.arc_length = 1516, .mass = 1}};
    adjust(input, 0, 1300.0);  // 10 m less
    EXPECT_EQ(input.lines[0].attachments[0].arc_length, 200.0);
    EXPECT_EQ(input.lines[0].attachments[1].arc_length, 1500.0);
    EXPECT_EQ(input.lines[0].attachments[2].arc_length, 1506.0);
    EXPECT_EQ(input.lines[0].constraints[0].arc_length, 0.0);
}

std::string refusal(const Case& input) {
    try {
        const auto found = find_adjustments(input);
        return "found " + std::to_string(found.at(0).found);
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::no_equilibrium);
        return error.what();
    }
}

TEST(StaticTargets, TargetOutOfReachNamesLineTargetBestAndCause) {
    // A line with 200 m of height weighs at least that: 392 kN at the top, whatever the radius
    Case input = chain(400);
    input.lines[0].target = {.adjust = Adjust::anchor_radius, .pretension = 300e3};
    EXPECT_THAT(refusal(input),
                ::testing::AllOf(::testing::HasSubstr("line: "), ::testing::HasSubstr("300 kN"),
                                 ::testing::HasSubstr("the nearest is 3"),
                                 ::testing::HasSubstr("likely cause")));
    // A riser cannot be pulled with more than its stretch can give
    Case stiff = riser(1522.0);
    stiff.lines[0].target.pretension = 1e12;
    EXPECT_THAT(refusal(stiff), ::testing::HasSubstr("1e+09 kN at end A"));
}

TEST(StaticTargets, LinesWithoutOneAreLeftAlone) {
    Case input = chain(400);
    EXPECT_TRUE(find_adjustments(input).empty());
}

TEST(StaticTargets, NoteSaysWhatWasFoundForWhat) {
    Case input = riser(1522.0);
    const std::vector<Adjustment> found = find_adjustments(input);
    EXPECT_THAT(note_of(found.at(0), input),
                ::testing::MatchesRegex("line: section 2 is 1309\\.[0-9]+ m, 0\\.[0-9]+ m shorter, "
                                        "for 5338 kN at stroke 0"));
}

TEST(StaticTargets, NoteWarnsOfAnAnchorThatMovedFar) {
    const Case input = chain(400);
    Adjustment moved{.quantity = Adjust::anchor_radius,
                     .before = 2000,
                     .found = 2190,
                     .goal = Adjustment::Goal::pretension,
                     .target = 1e6};
    const auto warns = ::testing::HasSubstr("may be wrong");
    EXPECT_THAT(note_of(moved, input), ::testing::Not(warns));
    moved.found = 1790;
    EXPECT_THAT(note_of(moved, input), warns);
}

}  // namespace
}  // namespace hawser::worker
