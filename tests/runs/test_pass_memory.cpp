// A pass of the lines takes no memory, whatever acts on them: every call of malloc and its
// relatives is counted, Eigen's too, while whole cases run. Not under a sanitizer, which has its
// own malloc.
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

#include "io/case_file.hpp"
#include "local_lines.hpp"
#include "packing.hpp"

namespace {
std::atomic<long> taken{0};
}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t n) {
    ++taken;
    return __libc_malloc(n);
}
void* calloc(std::size_t count, std::size_t n) {
    ++taken;
    return __libc_calloc(count, n);
}
void* realloc(void* p, std::size_t n) {
    ++taken;
    return __libc_realloc(p, n);
}
void* aligned_alloc(std::size_t alignment, std::size_t n) {
    ++taken;
    return __libc_memalign(alignment, n);
}
int posix_memalign(void** p, std::size_t alignment, std::size_t n) {
    ++taken;
    *p = __libc_memalign(alignment, n);
    return *p != nullptr ? 0 : ENOMEM;
}
}
#define HAWSER_MALLOC_IS_COUNTED
#endif

namespace hawser {
namespace {

struct Sample {
    const char* name;
    const char* path;
    io::Overrides changes;
};

class PassOfTheLines : public ::testing::TestWithParam<Sample> {};

TEST_P(PassOfTheLines, TakesNoMemory) {
#ifndef HAWSER_MALLOC_IS_COUNTED
    GTEST_SKIP() << "malloc belongs to the sanitizer";
#endif
    const std::filesystem::path source = HAWSER_SOURCE_DIR;
    const Case input = io::read_case(source / GetParam().path, GetParam().changes).value;
    std::vector<int> all;
    for (int p = 0; p < static_cast<int>(packs_of(input).size()); ++p) all.push_back(p);
    worker::LocalLines lines(input, all, nullptr);

    // the platform heaves and surges 2 m about its design position, in steps of 0.5 s for 6 s
    const auto pose = [](double t) {
        PlatformMotion m;
        const double w = 0.6;
        m.position = 2.0 * Vec3(1 - std::cos(w * t), 0, std::sin(w * t) - w * t * std::exp(-t));
        m.velocity = 2.0 * w * Vec3(std::sin(w * t), 0, std::cos(w * t) - (1 - t) * std::exp(-t));
        return m;
    };
    lines.send({.ask = Ask::equilibrium, .to = pose(0)});
    ASSERT_TRUE(lines.receive().status.ok());

    bool keep = false;
    const auto pass = [&](double t0, double t1) {
        lines.send({.ask = Ask::run_to,
                    .keep_previous = keep,
                    .t0 = t0,
                    .t1 = t1,
                    .from = pose(t0),
                    .to = pose(t1)});
        keep = false;
        return lines.receive().status;
    };
    const long before = taken;
    Status status;
    for (int step = 0; step < 12 && status.ok(); ++step) {
        const double t = 0.5 * step;
        for (const double end : {t + 0.25, t + 0.25, t + 0.5, t + 0.5})
            if (status.ok()) status = pass(t, end);
        keep = true;
    }
    EXPECT_EQ(taken - before, 0);
    EXPECT_TRUE(status.ok()) << "line " << status.line << ", t " << status.t;

    const long counted = taken;  // the count works: a copy takes memory
    const worker::RodPack<worker::Quad> another = lines.packs().front();
    EXPECT_GT(taken, counted);
    EXPECT_GT(another.elements(), 0);
}

const Sample samples[] = {
    {"EveryConstraint", "tests/runs/every_constraint.yml", {}},
    {"EveryConstraintWithAFit",
     "tests/runs/every_constraint.yml",
     {{"analysis.dynamics.coupling.force", "quadratic_fit"}}},
    {"EveryConstraintByAdamsMoulton",
     "tests/runs/every_constraint.yml",
     {{"analysis.dynamics.rod_scheme.type", "adams_moulton"}}},
    {"Bridle", "cases/bridle.yml", {}},
    {"TensionLegs", "cases/tlp/tlp.yml", {}},
    {"QuasiStaticTrussSpar",
     "cases/truss_spar/truss_spar.yml",
     {{"analysis.dynamics.line_model", "quasi_static"}}},
    {"Catenaries", "cases/truss_spar/truss_spar.yml", {{"lines.mooring.model", "catenary"}}},
};
INSTANTIATE_TEST_SUITE_P(Cases, PassOfTheLines, ::testing::ValuesIn(samples),
                         [](const auto& about) { return std::string(about.param.name); });

}  // namespace
}  // namespace hawser
