#include <gtest/gtest.h>

#include <vector>

#include "doubles.hpp"
#include "lines_loop.hpp"

namespace hawser::master {
namespace {

TEST(LinesLoop, MakesOnePassPerStepAndKeepsEach) {
    test::SpringLines lines({Vec6::Ones()});
    Reply start;
    start.lines.resize(1);
    start.lines[0].end_tension = 7.0;
    Order next;
    std::vector<double> times;
    bool first_was_static = false;
    lines_loop(lines, start, next, 0.1, [&](int step, double t, const Reply& reply) {
        if (step == 0) first_was_static = reply.lines[0].end_tension == 7.0;
        times.push_back(t);
        next.sample = step == 1;
        return step < 3;
    });
    EXPECT_TRUE(first_was_static);
    EXPECT_EQ(times, (std::vector<double>{0.0, 0.1, 2 * 0.1, 3 * 0.1}));
    ASSERT_EQ(lines.orders.size(), 3U);
    for (int step = 0; step < 3; ++step) {
        const Order& order = lines.orders[static_cast<std::size_t>(step)];
        EXPECT_EQ(order.ask, Ask::run_to);
        EXPECT_EQ(order.t0, step * 0.1);
        EXPECT_EQ(order.t1, (step + 1) * 0.1);
        EXPECT_EQ(order.keep_previous, step > 0);
        EXPECT_EQ(order.sample, step == 1);
        EXPECT_EQ(order.from[0], PlatformMotion{});
    }
    EXPECT_TRUE(next.keep_previous);  // for the order that ends the run
}

TEST(LinesLoop, StopsAtALineThatFails) {
    class Failing final : public Lines {
     public:
        void send(const Order&) override {}
        const Reply& receive() override {
            reply.status = {.code = Status::Code::not_finite, .line = 2};
            return reply;
        }
        Reply reply;
    } lines;
    Order next;
    EXPECT_THROW(
        lines_loop(lines, Reply{}, next, 0.1, [](int, double, const Reply&) { return true; }),
        LinesFailed);
}

}  // namespace
}  // namespace hawser::master
