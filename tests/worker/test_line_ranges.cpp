// Ranges and extremes of rods against the same statistics of the whole series.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "line_ranges.hpp"
#include "rod_runs.hpp"
#include "statistics.hpp"

namespace hawser::worker {
namespace {

using namespace testing;
using Q = LineQuantity;

/// A mass that bobs on a hanging line, set off so hard that the line goes slack.
struct BobbingMass {
    double L = 50, M = 5000, m = 2, EA = 1e7;
    Case input;
    Sea sea;
    RodPack<Quad> rod;
    BobbingMass()
        : input([this] {
              LineType type = plain_type(m, EA);
              type.section_area = 0.01, type.breaking_load = 1e5;
              Case c = one_line(type, L, 4, fixed_at({0, 0, 0}), LineEnd{});
              c.environment.water.density = 0.0;
              c.lines[0].attachments = {{.arc_length = L, .mass = M}};
              c.analysis.dynamics.line_step = 0.01;
              return c;
          }()),
          sea(still_sea(input)),
          rod(input, sea, {0}) {}
    /// Runs and looks at every step; `speed` of the mass upwards [m/s].
    template <class Look>
    void run_with(double speed, double duration, Look&& look) {
        ASSERT_TRUE(rod.equilibrium({}, false).ok());
        look(0.0);
        for (int n = 0; n <= 4; ++n) {
            for (int lane = 0; lane < 4; ++lane)
                rod.kept().nodes()[n].v.z.set(lane, speed * (4 - n) / 4.0);
            for (int lane = 0; lane < 4; ++lane) rod.kept().nodes()[n].vd.z.set(lane, -speed / L);
        }
        ASSERT_TRUE(run<Quad>(rod, duration, 0.05, look).ok());
    }
};

TEST(QuantityRange, IsTheStatisticsOfTheSeriesAtEveryNode) {
    BobbingMass bob;
    Recovery<Quad> recovery(bob.input, bob.rod);
    QuantityRange range(Q::effective_tension, 5);
    std::vector<double> time;
    std::vector<std::vector<double>> series(5);
    bob.run_with(0.1, 3.0, [&](double t) {
        recovery.recover(bob.rod);
        range.add(recovery, t);
        time.push_back(t);
        for (int n = 0; n < 5; ++n)
            series[static_cast<std::size_t>(n)].push_back(
                recovery.node(n)[index_of(Q::effective_tension)][0]);
    });
    ASSERT_EQ(time.size(), 61u);
    for (int n = 0; n < 5; ++n) {
        const Statistics s = statistics_of(time, series[static_cast<std::size_t>(n)], 0.0);
        // least and greatest of the two sides of a node, which agree to rounding [N]
        EXPECT_NEAR(range.value(0, 0, n), s.min, 1e-6);
        EXPECT_NEAR(range.value(1, 0, n), s.mean, 1e-12 * s.mean);
        EXPECT_NEAR(range.value(2, 0, n), s.max, 1e-6);
        EXPECT_NEAR(range.value(3, 0, n), s.std, 1e-9 * s.std);
        if (n < 4) {
            EXPECT_GT(s.std, 1000.0);
        }  // the free end has none
        EXPECT_EQ(range.value(4, 0, n), s.t_min);
        EXPECT_EQ(range.value(5, 0, n), s.t_max);
    }
    // at_maximum: the values of one moment, that of the greatest value anywhere
    std::size_t when = 0;
    for (std::size_t k = 0; k < time.size(); ++k)
        for (int n = 0; n < 5; ++n)
            if (series[static_cast<std::size_t>(n)][k] == range.value(2, 0, 0)) when = k;
    EXPECT_EQ(range.time_of_maximum(0), time[when]);
    for (int n = 0; n < 5; ++n)
        EXPECT_EQ(range.value(6, 0, n), series[static_cast<std::size_t>(n)][when]) << n;
}

TEST(QuantityRange, OfSomethingThatHasNoMeaningIsEmpty) {
    BobbingMass bob;
    Recovery<Quad> recovery(bob.input, bob.rod);
    QuantityRange none(Q::wall_tension, 5), not_yet(Q::effective_tension, 5);
    bob.run_with(0.0, 0.1, [&](double t) {
        recovery.recover(bob.rod);
        none.add(recovery, t);
    });
    for (std::size_t k = 0; k < 7; ++k) {
        EXPECT_TRUE(std::isnan(none.value(k, 0, 2))) << k;
        EXPECT_TRUE(std::isnan(not_yet.value(k, 0, 2))) << k;
    }
}

TEST(LineWatch, FindsExtremesWithPlaceAndTimeAndHowLongTheLineWasSlack) {
    BobbingMass bob;
    const double weight = (bob.M + bob.m * bob.L) * 9.80665;
    Recovery<Quad> recovery(bob.input, bob.rod);
    LineWatch watch(5);
    double least = 1e30, greatest = -1e30, slack = 0.0, first = NAN, before = 0.0;
    bob.run_with(2.5, 2.0, [&](double t) {
        // M g/k = 0.25 m: at v sqrt(M/k) above that the line has nothing left to carry
        recovery.recover(bob.rod);
        watch.add(recovery, t);
        bool is_slack = false;
        for (int n = 0; n < 4; ++n) {  // not the free end
            const double T = recovery.node(n)[index_of(Q::effective_tension)][0];
            least = std::min(least, T), greatest = std::max(greatest, T);
            is_slack = is_slack || T < 0.01 * weight;
        }
        if (is_slack) slack += t - before, first = std::isnan(first) ? t : first;
        before = t;
    });
    // A node's own tension is the mean of its two sides, its extremes are of each: rounding apart.
    EXPECT_DOUBLE_EQ(watch.extreme(0, 0)[0], least);
    EXPECT_DOUBLE_EQ(watch.extreme(1, 0)[0], greatest);
    EXPECT_EQ(watch.extreme(1, 0)[1], 0.0);  // the top carries most
    EXPECT_DOUBLE_EQ(watch.extreme(2, 0)[0], greatest / 0.01);
    EXPECT_TRUE(std::isnan(watch.extreme(3, 0)[0]));  // no yield
    EXPECT_EQ(watch.extreme(4, 0)[0], greatest / 1e5);
    EXPECT_NEAR(watch.slack(0)[0], 0.01 * weight, 1e-6 * weight);
    EXPECT_GT(slack, 0.2);
    EXPECT_NEAR(watch.slack(0)[1], slack, 1e-9);
    EXPECT_EQ(watch.slack(0)[2], first);
}

TEST(LineWatch, DoesNotCallTheFreeEndOfAHangingLineSlack) {
    Case input = one_line(plain_type(100, 1e9), 100, 8, fixed_at({0, 0, -10}), LineEnd{}, 1000);
    const Sea sea = still_sea(input);
    RodPack<Quad> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    Recovery<Quad> recovery(input, rod);
    recovery.recover(rod);
    LineWatch watch(9);
    watch.add(recovery, 0.0);
    watch.add(recovery, 1.0);
    EXPECT_EQ(watch.slack(0)[1], 0.0);
    EXPECT_TRUE(std::isnan(watch.slack(0)[2]));
    EXPECT_EQ(watch.extreme(0, 0)[1], 7.0);  // the last node that carries something
}

}  // namespace
}  // namespace hawser::worker
