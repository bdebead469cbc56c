// Physical dimensions of the case file's quantities. A dimension is the exponents of mass, length,
// time and plane angle; inside the program every quantity is in SI and radians.
#pragma once

#include <array>
#include <string_view>

namespace hawser {

struct Dimension {
    std::string_view name;         ///< for messages: "mass"
    std::array<int, 4> exponents;  ///< of mass, length, time, angle
    std::string_view unit;         ///< SI unit, as printed; empty for a pure number
    std::string_view example;      ///< for messages: "103800 t"
    bool unit_required = false;    ///< compounds with an angle, where radians could be mistaken

    constexpr bool operator==(const Dimension& other) const { return name == other.name; }
};

namespace dimension {

inline constexpr Dimension number{"pure number", {0, 0, 0, 0}, "", "1.2"};
inline constexpr Dimension length{"length", {0, 1, 0, 0}, "m", "1500 m"};
inline constexpr Dimension area{"area", {0, 2, 0, 0}, "m2", "900 m2"};
inline constexpr Dimension volume{"volume", {0, 3, 0, 0}, "m3", "0.5 m3"};
inline constexpr Dimension time{"time", {0, 0, 1, 0}, "s", "0.5 s"};
inline constexpr Dimension mass{"mass", {1, 0, 0, 0}, "kg", "103800 t"};
inline constexpr Dimension mass_per_length{"mass per length", {1, -1, 0, 0}, "kg/m", "589 kg/m"};
inline constexpr Dimension density{"density", {1, -3, 0, 0}, "kg/m3", "1025 kg/m3"};
inline constexpr Dimension force{"force", {1, 1, -2, 0}, "N", "5338 kN"};
inline constexpr Dimension stress{"stress", {1, -1, -2, 0}, "Pa", "207 GPa"};
inline constexpr Dimension angle{"angle", {0, 0, 0, 1}, "deg", "10 deg"};
inline constexpr Dimension speed{"speed", {0, 1, -1, 0}, "m/s", "1.9 m/s"};
inline constexpr Dimension acceleration{"acceleration", {0, 1, -2, 0}, "m/s2", "9.80665 m/s2"};
inline constexpr Dimension frequency{"frequency", {0, 0, -1, 1}, "rad/s", "0.4 rad/s"};
inline constexpr Dimension wave_density{
    "spectral density of waves", {0, 2, 1, -1}, "m2.s/rad", "12 m2.s/rad"};
inline constexpr Dimension angular_speed{
    "angular speed", {0, 0, -1, 1}, "rad/s", "0.5 deg/s", true};
inline constexpr Dimension stiffness{"stiffness", {1, 0, -2, 0}, "N/m", "147 kN/m"};
inline constexpr Dimension damping{"damping", {1, 0, -1, 0}, "N.s/m", "20 kN.s/m"};
inline constexpr Dimension axial_damping{"force per strain rate", {1, 1, -1, 0}, "N.s", "200 kN.s"};
inline constexpr Dimension bending_stiffness{
    "bending stiffness", {1, 3, -2, 0}, "N.m2", "45.9 MN.m2"};
inline constexpr Dimension bending_damping{
    "bending damping", {1, 3, -1, 0}, "N.m2.s", "10 kN.m2.s"};
inline constexpr Dimension stiffness_per_length{
    "stiffness per length", {1, -1, -2, 0}, "N/m2", "100 kN/m2"};
inline constexpr Dimension damping_per_length{
    "damping per length", {1, -1, -1, 0}, "N.s/m2", "10 kN.s/m2"};
inline constexpr Dimension moment{"moment", {1, 2, -2, 0}, "N.m", "120 kN.m"};
inline constexpr Dimension rotational_stiffness{
    "rotational stiffness", {1, 2, -2, -1}, "N.m/rad", "15 kN.m/deg", true};
inline constexpr Dimension rotational_damping{
    "rotational damping", {1, 2, -1, -1}, "N.m.s/rad", "2.0e8 N.m.s/rad", true};
inline constexpr Dimension force_per_angle{
    "force per angle", {1, 1, -2, -1}, "N/rad", "1 MN/rad", true};
inline constexpr Dimension force_per_angular_speed{
    "force per angular speed", {1, 1, -1, -1}, "N.s/rad", "1 MN.s/rad", true};
inline constexpr Dimension quadratic_damping{
    "quadratic damping", {1, -1, 0, 0}, "N.s2/m2", "200 kN.s2/m2"};
inline constexpr Dimension quadratic_cross_force{
    "force per angular speed squared", {1, 1, 0, -2}, "N.s2/rad2", "1 MN.s2/rad2", true};
inline constexpr Dimension quadratic_cross_moment{
    "moment per speed squared", {1, 0, 0, 0}, "N.s2/m", "1 MN.s2/m"};
inline constexpr Dimension quadratic_rotational_damping{
    "quadratic rotational damping", {1, 2, 0, -2}, "N.m.s2/rad2", "1e9 N.m.s2/rad2", true};
inline constexpr Dimension first_moment{"first moment of mass", {1, 1, 0, 0}, "kg.m", "1e6 kg.m"};
inline constexpr Dimension inertia{"moment of inertia", {1, 2, 0, 0}, "kg.m2", "7e11 kg.m2"};

/// The first named dimension with these exponents, empty if none has them.
std::string_view name_of(const std::array<int, 4>& exponents);

}  // namespace dimension
}  // namespace hawser
