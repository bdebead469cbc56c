// The reader of WAMIT numeric files, on a floating hemisphere written by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "hydro_relations.hpp"
#include "io/hydro_file.hpp"

namespace hawser::io {
namespace {

using testing::HasSubstr;
constexpr double rho = 1025.0, g = 9.80665, radius = 2.0, omega = 1.5;
const double period = 2 * M_PI / omega;

/// Files of a hemisphere of radius 2 m: invented coefficients of the right size at one frequency,
/// exact hydrostatics (C44 = 0: the metacentre is at O).
struct Hemisphere {
    double ulen = 1.0, density = rho;
    std::vector<double> headings{0, 90, 180, 270};
    std::map<std::string, std::string> text;  ///< by extension
    HydroDatabase database;

    static constexpr double A33 = 9.0e3, B33 = 2.0e3, A15 = -3.0e3, X1 = 4.0e4, X5 = 1.5e4;
    static constexpr double D1 = 7.0e3, D6 = 2.5e2;

    explicit Hemisphere(double unit = 1.0, std::vector<double> at = {0, 90, 180, 270})
        : ulen(unit), headings(std::move(at)) {
        const auto L = [&](int n) { return std::pow(ulen, n); };
        text[".1"] = row({-1, 3, 3}, {0.8 * A33 / (rho * L(3))}) +
                     row({0, 3, 3}, {0.7 * A33 / (rho * L(3))}) +
                     row({period, 3, 3}, {A33 / (rho * L(3)), B33 / (rho * omega * L(3))}) +
                     row({period, 1, 5}, {A15 / (rho * L(4)), 0.0});
        for (const double b : headings) {
            const double c = std::cos(b * M_PI / 180), s = std::sin(b * M_PI / 180);
            const auto x = [&](int mode, double re, double im, int n) {
                const double scale = rho * g * L(n);
                text[".3"] += row({period, b, double(mode)},
                                  {std::hypot(re, im) / scale, std::atan2(im, re) * 180 / M_PI,
                                   re / scale, im / scale});
            };
            x(1, 0, X1 * c, 2);
            x(2, 0, X1 * s, 2);
            x(3, 2e4, 1e3, 2);
            x(5, X5 * c, 0, 3);
            x(4, -X5 * s, 0, 3);
            const auto d = [&](int mode, double value, int n) {
                const double v = value / (rho * g * L(n));
                text[".8"] += row({period, b, b, double(mode)}, {std::abs(v), 0, v, 0});
            };
            d(1, D1 * c, 1);
            d(2, D1 * s, 1);
            d(6, D6 * s, 2);
        }
        text[".hst"] = row({3, 3}, {M_PI * radius * radius / L(2)});
    }

    static std::string row(const std::vector<double>& a, const std::vector<double>& b) {
        std::string line;
        char word[40];
        for (const double x : a) std::snprintf(word, sizeof word, " %.9g", x), line += word;
        for (const double x : b) std::snprintf(word, sizeof word, " %.12E", x), line += word;
        return line + "\n";
    }

    HydroData read() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        const std::filesystem::path folder =
            std::filesystem::path(testing::TempDir()) / "hawser_hydro" / info->name();
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        database.path = (folder / "ball").string();
        database.ulen = ulen;
        database.rho = density;
        database.displaced_volume = 2.0 / 3 * M_PI * std::pow(radius, 3);
        if (!database.centre_of_buoyancy)
            database.centre_of_buoyancy = Vec3(0, 0, -3.0 / 8 * radius);
        for (const auto& [extension, content] : text)
            std::ofstream(database.path + extension) << content;
        return read_hydro(database, Water{rho, g});
    }

    std::string complaint() {
        try {
            (void)read();
        } catch (const HydroFileError& e) {
            EXPECT_EQ(e.code(), ExitCode::input);
            return e.what();
        }
        return "no complaint";
    }
};

/// Value of a table at a heading in degrees, at its only frequency.
template <class Value>
Value at(const WaveTable<Value>& table, double degrees) {
    for (const auto& h : table.headings)
        if (std::abs(std::remainder(h.heading - degrees * M_PI / 180, 2 * M_PI)) < 1e-9)
            return h.values.at(0);
    ADD_FAILURE() << "no heading of " << degrees << " deg";
    return Value::Zero();
}

TEST(HydroFile, GivesTheSameSINumbersForAnyLengthUnit) {
    for (const double unit : {1.0, 2.0}) {
        Hemisphere ball(unit);
        const HydroData d = ball.read();
        ASSERT_EQ(d.frequencies.size(), 1u);
        EXPECT_NEAR(d.frequencies[0], omega, 1e-8);  // nine digits of the period
        EXPECT_NEAR(d.added_mass[0](2, 2), ball.A33, 1e-4);
        EXPECT_NEAR(d.damping[0](2, 2), ball.B33, 1e-4);
        EXPECT_NEAR(d.added_mass[0](0, 4), ball.A15, 1e-4);
        EXPECT_NEAR((*d.added_mass_0)(2, 2), 0.8 * ball.A33, 1e-4);
        EXPECT_NEAR((*d.added_mass_inf)(2, 2), 0.7 * ball.A33, 1e-4);
        EXPECT_NEAR(at(d.excitation, 0)[0].imag(), ball.X1, 1e-4);
        EXPECT_NEAR(at(d.excitation, 90)[3].real(), -ball.X5, 1e-4);
        EXPECT_NEAR(at(d.mean_drift, 0)[0], ball.D1, 1e-4);
        EXPECT_NEAR(at(d.mean_drift, 90)[5], ball.D6, 1e-4);
        EXPECT_TRUE(d.drift_is_horizontal);
        EXPECT_NEAR(d.waterplane_stiffness(0, 0), rho * g * M_PI * 4, 1e-3);
        // K:7: C44 = 0 less rho g V z_B is the waterplane's pi/4 r^4.
        EXPECT_NEAR(d.waterplane_stiffness(1, 1), rho * g * M_PI / 4 * 16, 1e-3);
    }
}

TEST(HydroFile, SizeOfAHullWithoutAVolumeIsTheDiscOfItsWaterplane) {
    HydroData d;
    d.density = rho, d.gravity = g;
    EXPECT_EQ(hull_size(d), 0.0);
    d.buoyancy_stiffness = Mat6::Zero();
    (*d.buoyancy_stiffness)(2, 2) = rho * g * M_PI * 400;
    EXPECT_NEAR(hull_size(d), 40.0, 1e-10);
}

TEST(HydroFile, HeaderLineIsSkippedOrAbsent) {
    Hemisphere ball;
    const HydroData bare = ball.read();
    for (auto& [extension, content] : ball.text)
        content = "WAMIT Numeric Output -- Filename  ball 2026-01-01\n" + content;
    const HydroData headed = ball.read();
    EXPECT_EQ(bare.added_mass[0], headed.added_mass[0]);
    EXPECT_EQ(at(bare.excitation, 90), at(headed.excitation, 90));
    EXPECT_EQ(bare.waterplane_stiffness, headed.waterplane_stiffness);
}

TEST(HydroFile, LimitsMayStandFirstLastOrNowhere) {
    Hemisphere ball;
    std::string& text = ball.text[".1"];
    const std::size_t limits = text.find('\n', text.find('\n') + 1) + 1;
    const std::string first = text, rest = text.substr(limits);
    text = rest + first.substr(0, limits);
    const HydroData last = ball.read();
    ASSERT_TRUE(last.added_mass_0 && last.added_mass_inf);
    EXPECT_NEAR((*last.added_mass_0)(2, 2), 0.8 * ball.A33, 1e-4);
    EXPECT_EQ(last.frequencies.size(), 1u);
    text = rest;
    const HydroData none = ball.read();
    EXPECT_FALSE(none.added_mass_0 || none.added_mass_inf);
    EXPECT_EQ(none.added_mass[0], last.added_mass[0]);
}

TEST(HydroFile, UpperTriangleStandsForBothHalves) {
    Hemisphere ball;
    EXPECT_NEAR(ball.read().added_mass[0](4, 0), ball.A15, 1e-4);  // only 1 5 is written
}

TEST(HydroFile, HeadingsOfAnyRangeMakeTheSameCircle) {
    const HydroData turn = Hemisphere(1, {0, 45, 90, 135, 180, 225, 270, 315, 360}).read();
    const HydroData signs = Hemisphere(1, {-180, -135, -90, -45, 0, 45, 90, 135, 180}).read();
    Hemisphere quarter(1, {0, 45, 90});
    quarter.database.symmetry = {"xz", "yz"};
    const HydroData mirrored = quarter.read();
    const HydroData half = Hemisphere(1, {0, 45, 90, 135, 180}).read();  // shows its symmetry
    for (const HydroData* d : {&turn, &signs, &mirrored, &half}) {
        EXPECT_TRUE(d->excitation.full_circle);
        EXPECT_TRUE(d->mean_drift.full_circle);
        ASSERT_EQ(d->excitation.headings.size(), 8u);
        for (int i = 0; i < 8; ++i) {
            EXPECT_LT((at(d->excitation, 45 * i) - at(turn.excitation, 45 * i)).norm(), 1e-3)
                << 45 * i;
            const Vec6 D = at(d->mean_drift, 45 * i), expected = at(turn.mean_drift, 45 * i);
            EXPECT_LT((D - expected).head<3>().norm(), 1e-3) << 45 * i;
        }
    }
    EXPECT_EQ(turn.notes.size() + 1, half.notes.size());  // taken without being told: said
    EXPECT_THAT(half.notes, testing::Contains(HasSubstr("mirrored")));
    const HydroData open = Hemisphere(1, {0, 45, 90}).read();
    EXPECT_FALSE(open.excitation.full_circle);
    EXPECT_EQ(open.excitation.headings.size(), 3u);
}

TEST(HydroFile, RangeAcrossZeroIsNotCut) {
    const HydroData d = Hemisphere(1, {-45, 0, 45}).read();
    ASSERT_EQ(d.excitation.headings.size(), 3u);
    EXPECT_NEAR(d.excitation.headings.front().heading, -M_PI / 4, 1e-12);
    EXPECT_NEAR(d.excitation.headings.back().heading, M_PI / 4, 1e-12);
}

TEST(HydroFile, NamesThePeriodThatHasNoAddedMass) {
    Hemisphere ball;
    ball.text[".3"] +=
        " 7.5 0 1 1 0 1 0\n 7.5 90 1 1 0 1 0\n 7.5 180 1 1 0 1 0\n 7.5 270 1 1 0 1 0\n";
    EXPECT_THAT(ball.complaint(), HasSubstr("ball.3:21: error: period 7.5 s has excitation but no "
                                            "added mass and damping in ball.1"));
}

TEST(HydroFile, ReportsEveryProblemWithFileAndLine) {
    Hemisphere ball;
    ball.text[".1"] += "4.0 1 1 0.5\n4.0 7 7 1.0 1.0\n";
    ball.text[".3"] += "4.18879 0 1 oops\n";
    ball.text[".8"] += "4.18879020 0 0 1 1.0\n";
    ball.text.erase(".hst");
    const std::string all = ball.complaint();
    EXPECT_THAT(all, HasSubstr("ball.1:5: error: expected 5 numbers, PER I J A B; got 4"));
    EXPECT_THAT(all, HasSubstr("ball.1:6: error: mode 7 belongs to a second body"));
    EXPECT_THAT(all, HasSubstr("ball.3:21: error: expected a number; got \"oops\""));
    EXPECT_THAT(all, HasSubstr("ball.8:13: error: expected 8 numbers; got 5"));
    EXPECT_THAT(all, HasSubstr("ball.hst: error: cannot be read"));
}

TEST(HydroFile, HeadingMissingAtOnePeriodIsAProblem) {
    Hemisphere ball;
    ball.text[".1"] += "6.0 3 3 1.0 0.1\n";
    for (const char* b : {"0", "90", "180"})
        ball.text[".3"] += std::string("6.0 ") + b + " 3 1 0 1 0\n";
    EXPECT_THAT(ball.complaint(), HasSubstr("no rows for period 6 s and heading 270 deg"));
}

TEST(HydroFile, WeightInTheFileIsTakenOut) {
    Hemisphere ball;
    const double mass = 5000, z_G = -0.5, weight = -mass * g * z_G / (rho * g);
    ball.text[".hst"] += Hemisphere::row({4, 4}, {weight}) + Hemisphere::row({5, 5}, {weight});
    ball.database.includes_weight = true;
    ball.database.included_mass = mass;
    ball.database.included_z = z_G;
    EXPECT_NEAR(ball.read().waterplane_stiffness(2, 2), rho * g * M_PI / 4 * 16, 1e-3);
    ball.text[".hst"] = "3 3 12.566\n4 4 -1.0\n5 5 -1.0\n";
    EXPECT_THAT(ball.complaint(), HasSubstr("proves that the file does not contain the weight"));
}

TEST(HydroFile, WrongLengthUnitBreaksTheWaterplane) {  // the disc has the least second moment
    Hemisphere ball;
    ball.ulen = 1.5;  // files were written for 1
    EXPECT_THAT(ball.complaint(), HasSubstr("Check ulen"));
}

TEST(HydroFile, DensityMustBeThatOfWater) {
    Hemisphere ball;
    ball.density = 1.025;
    EXPECT_THAT(ball.complaint(), HasSubstr("expected the density of water, 900 to 1100 kg/m3"));
    ball.density = 1000;  // good, but not the case's 1025: said once, of the key
    for (const HydroDoubt& doubt : ball.read().doubts)
        EXPECT_THAT(doubt.sentence, testing::Not(HasSubstr("made dimensional")));
}

TEST(HydroFile, DriftFallsBackToPressureThenControlSurface) {
    Hemisphere ball;
    ball.text[".9"] = ball.text[".8"];
    ball.text.erase(".8");
    const HydroData d = ball.read();
    EXPECT_FALSE(d.drift_is_horizontal);
    EXPECT_NEAR(at(d.mean_drift, 0)[0], ball.D1, 1e-4);
    ball.text.erase(".9");
    EXPECT_TRUE(ball.read().mean_drift.empty());
}

TEST(HydroFile, MomentsMoveToTheReferencePoint) {
    Hemisphere ball;
    const HydroData at_origin = ball.read();
    ball.database.reference_point = {0, 0, -3};  // the files' origin lies 3 m below O
    ball.database.centre_of_buoyancy = Vec3{0, 0, -3 - 3.0 / 8 * radius};
    const HydroData d = ball.read();
    // M_O = M_P + r x F: pitch gains z F_x, and A15 about O gains z A11 (zero here).
    EXPECT_LT(std::abs(at(d.excitation, 0)[4] - at(at_origin.excitation, 0)[4] -
                       -3.0 * at(at_origin.excitation, 0)[0]),
              1e-4);
    EXPECT_NEAR(d.added_mass[0](2, 2), ball.A33, 1e-4);
    EXPECT_NEAR(d.added_mass[0](4, 4), 2 * -3 * ball.A15, 1e-4);
    EXPECT_NEAR(d.waterplane_stiffness(1, 1), at_origin.waterplane_stiffness(1, 1), 1e-3);
}

}  // namespace
}  // namespace hawser::io
