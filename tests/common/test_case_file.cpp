#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "adjustment.hpp"
#include "bed_contact.hpp"
#include "io/case_file.hpp"

namespace hawser::io {
namespace {

namespace fs = std::filesystem;
const fs::path source = HAWSER_SOURCE_DIR;
const fs::path spar = source / "cases/truss_spar/truss_spar.yml";

const LineType& type(const Case& c, const std::string& name) {
    for (const LineType& t : c.line_types) {
        if (t.name == name) return t;
    }
    throw std::runtime_error("no line type " + name);
}

const Line& line(const Case& c, const std::string& name) {
    for (const Line& l : c.lines) {
        if (l.name == name) return l;
    }
    throw std::runtime_error("no line " + name);
}

double submerged_weight(const Case& c, const LineType& t) {
    const Water& water = c.environment.water;
    return (t.mass - water.density * t.displaced_area) * water.gravity;
}

Case read(const fs::path& path, const Overrides& overrides = {}) {
    return read_case(path, overrides).value;
}

std::vector<fs::path> cases_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yml" && entry.path().stem() != "reference") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<fs::path> all_cases() {
    std::vector<fs::path> files = cases_in(source / "cases");
    for (const char* folder : {"cases/truss_spar", "tests/common/cases/accepted"}) {
        const std::vector<fs::path> more = cases_in(source / folder);
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

TEST(Output, ARangeAloneRecordsNoEnd) {
    const std::string chain = (source / "tests/common/cases/accepted/chain.yml").string();
    const auto lines = [&](const std::string& entry) {
        return read(chain, {{"output.lines", entry}}).output.lines.at(0).results;
    };
    EXPECT_TRUE(lines("[{range: [effective_tension]}]").empty());
    EXPECT_EQ(lines("[{range: [effective_tension], at: [end_b]}]").size(), 1u);
    EXPECT_EQ(lines("[{select: '*'}]").size(), 1u);
}

TEST(CaseFile, EveryCaseIsValid) {
    for (const fs::path& file : all_cases()) {
        EXPECT_NO_THROW(read_case(file, {})) << file;
    }
    EXPECT_GE(all_cases().size(), 8U);
}

TEST(CaseFile, ResolvedTextGivesTheSameBits) {
    for (const fs::path& file : all_cases()) {
        const CaseFile first = read_case(file, {});
        const std::string name = first.value.name;
        const CaseFile again = read_resolved_case(name, first.resolved, file.parent_path());
        EXPECT_TRUE(again.value == first.value) << file;
        // A resolved case is a case: written out and read as any other file it says the same.
        const fs::path copy = fs::path(testing::TempDir()) / (name + ".yml");
        std::ofstream(copy) << first.resolved;
        Overrides place;  // data files stay where they are
        for (int k = 0; k < first.value.platform_count(); ++k)
            if (const Platform& p = first.value.platform_at(k); p.hydrodynamics.database)
                place.emplace_back(p.key_path + ".hydrodynamics.database.path",
                                   p.hydrodynamics.database->path);
        CaseFile third;
        EXPECT_NO_THROW(third = read_case(copy, place)) << file;
        fs::remove(copy);
        EXPECT_TRUE(third.value == first.value) << file;
    }
}

std::string said_of(const fs::path& path, const Overrides& overrides) {
    try {
        read_case(path, overrides);
    } catch (const InputError& e) {
        return e.what();
    }
    return "valid";
}

TEST(CaseFile, WhatCannotBeSetFromOutsideIsRefused) {
    const fs::path chain = fs::path(HAWSER_SOURCE_DIR) / "tests/common/cases/accepted/chain.yml";
    for (const char* key : {"units", "include", "base"}) {
        EXPECT_NE(said_of(chain, {{key, "US"}}).find("belongs to the text of a file"),
                  std::string::npos)
            << key;
    }
    EXPECT_EQ(said_of(chain, {{"environment.waves[0].seed", "3"}}),
              "--set environment.waves[0].seed: error: environment.waves[0].seed: the case has no "
              "waves\n1 error, 0 warnings. Nothing was run.");
}

// hanging_chain.yml says statistics_from: 60 s.
TEST(CaseFile, AShorterDurationNamesTheKeyThatStandsInItsWay) {
    const fs::path chain = fs::path(HAWSER_SOURCE_DIR) / "cases/hanging_chain.yml";
    const std::string said = said_of(chain, {{"analysis.dynamics.duration", "40 s"}});
    EXPECT_NE(said.find("--set analysis.dynamics.statistics_from=\"20 s\""), std::string::npos)
        << said;
    EXPECT_EQ(said_of(chain, {{"analysis.dynamics.duration", "40 s"},
                              {"analysis.dynamics.statistics_from", "20 s"}}),
              "valid");
}

TEST(CaseFile, ATensionersFrictionIsAForceAndAGuidesACoefficient) {
    const fs::path riser = fs::path(HAWSER_SOURCE_DIR) / "tests/common/cases/accepted/riser.yml";
    const Case c = read(riser, {{"lines.riser.constraints[0].friction", "5 kN"},
                                {"lines.riser.constraints[1].friction", "0.2"},
                                {"lines.riser.constraints[1].length", "4 m"}});
    const std::vector<LineConstraint>& all = c.lines[0].constraints;
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(all[0].friction_force, 5e3);
    EXPECT_EQ(all[0].friction, 0.0);
    EXPECT_EQ(all[4].name, "plate2.lower");
    EXPECT_EQ(all[4].position, Vec3(0, 0, -32));
    EXPECT_EQ(all[4].friction, 0.2);
}

// The bed rises by 2 degrees towards y: under an anchor 1000 m out there it is 34.92 m higher.
TEST(CaseFile, AnchorsLieOnASlopingBed) {
    const fs::path chain = fs::path(HAWSER_SOURCE_DIR) / "tests/common/cases/accepted/chain.yml";
    const Case c = read(chain, {{"environment.seabed.slope", "{angle: 2, direction: 90}"},
                                {"lines.chain.end_b.anchor.position", "[0, 1000]"},
                                {"lines.chain.sections[0].length", "1010 m"}});
    const double bed = -100 + 1000 * std::tan(2 * M_PI / 180);
    EXPECT_NEAR(c.lines[0].end_b.position.z(), bed + resting_height(c.line_types[0], c.environment),
                1e-9);
}

TEST(CaseFile, AnAnchorHoldsItsLineWhereItRests) {
    LineType pipe;
    pipe.mass = 200, pipe.displaced_area = 0.1, pipe.outer_diameter = 0.36;
    Environment sea;
    sea.seabed.normal_stiffness = 100e3;
    const double w = (200 - 102.5) * 9.80665;  // sinks in by less than d0 = 25 mm
    EXPECT_NEAR(resting_height(pipe, sea), 0.18 - std::sqrt(2 * 0.025 * w / 100e3), 1e-12);
    pipe.mass = 1000;  // by more
    EXPECT_NEAR(resting_height(pipe, sea), 0.18 - (897.5 * 9.80665 / 100e3 + 0.0125), 1e-12);
    pipe.mass = 50;  // floats: touches
    EXPECT_NEAR(resting_height(pipe, sea), 0.18, 1e-12);
    sea.seabed.slope_angle = 0.2;
    EXPECT_NEAR(resting_height(pipe, sea), 0.18 / std::cos(0.2), 1e-12);
}

TEST(CaseFile, ResolvedTextIsCompleteButForAuto) {
    const std::string text = read_case(spar, {}).resolved;
    for (const char* key :
         {"discretisation: equal_energy", "max_iterations: 200", "depth_filter: 1",
          "statistics_from: 600 s", "interval: 0.5 s", "volume_diameter: 0.324 m  # auto",
          "  ml12:\n", "  scr_prod2:\n", "seed: 1  # truss_spar.yml:"}) {
        EXPECT_NE(text.find(key), std::string::npos) << key;
    }
    EXPECT_EQ(text.find("pattern"), std::string::npos);
}

TEST(SeveralPlatforms, NamesBecomeIndicesAndPlacesCountFromTheirOwnPlatform) {
    const Case c = read(source / "tests/common/cases/accepted/two_platforms.yml");
    ASSERT_EQ(c.platform_count(), 2);
    EXPECT_EQ(c.platform_at(0).name, "barge");
    EXPECT_EQ(c.platform_at(1).name, "buoy");
    EXPECT_EQ(c.platform_at(1).key_path, "platforms.buoy");
    EXPECT_FALSE(c.platform_at(0).mass);  // auto, each for itself
    EXPECT_EQ(c.platform_at(1).mass, 1e6);
    EXPECT_EQ(c.platform_at(0).position, Vec3::Zero());
    const Vec3 buoy(300.0, 40.0, 0.0);
    EXPECT_EQ(c.platform_at(1).position, buoy);

    const auto line = [&](const std::string& name) -> const Line& {
        return *std::find_if(c.lines.begin(), c.lines.end(),
                             [&](const Line& l) { return l.name == name; });
    };
    const Line& hawser = line("hawser");
    EXPECT_EQ(hawser.end_a.platform, 0);
    EXPECT_EQ(hawser.end_b.kind, EndKind::platform);
    EXPECT_EQ(hawser.end_b.platform, 1);
    EXPECT_NEAR(hawser.azimuth, std::atan2(40.0, 278.0), 1e-12);  // (15, 0) to (293, 40)
    EXPECT_NEAR((c.place_of(hawser.end_b) - Vec3(293.0, 40.0, 3.0)).norm(), 0.0, 1e-12);
    const Line &of_barge = line("bm1"), &of_buoy = line("ym2");
    EXPECT_EQ(of_buoy.end_a.platform, 1);
    EXPECT_NEAR(of_barge.end_b.position.head<2>().norm(), 600.0, 1e-9);
    EXPECT_NEAR((of_buoy.end_b.position - buoy).head<2>().norm(), 600.0, 1e-9);
    EXPECT_NEAR(of_buoy.end_a.position.head<2>().norm(), 7.0, 1e-12);  // on its platform's axes

    const Line& riser = line("riser2");  // at (-1, 0) on the buoy
    EXPECT_NEAR((riser.end_b.position - Vec3(299.0, 40.0, -200.0)).norm(), 0.0, 1e-12);
    ASSERT_EQ(riser.constraints.size(), 3U);
    const LineConstraint &tensioner = riser.constraints[0], &at_bed = riser.constraints[1],
                         &keel = riser.constraints[2];
    EXPECT_EQ(tensioner.platform, 1);
    EXPECT_EQ(tensioner.position, Vec3(-1.0, 0.0, 3.0));
    EXPECT_FALSE(at_bed.on_platform);
    EXPECT_EQ(at_bed.position, Vec3(299.0, 40.0, -195.0));
    EXPECT_EQ(keel.position, Vec3(-1.0, 0.0, -7.0));
}

TEST(SeveralPlatforms, AnAdjustedAnchorKeepsItsAzimuthSeenFromItsPlatform) {
    Case c = read(source / "tests/common/cases/accepted/two_platforms.yml",
                  {{"lines.buoy_mooring.adjust", "anchor_radius"},
                   {"lines.buoy_mooring.pretension", "400 kN"}});
    const auto at =
        std::find_if(c.lines.begin(), c.lines.end(), [](const Line& l) { return l.name == "ym2"; });
    EXPECT_NEAR(adjusted_quantity(*at), 600.0, 1e-9);
    adjust(c, static_cast<int>(at - c.lines.begin()), 550.0);
    const Vec3 from = at->end_b.position - c.platform_at(1).position;
    EXPECT_NEAR(from.head<2>().norm(), 550.0, 1e-9);
    EXPECT_NEAR(std::atan2(from.y(), from.x()), 2.0 * M_PI / 3.0, 1e-12);
}

TEST(SeveralPlatforms, OneAloneMayStandAnywhereUnderItsName) {
    const Case c = read(source / "tests/common/cases/accepted/two_platforms.yml",
                        {{"platforms.barge", "null"}, {"lines", "null"}});
    ASSERT_EQ(c.platform_count(), 1);
    EXPECT_EQ(c.platform->name, "buoy");
    EXPECT_EQ(c.design_of(0).position, Vec3(300.0, 40.0, 0.0));
}

// Case-format 9.1: the worked-out properties of the example's lines.
TEST(TrussSpar, LineTypesHaveTheirPublishedWeights) {
    const Case c = read(spar);
    EXPECT_NEAR(submerged_weight(c, type(c, "chain")), 5.02e3, 5.0);       // 5.02 kN/m
    EXPECT_NEAR(submerged_weight(c, type(c, "polyester")), 0.144e3, 0.5);  // 0.144 kN/m
    EXPECT_NEAR(submerged_weight(c, type(c, "scr_oil")), 1418.83, 0.01);   // validation row A22
    EXPECT_NEAR(type(c, "scr_oil").EI, 4.58729e7, 50.0);                   // validation row A22a
    const double area = std::numbers::pi / 4 * (0.324 * 0.324 - 0.284 * 0.284);
    EXPECT_NEAR(type(c, "scr_oil").EA, 207e9 * area, 1.0);
    EXPECT_EQ(type(c, "polyester").EA, 706.32e6);
    EXPECT_EQ(type(c, "polyester").viscoelastic->EA_static, 451.26e6);
    EXPECT_EQ(type(c, "scr_gas").drag_diameter, 0.406);
    EXPECT_EQ(type(c, "chain").drag_diameter, 0.172);
}

// Case-format 9.1: top-tensioned riser of Table 3: 235 + 102 - 133 kg/m, 2.00 kN/m.
// A curve gives its first slope as the one number of the stiffness; a wall keeps what stresses
// need.
TEST(LineTypes, CurvesAndWallsAreKept) {
    const fs::path riser = fs::path(HAWSER_SOURCE_DIR) / "tests/common/cases/accepted/riser.yml";
    const Case c = read(riser, {{"line_types.pipe.EA", "[[0, 0], [0.001, 4 MN], [0.01, 20 MN]]"},
                                {"line_types.pipe.stress", "{scf: 1.3, thickness_factor: 0.9}"},
                                {"line_types.pipe.yield", "448 MPa"},
                                {"lines.riser.end_b.joint", "flex"},
                                {"lines.riser.end_b.rotational_stiffness",
                                 "[[0, 0], [1 deg, 10 kN.m], [2 deg, 90 kN.m]]"}});
    const LineType& pipe = c.line_types[0];
    EXPECT_EQ(pipe.EA_curve, (Curve{{0, 0}, {0.001, 4e6}, {0.01, 20e6}}));
    EXPECT_NEAR(pipe.EA, 4e9, 1);
    EXPECT_EQ(pipe.wall->concentration, 1.3);
    EXPECT_EQ(pipe.wall->thickness_factor, 0.9);
    EXPECT_EQ(pipe.wall->yield, 448e6);
    const LineEnd& end = c.lines[0].end_b;
    EXPECT_EQ(end.rotational_curve.size(), 3U);
    EXPECT_NEAR(end.rotational_stiffness, 10e3 * 180 / M_PI, 1e-6);
}

TEST(LineTypes, PipeFullOfSeaWater) {
    const Case c = read(spar, {{"line_types.scr_oil.outer_diameter", "406 mm"},
                               {"line_types.scr_oil.wall_thickness", "25 mm"},
                               {"line_types.scr_oil.contents_density", "1025"}});
    EXPECT_NEAR(submerged_weight(c, type(c, "scr_oil")), 2.00e3, 5.0);
    EXPECT_NEAR(type(c, "scr_oil").mass, 235 + 102, 0.5);
}

TEST(LineTypes, ChainRulesStandInForWhatIsNotGiven) {
    const CaseFile file = read_case(source / "tests/common/cases/accepted/chain.yml", {});
    const LineType& t = type(file.value, "chain");
    EXPECT_NEAR(t.mass, 199.0, 1e-9);
    EXPECT_NEAR(t.EA, 8.54e8, 1e-3);
    const double volume_diameter = std::sqrt(4 * t.displaced_area / std::numbers::pi);
    EXPECT_NEAR(volume_diameter, 0.18, 0.0004);  // 1.80 d
    int notes = 0;
    for (const Problem& p : file.problems) notes += p.severity == Severity::note ? 1 : 0;
    EXPECT_EQ(notes, 2);  // mass and EA say what was chosen
}

TEST(LineTypes, CoatingAndGrowthAddMassVolumeAndDrag) {
    const Case c = read(source / "tests/common/cases/accepted/families.yml");
    const LineType& t = type(c, "riser");
    const auto disc = [](double d) { return std::numbers::pi / 4 * d * d; };
    const double D = 12.75 * 0.0254, Di = D - 0.04, coated = D + 0.1, grown = coated + 0.05;
    EXPECT_NEAR(t.mass,
                7850 * (disc(D) - disc(Di)) + 900 * (disc(coated) - disc(D)) +
                    1300 * (disc(grown) - disc(coated)) + 800 * disc(Di),
                1e-9);
    EXPECT_NEAR(t.displaced_area, disc(grown), 1e-12);
    EXPECT_NEAR(t.drag_diameter, grown, 1e-12);
    EXPECT_EQ(*t.damping_ratio, 0.02);  // from defaults
}

TEST(TrussSpar, TwelveLinesStandInThreeGroups) {
    const Case c = read(spar);
    ASSERT_EQ(c.lines.size(), 20U);
    const double deg = std::numbers::pi / 180;
    const double expected[] = {-7.5,  -2.5,  2.5,   7.5,   112.5, 117.5,
                               122.5, 127.5, 232.5, 237.5, 242.5, 247.5};
    for (std::size_t i = 0; i < 12; ++i) {
        const Line& l = c.lines[i];
        EXPECT_EQ(l.name, "ml" + std::to_string(i + 1));
        EXPECT_EQ(l.family, "mooring");
        const double a = expected[i] * deg;
        EXPECT_NEAR((l.end_a.position - Vec3(20.5 * cos(a), 20.5 * sin(a), -60)).norm(), 0, 1e-9);
        const LineType& last = c.line_types[static_cast<std::size_t>(l.sections.back().type)];
        const double z = -1500 + resting_height(last, c.environment);
        EXPECT_NEAR((l.end_b.position - Vec3(2068 * cos(a), 2068 * sin(a), z)).norm(), 0, 1e-9);
        EXPECT_EQ(l.end_a.kind, EndKind::platform);
        EXPECT_EQ(l.end_b.kind, EndKind::anchor);
        EXPECT_EQ(l.attachments[0].arc_length, 91.0);
        EXPECT_EQ(l.attachments[1].arc_length, 91.0 + 2286.0);
    }
    EXPECT_EQ(c.lines[16].name, "scr_oil");
    EXPECT_EQ(c.lines[16].family, "scr");
    EXPECT_NEAR(c.lines[16].azimuth, 60 * deg, 1e-15);
}

TEST(TrussSpar, FourTopTensionedRisersHangInTheirTensionersAndSlideThroughSixGuides) {
    const Case c = read(spar);
    const double corners[][2] = {{4.5, 4.5}, {-4.5, 4.5}, {-4.5, -4.5}, {4.5, -4.5}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Line& l = c.lines[12 + i];
        EXPECT_EQ(l.name, "ttr" + std::to_string(i + 1));
        const double x = corners[i][0], y = corners[i][1];
        EXPECT_EQ(l.end_a.kind, EndKind::free);
        EXPECT_EQ(l.end_a.position, Vec3(x, y, 22));
        EXPECT_EQ(l.end_b.position, Vec3(x, y, -1500));
        EXPECT_EQ(l.end_b.joint, Joint::clamped);
        EXPECT_EQ(l.length(), 1522);
        EXPECT_EQ(l.sheltered_above, -70.0);
        EXPECT_EQ(l.target.adjust, StaticTarget::Adjust::section_length);
        EXPECT_EQ(l.target.section, 5);
        ASSERT_EQ(l.constraints.size(), 7U);
        const LineConstraint& tensioner = l.constraints[0];
        EXPECT_EQ(tensioner.type, ConstraintType::tensioner);
        EXPECT_EQ(tensioner.position, Vec3(x, y, 22));
        EXPECT_EQ(tensioner.arc_length, 0.0);
        EXPECT_EQ(tensioner.nominal_tension, 5338e3);
        EXPECT_EQ(tensioner.exponent, 1.1);
        EXPECT_EQ(tensioner.stroke_max, 4.5);
        const double z[] = {-95, -115, -135, -165, -172, -174};
        const char* names[] = {"plate1", "plate2", "plate3", "plate4", "keel.upper", "keel.lower"};
        for (std::size_t k = 0; k < 6; ++k) {
            const LineConstraint& guide = l.constraints[k + 1];
            EXPECT_EQ(guide.type, ConstraintType::guide);
            EXPECT_EQ(guide.name, names[k]);
            EXPECT_EQ(guide.position, Vec3(x, y, z[k]));
            EXPECT_EQ(guide.gap, 0.025);
            EXPECT_FALSE(guide.arc_length);
        }
        const auto name = [&c](int type) {
            return c.line_types.at(static_cast<std::size_t>(type)).name;
        };
        EXPECT_EQ(name(l.sections[1].type) + ">" + name(l.sections[1].type_at_end), "ttr>ttr_keel");
        EXPECT_EQ(name(l.sections[3].type) + ">" + name(l.sections[3].type_at_end), "ttr_keel>ttr");
        EXPECT_EQ(l.sections[4].type_at_end, -1);
    }
    const PipeWall wall = *c.line_types[2].wall;
    EXPECT_EQ(wall.outer_diameter, 0.406);
    EXPECT_NEAR(wall.inner_diameter, 0.356, 1e-15);
    EXPECT_EQ(wall.contents_density, 1025);
    EXPECT_EQ(wall.yield, 448e6);
}

// 10 deg from vertical down, in the plane of the riser's azimuth, along increasing arc length.
TEST(TrussSpar, FlexJointPointsDownAndOut) {
    const Case c = read(spar);
    const Line& l = line(c, "scr_oil");
    const double d = 10 * std::numbers::pi / 180, a = 60 * std::numbers::pi / 180;
    ASSERT_TRUE(l.end_a.direction);
    EXPECT_NEAR((*l.end_a.direction - Vec3(sin(d) * cos(a), sin(d) * sin(a), -cos(d))).norm(), 0,
                1e-15);
    EXPECT_NEAR(l.end_a.rotational_stiffness, 15e3 * 180 / std::numbers::pi, 1e-6);
    EXPECT_EQ(l.end_a.joint, Joint::flex);
}

TEST(TrussSpar, DefaultsFollowFromOtherKeys) {
    const Case c = read(spar);
    const Platform& p = *c.platform;
    EXPECT_FALSE(p.mass);
    EXPECT_FALSE(p.members[0].inertia);
    EXPECT_EQ(p.members[0].displaced_area, 0.0);
    EXPECT_EQ(p.members[1].displaced_area, 7.77);
    EXPECT_EQ(p.plates.size(), 3U);
    EXPECT_EQ(p.plates[2].position.z(), -135.0);
    EXPECT_NEAR(*p.hydrodynamics.added_mass_frequency, 2 * std::numbers::pi / 15.6, 1e-15);
    EXPECT_NEAR(*p.hydrodynamics.slow_cutoff, 2 * std::numbers::pi / 15.6 / 4, 1e-15);
    EXPECT_EQ(p.hydrodynamics.database->path,
              (source / "cases/truss_spar/hydro/truss_spar").string());
    EXPECT_EQ(c.output.interval, c.analysis.dynamics.platform_step);
    const Case changed = read(spar, {{"analysis.dynamics.steps.platform", "1 s"}});
    EXPECT_EQ(changed.output.interval, 1.0);  // the default goes with the step
}

TEST(TrussSpar, ThePapersCaseDiffersInTheSchemeAndTheForceAlone) {
    Case recommended = read(spar);
    const Case paper = read(source / "cases/truss_spar/truss_spar_paper.yml");
    EXPECT_EQ(paper.analysis.dynamics.rod_scheme.type, RodSchemeType::adams_moulton);
    recommended.name = paper.name;
    recommended.title = paper.title;
    recommended.analysis.dynamics.rod_scheme = paper.analysis.dynamics.rod_scheme;
    EXPECT_EQ(paper.analysis.dynamics.force, ForceFit::instantaneous);
    EXPECT_EQ(recommended.analysis.dynamics.force, ForceFit::impulse_matched);
    recommended.analysis.dynamics.force = paper.analysis.dynamics.force;
    EXPECT_TRUE(recommended == paper);
}

TEST(CaseFile, OutputNamesPlacesRangesAndConstraints) {
    const fs::path chain = source / "tests/common/cases/accepted/chain.yml";
    const Case c = read(chain, {{"output.lines",
                                 "[{select: chain, at: [end_b], at_arc: [50 m, 0.1 km], "
                                 "results: [curvature, touchdown, guide.force], "
                                 "range: [effective_tension, seabed_force]}, {at_arc: 7}]"}});
    ASSERT_EQ(c.output.lines.size(), 2U);
    const LineOutput& first = c.output.lines[0];
    EXPECT_FALSE(first.end_a);
    EXPECT_TRUE(first.end_b);
    EXPECT_EQ(first.at_arc, (std::vector<double>{50.0, 100.0}));
    EXPECT_EQ(first.results, (std::vector<std::string>{"curvature", "touchdown", "guide.force"}));
    EXPECT_EQ(first.range, (std::vector<std::string>{"effective_tension", "seabed_force"}));
    EXPECT_EQ(c.output.lines[1].at_arc, std::vector<double>{7.0});
    EXPECT_EQ(c.output.lines[1].results, std::vector<std::string>{"effective_tension"});
    EXPECT_TRUE(c.output.lines[1].range.empty());
}

TEST(CaseFile, ValuesCanBeSet) {
    const Case c = read(spar, {{"environment.waves[0].Hs", "12 m"},
                               {"parameters.heading", "15 deg"},
                               {"output.snapshots", "4 s"},
                               {"environment.seabed", "{depth: 1500, damping: 0}"}});
    EXPECT_EQ(c.environment.waves[0].Hs, 12.0);
    EXPECT_NEAR(c.environment.wind->heading, std::numbers::pi / 12, 1e-15);
    EXPECT_EQ(*c.output.snapshots, 4.0);
    EXPECT_EQ(c.environment.seabed.damping, 0.0);
    EXPECT_THROW(read(spar, {{"environment.waves[3].Hs", "12 m"}}), InputError);
    EXPECT_THROW(read(spar, {{"environment.wave[0].Hs", "12 m"}}), InputError);
    EXPECT_THROW(read(spar, {{"environment..Hs", "12 m"}}), InputError);
}

TEST(CaseFile, ADerivedCaseNeedNotSayItsFormatAgain) {
    const fs::path path = fs::path(testing::TempDir()) / "hawser_derived.yml";
    std::ofstream(path) << "base: " << spar.string() << "\ntitle: derived\n";
    for (const std::string& note : read_case(path).notes)
        EXPECT_EQ(note.find("is not the first key"), std::string::npos) << note;
    std::ofstream(path) << "title: late\nformat: 1\nbase: " << spar.string() << "\n";
    bool told = false;
    for (const std::string& note : read_case(path).notes)
        told = told || note.find("is not the first key") != std::string::npos;
    EXPECT_TRUE(told);
    fs::remove(path);
}

TEST(CaseFile, NullTakesAKeyAway) {
    const Case c = read(spar, {{"environment.wind", "null"}, {"environment.current", "~"}});
    EXPECT_FALSE(c.environment.wind || c.environment.current);
    EXPECT_FALSE(c.environment.waves.empty());
    EXPECT_THROW(read(spar, {{"environment.wnd", "null"}}), InputError);
    EXPECT_THROW(read(spar, {{"environment.waves[0]", "null"}}), InputError);
    EXPECT_THROW(read(spar, {{"environment.seabed.depth", "null"}}), InputError);  // required
    const Case calm = read(source / "tests/common/cases/calm_spar.yml");
    EXPECT_TRUE(calm.environment.waves.empty());
    EXPECT_TRUE(calm.environment.wind.has_value());
}

TEST(CaseFile, UnitsOfAFileScaleItsPlainNumbers) {
    const fs::path folder = source / "tests/common/cases/accepted";
    Case si = read(folder / "chain.yml");
    const Case kn = read(folder / "si_kn.yml");
    EXPECT_EQ(kn.lines[0].length(), 200.0);
    EXPECT_EQ(kn.environment.seabed.normal_stiffness, 1e5);
    EXPECT_NEAR(kn.line_types[0].mass, si.line_types[0].mass, 1e-9);
    EXPECT_NEAR(kn.line_types[0].EA, si.line_types[0].EA, 1e-3);
    EXPECT_NEAR(kn.line_types[0].displaced_area, si.line_types[0].displaced_area, 1e-12);
}

TEST(CaseFile, FamiliesExpand) {
    const Case c = read(source / "tests/common/cases/accepted/families.yml");
    std::vector<std::string> names;
    for (const Line& l : c.lines) names.push_back(l.name + ":" + l.family);
    EXPECT_EQ(names, (std::vector<std::string>{"m1:mooring", "m2:mooring", "m3:mooring",
                                               "m4:mooring", "t1:tethers", "t2:tethers",
                                               "r1:risers", "r2:risers", "s:spare"}));
    const Line& t2 = line(c, "t2");
    EXPECT_EQ(t2.end_a.position, Vec3(-4, 4, 5));
    EXPECT_EQ(t2.end_b.position, Vec3(-4, 4, -295));
    EXPECT_EQ(t2.end_b.kind, EndKind::fixed);
    EXPECT_EQ(*t2.end_a.direction, Vec3(0, 0, -1));
    EXPECT_EQ(t2.sections[0].elements, 50);             // without a count: 50 elements a line
    EXPECT_EQ(line(c, "m3").sections[0].elements, 20);  // 500 m in elements of 25 m
    EXPECT_FALSE(line(c, "r1").end_a.direction);        // static
    EXPECT_EQ(*line(c, "r1").time_step, 0.01);
}

TEST(CaseFile, MissingFileIsAnInputOutputFailure) {
    try {
        read(source / "cases/nowhere.yml");
        FAIL();
    } catch (const RunError& e) {
        EXPECT_EQ(e.code(), ExitCode::io);
    }
}

}  // namespace
}  // namespace hawser::io
