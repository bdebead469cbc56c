#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "failure_message.hpp"
#include "statics_diagnosis.hpp"

namespace hawser::master {
namespace {

using testing::HasSubstr;

/// A chain of 600 m from a platform at -20 m to an anchor 450 m away in 300 m of water.
Case moored() {
    Case c;
    c.environment.seabed.depth = 300.0;
    LineType chain;
    chain.name = "chain";
    chain.mass = 100.0;
    chain.displaced_area = 0.0127;
    chain.outer_diameter = 0.08;
    chain.EA = 5e8;
    c.line_types = {chain};
    Line line;
    line.name = "ml1";
    line.end_a = {.kind = EndKind::platform, .position = {0, 0, -20}};
    line.end_b = {.kind = EndKind::anchor, .position = {450, 0, -300}};
    line.sections = {{.type = 0, .length = 600.0, .elements = 20}};
    c.lines = {line};
    return c;
}

std::string cause(const Case& c, const PlatformMotion& pose = {}) {
    return static_failure_cause(c.lines[0], c, {pose});
}

TEST(StaticFailure, SaysThatTheAnchorIsOutOfReach) {
    Case c = moored();
    c.lines[0].sections[0].length = 500.0;  // of a chord of 530 m
    EXPECT_THAT(cause(c), HasSubstr("anchor out of reach: the ends are 530 m apart and the line is "
                                    "500 m long; to stretch so far takes 3e+04 kN"));
    // and so it is when the platform has gone too far
    PlatformMotion away;
    away.position.x() = -100.0;
    EXPECT_THAT(cause(moored(), away), HasSubstr("anchor out of reach"));
    EXPECT_THAT(cause(moored()), testing::Not(HasSubstr("reach: ")));
}

TEST(StaticFailure, OfATautLineIsNotItsReach) {
    // A tendon is always shorter than the distance it spans: 2.8 m of 280 m would be out of reach.
    Case c = moored();
    c.lines[0].end_b = {.kind = EndKind::anchor, .position = {0, 0, -300}};
    c.lines[0].sections[0].length = 279.7;
    EXPECT_THAT(cause(c), testing::Not(HasSubstr("reach: ")));
    c.line_types[0].breaking_load = 500e3;  // 0.3/279.7 of 5e8 N are 536 kN
    EXPECT_THAT(cause(c), HasSubstr("anchor out of reach"));
    c = moored();
    c.lines[0].end_b = {.kind = EndKind::anchor, .position = {0, 0, -300}};
    c.lines[0].sections[0].length = 277.2;
    EXPECT_THAT(cause(c), HasSubstr("anchor out of reach"));
}

TEST(StaticFailure, SaysThatTheLineLiesSlack) {
    Case c = moored();
    c.lines[0].sections[0].length = 740.0;  // 450 across and 280 down are 730
    EXPECT_THAT(cause(c), HasSubstr("lies slack"));
}

TEST(StaticFailure, LooksAtFreeEndsThePlatformAndTheMesh) {
    Case c = moored();
    c.lines[0].end_b = LineEnd{.kind = EndKind::free};
    EXPECT_THAT(cause(c), HasSubstr("one end is free and the line is 600 m long, where the held "
                                    "end is 280 m above the bed"));
    c.lines[0].sections[0].length = 250.0;
    EXPECT_THAT(cause(c), HasSubstr("none of reach"));
    PlatformMotion up;
    up.position.z() = 16.0;  // a twentieth of the depth is 15 m
    EXPECT_THAT(cause(moored(), up), HasSubstr("the platform had gone 16 m"));
    up.position.z() = 14.0;
    EXPECT_THAT(cause(moored(), up), HasSubstr("none of reach"));
    c = moored();
    c.lines[0].sections[0].elements = 4;
    EXPECT_THAT(cause(c), HasSubstr("4 elements of up to 150 m"));
}

TEST(StaticFailure, SaysThatTheLineFloats) {
    Case c = moored();
    c.line_types[0].displaced_area = 0.2;
    EXPECT_THAT(cause(c), HasSubstr("lighter than water"));
    c = moored();
    LineType buoyant = c.line_types[0];
    buoyant.name = "modules";
    buoyant.displaced_area = 0.15;
    c.line_types.push_back(buoyant);
    c.lines[0].sections = {{.type = 0, .length = 500.0}, {.type = 1, .length = 100.0}};
    EXPECT_THAT(cause(c), HasSubstr("modules floats"));
}

TEST(StaticFailure, SaysThatATensionerIsWeakerThanTheRiserIsHeavy) {
    Case c = moored();
    Line& riser = c.lines[0];
    riser.end_a = LineEnd{};
    riser.end_b = {.kind = EndKind::fixed, .position = {0, 0, -300}};
    riser.sections[0].length = 320.0;
    LineConstraint tensioner;
    tensioner.type = ConstraintType::tensioner;
    tensioner.name = "ram";
    tensioner.arc_length = 0.0;
    tensioner.nominal_tension = 200e3;  // 320 m of 853 N/m are 273 kN
    riser.constraints = {tensioner};
    EXPECT_THAT(cause(c), HasSubstr("ram pulls with 200 kN at stroke 0, the riser below weighs "
                                    "273"));
    riser.constraints[0].nominal_tension = 400e3;
    EXPECT_THAT(cause(c), testing::Not(HasSubstr("ram")));
    // two carry it together
    riser.constraints[0].nominal_tension = 150e3;
    riser.constraints.push_back(tensioner);
    riser.constraints[1].name = "ring";
    EXPECT_THAT(cause(c), testing::Not(HasSubstr("ram")));
    riser.constraints[1].nominal_tension = 100e3;
    EXPECT_THAT(cause(c), HasSubstr("ram and ring pull together with 250 kN"));
}

TEST(StaticFailure, SaysThatAStiffnessIsOutOfReason) {
    Case c = moored();
    c.line_types[0].EA = 1e5;
    EXPECT_THAT(cause(c), HasSubstr("own weight"));
    c = moored();
    c.line_types[0].EI = 1e12;
    EXPECT_THAT(cause(c), HasSubstr("EI = 1e+12 N.m2 of chain"));
}

TEST(StaticFailure, SpeaksOfALoopOnlyWhereItIsDeeperThanWide) {
    Case c = moored();
    c.lines[0].end_b = {.kind = EndKind::fixed, .position = {40, 0, -20}};
    c.lines[0].sections[0].length = 200.0;
    EXPECT_THAT(cause(c), HasSubstr("in a loop 100 m deep between ends 40 m apart"));
    c.lines[0].end_b.position.x() = 197.0;  // sags by 15 m
    EXPECT_THAT(cause(c),
                testing::AllOf(testing::Not(HasSubstr("loop")), testing::Not(HasSubstr("slack"))));
}

TEST(StaticFailure, SaysThatAnEndIsInTheGround) {
    Case c = moored();
    c.lines[0].end_b = {.kind = EndKind::fixed, .position = {450, 0, -310}};
    EXPECT_THAT(cause(c), HasSubstr("end B lies 10 m below the seabed"));
}

TEST(StaticFailure, IsToldWithLineIterationsResidualAndPlace) {
    Case c = moored();
    c.lines[0].sections[0].length = 500.0;
    const Status status = {.code = Status::Code::no_equilibrium,
                           .line = 0,
                           .arc_length = 120.0,
                           .residual = 3.5,
                           .iterations = 100};
    const std::string text = failure_message(status, c, 0);
    EXPECT_TRUE(
        text.starts_with("ml1: no static solution after 100 iterations, largest position "
                         "correction 3.5 m at s = 120 m; likely cause: anchor out of reach"))
        << text;
}

}  // namespace
}  // namespace hawser::master
