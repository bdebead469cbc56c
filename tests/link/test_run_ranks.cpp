// Whole coupled runs on several ranks: the same bits as alone, and every rank ends together.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <optional>

#include "io/hdf5.hpp"
#include "moored_spar.hpp"
#include "ranks.hpp"
#include "roles.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;
using test::ranks;

/// A folder that all ranks name alike; rank 0 clears it.
fs::path folder(const std::string& name) {
    const fs::path path =
        fs::path(testing::TempDir()) / ("hawser_np" + std::to_string(ranks().size()) + "_" + name);
    if (ranks().rank() == 0) fs::remove_all(path);
    ranks().barrier();
    return path;
}

ExitCode run(const Case& input, const fs::path& path, io::Link& link) {
    RunRequest request;
    request.folder = path;
    request.progress = ProgressStyle::none;
    request.quiet = true;
    return link.rank() == 0 ? run_master(input, request, link) : run_worker(input, request, link);
}

void expect_same_bits(const io::Hdf5File& a, const io::Hdf5File& b, const std::string& path) {
    const std::vector<double> x = a.read(path), y = b.read(path);
    ASSERT_EQ(x.size(), y.size()) << path;
    ASSERT_GT(x.size(), 0U) << path;
    EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(double)), 0) << path;
}

TEST(RunOnRanks, GivesTheBitsOfARunAlone) {
    const Case input = test::moored_spar();
    const fs::path together = folder("together"), by_itself = folder("alone");
    io::Link link = ranks().duplicate();
    ASSERT_EQ(run(input, together, link), ExitCode::done);
    if (ranks().rank() == 0) {
        io::Link alone;
        ASSERT_EQ(run(input, by_itself, alone), ExitCode::done);
        const io::Hdf5File a = io::Hdf5File::open(together / "result.h5");
        const io::Hdf5File b = io::Hdf5File::open(by_itself / "result.h5");
        for (const char* path : {"/time",
                                 "/snapshot_time",
                                 "/platform/spar/position",
                                 "/platform/spar/velocity",
                                 "/platform/spar/acceleration",
                                 "/platform/spar/loads/lines",
                                 "/platform/spar/loads/members",
                                 "/platform/spar/loads/total",
                                 "/environment/elevation",
                                 "/lines/end_a/effective_tension",
                                 "/lines/end_b/effective_tension",
                                 "/lines/end_a/force",
                                 "/lines/nodes/position",
                                 "/lines/at/effective_tension",
                                 "/lines/at/seabed_force",
                                 "/lines/end_b/curvature",
                                 "/lines/touchdown/arc_length",
                                 "/lines/range/effective_tension/std",
                                 "/lines/range/effective_tension/at_maximum",
                                 "/lines/range/seabed_force/max",
                                 "/lines/extremes/effective_tension_min",
                                 "/statics/lines/touchdown",
                                 "/ledger/spar/mean",
                                 "/ledger/spar/residual"})
            expect_same_bits(a, b, path);
        // and it moved: this is not the same still water twice
        const std::vector<double> surge = a.dataset("/platform/spar/position").read_column(0);
        EXPECT_GT(std::abs(surge.back() - surge.front()), 1e-3);
        fs::remove_all(together);
        fs::remove_all(by_itself);
    }
    ranks().barrier();
}

TEST(RunOnRanks, EndsOnAllRanksWithThreeWhenTheInputIsWrong) {
    Case input = test::moored_spar();
    input.platform->hydrodynamics.database.emplace().path = "/nowhere/at_all";
    io::Link link = ranks().duplicate();
    if (ranks().rank() == 0) testing::internal::CaptureStderr();
    EXPECT_EQ(run(input, folder("input"), link), ExitCode::input);
    if (ranks().rank() == 0) {
        EXPECT_NE(testing::internal::GetCapturedStderr().find("/nowhere/at_all"),
                  std::string::npos);
    }
}

TEST(RunOnRanks, EndsOnAllRanksWithFourWhenALineHasNoEquilibrium) {
    Case input = test::moored_spar();
    input.lines[3].sections[0].length = 300.0;  // shorter than the way to its anchor by half
    const fs::path path = folder("short");
    io::Link link = ranks().duplicate();
    if (ranks().rank() == 0) testing::internal::CaptureStderr();
    EXPECT_EQ(run(input, path, link), ExitCode::no_equilibrium);
    if (ranks().rank() == 0) {
        const std::string said = testing::internal::GetCapturedStderr();
        EXPECT_NE(said.find("ml4"), std::string::npos) << said;
        fs::remove_all(path);
    }
    ranks().barrier();
}

TEST(RunOnRanks, EndsOnAllRanksWithFiveAndAReadableResultWhenALineFails) {
    Case input = test::moored_spar();
    // Heave far too stiff for the platform step: it throws the lines about.
    input.platform->hydrodynamics.matrix->stiffness(2, 2) = 3e9;
    input.analysis.dynamics.duration = 200.0;
    const fs::path path = folder("light");
    io::Link link = ranks().duplicate();
    if (ranks().rank() == 0) testing::internal::CaptureStderr();
    EXPECT_EQ(run(input, path, link), ExitCode::diverged);
    if (ranks().rank() == 0) {
        const std::string said = testing::internal::GetCapturedStderr();
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        const io::Hdf5File result = io::Hdf5File::open(path / "result.h5");
        EXPECT_GE(result.read("/time").size(), 1U);
        fs::remove_all(path);
    }
    ranks().barrier();
}

TEST(RunOnRanks, LinesOfAllModelsGiveTheBitsOfARunAlone) {
    Case input = test::moored_spar();
    input.lines[1].model = input.lines[3].model = LineModel::quasi_static;
    input.lines[2].model = input.lines[5].model = LineModel::catenary;
    const fs::path together = folder("models"), by_itself = folder("models_alone");
    io::Link link = ranks().duplicate();
    ASSERT_EQ(run(input, together, link), ExitCode::done);
    if (ranks().rank() == 0) {
        io::Link alone;
        ASSERT_EQ(run(input, by_itself, alone), ExitCode::done);
        const io::Hdf5File a = io::Hdf5File::open(together / "result.h5");
        const io::Hdf5File b = io::Hdf5File::open(by_itself / "result.h5");
        for (const char* path : {"/platform/spar/position", "/platform/spar/loads/lines",
                                 "/lines/end_a/effective_tension", "/lines/end_b/effective_tension",
                                 "/lines/nodes/position"})
            expect_same_bits(a, b, path);
    }
    ranks().barrier();
}

TEST(RunOnRanks, LinesBetweenTwoPlatformsGiveTheBitsOfARunAlone) {
    Case input = test::moored_spar();
    input.further_platforms = {*input.platform};
    Platform& second = input.further_platforms[0];
    second.name = "buoy";
    second.key_path = "platforms.buoy";
    second.position = {250.0, 30.0, 0.0};
    for (const int i : {0, 1, 2}) {  // these moor the second; two more lie between
        Line& line = input.lines[static_cast<std::size_t>(i)];
        line.end_a.platform = 1;
        line.end_b.position += second.position;
    }
    for (int i = 0; i < 2; ++i) {
        Line between = input.lines[3];
        between.name = "between" + std::to_string(i + 1);
        between.family = "between";
        between.end_a.position = {4.0, 3.0 * i, -30.0};
        between.end_b = {
            .kind = EndKind::platform, .platform = 1, .position = {-4.0, 3.0 * i, -25.0}};
        between.sections = {{.type = 0, .length = 270.0, .elements = i == 0 ? 24 : 27}};
        input.lines.push_back(between);
    }
    input.lines.back().model = LineModel::quasi_static;
    const fs::path together = folder("between"), by_itself = folder("between_alone");
    io::Link link = ranks().duplicate();
    ASSERT_EQ(run(input, together, link), ExitCode::done);
    if (ranks().rank() == 0) {
        io::Link alone;
        ASSERT_EQ(run(input, by_itself, alone), ExitCode::done);
        const io::Hdf5File a = io::Hdf5File::open(together / "result.h5");
        const io::Hdf5File b = io::Hdf5File::open(by_itself / "result.h5");
        for (const char* path :
             {"/platform/spar/position", "/platform/buoy/position", "/platform/spar/loads/lines",
              "/platform/buoy/loads/lines", "/platform/buoy/loads/members", "/ledger/spar/mean",
              "/ledger/buoy/mean", "/lines/end_a/effective_tension",
              "/lines/end_b/effective_tension", "/lines/nodes/position"})
            expect_same_bits(a, b, path);
        fs::remove_all(together);
        fs::remove_all(by_itself);
    }
    ranks().barrier();
}

TEST(RunOnRanks, EveryRankPutsTheSameBitsIntoItsLinesForTheirTargets) {
    Case input = test::moored_spar();
    const double before = input.lines[0].end_b.position.norm();
    input.lines[0].target = {.adjust = StaticTarget::Adjust::anchor_radius, .pretension = 1.2e6};
    const std::vector<Adjustment> found = meet_targets(input, ranks());
    EXPECT_EQ(found.size(), ranks().rank() == 0 ? 1U : 0U);
    EXPECT_NE(input.lines[0].end_b.position.norm(), before);
    const std::vector<int> counts(static_cast<std::size_t>(ranks().size()), 3);
    std::vector<double> all(3 * counts.size());
    ranks().gather({input.lines[0].end_b.position.data(), 3}, counts, all);
    for (std::size_t i = 3; i < all.size() && ranks().rank() == 0; ++i)
        EXPECT_EQ(all[i], all[i % 3]);
}

TEST(RunOnRanks, ATargetOutOfReachEndsEveryRank) {
    Case input = test::moored_spar();
    input.lines[0].target = {.adjust = StaticTarget::Adjust::anchor_radius, .pretension = 1.0};
    try {
        meet_targets(input, ranks());
        ADD_FAILURE() << "nothing thrown";
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::no_equilibrium);
        EXPECT_EQ(std::string(error.what()).empty(), ranks().rank() != 0);
    }
}

}  // namespace
}  // namespace hawser
