// What is recorded along a line, at its ends, at places and over the arc: names, units and words of
// the quantities that a rod's state gives (R:37, R:38).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hawser {

enum class LineQuantity {
    effective_tension,
    wall_tension,
    axial_strain,
    curvature,
    bend_moment,
    shear_force,
    axial_stress,
    bending_stress,
    von_mises_stress,
    yield_utilisation,
    load_utilisation,
    seabed_force,
    declination,
    azimuth,
    x,
    y,
    z,
    vx,
    vy,
    vz,
};

struct LineQuantityWords {
    const char* name;
    const char* units;
    const char* description;
};

/// In the order of the enumeration. Results are SI, with angles in degrees.
inline constexpr std::array<LineQuantityWords, 20> line_quantities{{
    {"effective_tension", "N", "Effective tension"},
    {"wall_tension", "N", "Tension in the wall of a pipe: effective + p_i A_i - p_o A_o"},
    {"axial_strain", "1", "Axial strain, creep included"},
    {"curvature", "1/m", "Curvature"},
    {"bend_moment", "N.m", "Bending moment"},
    {"shear_force", "N", "Shear force"},
    {"axial_stress", "Pa", "Axial stress without bending"},
    {"bending_stress", "Pa", "Bending stress at the outer radius"},
    {"von_mises_stress", "Pa", "Von Mises stress, the largest across the wall"},
    {"yield_utilisation", "1", "Von Mises stress over yield"},
    {"load_utilisation", "1", "Effective tension over breaking load"},
    {"seabed_force", "N/m", "Normal force of the seabed per unstretched length"},
    {"declination", "deg", "Angle from vertical down of the tangent towards end B"},
    {"azimuth", "deg", "Angle from +x, counter-clockwise from above, of the tangent towards end B"},
    {"x", "m", "Position, world axes: x"},
    {"y", "m", "Position, world axes: y"},
    {"z", "m", "Position, world axes: z"},
    {"vx", "m/s", "Velocity, world axes: x"},
    {"vy", "m/s", "Velocity, world axes: y"},
    {"vz", "m/s", "Velocity, world axes: z"},
}};
inline constexpr std::size_t n_line_quantities = line_quantities.size();

[[nodiscard]] constexpr std::size_t index_of(LineQuantity q) { return static_cast<std::size_t>(q); }
[[nodiscard]] constexpr const LineQuantityWords& words_of(LineQuantity q) {
    return line_quantities[index_of(q)];
}

}  // namespace hawser
