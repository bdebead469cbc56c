// The same orders to lines in this process and to lines on other ranks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "ranks.hpp"
#include "remote_lines.hpp"
#include "worker_loop.hpp"

namespace hawser {
namespace {

using test::ranks;

/// Lines whose loads are awkward functions of the order, with a kept state each: what a line
/// replies depends on every order before, and every flag leaves its mark.
class FakeLines final : public Lines {
 public:
    explicit FakeLines(std::vector<int> mine) : mine_(std::move(mine)), kept_(mine_.size(), 0.3) {
        trial_ = kept_;
        reply_.lines.resize(mine_.size());
    }
    void send(const Order& order) override {
        if (order.keep_previous) kept_ = trial_;
        order_ = order;
    }
    const Reply& receive() override {
        reply_.status = Status{};
        for (size_t i = 0; i < mine_.size(); ++i) {
            const int line = mine_[i];
            trial_[i] = std::sin(kept_[i] + order_.t1 + 0.1 * line + order_.to[0].position.x());
            LineLoad& load = reply_.lines[i];
            for (int j = 0; j < 6; ++j) load.wrench[j] = std::exp(3.0 * trial_[i] + j) / (line + 3);
            load.wrench[5] = -0.0;
            load.end_tension = trial_[i] / 3.0;
            load.stiffness = Mat6::Constant(order_.current ? trial_[i] : -trial_[i]);
            if (order_.t1 == 7.5 && line >= 4 && line != 5 && reply_.status.ok())
                reply_.status = {.code = Status::Code::not_converged,
                                 .line = line,
                                 .arc_length = 10.0 * line,
                                 .t = order_.t1,
                                 .residual = 2.1e3,
                                 .iterations = 30};
        }
        return reply_;
    }

 private:
    std::vector<int> mine_;
    std::vector<double> kept_, trial_;
    Order order_;
    Reply reply_;
};

constexpr int n_lines = 7;

std::vector<std::vector<int>> dealt_to_ranks() {  // line i to worker i mod (size - 1)
    std::vector<std::vector<int>> lines(static_cast<size_t>(ranks().size()));
    for (int i = 0; i < n_lines; ++i)
        lines[static_cast<size_t>(1 + i % (ranks().size() - 1))].push_back(i);
    return lines;
}

bool same_bits(const LineLoad& a, const LineLoad& b) {
    return std::memcmp(a.wrench.data(), b.wrench.data(), sizeof(double) * 6) == 0 &&
           std::memcmp(&a.end_tension, &b.end_tension, sizeof(double)) == 0 &&
           std::memcmp(a.stiffness.data(), b.stiffness.data(), sizeof(double) * 36) == 0;
}

Order order_number(int k) {
    Order order{.ask = k % 5 == 0 ? Ask::equilibrium : Ask::run_to,
                .keep_previous = k % 3 == 2,
                .current = k % 2 == 0,
                .t0 = 0.5 * k,
                .t1 = 0.5 * k + 0.5};
    order.to[0].position.x() = 1.0 / (k + 1);
    return order;
}

TEST(RemoteLines, AnswerLikeLocalLinesToTheLastBit) {
    if (ranks().alone()) GTEST_SKIP() << "a run alone has local lines";
    const auto dealt = dealt_to_ranks();
    if (ranks().rank() > 0) {
        FakeLines mine(dealt[static_cast<size_t>(ranks().rank())]);
        worker::worker_loop(ranks(), mine, nullptr);
        return;
    }
    master::RemoteLines remote(ranks(), dealt);
    FakeLines local({0, 1, 2, 3, 4, 5, 6});
    for (int k = 0; k < 40; ++k) {
        const Order order = order_number(k);
        remote.send(order);
        local.send(order);
        const Reply& far = remote.receive();
        const Reply& near = local.receive();
        ASSERT_EQ(far.status.code, near.status.code);
        EXPECT_EQ(far.status.line, near.status.line);
        EXPECT_EQ(far.status.arc_length, near.status.arc_length);
        EXPECT_EQ(far.status.iterations, near.status.iterations);
        EXPECT_EQ(far.status.ok(), k != 14);  // order 14 ends at 7.5 s, where lines 4 and 6 fail
        if (!far.status.ok()) {
            EXPECT_EQ(far.status.line, 4);
        }
        ASSERT_EQ(far.lines.size(), static_cast<size_t>(n_lines));
        for (size_t i = 0; i < n_lines; ++i) {
            LineLoad expected = near.lines[i];
            if (order.ask != Ask::equilibrium) expected.stiffness.setZero();
            EXPECT_TRUE(same_bits(far.lines[i], expected)) << "order " << k << ", line " << i;
            EXPECT_TRUE(std::signbit(far.lines[i].wrench[5]));
        }
    }
    remote.send({.ask = Ask::stop});
}

}  // namespace
}  // namespace hawser
