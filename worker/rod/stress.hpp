// Stress in a line's section, R:38: the wall of a pipe under tension, bending and the pressures
// inside and outside; chain and rope by their nominal area. No torsion, no shear.
#pragma once

#include "case/case.hpp"
#include "rod/vector3.hpp"

namespace hawser::worker {

/// What of a section carries stress. Chain and rope have an area only: no radii, no bending stress.
/// A section of unknown make (category general) has no stress: its area is NaN.
template <class V>
struct StressSection {
    V area;                        ///< A_s [m2]
    V inner_radius, outer_radius;  ///< R_i, R_o of the wall that is left [m]
    V second_moment;               ///< I [m4]; 1 without a wall
    V concentration;               ///< factor on axial and bending stress
    V contents_weight;             ///< of what is inside, per volume [N/m3]
    V yield, breaking_load;        ///< [Pa], [N]; NaN where not given
    V no_wall;                     ///< 0 for a pipe, else NaN
};

/// Section of a line at an arc length from end A [m]; at a joint of two sections `next` chooses the
/// one that begins there. In a taper all of it runs
/// linearly, yield and breaking load too.
///
///     pipe: R_i = R_o - thickness_factor (wall thickness), A_s = pi (R_o^2 - R_i^2), I = pi/4
///     (R_o^4 - R_i^4) chain: A_s = 2 pi/4 d^2 (two legs of a link);  rope, wire: A_s = pi/4 d^2, d
///     nominal
StressSection<double> stress_section(const Case& input, const Line& line, double arc_length,
                                     bool next);

/// T_wall = T_eff + p_i A_i - p_o A_o; without a wall the effective tension. [N], [Pa]
template <class V>
[[gnu::always_inline]] inline V wall_force(const StressSection<V>& s, V effective_tension, V p_i,
                                           V p_o) {
    return effective_tension + V(M_PI) * (p_i * s.inner_radius * s.inner_radius -
                                          p_o * s.outer_radius * s.outer_radius);
}

template <class V>
struct Stresses {
    V axial, bending, von_mises;  ///< [Pa]
};

/// R:38  the largest von Mises stress of four points, R in {R_i, R_o} at both extremes of bending.
///
///     sig_a = c (T_wall/A_s +- M R/I)      sig_h, sig_r: Lame with p_i, p_o
///     sig_vm^2 = ((sig_a - sig_h)^2 + (sig_h - sig_r)^2 + (sig_r - sig_a)^2)/2
///
/// @param wall  force in the wall [N]  @param moment  [N.m], not negative
template <class V>
[[gnu::always_inline]] inline Stresses<V> stresses(const StressSection<V>& s, V wall, V moment,
                                                   V p_i, V p_o) {
    const V ri2 = s.inner_radius * s.inner_radius, ro2 = s.outer_radius * s.outer_radius;
    const V thick = ro2 - ri2;
    const V inverse = select(thick > V(0.0), V(1.0) / thick, V(0.0));
    const V k =
        (p_i * ri2 - p_o * ro2) * inverse;  // Lame: sig = k -+ (p_i - p_o) ri2 ro2/(thick R^2)
    const V at_inner = (p_i - p_o) * ro2 * inverse, at_outer = (p_i - p_o) * ri2 * inverse;
    const V axial = s.concentration * wall / s.area;
    const V per_radius = s.concentration * moment / s.second_moment;
    const auto square = [&](V a, V lame) {
        const V h = k + lame, r = k - lame;
        return V(0.5) * ((a - h) * (a - h) + (h - r) * (h - r) + (r - a) * (r - a));
    };
    const V inner = per_radius * s.inner_radius, outer = per_radius * s.outer_radius;
    const V largest = max(max(square(axial + inner, at_inner), square(axial - inner, at_inner)),
                          max(square(axial + outer, at_outer), square(axial - outer, at_outer)));
    return {axial, outer, sqrt(largest)};
}

}  // namespace hawser::worker
