// The hull's part of a time step takes no memory: counted through the program's own operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "spar_hull.hpp"

namespace {
std::atomic<long> taken{0};
}

[[gnu::noinline]] void* operator new(std::size_t n) {
    ++taken;
    if (void* p = std::malloc(n)) return p;
    throw std::bad_alloc();
}
void* operator new[](std::size_t n) { return operator new(n); }
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace hawser::master {
namespace {

/// Everything a hull can have: waves, wind, current, drift, members, plates.
Case full_case() {
    Case c = spar_case();
    c.environment.waves = {paper_sea()};
    c.environment.current = Current{.profile = {{0, 1.9, {}}, {75, 0, {}}}};
    c.environment.wind = Wind{.spectrum = WindSpectrum::npd, .speed = 45, .seed = 1};
    Platform& p = *c.platform;
    p.hydrodynamics.drift = Drift::newman;
    p.hydrodynamics.wave_phase = WavePhase::instantaneous;
    p.members = {{.name = "column",
                  .to = {0, 0, -70},
                  .diameter = 40,
                  .Cd = 1.2,
                  .end_Cd_to = 1,
                  .displaced_area = 3}};
    p.plates = {
        {.name = "plate", .position = {0, 0, -90}, .area = 900, .Cd = 5, .added_mass = 1e7}};
    p.wind = WindArea{2500, 45, 1};
    return c;
}

/// With full QTFs of any values at three headings, all pairs of them.
HydroData full_data() {
    HydroData data = spar_data();
    for (Qtf* qtf : {&data.difference, &data.sum}) {
        qtf->frequencies = {0.2, 0.9, 2.1};
        for (const double b1 : {-1.0, 0.0, 1.0})
            for (const double b2 : {-1.0, 0.0, 1.0})
                qtf->pairs.push_back(
                    {b1, b2, std::vector<CVec6>(9, CVec6::Constant(1e4)), std::vector<char>(9, 1)});
    }
    return data;
}

class HullWithDrift : public testing::TestWithParam<Drift> {};
INSTANTIATE_TEST_SUITE_P(EveryDrift, HullWithDrift,
                         testing::Values(Drift::newman, Drift::full_qtf));

TEST_P(HullWithDrift, TakesNoMemoryWithinAStep) {
    Case c = full_case();
    c.platform->hydrodynamics.drift = GetParam();
    c.environment.waves.push_back(c.environment.waves[0]);
    c.environment.waves[1].heading = 0.5;
    const HydroData data = full_data();
    const Hull hull(c, &data);
    const State s = hull.start({}, {});
    const long before = taken;
    HullLoads loads = hull.loads(200, s);
    const State rate = hull.rate(200, s, loads, Vec6::Zero());
    EXPECT_EQ(taken - before, 0);
    EXPECT_GT(rate.norm(), 0);
    const Hull another = hull;  // the count works: a copy takes memory
    EXPECT_GT(another.mass(), 0);
    EXPECT_GT(taken - before, 0);
}

TEST(HullWithMemory, TakesNoMemoryWithinAStep) {
    for (const auto form :
         {RadiationMemoryKeys::Form::fitted, RadiationMemoryKeys::Form::discrete}) {
        Case c = full_case();
        c.platform->hydrodynamics.added_mass_frequency.reset();
        c.platform->hydrodynamics.memory = RadiationMemoryKeys{.form = form, .order = {}};
        Hull hull(c, &spar_data());
        const State s = hull.start({}, {});
        Vec6 acceleration;
        const long before = taken;
        HullLoads loads = hull.loads(200, s);
        const State k1 = hull.rate(200, s, loads, Vec6::Zero(), &acceleration);
        hull.remember(200, s, acceleration);
        const State middle = s + 0.25 * k1;
        loads = hull.loads(200.25, middle);
        const State k2 = hull.rate(200.25, middle, loads, Vec6::Zero());
        EXPECT_EQ(taken - before, 0);
        EXPECT_GT((k2 - k1).norm(), 0);
    }
}

}  // namespace
}  // namespace hawser::master
