// Tabulated laws (tension over stroke, moment over angle): a curve through points, straight between
// them and going on with its end slopes beyond them; its integral is the law's energy.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "case/lines.hpp"

namespace hawser::worker {

class PiecewiseLinear {
 public:
    PiecewiseLinear() = default;
    /// @param points (x, y) of ascending x, two or more; none: an empty curve
    explicit PiecewiseLinear(Curve points) : points_(std::move(points)), area_(points_.size()) {
        for (std::size_t i = 1; i < points_.size(); ++i)
            area_[i] = area_[i - 1] + 0.5 * (points_[i][1] + points_[i - 1][1]) *
                                          (points_[i][0] - points_[i - 1][0]);
    }
    [[nodiscard]] bool empty() const { return points_.empty(); }

    struct Value {
        double y, slope, integral;  ///< integral of y from the first point on
    };
    [[nodiscard]] Value at(double x) const {
        std::size_t i = 0;  // the piece from point i to point i + 1
        while (i + 2 < points_.size() && points_[i + 1][0] <= x) ++i;
        const double dx = x - points_[i][0];
        const double slope =
            (points_[i + 1][1] - points_[i][1]) / (points_[i + 1][0] - points_[i][0]);
        return {points_[i][1] + slope * dx, slope,
                area_[i] + dx * (points_[i][1] + 0.5 * slope * dx)};
    }

 private:
    Curve points_;
    std::vector<double> area_;
};

}  // namespace hawser::worker
