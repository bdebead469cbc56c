// What the summary marks with an exclamation mark: everything a reader must not overlook.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "io/summary.hpp"

namespace hawser::io {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One riser that came to no harm, 100 s.
struct RiserRun {
    RunRecord record;
    ResultDigest digest;
    RiserRun() {
        Line riser;
        riser.name = "ttr";
        riser.sections = {{.length = 100.0}};
        LineConstraint ram;
        ram.type = ConstraintType::tensioner;
        ram.name = "ram";
        ram.stroke_min = -4.5, ram.stroke_max = 4.0;
        riser.constraints = {ram};
        record.input.line_types = {LineType{}};
        record.input.lines = {riser};
        record.complete = true;
        LineCourse course;
        course.extremes = {Extreme{1e5, 90.0, 11.0}, Extreme{9e5, 0.0, 12.0},
                           Extreme{2e8, 40.0, 13.0}, Extreme{0.5, 40.0, 13.0},
                           Extreme{0.4, 0.0, 12.0}};
        course.slack_limit = 1e3, course.slack_duration = 0.0, course.slack_first = nan;
        digest.lines = {LineStart{9e5, 1e5, 0.0, 0.0, 0.0, nan}};
        digest.courses = {course};
        digest.samples = 100;
        digest.last_time = 100.0;
        ChannelStatistics stroke{"constraint/ttr/ram/stroke", "m", {}};
        stroke.values.n = 100;
        stroke.values.min = -4.49, stroke.values.t_min = 20.0;
        stroke.values.max = 3.99, stroke.values.t_max = 30.0;
        digest.statistics = {stroke};
    }
    Extreme& extreme(std::size_t which) { return digest.courses[0].extremes[which]; }
    Statistics& stroke() { return digest.statistics[0].values; }
    [[nodiscard]] std::string text() const { return summary_text(record, digest); }
};

TEST(Summary, MarksNothingWhereNothingHappened) {
    EXPECT_THAT(RiserRun().text(), Not(HasSubstr("! ")));
}

TEST(Summary, TellsALineThatParted) {
    RiserRun run;
    run.record.input.lines[0].fail = {.time = 60.0, .arc_length = 25.0};
    EXPECT_THAT(run.text(), HasSubstr("! ttr: parted at 60 s at 25.0 m, as the case says\n"));
    run.record.input.lines[0].fail->time = 100.5;  // after the end of the run
    EXPECT_THAT(run.text(), Not(HasSubstr("parted")));
}

TEST(Summary, TellsATensionerOnItsStops) {
    RiserRun run;
    run.stroke().min = -4.52;
    EXPECT_THAT(run.text(),
                HasSubstr("! ttr/ram: on its upper stop of -4.5 m, furthest at t = 20 s with "
                          "-4.520 m\n"));
    EXPECT_THAT(run.text(), Not(HasSubstr("lower stop")));
    run.stroke().max = 4.01;
    EXPECT_THAT(run.text(),
                HasSubstr("! ttr/ram: on its lower stop of 4 m, furthest at t = 30 s with "
                          "4.010 m\n"));
}

TEST(Summary, TellsLoadsAboveWhatTheLineBears) {
    RiserRun run;
    run.extreme(4).value = 1.01;
    EXPECT_THAT(run.text(), HasSubstr("! ttr: above its breaking load at 0.0 m, t = 12 s\n"));
    EXPECT_THAT(run.text(), Not(HasSubstr("yield at")));
    run.extreme(3).value = 1.2;
    EXPECT_THAT(run.text(), HasSubstr("! ttr: above yield at 40.0 m, t = 13 s\n"));
}

TEST(Summary, TellsCompressionAndSlack) {
    RiserRun run;
    run.extreme(0).value = -2500.0;
    EXPECT_THAT(run.text(), HasSubstr("! ttr: compression of 2.5 kN at 90.0 m, t = 11 s\n"));
    run.digest.courses[0].slack_first = 10.5, run.digest.courses[0].slack_duration = 3.0;
    EXPECT_THAT(run.text(), HasSubstr("! ttr: slack (below 1.0 kN somewhere) for 3 s in all, "
                                      "first at t = 10.5 s"));
}

}  // namespace
}  // namespace hawser::io
