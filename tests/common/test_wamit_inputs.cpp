// Panels of a .gdf and the control of forces .frc against closed forms, and against the results and
// the case.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "hull_panels.hpp"
#include "io/hydro_file.hpp"

namespace hawser::io {
namespace {

using testing::HasSubstr;
using Verdict = HydroCheck::Verdict;
constexpr double rho = 1025.0, g = 9.80665;
// A box of 8 x 6 m, 3 m deep: V, z_B, waterplane and its moments are exact.
constexpr double l = 8, b = 6, draft = 3, V = l * b * draft, z_B = -draft / 2;

using Corner = std::array<double, 3>;

/// The lines of a panel, its corners anticlockwise from the water.
std::string panel(const std::array<Corner, 4>& corners, double unit) {
    std::string text;
    for (const Corner& c : corners)
        text += fmt::format("{:.8f} {:.8f} {:.8f}\n", c[0] / unit, c[1] / unit, c[2] / unit);
    return text;
}

/// A quarter of the box (x > 0, y > 0): bottom, end and side.
std::string quarter(double lift = 0.0, double unit = 1.0, bool inward = false) {
    const double x = l / 2, y = b / 2, z = lift - draft, w = lift;
    std::array<std::array<Corner, 4>, 3> faces{
        {{{{0, 0, z}, {0, y, z}, {x, y, z}, {x, 0, z}}},    // seen from below
         {{{x, 0, z}, {x, y, z}, {x, y, w}, {x, 0, w}}},    // from ahead
         {{{x, y, z}, {0, y, z}, {0, y, w}, {x, y, w}}}}};  // from the side
    std::string text;
    for (auto& face : faces) {
        if (inward) std::swap(face[1], face[3]);
        text += panel(face, unit);
    }
    return text;
}

std::string gdf(double ulen, const std::string& panels, int count = 3, double gravity = g) {
    return fmt::format("box\n{} {} ULEN GRAV\n1 1 ISX ISY\n{} NPAN\n{}", ulen, gravity, count,
                       panels);
}

/// A set of the box as far as hydrostatics go, with the inputs beside it.
struct Box {
    double z_G = 0.0;  ///< whose weight the .hst holds
    std::string geometry, control;
    HydroDatabase database;

    Box() {
        database.rho = rho;
        database.displaced_volume = V;
        database.centre_of_buoyancy = Vec3(0, 0, z_B);
    }

    CheckedHydro read() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        const std::filesystem::path folder =
            std::filesystem::path(testing::TempDir()) / "hawser_inputs" / info->name();
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        database.path = (folder / "box").string();
        std::ofstream(database.path + ".1") << "6.0 3 3 0.1E+03 0.2E+02\n";
        std::ofstream(database.path + ".3") << "6.0 0 3 0.1E+02 0 0.1E+02 0\n";
        const double roll = l * b * b * b / 12 + V * (z_B - z_G),
                     pitch = b * l * l * l / 12 + V * (z_B - z_G);
        std::ofstream(database.path + ".hst")
            << fmt::format("3 3 {:.8E}\n4 4 {:.8E}\n5 5 {:.8E}\n", l * b, roll, pitch);
        if (!geometry.empty()) std::ofstream(database.path + ".gdf") << geometry;
        if (!control.empty()) std::ofstream(database.path + ".frc") << control;
        return read_checked_hydro(database, Water{rho, g}, 100.0);
    }

    /// What stands beside the name of a check, "" if there is none.
    static std::string verdict(const CheckedHydro& found, const std::string& what) {
        for (const PlacedCheck& one : found.checks)
            if (one.check.what == what &&
                (one.file.ends_with(".gdf") || one.file.ends_with(".frc")))
                return (one.check.verdict == Verdict::fine       ? "fine: "
                        : one.check.verdict == Verdict::remark   ? "remark: "
                        : one.check.verdict == Verdict::doubtful ? "doubtful: "
                                                                 : "wrong: ") +
                       fmt::format("{}: {}", one.line, one.check.sentence);
        return "";
    }
};

TEST(PanelHydrostatics, OfABoxAreExactFromAQuarterOfIt) {
    std::vector<Panel> panels;
    for (const auto& face :
         {Panel{Vec3(0, 0, -draft), Vec3(0, b / 2, -draft), Vec3(l / 2, b / 2, -draft),
                Vec3(l / 2, 0, -draft)},
          Panel{Vec3(l / 2, 0, -draft), Vec3(l / 2, b / 2, -draft), Vec3(l / 2, b / 2, 0),
                Vec3(l / 2, 0, 0)},
          Panel{Vec3(l / 2, b / 2, -draft), Vec3(0, b / 2, -draft), Vec3(0, b / 2, 0),
                Vec3(l / 2, b / 2, 0)},
          // a lid inside, against irregular frequencies
          Panel{Vec3(0, 0, 0), Vec3(l / 2, 0, 0), Vec3(l / 2, b / 2, 0), Vec3(0, b / 2, 0)}})
        panels.push_back(face);
    const PanelHydrostatics box = panel_hydrostatics(panels, true, true);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.volumes[i], V, 1e-10);
    EXPECT_NEAR((box.centre_of_buoyancy - Vec3(0, 0, z_B)).norm(), 0, 1e-12);
    EXPECT_NEAR(box.area(), l * b, 1e-12);
    EXPECT_NEAR(box.waterplane(1, 1), l * b * b * b / 12, 1e-10);
    EXPECT_NEAR(box.waterplane(2, 2), b * l * l * l / 12, 1e-10);
    EXPECT_NEAR(box.waterplane(0, 1) + box.waterplane(0, 2) + box.waterplane(1, 2), 0, 1e-10);
    EXPECT_EQ(box.lids, 1);
    EXPECT_DOUBLE_EQ(box.draft, draft);
}

/// Wedge of triangles leaning in every direction, away from the origin: nothing is symmetric.
TEST(PanelHydrostatics, OfATetrahedronUnderWaterAreExactWithoutSymmetry) {
    const Vec3 p(3, -2, -5), e1(2, 0, 0.5), e2(-0.5, 3, 0), e3(0.3, 0.2, -4);
    const Vec3 a = p, q = p + e1, r = p + e2, s = p + e3;
    // Outward: the fourth corner lies behind each.
    std::vector<Panel> panels;
    for (const auto& [x, y, z, behind] : {std::array{a, q, r, s}, std::array{a, q, s, r},
                                          std::array{a, r, s, q}, std::array{q, r, s, a}}) {
        const bool turn = (y - x).cross(z - x).dot(behind - x) > 0;
        panels.push_back(turn ? Panel{x, z, y, y} : Panel{x, y, z, z});
    }
    const PanelHydrostatics body = panel_hydrostatics(panels, false, false);
    const double volume = std::abs(e1.cross(e2).dot(e3)) / 6;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(body.volumes[i], volume, 1e-12 * volume + 1e-12);
    const Vec3 centre = (a + q + r + s) / 4;
    EXPECT_NEAR(body.centre_of_buoyancy.x(), centre.x(), 1e-12);
    EXPECT_NEAR(body.centre_of_buoyancy.y(), centre.y(), 1e-12);
    EXPECT_NEAR(body.centre_of_buoyancy.z() + body.waterline, centre.z(), 1e-12);
    EXPECT_NEAR(body.area(), 0, 1e-12);
}

TEST(WamitInputs, PanelsOfTheHullOfTheSetAreFine) {
    for (const bool feet : {false, true}) {
        Box box;
        box.database.ulen = feet ? 0.3048 : 1.0;
        // The numeric files are written for ulen 1; what is looked at is ULEN, V, z_B.
        box.geometry = gdf(1, quarter(0, feet ? 0.3048 : 1.0), 3, feet ? 32.174 : g);
        const CheckedHydro found = box.read();
        EXPECT_THAT(Box::verdict(found, "ULEN"), HasSubstr("fine: 2: ")) << feet;
        EXPECT_THAT(Box::verdict(found, "volume"),
                    HasSubstr("fine: 4: volume of the panels is 144"));
        EXPECT_THAT(Box::verdict(found, "centre of buoyancy z"), HasSubstr("fine"));
        if (feet) continue;
        EXPECT_THAT(Box::verdict(found, "waterplane"), HasSubstr("fine"));
        EXPECT_THAT(Box::verdict(found, "C44"), HasSubstr("fine"));
        EXPECT_THAT(Box::verdict(found, "C55"), HasSubstr("fine"));
        EXPECT_TRUE(found.files.back().ends_with("box.gdf"));
    }
}

TEST(WamitInputs, UlenOfThePanelsIsThatOfTheSet) {
    Box box;
    box.geometry = gdf(10, quarter());
    const std::string said = Box::verdict(box.read(), "ULEN");
    EXPECT_THAT(said, HasSubstr("wrong: 2: ULEN is 10 m"));
    EXPECT_THAT(said, HasSubstr("expected ulen: 10 m, got 1 m"));
}

TEST(WamitInputs, AnotherHullIsWrong) {
    Box box;
    box.geometry = gdf(1, quarter());
    box.database.displaced_volume = 2 * V;
    EXPECT_THAT(Box::verdict(box.read(), "volume"), HasSubstr("wrong: 4"));
    box.database.displaced_volume = V;
    box.database.centre_of_buoyancy = Vec3(0, 0, -draft);
    EXPECT_THAT(Box::verdict(box.read(), "centre of buoyancy z"), HasSubstr("wrong: 4"));
}

TEST(WamitInputs, PanelsThatFaceInwardOrLeaveHolesAreDoubtful) {
    Box box;
    box.geometry = gdf(1, quarter(0, 1, true));
    EXPECT_THAT(Box::verdict(box.read(), "panels"), HasSubstr("they face into the hull"));
    const std::string all = quarter();
    box.geometry = gdf(1, all.substr(0, all.size() * 2 / 3), 2);
    EXPECT_THAT(Box::verdict(box.read(), "panels"), HasSubstr("doubtful: 4: "));
    box.geometry = gdf(1, all, 4);
    EXPECT_THAT(Box::verdict(box.read(), "panels"), HasSubstr("panel 4 has 0"));
    box.geometry = "box\n1 9.8\n1 1\n7 1\n0 0\n";
    EXPECT_THAT(Box::verdict(box.read(), "panels"), HasSubstr("higher order"));
}

TEST(WamitInputs, PanelsAboutAnotherHeightAreCompared) {
    Box box;  // origin 3 m below the water: the axes of the panels stand at the keel
    box.geometry = gdf(1, quarter(draft));
    const CheckedHydro found = box.read();
    EXPECT_THAT(Box::verdict(found, "panels"),
                HasSubstr("remark: 4: the waterline of the panels is at 3 m"));
    EXPECT_THAT(Box::verdict(found, "volume"), HasSubstr("fine"));
    EXPECT_THAT(Box::verdict(found, "centre of buoyancy z"), HasSubstr("fine"));
}

TEST(WamitInputs, AWeightInTheHydrostaticFileThatTheCaseDoesNotKnowIsWrong) {
    Box box;
    box.geometry = gdf(1, quarter());
    box.z_G = -2.0;
    EXPECT_THAT(Box::verdict(box.read(), "C44"), HasSubstr("wrong: 4: C44 of the .hst"));
    box.database.includes_weight = true;
    box.database.included_mass = rho * V;
    box.database.included_z = -2.0;
    EXPECT_THAT(Box::verdict(box.read(), "C44"), HasSubstr("fine"));
}

TEST(WamitInputs, BothFormsOfTheControlTellTheWeight) {
    const std::string options = "title\n1 0 1 0 0 0 0 0 0 IOPTN\n";
    const std::string radii = "3 0 0\n0 3 0\n0 0 3\n0 NBETAH\n0\n";
    const std::string matrix = fmt::format(
        "{0} 0 0 0 0 0\n0 {0} 0 0 0 0\n0 0 {0} 0 0 0\n0 0 0 1 0 0\n0 0 0 0 1 0\n0 0 0 0 0 1\n",
        rho * V);
    for (const std::string& control :
         {options + "-2.0 VCG\n" + radii,
          options + "1025. RHO\n0. 0. -2.0 XCG\n1 IMASS\n" + matrix + "0\n0\n0\n0\n"}) {
        Box box;
        box.z_G = -2.0;
        box.control = control;
        EXPECT_THAT(Box::verdict(box.read(), "weight"),
                    HasSubstr("put the centre of gravity at -2 m"));
        box.database.includes_weight = true;
        box.database.included_mass = rho * V;
        box.database.included_z = -2.0;
        EXPECT_EQ(Box::verdict(box.read(), "weight"), "");
        box.database.included_z = -2.5;
        EXPECT_THAT(Box::verdict(box.read(), "weight"), HasSubstr("doubtful"));
    }
}

TEST(WamitInputs, AFileThatTheControlDidNotAskForIsOfAnotherRun) {
    Box box;
    box.control = "title\n1 0 0 0 0 0 0 0 0\n0.0\n1 0 0\n0 1 0\n0 0 1\n0\n0\n";
    EXPECT_THAT(Box::verdict(box.read(), "IOPTN"),
                HasSubstr("doubtful: 2: did not ask for a .3 (IOPTN(3) is 0), but box.3 is there"));
    box.control = "title\n1 0 1 0 0 0 0 0 0\n0.0\n1 0 0\n0 1 0\n0 0 1\n0\n0\n";
    EXPECT_EQ(Box::verdict(box.read(), "IOPTN"), "");
}

TEST(WamitInputs, ADensityOfTheControlThatIsNotTheStatedOneIsDoubtful) {
    Box box;
    box.control = "title\n1 0 1 0\n1000. RHO\n0. 0. 0. XCG\n0 IMASS\n0\n0\n0\n0\n";
    EXPECT_THAT(Box::verdict(box.read(), "RHO"), HasSubstr("doubtful: 3: RHO is 1000"));
}

TEST(WamitInputs, PanelsTellTheVolumeWhereNothingElseDoes) {
    Box box;
    box.geometry = gdf(1, quarter());
    box.database.displaced_volume.reset();
    box.database.centre_of_buoyancy.reset();
    const CheckedHydro found = box.read();
    EXPECT_NEAR(found.data.displaced_volume, V, 1e-6);
    EXPECT_NEAR(found.data.centre_of_buoyancy.z(), z_B, 1e-9);
}

}  // namespace
}  // namespace hawser::io
