// `hawser hydro cylinder`: its options, and its files as the reader of hydrodynamic data sees them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/command_line.hpp"
#include "io/cylinder_command.hpp"
#include "io/hydro_file.hpp"
#include "io/wamit_output.hpp"

namespace hawser::io {
namespace {

using testing::HasSubstr;

CommandLine parse(std::vector<const char*> words) {
    words.insert(words.begin(), {"hawser", "hydro", "cylinder"});
    return parse_command_line(static_cast<int>(words.size()), words.data());
}

TEST(HydroCylinder, TakesItsOptions) {
    const CommandLine line = parse({"--depth",
                                    "1500",
                                    "--part",
                                    "20,0,-70",
                                    "--part",
                                    "20,-165,-175",
                                    "--frequencies",
                                    "0.02:2.5:0.02",
                                    "--headings",
                                    "0:90:15",
                                    "--out",
                                    "there/spar",
                                    "--mass",
                                    "1.03e8",
                                    "--cog",
                                    "-66",
                                    "--gyration",
                                    "83",
                                    "--heave-added-mass",
                                    "3.9e7",
                                    "--heave-damping",
                                    "0.1",
                                    "--rho",
                                    "1000",
                                    "--g",
                                    "9.81",
                                    "--tolerance",
                                    "1e-3"});
    ASSERT_FALSE(line.finished) << line.message;
    EXPECT_EQ(line.command, CommandLine::Command::hydro_cylinder);
    const hydro::CylinderRequest& r = line.cylinder;
    EXPECT_EQ(r.hull.depth, 1500.0);
    ASSERT_EQ(r.hull.parts.size(), 2U);
    EXPECT_EQ(r.hull.parts[1].bottom, -175.0);
    ASSERT_EQ(r.frequencies.size(), 125U);
    EXPECT_NEAR(r.frequencies.back(), 2.5, 1e-12);
    ASSERT_EQ(r.headings.size(), 7U);
    EXPECT_DOUBLE_EQ(r.headings.back(), M_PI / 2);
    ASSERT_TRUE(r.free);
    EXPECT_EQ(r.free->cog, -66.0);
    EXPECT_EQ(r.free->heave_added_mass, 3.9e7);
    EXPECT_EQ(r.heave_damping_fraction, 0.1);
    EXPECT_EQ(r.water.density, 1000.0);
    EXPECT_EQ(r.tolerance, 1e-3);
    EXPECT_EQ(line.out, "there/spar");
}

TEST(HydroCylinder, TellsEveryMistakeAtOnce) {
    const CommandLine none = parse({});
    EXPECT_EQ(none.finished, ExitCode::command_line);
    for (const char* option : {"--depth", "--part", "--frequencies", "--out"})
        EXPECT_THAT(none.message, HasSubstr(option));

    const CommandLine wrong =
        parse({"--depth", "-5", "--part", "20,0", "--frequencies", "1:0:0.1", "--headings", "x",
               "--rho", "heavy", "--cog", "-3", "--out", "a"});
    EXPECT_EQ(wrong.finished, ExitCode::command_line);
    for (const char* said : {"--depth: expected a depth", "--part 20,0: expected RADIUS,TOP,BOTTOM",
                             "--frequencies 1:0:0.1: expected TO above FROM", "--headings x",
                             "--rho: expected a density", "--cog: needs --mass"})
        EXPECT_THAT(wrong.message, HasSubstr(said));

    const CommandLine overlap =
        parse({"--depth", "100", "--part", "20,0,-70", "--part", "10,-60,-120", "--frequencies",
               "0,1", "--mass", "1e6", "--out", "a"});
    EXPECT_EQ(overlap.finished, ExitCode::command_line);
    for (const char* said : {"overlaps part 20,0,-70", "below the seabed", "above zero",
                             "--cog: expected with --mass", "--gyration: expected with --mass"})
        EXPECT_THAT(overlap.message, HasSubstr(said));
    EXPECT_EQ(parse({"--radius", "3"}).finished, ExitCode::command_line);
}

TEST(HydroCylinder, WritesWhatTheReaderReads) {
    // Ten digits are written; the reader turns them back into the same SI numbers and headings.
    hydro::CylinderRequest request;
    request.hull = {100.0, {{10.0, 0.0, -20.0}}};
    request.frequencies = {0.4, 0.8};
    request.headings = {0.0, M_PI / 4, M_PI / 2};
    request.tolerance = 1e-2;
    const hydro::CylinderData made = hydro::cylinder_data(request);
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser_cylinder";
    std::filesystem::create_directories(folder);
    const std::string stem = (folder / "hull").string();
    EXPECT_EQ(write_wamit(made.data, request.water.gravity, stem).size(), 4U);

    HydroDatabase database;
    database.path = stem;
    database.ulen = 1.0;
    database.rho = 1025.0;
    database.displaced_volume = made.buoyancy.volume;
    database.centre_of_buoyancy = {0.0, 0.0, made.buoyancy.centre};
    database.includes_weight = false;
    database.symmetry = {"xz", "yz"};
    Water water;
    water.gravity = request.water.gravity;
    const HydroData read = read_hydro(database, water);
    const double close = 1e-8;
    ASSERT_EQ(read.frequencies.size(), 2U);
    EXPECT_NEAR(read.frequencies[1], 0.8, close);
    for (std::size_t f = 0; f < 2; ++f) {
        EXPECT_LT((read.added_mass[f] - made.data.added_mass[f]).norm(),
                  close * made.data.added_mass[f].norm());
        EXPECT_LT((read.damping[f] - made.data.damping[f]).norm(),
                  close * made.data.damping[f].norm());
    }
    ASSERT_TRUE(read.added_mass_0 && read.added_mass_inf);
    EXPECT_LT((*read.added_mass_inf - *made.data.added_mass_inf).norm(),
              close * made.data.added_mass_inf->norm());
    EXPECT_LT((read.waterplane_stiffness - made.data.waterplane_stiffness).norm(),
              close * made.data.waterplane_stiffness.norm() * 10.0);
    EXPECT_TRUE(read.excitation.full_circle);
    int compared = 0;
    for (const auto& own : made.data.excitation.headings)
        for (const auto& h : read.excitation.headings)
            if (std::abs(h.heading - own.heading) < 1e-6) {
                ++compared;
                EXPECT_LT((h.values[1] - own.values[1]).norm(), close * own.values[1].norm());
            }
    EXPECT_EQ(compared, 3);
    for (const auto& h : read.mean_drift.headings)
        if (std::abs(h.heading - M_PI / 4) < 1e-6) {
            EXPECT_NEAR(h.values[1][0], made.data.mean_drift.headings[1].values[1][0],
                        close * std::abs(h.values[1][0]));
            EXPECT_NEAR(h.values[1][0], h.values[1][1], close * std::abs(h.values[1][0]));
        }
}

TEST(HydroCylinder, SaysBeforeItWorksThatTheFolderIsMissing) {
    hydro::CylinderRequest request;
    request.hull = {100.0, {{10.0, 0.0, -20.0}}};
    request.frequencies = {0.4};
    request.headings = {0.0};
    EXPECT_THROW(static_cast<void>(cylinder_command(request, "no/such/folder/hull", true)),
                 RunError);
}

}  // namespace
}  // namespace hawser::io
