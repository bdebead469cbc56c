#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spar_hull.hpp"
#include "stability.hpp"

namespace hawser::master {
namespace {

/// Of one platform with rotations that count on a lever of 80 m.
Stability stability_with(const Hull& hull, const Mat6& K) {
    return stability_of({hull}, 9.80665, K, {{.length = 80.0}}).front();
}

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MetacentricHeight, IsThatOfTheTwoTanksWhateverTheLinesPull) {  // validation row B2
    // z_B + BM - z_G = -51.875 + (pi/4 20^4)/100531 + 66 = 15.375 m; the database's waterplane has
    // panels, so its second moment is 0.1 % of 1.25 m off at most
    Case c = spar_case();
    const Hull hull(c, &spar_data());
    EXPECT_NEAR(hull_GM(hull, 0, 9.80665), 15.375, 2e-3);
    EXPECT_NEAR(hull_GM(hull, 1, 9.80665), 15.375, 2e-3);
    c.platform->mass = 0.95 * *c.platform->mass;  // 5 % of the buoyancy holds lines
    EXPECT_NEAR(hull_GM(Hull(c, &spar_data()), 0, 9.80665), 15.375, 2e-3);
    c.platform->centre_of_gravity.z() = -40.0;  // 26 m higher
    EXPECT_NEAR(hull_GM(Hull(c, &spar_data()), 0, 9.80665), 15.375 - 26.0, 2e-3);
}

TEST(Stability, NamesTheMotionsWithNegativeAndWithoutStiffness) {
    const Hull hull(spar_case(), &spar_data());
    Vec6 k;
    k << 0, 1e5, 1e7, 1e10, -1e10, 1e8;
    const Stability s = stability_with(hull, k.asDiagonal());
    EXPECT_FALSE(s.stable());
    EXPECT_THAT(s.unstable, ElementsAre("pitch"));
    EXPECT_THAT(s.unheld, ElementsAre("surge"));
    ASSERT_EQ(stability_warnings(s, "spar").size(), 1U);
    EXPECT_THAT(stability_warnings(s, "spar").front(), HasSubstr("not stable in pitch"));
    // An unstable direction may be of several motions, none of which is negative by itself.
    Vec6 diagonal;
    diagonal << 1e5, 1e5, 1e7, 1e10, 1e10, 1e8;
    Mat6 coupled = diagonal.asDiagonal();
    coupled(0, 4) = coupled(4, 0) = 5e7;
    EXPECT_FALSE(stability_with(hull, coupled).stable());
    EXPECT_TRUE(stability_with(hull, k.cwiseAbs().asDiagonal()).stable());
}

TEST(Stability, OfAHullThatOnlyItsLinesKeepUprightIsToldAsSuch) {
    Case c = spar_case();
    c.platform->centre_of_gravity.z() = -40.0;
    const Hull hull(c, &spar_data());
    Vec6 diagonal;
    diagonal << 1e5, 1e5, 1e8, 1e9, 1e9, 1e8;
    const Mat6 held = diagonal.asDiagonal();
    const auto warnings = stability_warnings(stability_with(hull, held), "tlp");
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings.front(), HasSubstr("only the lines keep it upright"));
    const Hull sound(spar_case(), &spar_data());
    EXPECT_THAT(stability_warnings(stability_with(sound, held), "spar"), IsEmpty());
}

}  // namespace
}  // namespace hawser::master
