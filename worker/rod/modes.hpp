// Natural modes of a rod about its static solution: the lowest eigenvalues of R:43.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "resting_lines.hpp"
#include "rod/rod_pack.hpp"
#include "rod/small_motion.hpp"

namespace hawser::worker {

/// The lowest modes of J x = omega^2 M x by subspace iteration; x has M-norm 1. Throws RunError
/// where J + 1e-6 M is singular or the frequencies do not settle to a millionth.
struct Eigenmodes {
    Eigen::VectorXd omega_squared;  ///< ascending
    Eigen::MatrixXd shapes;         ///< a column each
};
Eigenmodes lowest_modes(const SmallMotion& motion, int count);

/// The same with what people want to know of the shapes. In plane: the vertical plane through both
/// ends (of a vertical rod through its azimuth). Modes of equal frequency are turned so that one of
/// them moves in that plane.
template <class V>
std::vector<RodMode> rod_modes(RodPack<V>& pack, int lane, const Case& input, int count);

}  // namespace hawser::worker
