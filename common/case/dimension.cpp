#include "case/dimension.hpp"

namespace hawser::dimension {

std::string_view name_of(const std::array<int, 4>& exponents) {
    static constexpr std::array named{
        number,
        length,
        area,
        volume,
        time,
        mass,
        mass_per_length,
        density,
        force,
        stress,
        angle,
        speed,
        acceleration,
        frequency,
        stiffness,
        damping,
        axial_damping,
        bending_stiffness,
        bending_damping,
        damping_per_length,
        moment,
        rotational_stiffness,
        force_per_angle,
        force_per_angular_speed,
        first_moment,
        rotational_damping,
        inertia,
        quadratic_rotational_damping,
    };
    for (const Dimension& d : named) {
        if (d.exponents == exponents) return d.name;
    }
    return {};
}

}  // namespace hawser::dimension
