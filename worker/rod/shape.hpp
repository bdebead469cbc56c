// Shape functions of the rod element and their exact integrals: R:7, R:8. Slopes are scaled with
// the element length (L r') inside an element, so everything here is a constant.
#pragma once

#include <array>

namespace hawser::worker {

/// Four-point Gauss rule on [0, 1].
inline constexpr int gauss_points = 4;
inline constexpr std::array<double, gauss_points> gauss_xi = {
    0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
inline constexpr std::array<double, gauss_points> gauss_weight = {
    0.17392742256872692, 0.32607257743127308, 0.32607257743127308, 0.17392742256872692};

/// Hermite functions A1 ... A4 of r_a, L r'_a, r_b, L r'_b at x, R:7.
constexpr std::array<double, 4> hermite(double x) {
    return {1 - 3 * x * x + 2 * x * x * x, x - 2 * x * x + x * x * x, 3 * x * x - 2 * x * x * x,
            x * x * x - x * x};
}
/// Derivatives a_i' of a = (A3, A2, A4): dr/dxi = a_i' q_i with q = (r_b - r_a, L r'_a, L r'_b),
/// R:8.
constexpr std::array<double, 3> reduced_slope(double x) {
    return {6 * x - 6 * x * x, 1 - 4 * x + 3 * x * x, 3 * x * x - 2 * x};
}
/// Second derivatives a_i''.
constexpr std::array<double, 3> reduced_curvature(double x) {
    return {6 - 12 * x, -4 + 6 * x, 6 * x - 2};
}
/// Quadratic functions P1 ... P3 of lambda at x = 0, 1/2, 1, R:7.
constexpr std::array<double, 3> quadratic(double x) {
    return {1 - 3 * x + 2 * x * x, 4 * x * (1 - x), 2 * x * x - x};
}

struct ShapeTables {
    std::array<std::array<std::array<double, 3>, 3>, 3> alpha{};  ///< int a_i' a_k' P_m
    std::array<std::array<double, 3>, 3> beta{};                  ///< int a_i'' a_k''
    std::array<std::array<double, 4>, gauss_points> A{};          ///< hermite at the Gauss points
    std::array<std::array<double, 3>, gauss_points> slope{};
    std::array<std::array<double, 3>, gauss_points> P{};
};

/// All tables; the four-point rule is exact for the integrands (degree 6 and below).
constexpr ShapeTables make_shape_tables() {
    ShapeTables t;
    for (std::size_t g = 0; g < gauss_points; ++g) {
        const double x = gauss_xi[g], w = gauss_weight[g];
        t.A[g] = hermite(x);
        t.slope[g] = reduced_slope(x);
        t.P[g] = quadratic(x);
        const auto c = reduced_curvature(x);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                t.beta[i][k] += w * c[i] * c[k];
                for (std::size_t m = 0; m < 3; ++m)
                    t.alpha[i][k][m] += w * t.slope[g][i] * t.slope[g][k] * t.P[g][m];
            }
        }
    }
    return t;
}

inline constexpr ShapeTables shape = make_shape_tables();

/// A_i(xi) of r_a, r'_a, r_b, r'_b, and their derivatives w_i in arc length: r = A_i q_i, r' = w_i
/// q_i with q = (r_a, r'_a, r_b, r'_b).
template <class V>
struct PointShape {
    V A[4], w[4];
    PointShape(V x, V L) {
        const V x2 = x * x, x3 = x2 * x;
        A[0] = V(1.0) - V(3.0) * x2 + V(2.0) * x3;
        A[1] = L * (x - V(2.0) * x2 + x3);
        A[2] = V(3.0) * x2 - V(2.0) * x3;
        A[3] = L * (x3 - x2);
        w[2] = V(6.0) * (x - x2) / L;
        w[0] = -w[2];
        w[1] = V(1.0) - V(4.0) * x + V(3.0) * x2;
        w[3] = V(3.0) * x2 - V(2.0) * x;
    }
};

}  // namespace hawser::worker
