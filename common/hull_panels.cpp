#include "hull_panels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {

namespace {

/// Mean over a flat triangle of the product of two linear functions with these corner values.
double mean_product(const Vec3& f, const Vec3& g) { return (f.sum() * g.sum() + f.dot(g)) / 12.0; }

/// Adds what one triangle gives; `corners` has one in each column.
void add_triangle(const Mat3& corners, PanelHydrostatics& to) {
    const Vec3 n = 0.5 * (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    for (int i = 0; i < 3; ++i) {
        const Vec3 x = corners.row(i);
        to.volumes[i] += n[i] * x.mean();
        to.centre_of_buoyancy[i] += 0.5 * n[i] * mean_product(x, x);
    }
    // Heave, roll and pitch lift a point of the waterplane by (1, y, -x).
    const Vec3 lift[3] = {Vec3::Ones(), corners.row(1), -corners.row(0)};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) to.waterplane(i, j) -= n.z() * mean_product(lift[i], lift[j]);
}

}  // namespace

double PanelHydrostatics::gap() const {
    return (volumes.array() - volume()).abs().maxCoeff() / std::abs(volume());
}

PanelHydrostatics panel_hydrostatics(const std::vector<Panel>& panels, bool yz, bool xz) {
    PanelHydrostatics out;
    double lowest = std::numeric_limits<double>::infinity();
    out.waterline = -lowest;
    for (const Panel& panel : panels)
        for (const Vec3& corner : panel) {
            lowest = std::min(lowest, corner.z());
            out.waterline = std::max(out.waterline, corner.z());
        }
    out.draft = out.waterline - lowest;
    for (const Panel& panel : panels) {
        const double near = 1e-6 * out.draft;
        if (std::abs(out.waterline) < near &&
            std::all_of(panel.begin(), panel.end(),
                        [&](const Vec3& corner) { return std::abs(corner.z()) < near; })) {
            ++out.lids;
            continue;
        }
        for (const double x : {1.0, -1.0})
            for (const double y : {1.0, -1.0}) {
                if ((x < 0 && !yz) || (y < 0 && !xz)) continue;
                const auto corner = [&](std::size_t i) {
                    return Vec3(x * panel[i].x(), y * panel[i].y(), panel[i].z() - out.waterline);
                };
                // A mirror turns the panel round.
                const std::size_t second = x * y > 0 ? 1 : 3, last = 4 - second;
                Mat3 triangle;
                triangle << corner(0), corner(second), corner(2);
                add_triangle(triangle, out);
                triangle << corner(0), corner(2), corner(last);
                add_triangle(triangle, out);
            }
    }
    if (out.volume() != 0.0) out.centre_of_buoyancy /= out.volume();
    return out;
}

}  // namespace hawser
