// Eigenfunctions of one water column over its height: orthonormal cosines between floor and ceiling
// (H:2) or under a free surface (H:3). Linear potential flow, finite depth.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "hydro/cylinder_shape.hpp"

namespace hawser::hydro {

/// Z_j(z) = c_j cos k_j (z - low), or mode 0 of a surface column c_0 cosh k (z - low) / cosh kH,
/// with integral of Z_j^2 over the height 1.
struct ColumnModes {
    enum class First { decaying, constant, propagating };
    Span z;
    First first = First::decaying;     ///< what mode 0 is
    Eigen::ArrayXd k, c, top, bottom;  ///< wave number [1/m], c, Z at ceiling and floor [m^-1/2]

    [[nodiscard]] Eigen::Index size() const { return k.size(); }
    /// Z'' = -s Z: s = k^2, for the propagating mode -k^2.
    [[nodiscard]] double curvature(Eigen::Index j) const {
        return j == 0 && first == First::propagating ? -k[j] * k[j] : k[j] * k[j];
    }
};

/// omega^2 / g of no waves at all: the surface is held at zero potential.
constexpr double infinite_frequency = std::numeric_limits<double>::infinity();

/// H:2, number begin to end - 1: k_l = l pi / H.
ColumnModes closed_modes(Span z, int begin, int end);

/// H:3, number 0 (propagating) to end - 1:
///
///     K = k tanh kH,  K = -k_j tan k_j H,  K = omega^2 / g
///
/// At infinite_frequency there is no propagating mode: k_j = (j - 1/2) pi / H, j = begin .. end
/// - 1.
ColumnModes surface_modes(Span z, double K, int end, int begin = 1);

/// Integrals of Z_j and of z Z_j over part of the height, shape modes x 2.
Eigen::MatrixX2d wall_moments(const ColumnModes& modes, Span wall);

}  // namespace hawser::hydro
