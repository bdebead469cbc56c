// Sine, cosine and exponential of N lanes at once: range reduction and Taylor polynomials, no
// tables, no branches. Error below 1e-13 (absolute for sin and cos, relative for exp), every lane
// computed alone. Valid for |x| < 1e6 (sin, cos) and for x within +-700 (exp, clamped there).
#pragma once

#include <array>
#include <numbers>

#include "lanes.hpp"

namespace hawser {

template <int N>
struct SinCos {
    Lanes<N> sin, cos;
};

namespace detail {

/// Adding this number to |x| < 2^51 leaves round(x) in the low bits of the sum's significand.
inline constexpr double rounding_shift = 6755399441055744.0;  // 1.5 * 2^52

/// 1/n!
consteval double inverse_factorial(int n) {
    double product = 1.0;
    for (int i = 2; i <= n; ++i) product *= i;
    return 1.0 / product;
}

/// pi/2 as three numbers, the first two of 33 significant bits: n times them is exact for n < 2^20.
inline constexpr std::array<double, 3> half_pi = {0x1.921fb544p+0, 0x1.0b4611a6p-34,
                                                  0x1.3198a2e037073p-69};
/// ln 2 as two numbers, the first of 33 significant bits.
inline constexpr std::array<double, 2> ln_2 = {0x1.62e42fee00000p-1, 0x1.a39ef35793c76p-33};

}  // namespace detail

/// sin x and cos x of every lane. With n = round(2x/pi) and r = x - n pi/2, |r| <= pi/4, the Taylor
/// series of sin r (to r^15) and cos r (to r^14) are exchanged and signed by n mod 4.
template <int N>
[[gnu::always_inline]] inline SinCos<N> sincos(Lanes<N> x) {
    using Real = typename Lanes<N>::Raw;
    using Integer = typename LaneMask<N>::Raw;
    using detail::inverse_factorial;

    const Real shifted = x.v * (2.0 / std::numbers::pi) + detail::rounding_shift;
    const Integer quadrant = (Integer)shifted;
    const Real n = shifted - detail::rounding_shift;
    Real r = x.v - n * detail::half_pi[0];
    r = r - n * detail::half_pi[1];
    r = r - n * detail::half_pi[2];

    const Real q = r * r;
    Real s = Real{} - inverse_factorial(15);
    s = s * q + inverse_factorial(13);
    s = s * q - inverse_factorial(11);
    s = s * q + inverse_factorial(9);
    s = s * q - inverse_factorial(7);
    s = s * q + inverse_factorial(5);
    s = s * q - inverse_factorial(3);
    s = (s * q) * r + r;
    Real c = Real{} - inverse_factorial(14);
    c = c * q + inverse_factorial(12);
    c = c * q - inverse_factorial(10);
    c = c * q + inverse_factorial(8);
    c = c * q - inverse_factorial(6);
    c = c * q + inverse_factorial(4);
    c = c * q - inverse_factorial(2);
    c = c * q + 1.0;

    const auto odd = (quadrant & 1) != 0;
    const Real sine = odd ? c : s;
    const Real cosine = odd ? s : c;
    return {Lanes<N>((quadrant & 2) != 0 ? -sine : sine),
            Lanes<N>(((quadrant + 1) & 2) != 0 ? -cosine : cosine)};
}

/// e^x of every lane, x clamped to +-700. With n = round(x/ln 2) and r = x - n ln 2 it is 2^n times
/// the Taylor series of e^r to r^12, |r| <= ln(2)/2.
template <int N>
[[gnu::always_inline]] inline Lanes<N> exp(Lanes<N> x) {
    using Real = typename Lanes<N>::Raw;
    using Integer = typename LaneMask<N>::Raw;
    using detail::inverse_factorial;

    const Real clamped = min(Lanes<N>(700.0), max(Lanes<N>(-700.0), x)).v;  // lets NaN through
    const Real shifted = clamped * std::numbers::log2e + detail::rounding_shift;
    const Real n = shifted - detail::rounding_shift;
    Real r = clamped - n * detail::ln_2[0];
    r = r - n * detail::ln_2[1];

    Real e = Real{} + inverse_factorial(12);
    e = e * r + inverse_factorial(11);
    e = e * r + inverse_factorial(10);
    e = e * r + inverse_factorial(9);
    e = e * r + inverse_factorial(8);
    e = e * r + inverse_factorial(7);
    e = e * r + inverse_factorial(6);
    e = e * r + inverse_factorial(5);
    e = e * r + inverse_factorial(4);
    e = e * r + inverse_factorial(3);
    e = e * r + inverse_factorial(2);
    e = e * r + 1.0;
    e = e * r + 1.0;
    const Integer power = ((Integer)shifted + 1023) << 52;  // 2^n: n moved into the exponent
    return Lanes<N>(e * (Real)power);
}

/// Sum of the lanes, always in the same order.
template <int N>
[[gnu::always_inline]] inline double sum(Lanes<N> a) {
    double total = 0.0;
    for (int i = 0; i < N; ++i) total += a.v[i];
    return total;
}

}  // namespace hawser
