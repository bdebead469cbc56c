// A case with full quadratic transfer functions against what the functions hold: problems with
// their keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/hydro_of_case.hpp"

namespace hawser {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double degree = M_PI / 180;

Case case_with_qtf() {
    Case c;
    c.environment.seabed.depth = 500;
    c.environment.waves = {{.type = WaveType::jonswap, .Hs = 6, .Tp = 10, .gamma = 3.3, .seed = 1}};
    c.platform.emplace().hydrodynamics.drift = Drift::full_qtf;
    return c;
}

Qtf qtf(double from, double to) {
    Qtf q;
    for (int i = 0; i < 20; ++i) q.frequencies.push_back(from + (to - from) * i / 19);
    q.pairs.push_back({0, 0, std::vector<CVec6>(400, CVec6::Ones()), std::vector<char>(400, 1)});
    return q;
}

HydroData data_with_qtf(double from = 0.2, double to = 3.2) {
    HydroData data;
    data.depth = 500;
    data.frequencies = {from, to};
    data.excitation.frequencies = {0.1, 3.5};
    data.excitation.full_circle = true;
    for (const double b : {0.0, 90.0, 180.0, 270.0})
        data.excitation.headings.push_back({b * degree, {CVec6::Ones(), CVec6::Ones()}});
    data.difference = data.sum = qtf(from, to);
    return data;
}

/// "key: message" of every problem.
std::vector<std::string> said(const Case& c, const HydroData& data) {
    Problems problems;
    check_coverage(c, *c.platform, data, problems);
    std::vector<std::string> all;
    for (const Problem& p : problems)
        all.push_back((p.severity == Severity::error     ? "error: "
                       : p.severity == Severity::warning ? "warning: "
                                                         : "note: ") +
                      p.path + ": " + p.message);
    return all;
}

TEST(FullQtfOfACase, IsNothingToSpeakOfWhereAllIsThere) {
    EXPECT_THAT(said(case_with_qtf(), data_with_qtf()), IsEmpty());
}

TEST(FullQtfOfACase, NeedsADifferenceQtfAndDoesWithoutSums) {
    HydroData data = data_with_qtf();
    data.sum = {};
    EXPECT_THAT(said(case_with_qtf(), data),
                ElementsAre("note: platform.hydrodynamics.drift: no sum-frequency QTF in the "
                            "database: difference frequencies alone"));
    data.difference = {};
    EXPECT_THAT(said(case_with_qtf(), data),
                ElementsAre(HasSubstr("error: platform.hydrodynamics.drift: full_qtf: the database "
                                      "holds no difference-frequency QTF")));
}

TEST(FullQtfOfACase, CoversTheFrequenciesOfTheWaves) {
    EXPECT_THAT(said(case_with_qtf(), data_with_qtf(0.6, 0.9)),
                ElementsAre(HasSubstr("frequencies of the database's difference QTF, 0.6 to 0.9"),
                            HasSubstr("frequencies of the database's sum QTF, 0.6 to 0.9")));
}

TEST(FullQtfOfACase, CoversTheHeadingsOfTheWaves) {
    Case c = case_with_qtf();
    c.environment.waves[0].heading = 4 * degree;  // one heading serves a little to either side
    EXPECT_THAT(said(c, data_with_qtf()), IsEmpty());
    c.environment.waves[0].heading = 6 * degree;
    EXPECT_THAT(said(c, data_with_qtf()),
                ElementsAre(HasSubstr("error: environment.waves[0].heading: waves meet the "
                                      "platform at a heading of 6 deg"),
                            HasSubstr("sum QTF")));
}

TEST(FullQtfOfACase, TellsWhatPairsAreMissing) {
    HydroData data = data_with_qtf();
    for (int m = 0; m < 20; ++m)
        for (int n = 0; n < 20; ++n)  // a band of differences, as files often have
            if (std::abs(m - n) > 1)
                data.difference.pairs[0].given[static_cast<std::size_t>(m * 20 + n)] = 0;
    EXPECT_THAT(said(case_with_qtf(), data),
                ElementsAre(HasSubstr("warning: platform.hydrodynamics.drift: the database's "
                                      "difference QTF lacks pairs of frequencies that carry")));
    data.difference.pairs[0].given[3 * 20 + 3] = 0;
    EXPECT_THAT(said(case_with_qtf(), data),
                ElementsAre(HasSubstr("error: platform.hydrodynamics.drift: the database's "
                                      "difference QTF has no value on its diagonal at 0.6737")));
}

TEST(FullQtfOfACase, SaysThatCrossedSeasTakeTheMeanOfEqualHeadings) {
    Case c = case_with_qtf();
    c.environment.waves.push_back(c.environment.waves[0]);
    c.environment.waves[1].heading = 90 * degree;
    HydroData data = data_with_qtf();
    for (Qtf* q : {&data.difference, &data.sum}) {
        q->pairs.push_back(q->pairs[0]);
        q->pairs[1].heading_1 = q->pairs[1].heading_2 = 90 * degree;
    }
    EXPECT_THAT(said(c, data),
                ElementsAre(HasSubstr("note: platform.hydrodynamics.drift: the difference QTF "
                                      "lacks pairs of unequal headings"),
                            HasSubstr("the sum QTF")));
}

/// A cylinder 40 m across and 70 m deep: V and z_B in the data.
HydroData cylinder() {
    HydroData data;
    data.density = 1025, data.gravity = 9.80665;
    data.displaced_volume = M_PI * 400 * 70;
    data.centre_of_buoyancy = Vec3(0, 0, -35);
    data.waterplane_stiffness(0, 0) = data.density * data.gravity * M_PI * 400;
    return data;
}

std::vector<std::string> said_of_size(double draft, double radius) {
    Case c;
    c.platform.emplace().draft = draft;
    c.platform->radii_of_gyration = Vec3(25, radius, 14);
    const HydroData data = cylinder();
    Problems problems;
    check_size(c, *c.platform, &data, problems);
    std::vector<std::string> all;
    for (const Problem& p : problems)
        all.push_back((p.severity == Severity::error ? "error: " : "warning: ") + p.path + ": " +
                      p.message);
    return all;
}

TEST(SizeOfAHull, HasItsCentreOfBuoyancyBetweenKeelAndWaterline) {
    EXPECT_THAT(said_of_size(70, 25), IsEmpty());
    EXPECT_THAT(said_of_size(35, 25),
                ElementsAre(HasSubstr("error: platform.draft: the keel is at -35 m, but the")));
    EXPECT_THAT(said_of_size(40, 25), ElementsAre(HasSubstr("warning: platform.draft")));
    EXPECT_THAT(said_of_size(700, 25), ElementsAre(HasSubstr("so near to the waterline")));
}

TEST(SizeOfAHull, TellsRadiiOfGyrationInAnotherUnit) {
    for (const double radius : {0.025, 250.0})
        EXPECT_THAT(said_of_size(70, radius),
                    ElementsAre(HasSubstr("warning: platform.radii_of_gyration: a radius of "
                                          "gyration in pitch of")));
}

TEST(StepsOfWaves, AreAtLeastSixAPeriod) {
    Case c;
    c.environment.seabed.depth = 500;
    c.environment.waves = {{.type = WaveType::airy, .H = 2, .T = 12}};
    const auto count = [&](double step) {
        c.analysis.dynamics.platform_step = step;
        Problems problems;
        check_steps_of_waves(c, problems);
        return problems.size();
    };
    EXPECT_EQ(count(2.0), 0u);
    EXPECT_EQ(count(2.1), 1u);
    // The tail of a spectrum does not count: 2 % of this sea has periods below 6 s.
    c.environment.waves = {{.type = WaveType::jonswap, .Hs = 6, .Tp = 14, .gamma = 2.4, .seed = 1}};
    EXPECT_EQ(count(1.0), 0u);
    EXPECT_EQ(count(2.0), 1u);
}

TEST(HeadingsOfACase, ASpreadSeaNamesItsTrainAndTheOneHeadingOfTheData) {
    Case c = case_with_qtf();
    c.environment.waves[0].heading = 60 * degree;
    c.environment.waves[0].spreading.emplace();
    c.platform->hydrodynamics.drift = Drift::none;
    HydroData data = data_with_qtf();
    data.excitation.full_circle = false;
    data.excitation.headings.resize(1);
    const std::vector<std::string> all = said(c, data);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_THAT(all[0], HasSubstr("waves spread about 60 deg meet the platform at a heading of "));
    EXPECT_THAT(all[0], HasSubstr("outside the one heading, 0 deg, of the database's excitation"));
}

}  // namespace
}  // namespace hawser
