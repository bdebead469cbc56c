// First-order potential flow about vertical cylinders on one axis by matched eigenfunctions: one
// azimuth number and one frequency at a time. Linear, inviscid, finite depth, time factor e^{+i w
// t}.
#pragma once

#include <complex>
#include <map>
#include <vector>

#include "hydro/column_modes.hpp"
#include "hydro/radial.hpp"

namespace hawser::hydro {

using Complex = std::complex<double>;

/// What the sums keep. `level` scales all three numbers at once, so that doubling it shows the
/// error.
struct Resolution {
    double level = 1.0;
    double largest_K = 0.0;  ///< omega^2 / g of the shortest wave [1/m]
};

/// The flow of one azimuth number m: heave is m = 0, surge and pitch are the two motions of m = 1.
struct AzimuthFlow {
    int motions = 0;  ///< 1 for m = 0, 2 for m = 1, none beyond
    /// integral of phi_j n_i over the hull for unit velocities, n into the water; -rho times it is
    /// A - i B / w
    Eigen::Matrix2cd force = Eigen::Matrix2cd::Zero();
    Eigen::Vector2cd radiated =
        Eigen::Vector2cd::Zero();  ///< flux of phi_j into the propagating mode
    /// The same of the wave that has the potential 1 in the propagating mode on a hull without
    /// flux.
    Eigen::Vector2cd exciting = Eigen::Vector2cd::Zero();
    Complex scattered = 0.0;
};

/// Waves outside the hull, in its propagating mode.
struct FarWaves {
    double K = 0.0, k = 0.0;   ///< omega^2 / g, wave number [1/m]
    double radius = 0.0;       ///< where the outer column begins [m]
    double at_surface = 0.0;   ///< Z_0(0) [m^-1/2]
    double group_ratio = 0.0;  ///< group over phase velocity
};

/// H_m(x) / H_m'(x) of outgoing waves, H_m = J_m - i Y_m.
Complex outgoing_ratio(int m, double x);

class CylinderFlow {
 public:
    /// The hull has no problems_of.
    CylinderFlow(const Hull& hull, Resolution resolution);

    /// At most two azimuth numbers at infinite_frequency: 0 and 1. H:7.
    AzimuthFlow solve(int m, double K);
    FarWaves far_waves(double K);

    /// Of all openings together, and of the outer column before the tail.
    [[nodiscard]] int functions() const { return functions_; }
    [[nodiscard]] int outer_modes() const { return heads_.back(); }

 private:
    /// Contributions to the matrix, the right sides and the force that needs no solution.
    struct Sums {
        Eigen::MatrixXd A, rhs;
        Eigen::Matrix2d direct = Eigen::Matrix2d::Zero();
    };
    /// A column's modes with what projects on them.
    struct Projected {
        ColumnModes modes;
        Eigen::MatrixXd outer, inner;  ///< functions x modes
        Eigen::MatrixX2d walls;
    };
    [[nodiscard]] Projected projected(std::size_t column, ColumnModes modes, bool odd) const;
    [[nodiscard]] Sums empty() const;
    void add(std::size_t column, const Projected& p, const Radial& r, int m, bool matrix,
             Sums& sums) const;
    void add_lids(std::size_t column, double K, int m, Eigen::Matrix2d& direct) const;
    void add_tails();
    void add_tail(bool surface, int m, Sums& sums) const;
    void add_infinite_surface(std::size_t column, int m, Sums& sums) const;
    const Sums& closed(int m);
    const std::vector<Projected>& surface_columns(double K);

    Partition water_;
    std::vector<int> count_, offset_;  ///< functions of each opening, where they begin
    std::vector<int> heads_, ends_;    ///< modes of each column: exact, and with the tail
    std::vector<int> constants_;       ///< unknown of a closed column's constant mode, or -1
    int functions_ = 0, unknowns_ = 0;
    Sums tail_[2][2];  ///< of closed and surface columns, for m = 0 and 1
    std::vector<Projected> closed_columns_;
    std::map<int, Sums> closed_;  ///< closed columns by m
    double K_ = -1.0;
    std::vector<Projected> surface_;
};

}  // namespace hawser::hydro
