#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "message.hpp"

namespace hawser {
namespace {

TEST(Message, AnOrderArrivesAsItWasSent) {
    const Order sent = {
        .ask = Ask::equilibrium,
        .keep_previous = true,
        .sample = false,
        .snapshot = true,
        .write_segment = false,
        .current = false,
        .t0 = 0.1,
        .t1 = 0.35,
        .frequency = 0.403,
        .from = {PlatformMotion{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}},
                 PlatformMotion{{20, 0, 0}, {}, {}, {0, 0, 21}}},
        .to = {PlatformMotion{{-1, -2, -3}, {-4, -5, -6}, {-7, -8, -9}, {-10, -11, -0.0}},
               PlatformMotion{}, PlatformMotion{{0, 22, 0}, {}, {}, {}}}};
    const Order got = unpack(pack(sent));
    EXPECT_EQ(got.ask, sent.ask);
    EXPECT_EQ(got.keep_previous, sent.keep_previous);
    EXPECT_EQ(got.sample, sent.sample);
    EXPECT_EQ(got.snapshot, sent.snapshot);
    EXPECT_EQ(got.write_segment, sent.write_segment);
    EXPECT_EQ(got.current, sent.current);
    EXPECT_EQ(got.t0, sent.t0);
    EXPECT_EQ(got.t1, sent.t1);
    EXPECT_EQ(got.frequency, sent.frequency);
    for (std::size_t k = 0; k < sent.from.size(); ++k) {
        EXPECT_EQ(got.from[k], sent.from[k]) << k;
        EXPECT_EQ(got.to[k], sent.to[k]) << k;
    }
    EXPECT_TRUE(std::signbit(got.to[0].angle_rates.z()));
    Order other = sent;  // each flag has a place of its own
    other.sample = other.write_segment = other.current = true;
    other.keep_previous = other.snapshot = false;
    const Order back = unpack(pack(other));
    EXPECT_TRUE(back.sample && back.write_segment && back.current);
    EXPECT_FALSE(back.keep_previous || back.snapshot);
}

TEST(Message, AReplyArrivesAsItWasSentAndStiffnessOnlyWhereAsked) {
    Reply sent;
    sent.status = {.code = Status::Code::not_finite,
                   .line = 3,
                   .arc_length = 1583.0,
                   .t = 31.24,
                   .residual = 2.1e3,
                   .iterations = 30};
    sent.lines.resize(2);
    for (int i = 0; i < 2; ++i) {
        LineLoad& line = sent.lines[static_cast<size_t>(i)];
        for (int j = 0; j < 6; ++j) line.wrench[j] = 10.0 * i + j + 0.1;
        line.end_tension = 1e6 + i;
        line.impulse_mismatch = 0.01 * i;
        line.mismatch_at = 3 - i;
        for (int j = 0; j < 36; ++j) line.stiffness.data()[j] = 100.0 * i + j;
    }
    for (const Ask ask : {Ask::run_to, Ask::equilibrium, Ask::impedance}) {
        std::vector<double> message(static_cast<size_t>(reply_numbers(ask, 2)), -1.0);
        pack_reply_to(sent, ask, message);
        const Status status = unpack_status(message);
        EXPECT_EQ(status.code, sent.status.code);
        EXPECT_EQ(status.line, 3);
        EXPECT_EQ(status.arc_length, 1583.0);
        EXPECT_EQ(status.t, 31.24);
        EXPECT_EQ(status.residual, 2.1e3);
        EXPECT_EQ(status.iterations, 30);
        for (int i = 0; i < 2; ++i) {
            const LineLoad& line = sent.lines[static_cast<size_t>(i)];
            const LineLoad got = unpack_line(message, ask, i);
            EXPECT_EQ(got.wrench, line.wrench);
            EXPECT_EQ(got.end_tension, line.end_tension);
            EXPECT_EQ(got.impulse_mismatch, line.impulse_mismatch);
            EXPECT_EQ(got.mismatch_at, line.mismatch_at);
            EXPECT_EQ(got.stiffness, ask != Ask::run_to ? line.stiffness : Mat6::Zero());
        }
    }
}

TEST(Message, ALineBetweenTwoPlatformsBringsTheLoadsOfBoth) {
    Reply sent;
    sent.lines.resize(2);
    for (int i = 0; i < 2; ++i) {
        LineLoad& line = sent.lines[static_cast<size_t>(i)];
        line.wrench.setConstant(1.0 + i);
        line.second.wrench.setConstant(10.0 + i);
        line.stiffness.setConstant(20.0 + i);
        line.second.stiffness.setConstant(30.0 + i);
        line.second.on_first.setConstant(40.0 + i);
        line.second.of_first.setConstant(50.0 + i);
    }
    for (const Ask ask : {Ask::run_to, Ask::equilibrium}) {
        std::vector<double> message(static_cast<size_t>(reply_numbers(ask, 2, true)));
        pack_reply_to(sent, ask, message, true);
        for (int i = 0; i < 2; ++i) {
            const LineLoad got = unpack_line(message, ask, i, true);
            const LineLoad& was = sent.lines[static_cast<size_t>(i)];
            EXPECT_EQ(got.wrench, was.wrench);
            EXPECT_EQ(got.second.wrench, was.second.wrench);
            const bool stiff = replies_stiffness(ask);
            EXPECT_EQ(got.stiffness, stiff ? was.stiffness : Mat6(Mat6::Zero()));
            EXPECT_EQ(got.second.stiffness, stiff ? was.second.stiffness : Mat6(Mat6::Zero()));
            EXPECT_EQ(got.second.on_first, stiff ? was.second.on_first : Mat6(Mat6::Zero()));
            EXPECT_EQ(got.second.of_first, stiff ? was.second.of_first : Mat6(Mat6::Zero()));
        }
    }
    // the messages of one platform are as short as ever
    EXPECT_EQ(order_numbers(1), 33);
    EXPECT_EQ(reply_numbers(Ask::run_to, 1), 15);
}

}  // namespace
}  // namespace hawser
