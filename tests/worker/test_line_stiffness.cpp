// Static stiffness of lines about the platform's reference point against differences of the loads.
#include <gtest/gtest.h>

#include "rod_cases.hpp"

namespace hawser::worker {
namespace {

/// The pose moved by a small rotation vector about O (exact for poses without rotation to first
/// order in v).
PlatformMotion moved(int motion, double by) {
    PlatformMotion m;
    if (motion < 3)
        m.position[motion] += by;
    else
        m.angles[motion - 3] += by;
    return m;
}

class LineStiffness : public ::testing::TestWithParam<Joint> {};

TEST_P(LineStiffness, IsMinusTheDerivativeOfTheStaticLoad) {  // R:25
    LineEnd a = testing::fixed_at({20.0, 5.0, -30.0}, GetParam());
    a.kind = EndKind::platform;
    a.rotational_stiffness = 2e5;
    const LineEnd b = testing::anchored_at({500.0, 130.0, -400.0});
    LineType pipe = testing::plain_type(100.0, 5e8, 1e6);
    pipe.displaced_area = 0.03;
    Case input = testing::one_line(pipe, 640.0, 24, a, b);  // hangs free of the bed
    input.lines[0].end_a.direction = Vec3(0.6, 0.2, -0.7).normalized();
    const Sea sea = testing::still_sea(input);
    RodPack<Quad> rod(input, sea, {0});

    ASSERT_TRUE(rod.equilibrium(PlatformMotion{}, false).ok());
    const Mat6 K = rod.stiffness(0, Vec3::Zero());
    for (int j = 0; j < 6; ++j) {
        const double h = j < 3 ? 0.02 : 0.001;
        ASSERT_TRUE(rod.equilibrium(moved(j, h), false).ok());
        const Vec6 up = rod.wrench(0, moved(j, h).position);
        ASSERT_TRUE(rod.equilibrium(moved(j, -h), false).ok());
        const Vec6 down = rod.wrench(0, moved(j, -h).position);
        const Vec6 column = (down - up) / (2 * h);
        // differences err by h^2 and by the residual left in the statics
        EXPECT_LT((K.col(j) - column).head<3>().norm(), 2e-4 * column.head<3>().norm() + 1.0)
            << j << "\n"
            << K.col(j).transpose() << "\n"
            << column.transpose();
        EXPECT_LT((K.col(j) - column).tail<3>().norm(), 2e-4 * column.tail<3>().norm() + 30.0)
            << j << "\n"
            << K.col(j).transpose() << "\n"
            << column.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(Joints, LineStiffness,
                         ::testing::Values(Joint::ball, Joint::clamped, Joint::flex));

}  // namespace
}  // namespace hawser::worker
