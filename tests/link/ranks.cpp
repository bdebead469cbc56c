#include "ranks.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace hawser::test {
namespace {
std::optional<io::Link> all;
}
io::Link& ranks() { return *all; }
}  // namespace hawser::test

int main(int argc, char** argv) {
    std::optional<hawser::io::MpiRuntime> runtime;
    if (hawser::io::launch().alone()) {
        hawser::test::all.emplace();
    } else {
        runtime.emplace(&argc, &argv);
        hawser::test::all = runtime->link();
    }
    testing::InitGoogleTest(&argc, argv);
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    if (hawser::test::ranks().rank() > 0)
        delete listeners.Release(listeners.default_result_printer());
    const int result = hawser::test::ranks().greatest(RUN_ALL_TESTS());
    hawser::test::all.reset();
    return result;
}
