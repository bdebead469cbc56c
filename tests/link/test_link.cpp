#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "io/link.hpp"
#include "message.hpp"
#include "ranks.hpp"

namespace hawser {
namespace {

using test::ranks;

TEST(Link, HasTheSizeItWasStartedWith) {
    EXPECT_EQ(ranks().size(), io::launch().size);
    EXPECT_EQ(ranks().rank(), io::launch().rank);
}

TEST(Link, BroadcastBringsEveryBitOfRankZero) {
    const std::vector<double> sent = {-0.0, 0.1, std::numeric_limits<double>::denorm_min(),
                                      -std::numeric_limits<double>::infinity()};
    std::vector<double> values = ranks().rank() == 0 ? sent : std::vector<double>(4, 7.0);
    ranks().broadcast(values);
    EXPECT_EQ(std::memcmp(values.data(), sent.data(), 4 * sizeof(double)), 0);

    std::string text = ranks().rank() == 0 ? std::string(100000, 'x') + "\nend" : "";
    ranks().broadcast(text);
    EXPECT_EQ(text.size(), 100004U);
    EXPECT_TRUE(text.ends_with("x\nend"));
    std::string empty = ranks().rank() == 0 ? "" : "old";
    ranks().broadcast(empty);
    EXPECT_EQ(empty, "");
}

TEST(Link, GatherPutsUnequalPartsInRankOrderAndKeepsTheSignOfZero) {
    const int me = ranks().rank(), n = ranks().size();
    std::vector<double> mine(static_cast<size_t>(me), me);  // rank r sends r numbers, rank 0 none
    if (me > 0) mine[0] = -0.0;
    std::vector<int> counts(static_cast<size_t>(n));
    std::iota(counts.begin(), counts.end(), 0);
    std::vector<double> all(static_cast<size_t>(n * (n - 1) / 2));
    ranks().gather(mine, counts, all);
    if (me != 0) return;
    size_t at = 0;
    for (int rank = 0; rank < n; ++rank)
        for (int i = 0; i < rank; ++i, ++at) {
            EXPECT_EQ(all[at], i == 0 ? 0.0 : rank);
            EXPECT_EQ(std::signbit(all[at]), i == 0);
        }
}

TEST(Link, GreatestIsKnownToAll) {
    EXPECT_EQ(ranks().greatest(10 - ranks().rank()), 10);
    EXPECT_EQ(ranks().greatest(ranks().rank()), ranks().size() - 1);
}

TEST(Link, ADuplicateIsIndependentOfItsOriginal) {
    io::Link copy = ranks().duplicate();
    EXPECT_EQ(copy.rank(), ranks().rank());
    int a = ranks().rank() == 0 ? 1 : 0, b = ranks().rank() == 0 ? 2 : 0;
    ranks().broadcast(a);
    copy.broadcast(b);
    EXPECT_EQ(a, 1);
    EXPECT_EQ(b, 2);
    io::Link moved = std::move(copy);
    moved.barrier();
}

TEST(Link, AloneFailsByThrowing) {
    const io::Link alone;
    try {
        alone.fail(ExitCode::io, "disk full");
        FAIL();
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::io);
        EXPECT_STREQ(error.what(), "disk full");
    }
}

}  // namespace
}  // namespace hawser
