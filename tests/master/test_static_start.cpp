// What the static start doubts of a run that has not begun: the memory's fit, the platform step.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recorded_lines.hpp"
#include "spar_hull.hpp"
#include "static_start.hpp"

namespace hawser::master {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// The spar's hull alone, with the memory of these data.
std::vector<std::string> doubts(const HydroData& data, double step) {
    Case c = spar_case();
    Platform& p = *c.platform;
    p.mass.reset();
    p.hydrodynamics.added_mass_frequency.reset();
    p.hydrodynamics.memory.emplace();
    // What lines would hold.
    p.stiffness.diagonal() << 1e6, 1e6, 0, 0, 0, 1e9;
    c.analysis.dynamics.platform_step = step;
    std::vector<Hull> hulls;
    hulls.emplace_back(c, &data);
    NoLines lines;
    return static_start(c, hulls, lines).notes;
}

TEST(StaticStart, AnIrregularFrequencyInTheDataSpoilsTheMemoryAndIsNamed) {
    EXPECT_THAT(doubts(spar_data(), 0.5), Not(Contains(HasSubstr("oscillators miss"))));
    HydroData irregular = spar_data();
    const std::size_t at = irregular.frequencies.size() / 2;
    irregular.damping[at](2, 2) *= -20;
    irregular.added_mass[at](2, 2) *= 1.5;
    EXPECT_THAT(doubts(irregular, 0.5),
                Contains(HasSubstr(
                    fmt::format("most in heave at {:.4g} rad/s", irregular.frequencies[at]))));
}

TEST(StaticStart, APlatformStepAboveASixthOfANaturalPeriodIsNamed) {
    EXPECT_THAT(doubts(spar_data(), 1.0), Not(Contains(HasSubstr("is long for the natural"))));
    EXPECT_THAT(doubts(spar_data(), 8.0),
                Contains(ContainsRegex("step of 8 s is long for the natural period in heave of "
                                       "[0-9.]+ s: the scheme adds [0-9.]+ % of critical")));
}

}  // namespace
}  // namespace hawser::master
