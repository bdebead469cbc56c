// The joined result: its paths, shapes and attributes are those of the format, its data those of
// the segments, whatever the segments' lengths.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <fstream>

#include "common/io/folder.hpp"
#include "io/hdf5.hpp"
#include "io/result_fields.hpp"
#include "io/result_file.hpp"
#include "io/series_file.hpp"
#include "io/summary.hpp"
#include "line_weight.hpp"
#include "synthetic_run.hpp"

namespace {

using namespace hawser;
using namespace hawser::io;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

ResultDigest finish(const fs::path& folder, const Case& input, int samples_per_segment) {
    Link alone;
    test::record_synthetic(folder, input, alone, samples_per_segment);
    return write_result(folder, test::synthetic_record(input, 1));
}

TEST(Result, HasTheSameDataHoweverTheRunWasCutIntoSegments) {
    // 121 snapshots of 384 nodes: more than two chunks, and the last one not full
    const Case input = test::synthetic_spar(240.0);
    const test::Folder folder;
    fs::create_directories(folder.path / "one");
    fs::create_directories(folder.path / "many");
    finish(folder.path / "one", input, 1000);
    finish(folder.path / "many", input, 7);
    const Hdf5File one = Hdf5File::open(folder.path / "one" / "result.h5");
    const Hdf5File many = Hdf5File::open(folder.path / "many" / "result.h5");
    for (const char* path : {"/time", "/snapshot_time", "/platform/spar/position",
                             "/lines/nodes/position", "/line/ml3/end_a/force"}) {
        const std::vector<double> a = one.read(path), b = many.read(path);
        EXPECT_FALSE(a.empty());
        EXPECT_EQ(a, b) << path;
    }
    EXPECT_EQ(one.read("/time").size(), 481u);
    EXPECT_DOUBLE_EQ(one.read("/time").back(), 240.0);
    // the last node of the last snapshot is an anchor
    EXPECT_DOUBLE_EQ(many.read("/lines/nodes/position").back(), -1500.0);
}

TEST(Result, TellsSeveralPlatformsApart) {
    const Case input = test::synthetic_pair(20.0);
    const test::Folder folder;
    const ResultDigest digest = finish(folder.path, input, 1000);
    const Hdf5File file = Hdf5File::open(folder.path / "result.h5");
    for (const std::string name : {"spar", "tender"}) {
        for (const char* part : {"/position", "/velocity", "/acceleration", "/loads/total"})
            EXPECT_TRUE(file.exists("/platform/" + name + part)) << name << part;
        EXPECT_TRUE(file.exists("/ledger/" + name + "/mean"));
        EXPECT_EQ(file.dataset("/input/geometry/" + name + "/member_ends").shape(),
                  (Extent{name == "spar" ? 3U : 1U, 2, 3}));
        // surge and sway are displacements from where it is designed to be
        EXPECT_NEAR(file.read("/statics/platform/" + name + "/position").at(0), 31.0, 1e-9);
    }
    EXPECT_EQ(file.read("/statics/platform/tender/mass").at(0), 14500.0);
    ASSERT_GE(digest.statistics.size(), 12U);
    EXPECT_EQ(digest.statistics[0].channel, "platform/spar/surge");
    EXPECT_EQ(digest.statistics[6].channel, "platform/tender/surge");
    const std::string text = summary_text(test::synthetic_record(input, 1), digest);
    for (const char* words :
         {"Platform spar", "Platform tender", "designed to be at x 120 m, y 60 m",
          "Load ledger of tender", "no hydrodynamic interaction"})
        EXPECT_THAT(text, HasSubstr(words));
    EXPECT_THAT(summary_text(test::synthetic_record(test::synthetic_spar(20.0), 1), digest),
                Not(HasSubstr("interaction")));
}

TEST(Result, ReplacesTheSegments) {
    const test::Folder folder;
    finish(folder.path, test::synthetic_decay(20.0), 10);
    EXPECT_TRUE(segment_files(folder.path).empty());
    EXPECT_FALSE(fs::exists(folder.path / "result.h5.part"));
}

TEST(Result, ShowsEachLineUnderItsName) {
    const Case input = test::synthetic_spar(10.0);
    const test::Folder folder;
    finish(folder.path, input, 1000);
    const Hdf5File file = Hdf5File::open(folder.path / "result.h5");
    EXPECT_EQ(file.read_texts("/lines/names").at(12), "scr_oil");
    EXPECT_EQ(file.read_texts("/lines/family").at(12), "scr");
    const std::vector<double> all = file.read("/lines/end_a/effective_tension");
    const std::vector<double> oil = file.read("/line/scr_oil/end_a/effective_tension");
    ASSERT_EQ(oil.size(), 21u);
    for (std::size_t i = 0; i < oil.size(); ++i) EXPECT_EQ(oil[i], all[16 * i + 12]);
    // its nodes stand from first[12] to first[13] - 1
    const std::vector<double> first = file.read("/lines/nodes/first");
    const Extent shape = file.dataset("/line/scr_oil/nodes/position").shape();
    EXPECT_EQ(static_cast<double>(shape.at(1)), first[13] - first[12]);
    EXPECT_EQ(first.back(), static_cast<double>(file.read("/lines/nodes/arc_length").size()));
}

TEST(Result, LeavesColumnsThatNobodyAskedForEmpty) {
    const Case input = test::synthetic_spar(10.0);  // forces of the mooring lines only
    const test::Folder folder;
    finish(folder.path, input, 1000);
    const Hdf5File file = Hdf5File::open(folder.path / "result.h5");
    for (const double x : file.dataset("/lines/end_a/force").read_column(3 * 12)) {
        EXPECT_TRUE(std::isnan(x));
    }
    EXPECT_FALSE(file.exists("/line/scr_oil/end_a/force"));
    EXPECT_FALSE(file.exists("/lines/end_a/moment"));
    EXPECT_TRUE(file.exists("/line/ml1/end_a/force"));
}

TEST(Result, ShowsPlacesTouchdownAndConstraintsUnderTheirNames) {
    const Case input = test::synthetic_spar(10.0);
    const test::Folder folder;
    finish(folder.path, input, 1000);
    const Hdf5File file = Hdf5File::open(folder.path / "result.h5");
    // four risers with two places each, in line order
    EXPECT_EQ(file.read_texts("/lines/at/line").at(2), "scr_gas");
    EXPECT_EQ(file.read("/lines/at/arc_length"),
              (std::vector<double>{1480, 1550, 1480, 1550, 1480, 1550, 1480, 1550}));
    const auto same = [&](const std::string& path, const std::string& field, std::uint64_t column) {
        const std::vector<double> view = file.read(path);
        EXPECT_EQ(view, file.dataset(field).read_column(column)) << path;
        EXPECT_TRUE(std::isfinite(view.at(5))) << path;
    };
    same("/line/scr_gas/at/1550/von_mises_stress", "/lines/at/von_mises_stress", 3);
    same("/line/scr_gas/end_a/von_mises_stress", "/lines/end_a/von_mises_stress", 13);
    same("/line/scr_oil/touchdown/arc_length", "/lines/touchdown/arc_length", 12);
    EXPECT_EQ(file.read_texts("/constraints/names"),
              (std::vector<std::string>{"scr_oil/ram", "scr_oil/keel"}));
    same("/constraint/scr_oil/ram/stroke", "/constraints/stroke", 0);
    same("/constraint/scr_oil/keel/force", "/constraints/force", 1);
    EXPECT_FALSE(file.exists("/constraint/scr_oil/keel/stroke"));
}

TEST(Result, HoldsTheLatestOfWhatHasNoTime) {
    const Case input = test::synthetic_spar(30.0);
    const test::Folder folder;
    finish(folder.path, input, 7);  // segments of which each has its own
    const Hdf5File file = Hdf5File::open(folder.path / "result.h5");
    const std::vector<double> all = file.read("/lines/range/von_mises_stress/t_max");
    const std::vector<double> first = file.read("/lines/nodes/first");
    ASSERT_EQ(static_cast<double>(all.size()), first.back());
    const std::vector<double> oil = file.read("/line/scr_oil/range/von_mises_stress/t_max");
    ASSERT_EQ(static_cast<double>(oil.size()), first[13] - first[12]);
    for (const double t : oil) EXPECT_EQ(t, 30.0);
    EXPECT_FALSE(file.exists("/line/ml1/range/von_mises_stress/max"));
    EXPECT_EQ(file.dataset("/lines/extremes/slack").shape(), (Extent{16, 3}));
}

void expect_described(const Hdf5File& file, const std::string& path, bool is_group) {
    if (!is_group) {
        EXPECT_NO_THROW((void)file.text_attribute(path, "units")) << path;
        EXPECT_FALSE(file.text_attribute(path, "description").empty()) << path;
        return;
    }
    for (const std::string& name : file.children(path)) {
        const std::string child = (path == "/" ? "" : path) + "/" + name;
        bool group = true;
        try {
            (void)file.children(child);
        } catch (const RunError&) {
            group = false;
        }
        expect_described(file, child, group);
    }
}

TEST(Result, TellsTheBreakingLoadOfTheSectionAtEveryNode) {
    const test::Folder folder;
    Case input = test::synthetic_chain(10.0);
    input.line_types.push_back(input.line_types[0]);
    input.line_types[0].breaking_load = 5e6, input.line_types[1].breaking_load = 3e6;
    Line& line = input.lines[0];
    line.sections = {{.type = 0, .length = 20, .elements = 2},
                     {.type = 1, .length = 40, .elements = 2}};
    finish(folder.path, input, 1000);
    const auto load = Hdf5File::open(folder.path / "result.h5").read("/lines/nodes/breaking_load");
    EXPECT_EQ(load, (std::vector<double>{5e6, 5e6, 3e6, 3e6, 3e6}));
}

TEST(Result, DescribesEveryDataset) {
    const test::Folder folder;
    finish(folder.path, test::synthetic_spar(10.0), 1000);
    expect_described(Hdf5File::open(folder.path / "result.h5"), "/", true);
}

TEST(Result, OfARunThatFailedBeforeItsFirstSampleStillHoldsTheInput) {
    const test::Folder folder;
    RunRecord record = test::synthetic_record(test::synthetic_spar(10.0), 1);
    record.complete = false;
    record.outcome = "no static equilibrium";
    record.ledgers.clear();
    record.statics.reset();
    const ResultDigest digest = write_result(folder.path, record);
    EXPECT_EQ(digest.samples, 0);
    EXPECT_THAT(summary_text(record, digest), HasSubstr("NOT COMPLETE: no static equilibrium"));
    EXPECT_EQ(Hdf5File::open(folder.path / "result.h5").read_text("/input/case"), record.resolved);
}

TEST(Summary, MarksALargeLedgerResidualAndSaysNothingOfMotionsWithoutLoads) {
    const test::Folder folder;
    RunRecord record = test::synthetic_record(test::synthetic_spar(10.0), 1);
    record.ledgers.assign(1, {});
    LedgerTable& ledger = record.ledgers.front();
    ledger.components = {"waves", "damping"};
    ledger.mean.assign(2, Vec6::Zero());
    ledger.mean[0] << 1e6, 1e-3, 2e6, 0, 3e7, 0;
    ledger.residual << 4e3, 1e-3, -11e3, 0, 9e5, 0;  // 0.4 %, noise, 0.55 %, -, 3 %, -
    const ResultDigest digest = write_result(folder.path, record);
    const std::string text = summary_text(record, digest);
    EXPECT_THAT(text, HasSubstr("! residual above 0.5 %: heave 0.55 %, pitch 3 %."));
    EXPECT_THAT(text, HasSubstr("a load is missing or counted twice"));
    EXPECT_THAT(text, HasSubstr("residual, % of largest        0.400            -        0.550"));
    ledger.residual *= 0.1;
    EXPECT_THAT(summary_text(record, digest), Not(HasSubstr("! residual")));
}

TEST(Result, DigestsStatisticsAndTheStart) {
    const Case input = test::synthetic_spar(60.0);
    const test::Folder folder;
    const ResultDigest digest = finish(folder.path, input, 1000);
    // motions, environment; end tensions of 16 + 12 ends; declinations of 24; of the risers stress
    // at end A and two places, touchdown with its position; tensioner and guide of one
    ASSERT_EQ(digest.statistics.size(), 6u + 2u + 16u + 12u + 24u + 4u + 8u + 16u + 3u);
    EXPECT_EQ(digest.statistics[0].channel, "platform/spar/surge");
    EXPECT_EQ(digest.statistics[8].channel, "line/ml1/end_a/effective_tension");
    EXPECT_EQ(digest.statistics[0].values.n, 61);  // 30 s to 60 s
    EXPECT_NEAR(digest.lines[0].end_a_declination, 55.0, 1e-12);
    EXPECT_NEAR(digest.lines[12].end_a_declination, 55.0, 1e-12);  // though it is not recorded
    EXPECT_NEAR(digest.lines[0].grounded, 122.0, 1e-9);
    EXPECT_NEAR(digest.lines[0].touchdown, 2377.0, 1e-9);
    EXPECT_NEAR(digest.courses[3].extremes[1].arc_length, 0.25 * 2499, 1e-9);
    EXPECT_NEAR(digest.courses[3].extremes[1].time, 60.0, 1e-12);
}

TEST(Summary, TellsTheWeightOfALineInWater) {
    Case input = test::synthetic_chain(10.0);
    const Line& line = input.lines[0];
    // (100 kg/m - 1025 kg/m3 x 0.013 m2) x 60 m x g
    EXPECT_NEAR(submerged_weight(line, input), (100.0 - 13.325) * 60.0 * 9.80665, 1e-6);
}

TEST(LineWeight, OfATaperIsItsIntegralAndOfAPartOnlyWhatHangsBelow) {
    // 10 m plain of w, 10 m that grow to 4 w, a clump at their joint: from the middle of the taper
    // down 5 m of (2.5 w + 4 w)/2.
    Case input = test::synthetic_chain(10.0);
    LineType heavy = input.line_types[0];
    heavy.mass *= 4, heavy.displaced_area *= 4;
    input.line_types.push_back(heavy);
    Line& line = input.lines[0];
    const int last = static_cast<int>(input.line_types.size()) - 1;
    line.sections = {{.type = 0, .length = 10, .elements = 1},
                     {.type = 0, .length = 10, .elements = 3, .type_at_end = last}};
    line.attachments = {{.arc_length = 10, .mass = 50}};
    const double w = (100.0 - 13.325) * 9.80665;
    EXPECT_NEAR(submerged_weight(line, input), 10 * w + 25 * w + 50 * 9.80665, 1e-6);
    EXPECT_NEAR(submerged_weight(line, input, 10.0), 25 * w + 50 * 9.80665, 1e-6);
    EXPECT_NEAR(submerged_weight(line, input, 15.0), 5 * 3.25 * w, 1e-6);
    EXPECT_NEAR(submerged_weight(line, input, 20.0), 0.0, 1e-6);
}

TEST(Summary, WritesOneRowPerChannelThatReadsBackExactly) {
    const Statistics s{.n = 3,
                       .mean = 0.1,
                       .std = 1.0 / 3.0,
                       .min = -1,
                       .t_min = 2,
                       .max = 4,
                       .t_max = 5,
                       .skewness = 0,
                       .kurtosis = 3,
                       .tz = std::nan("")};
    const std::string csv = statistics_csv({{"platform/spar/surge", "m", s}});
    EXPECT_THAT(csv, HasSubstr("\nplatform/spar/surge,m,3,0.1,0.3333333333333333,-1,2,4,5,0,3,\n"));
}

TEST(Selection, MatchesGlobs) {
    EXPECT_TRUE(matches("ml*", "ml12"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("scr_?as", "scr_gas"));
    EXPECT_TRUE(matches("*prod*1", "scr_prod1"));
    EXPECT_FALSE(matches("ml*", "scr_ml"));
    EXPECT_FALSE(matches("ml?", "ml12"));
}

TEST(Segments, ThatFindNoRoomAreErrorsOfInputAndOutputWithPathAndCall) {
    const test::Folder folder;
    const Case input = test::synthetic_spar(60.0);
    // A limit on the size of files stands for the full disk; the signal it sends is ignored.
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{.rlim_cur = 20000, .rlim_max = limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string words;
    try {
        Link alone;
        test::record_synthetic(folder.path, input, alone, 1000);
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::io);
        words = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, before);
    EXPECT_THAT(words, HasSubstr("segment_00001.h5.part"));
    EXPECT_THAT(words, HasSubstr("H5"));
    EXPECT_THAT(words, HasSubstr("File too large"));
    EXPECT_TRUE(segment_files(folder.path).empty());  // nothing is called saved that is not
}

}  // namespace
