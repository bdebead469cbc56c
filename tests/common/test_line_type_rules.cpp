// What a line type's layers add to it: contents, coating, marine growth.
#include <gtest/gtest.h>

#include <cmath>

#include "case/line_type_rules.hpp"

namespace hawser {
namespace {

double disc(double d) { return M_PI / 4 * d * d; }

LineTypeKeys pipe() {
    LineTypeKeys type;
    type.name = "pipe", type.category = "pipe";
    type.outer_diameter = 0.3239, type.wall_thickness = 0.02;
    type.drag_normal = 1.0;
    return type;
}
LineType completed(LineTypeKeys type) {
    Material steel;
    steel.E = 207e9, steel.density = 7850;
    Problems problems;
    complete_line_type(type, &steel, problems);
    return line_type(type);
}

TEST(LineTypeRules, ContentsAddTheirMassAndNothingElse) {
    LineTypeKeys full = pipe();
    full.contents_density = 850;
    const LineType empty = completed(pipe());
    LineType filled = completed(full);
    EXPECT_NEAR(filled.mass - empty.mass, 850 * disc(0.2839), 1e-9);
    EXPECT_EQ(filled.EA, empty.EA);
    EXPECT_EQ(filled.EI, empty.EI);
    EXPECT_EQ(filled.displaced_area, empty.displaced_area);
    EXPECT_EQ(filled.drag_diameter, empty.drag_diameter);
}

TEST(LineTypeRules, CoatingAndMarineGrowthAddMassBuoyancyAndDrag) {
    LineTypeKeys layered = pipe();
    layered.coating = Layer{.thickness = 0.05, .density = 700};
    layered.marine_growth = Layer{.thickness = 0.03, .density = 1300};
    const LineType bare = completed(pipe()), got = completed(layered);
    const double coated = 0.3239 + 0.1, grown = coated + 0.06;
    EXPECT_NEAR(got.mass - bare.mass,
                700 * (disc(coated) - disc(0.3239)) + 1300 * (disc(grown) - disc(coated)), 1e-9);
    EXPECT_NEAR(got.displaced_area, disc(grown), 1e-12);
    EXPECT_NEAR(got.outer_diameter, grown, 1e-12);
    EXPECT_NEAR(got.drag_diameter, grown, 1e-12);
    EXPECT_EQ(got.EA, bare.EA);  // neither carries
    EXPECT_EQ(got.EI, bare.EI);
}

}  // namespace
}  // namespace hawser
