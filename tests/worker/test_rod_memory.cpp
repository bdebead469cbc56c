// A pass of a pack takes no memory, with everything that can act on a rod in use: counted through
// the program's own operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "rod/rod_group.hpp"
#include "rod_runs.hpp"

namespace {
std::atomic<long> taken{0};

void* take(std::size_t n, std::size_t alignment) {
    ++taken;
    const std::size_t whole = (n + alignment - 1) / alignment * alignment;
    if (void* p = std::aligned_alloc(alignment, whole)) return p;
    throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t n) { return take(n, alignof(std::max_align_t)); }
void* operator new[](std::size_t n) { return take(n, alignof(std::max_align_t)); }
void* operator new(std::size_t n, std::align_val_t a) {
    return take(n, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t n, std::align_val_t a) {
    return take(n, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace hawser::worker {
namespace {

using namespace testing;

/// Four risers with tensioner, guides and a slider, in waves and current, of viscous material.
Case four_risers() {
    LineType pipe = plain_type(337.0, 6.2e9, 1.13e8);
    pipe.displaced_area = M_PI / 4 * 0.406 * 0.406;
    pipe.outer_diameter = pipe.drag_diameter = 0.406;
    pipe.drag_normal = 1.2, pipe.added_mass_normal = 1.0, pipe.damping_ratio = 0.01;
    LineEnd foot = fixed_at({4.5, 4.5, -1500}, Joint::clamped);
    foot.direction = Vec3(0, 0, -1);
    Case input = one_line(pipe, 1521.1, 40, LineEnd{}, foot, 1500);
    std::vector<LineConstraint>& constraints = input.lines[0].constraints;
    constraints = {{.type = ConstraintType::tensioner,
                    .name = "tensioner",
                    .position = {4.5, 4.5, 22},
                    .arc_length = 0.0,
                    .damping = 2e4,
                    .nominal_tension = 5.338e6,
                    .exponent = 1.1,
                    .gas_column = 40,
                    .stroke_min = -4.5,
                    .stroke_max = 4.5}};
    for (const double z : {-95.0, -173.0})
        constraints.push_back({.type = ConstraintType::guide,
                               .name = "guide",
                               .position = {4.5, 4.5, z},
                               .stiffness = 2e7,
                               .damping = 2e5,
                               .gap = 0.025,
                               .friction = 0.1});
    constraints.push_back({.type = ConstraintType::slider,
                           .name = "slider",
                           .position = {4.5, 4.5, -10},
                           .stiffness = 1e6});
    for (int i = 1; i < 4; ++i) input.lines.push_back(input.lines[0]);
    input.environment.waves = {WaveTrain{.type = WaveType::airy, .H = 8, .T = 11}};
    input.environment.current = Current{.profile = {{.depth = 0, .speed = 1.0}}};
    return input;
}

class RodPass : public ::testing::TestWithParam<ForceFit> {};

TEST_P(RodPass, TakesNoMemory) {
    Case input = four_risers();
    input.analysis.dynamics.force = GetParam();
    const Sea sea(input.environment, 0.0, 0.0);
    RodPack<Quad> rods(input, sea, {0, 1, 2, 3});
    ASSERT_TRUE(rods.equilibrium({}, true).ok());
    PlatformMotion still, moved;
    moved.position.x() = 0.5, moved.velocity.x() = 1.0;
    const MotionSpline platform(0, still, 0.5, moved);
    const long before = taken;
    const Status first = rods.pass(0, 0.25, platform);
    Status last = rods.pass(0, 0.25, platform);
    for (int i = 0; i < 2 && last.ok(); ++i) last = rods.pass(0, 0.5, platform);
    rods.keep();
    EXPECT_EQ(taken - before, 0);
    EXPECT_TRUE(first.ok() && last.ok());
    EXPECT_GT(rods.constraint_magnitude(0, 2), 0.0);  // the hull has come up to the riser
    const RodPack<Quad> another = rods;               // the count works: a copy takes memory
    EXPECT_GT(another.elements(), 0);
    EXPECT_GT(taken - before, 0);
}
INSTANTIATE_TEST_SUITE_P(Forces, RodPass,
                         ::testing::Values(ForceFit::quadratic_fit, ForceFit::impulse_matched));

TEST(RodPass, OfTiedRodsTakesNoMemory) {
    Case input = four_risers();
    input.lines.resize(3);
    input.lines[2].constraints = {};
    for (const double arc : {300.0, 600.0})  // the third in the second, in the first
        for (const int i : {1, 2})
            input.lines[static_cast<std::size_t>(i)].constraints.push_back(
                {.type = ConstraintType::slider,
                 .name = "tie",
                 .on_platform = false,
                 .other_line = i - 1,
                 .arc_length = arc,
                 .stiffness = 1e7,
                 .gap = i == 1 ? 0.0 : 0.05});
    input.lines[2].end_a = fixed_at({4.6, 4.5, 23});
    const Sea sea(input.environment, 0.0, 0.0);
    std::vector<RodPack<Quad>> rods;
    for (int i = 0; i < 3; ++i) rods.emplace_back(input, sea, std::vector<int>{i});
    RodGroup<Quad> group{std::span(rods)};
    ASSERT_TRUE(group.equilibrium({}, true).ok());
    const PlatformMotion still;
    const long before = taken;
    const Status status = group.pass(0, 0.5, MotionSpline(0, still, 0.5, still));
    group.keep();
    EXPECT_EQ(taken - before, 0);
    EXPECT_TRUE(status.ok());
}

}  // namespace
}  // namespace hawser::worker
