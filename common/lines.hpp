// The seam between the platform and its lines: one order down, one reply up. These structs are the
// whole contract between master and worker, in one process as across ranks (README.md, "four
// steps").
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "frames.hpp"
#include "status.hpp"

namespace hawser {

/// Platforms in one case, and how many of them one line may touch.
inline constexpr int most_platforms = 4, most_touched = 2;

/// Of several platforms in one case: one value each.
template <class T>
using PerPlatform = std::array<T, static_cast<std::size_t>(most_platforms)>;

/// What the platform asks of the lines.
enum class Ask : int {
    run_to,       ///< run a pass of the rods from their kept state at t0 to t1 (P:3)
    equilibrium,  ///< static solution with the platform at `to`; replies the stiffness too
    impedance,    ///< undamped harmonic motion about the last equilibrium; replies the dynamic
                  ///< stiffness at `frequency`, the lines' inertia in it (R:44)
    stop,         ///< nothing more to do; flags are still carried out
};

/// One order. The flags are carried out first, in the order they stand here; then comes the ask.
/// Sent as bytes by MPI_Bcast: trivially copyable.
struct Order {
    Ask ask = Ask::stop;
    bool keep_previous = false;  ///< the pass that ended last becomes the rods' kept state
    bool sample = false;         ///< sample the kept state (time t0) for the results
    bool snapshot = false;       ///< sample node positions too
    bool write_segment = false;  ///< all ranks write what they have sampled (collective)
    bool current = true;         ///< equilibrium: with (true) or without current
    double t0 = 0.0, t1 = 0.0;   ///< [s]
    double frequency = 0.0;      ///< impedance: angular [rad/s]
    /// The platforms at t0 and t1; the spline P:5 lies between.
    PerPlatform<PlatformMotion> from{}, to{};
};

/// Of a line between two platforms: what it does to the second, with the second's O.
struct SecondLoad {
    int platform = -1;  ///< -1: the line touches one platform
    Vec6 wrench = Vec6::Zero();
    /// -d(wrench)/d(motion): of the second on the second, the second on the first, the first on the
    /// second; equilibrium, impedance
    Mat6 stiffness = Mat6::Zero(), on_first = Mat6::Zero(), of_first = Mat6::Zero();
};

/// Load of one line on a platform: force [N] and moment about O [N.m] on world axes, at t1.
struct LineLoad {
    int platform = 0;  ///< index in the case
    Vec6 wrench = Vec6::Zero();
    double end_tension = 0.0;       ///< effective tension at end A [N], for the progress line
    double impulse_mismatch = 0.0;  ///< largest of the line's constraints so far, R:40
    int mismatch_at = -1;           ///< and which, index into Line::constraints; -1: none
    Mat6 stiffness =
        Mat6::Zero();  ///< -d(wrench)/d(position, rotation vector); equilibrium, impedance
    SecondLoad second = {};

    /// On platform k; null where the line does not touch it.
    [[nodiscard]] const Vec6* on(int k) const {
        return platform == k ? &wrench : second.platform == k ? &second.wrench : nullptr;
    }
    /// Part of the stiffness in the rows of platform `row` for motions of platform `column`; null
    /// where there is none.
    [[nodiscard]] const Mat6* stiffness_of(int row, int column) const {
        if (row == platform && column == platform) return &stiffness;
        if (second.platform < 0) return nullptr;
        if (row == second.platform && column == second.platform) return &second.stiffness;
        if (row == platform && column == second.platform) return &second.on_first;
        if (row == second.platform && column == platform) return &second.of_first;
        return nullptr;
    }
};

struct Reply {
    Status status;
    std::vector<LineLoad> lines;  ///< one per line, in line order
};

/// Lines as the platform sees them: local (same process) or remote (other ranks). Between send and
/// receive the platform computes its own loads.
class Lines {
 public:
    Lines() = default;
    Lines(const Lines&) = delete;
    Lines& operator=(const Lines&) = delete;
    virtual ~Lines() = default;

    virtual void send(const Order& order) = 0;
    virtual const Reply& receive() = 0;
};

}  // namespace hawser
