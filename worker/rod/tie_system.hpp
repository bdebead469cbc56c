// Rods tied to each other: what a tie brings into the elimination of each of its two rods, and the
// small system that joins them, R:46.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rod/vector3.hpp"

namespace hawser::worker {

/// A tie of a group: constraint of the rods of `pack` that acts on a place on those of
/// `other_pack`, whose constraint `mirror` takes the opposite force.
struct Tie {
    std::size_t pack = 0, constraint = 0, other_pack = 0, mirror = 0;
};

/// One side of a tie in the elimination of its rod: the columns Z = A Q, with the weights A of its
/// point and the tie's stiffness Q Q^T, carried along from end B as R is (R:24).
template <class V>
struct TieSide {
    /// Columns of a node: rows r, r', lambda.
    struct Columns {
        V x[7][3];
    };
    std::size_t pack = 0, constraint = 0;
    std::size_t first = 0;   ///< the first node, of any lane, that has an entry
    V Q[3][3];               ///< [sqrt(N/m)]
    std::vector<Columns> z;  ///< L^-1 Z of every node but that at end A
    Columns last;            ///< what has reached that node
    V reaction[3][3];        ///< rows of a prescribed end B
};

/// What joins the stiffness of tied rods about the platform, of one lane of a pack: for its sides
/// C = Z^T J^-1 Z and G = Z^T J^-1 K, K the border of R:22 and R:23.
template <class V>
struct TieBorder {
    std::vector<const TieSide<V>*> sides;
    Eigen::MatrixXd C, G;
};

/// (P - C) x' = x0 for all sides of all ties, R:46: C = Z^T J^-1 Z within each rod, P changes the
/// two sides of every tie. Symmetric; in sums and differences of the two sides of each tie
/// quasi-definite, so that it is factorised without pivoting.
template <class V>
class TieSystem {
 public:
    void resize(std::size_t ties) {
        ties_ = ties;
        const std::size_t n = rows();
        C_.assign(n * n, V(0.0));
        H_.assign(n * n, V(0.0));
        x0_.assign(n, V(0.0));
        y_.assign(n, V(0.0));
    }
    /// Sides are numbered 2 t and 2 t + 1 of tie t, three rows each.
    [[nodiscard]] std::size_t rows() const { return 6 * ties_; }
    V& C(std::size_t row, std::size_t column) { return C_[row * rows() + column]; }
    [[nodiscard]] const V& C(std::size_t row, std::size_t column) const {
        return C_[row * rows() + column];
    }
    V& x0(std::size_t row) { return x0_[row]; }
    /// x' of a row, after solve().
    [[nodiscard]] V x(std::size_t row) const {
        const std::size_t t = row / 6, i = row % 3, half = rows() / 2;
        const V sum = y_[3 * t + i], difference = y_[half + 3 * t + i];
        return row % 6 < 3 ? sum + difference : sum - difference;
    }
    void solve();

 private:
    std::size_t ties_ = 0;
    std::vector<V> C_, H_, x0_, y_;
};

template <class V>
void TieSystem<V>::solve() {
    const std::size_t n = rows(), half = n / 2;
    // With s = (x'_i + x'_j)/2, a = (x'_i - x'_j)/2 of each tie, P is 1 and -1
    for (std::size_t r = 0; r < half; ++r) {
        const std::size_t ri = 6 * (r / 3) + r % 3, rj = ri + 3;
        y_[r] = V(0.5) * (x0_[ri] + x0_[rj]);
        y_[half + r] = V(0.5) * (x0_[ri] - x0_[rj]);
        for (std::size_t c = 0; c < half; ++c) {
            const std::size_t ci = 6 * (c / 3) + c % 3, cj = ci + 3;
            const V one(r == c ? 1.0 : 0.0);
            const V ii = C(ri, ci), ij = C(ri, cj), ji = C(rj, ci), jj = C(rj, cj);
            H_[r * n + c] = one - V(0.5) * ((ii + jj) + (ij + ji));
            H_[(half + r) * n + c] = V(-0.5) * ((ii - jj) + (ij - ji));
            H_[(half + r) * n + half + c] = V(0.0) - one - V(0.5) * ((ii + jj) - (ij + ji));
        }
    }
    // L D L^T of the lower triangle, in place: the pivots stay on the diagonal
    for (std::size_t j = 0; j < n; ++j) {
        const V inverse = V(1.0) / H_[j * n + j];
        for (std::size_t i = j + 1; i < n; ++i) {
            const V l = H_[i * n + j] * inverse;
            for (std::size_t k = j + 1; k <= i; ++k) H_[i * n + k] -= l * H_[k * n + j];
            y_[i] -= l * y_[j];
        }
        for (std::size_t i = j + 1; i < n; ++i) H_[i * n + j] = H_[i * n + j] * inverse;
    }
    for (std::size_t j = n; j-- > 0;) {
        V sum = y_[j] / H_[j * n + j];
        for (std::size_t i = j + 1; i < n; ++i) sum -= H_[i * n + j] * y_[i];
        y_[j] = sum;
    }
}

}  // namespace hawser::worker
