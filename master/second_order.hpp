// Second-order wave forces at difference and sum frequencies from full quadratic transfer functions
// (QTFs): K:11, K:12. Waves at the slow position, as for the mean drift. No wave-drift damping.
#pragma once

#include "component_table.hpp"

namespace hawser::master {

/// All pairs of the sea's components at once, from sums over single components alone. With Q
/// interpolated between the file's frequencies w_g by the same cubic L_g in both arguments,
///
///     K:11  sum_m sum_n z_m conj(z_n) Q(w_m, w_n) = sum_g sum_h Z_g conj(Z_h) Q(w_g, w_h)
///     K:12  sum_m sum_n z_m      z_n  Q(w_m, w_n) = sum_g sum_h Z_g      Z_h  Q(w_g, w_h)
///     Z_g = sum_m L_g(w_m) z_m,    z_m = a_m e^{i phi_m}
///
/// without any approximation: the number of components does not count, nothing is precomputed for
/// a position, and the phases are those of the moment.
///
/// Waves of several headings: with the file's own functions of unequal headings where it has all of
/// them, interpolated in both; else Q(b_m, b_n) = (Q(b_m, b_m) + Q(b_n, b_n)) / 2. Waves of one
/// heading need equal headings only.
///
/// Not for use by several threads at once: the loads share workspaces.
class QuadraticLoad {
 public:
    enum class Of { differences, sums };

    QuadraticLoad() = default;
    /// Pairs that the file does not have are zero. Throws RunError (input) if more than 1 % of the
    /// waves' energy lies beyond the file's frequencies, or a wave comes from a heading outside.
    QuadraticLoad(const Qtf& qtf, Of of, const std::vector<WaveComponent>& components);

    /// Force and moment about O on world axes [N, N.m], without the ramp.
    /// @param phases  WavePhases at the slow position, whose yaw is given
    [[nodiscard]] Vec6 load(const std::vector<Complex>& phases, double yaw) const;

    /// Re Q(w, w, b, b), interpolated in frequency as above, at the frequencies of the sea: what a
    /// component does to itself, of differences the mean drift [N/m2, N.m/m2].
    [[nodiscard]] WaveTable<Vec6> diagonal() const;

    [[nodiscard]] bool empty() const { return blocks_.empty(); }
    /// Does it use the file's functions of unequal headings?
    [[nodiscard]] bool crosses_headings() const { return crosses_; }

 private:
    using Modes = Eigen::Array<double, 8, 1>;  ///< six, and two of filling
    struct Coefficient {
        Modes re = Modes::Zero(), im = Modes::Zero();
    };
    /// Q of two headings, g by g: of equal ones h <= g only, the rest follows from symmetry.
    struct Block {
        std::size_t first = 0, second = 0;
        std::vector<Coefficient> Q;
    };
    struct FrequencyWeights {
        std::array<std::size_t, 4> index{};
        std::array<double, 4> weight{};
    };
    using Spectrum = std::vector<Complex>;

    void find_frequencies(const std::vector<double>& file, std::size_t& first);
    void add_block(const Qtf& qtf, std::size_t first_frequency, std::size_t i, std::size_t j);
    [[nodiscard]] Vec6 equal_headings(const Block& block, const Spectrum& a,
                                      const Spectrum& b) const;
    [[nodiscard]] Vec6 unequal_headings(const Block& block, const Spectrum& a,
                                        const Spectrum& b) const;

    Of of_ = Of::differences;
    bool full_circle_ = false, crosses_ = false;
    std::vector<double> headings_;           ///< of the file, ordered
    std::vector<Block> blocks_;              ///< first one per heading, then those of unequal ones
    std::size_t n_ = 0;                      ///< frequencies of the file that the sea touches
    std::vector<double> omega_;              ///< per component
    std::vector<FrequencyWeights> weights_;  ///< per component
    std::vector<double> directions_;         ///< different headings of the sea
    std::vector<std::size_t> direction_;     ///< which of them, per component
    mutable std::vector<Spectrum> by_direction_, by_heading_;  ///< workspaces: Z
    mutable Spectrum total_;
    mutable std::vector<char> used_;
};

}  // namespace hawser::master
