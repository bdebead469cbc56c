// Validation row A23: stresses of a pipe under tension, moment and pressures, Lame's thick wall
// with the true wall force; and row A22a's stress as the results tell it.
#include <gtest/gtest.h>

#include <cmath>

#include "rod/recovered.hpp"
#include "validation/row.hpp"
#include "worker/rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// 324 x 20 mm of steel.
LineType pipe() {
    LineType type =
        plain_type(144.680, 2.07e11 * M_PI / 4 * (0.324 * 0.324 - 0.284 * 0.284), 4.58729e7);
    type.category = "pipe";
    type.outer_diameter = 0.324;
    type.wall = PipeWall{.outer_diameter = 0.324, .inner_diameter = 0.284};
    return type;
}

TEST(ValidationA23, StressesOfAPipe) {
    const Case input = one_line(pipe(), 10, 1, fixed_at({0, 0, 0}), LineEnd{});
    const StressSection<double> of = stress_section(input, input.lines[0], 5.0, true);
    const StressSection<Single> s{of.area,          of.inner_radius,  of.outer_radius,
                                  of.second_moment, of.concentration, of.contents_weight,
                                  of.yield,         of.breaking_load, of.no_wall};
    struct Row {
        double p_i, p_o, moment, wall, von_mises;
        const char *wall_is, *von_mises_is;
    };
    for (const Row row :
         {Row{0, 0, 50e3, 500, 62.728, "true wall force, no pressure [kN]",
              "von Mises, no pressure [MPa]"},
          Row{20e6, 15.1e6, 50e3, 521.98, 68.783, "true wall force, 20 and 15.1 MPa [kN]",
              "von Mises, 20 and 15.1 MPa [MPa]"},
          Row{0, 15.1e6, 50e3, -744.96, 127.018, "true wall force, 0 and 15.1 MPa [kN]",
              "von Mises, 0 and 15.1 MPa [MPa]"},
          Row{0, 0, 0, 500, 26.177, "true wall force, no moment [kN]",
              "von Mises, no moment [MPa]"}}) {
        const Single wall = wall_force<Single>(s, 500e3, row.p_i, row.p_o);
        const Stresses<Single> got = stresses<Single>(s, wall, row.moment, row.p_i, row.p_o);
        validate({"A23", row.wall_is, row.wall, wall[0] / 1e3, 1e-4});
        validate({"A23", row.von_mises_is, row.von_mises, got.von_mises[0] / 1e6, 1e-4});
    }
}

}  // namespace
}  // namespace hawser::worker
