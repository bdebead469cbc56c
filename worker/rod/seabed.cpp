#include "rod/seabed.hpp"

#include <cmath>

namespace hawser::worker {

Bed bed_of(const Seabed& seabed) {
    Bed bed{.z = -seabed.depth,
            .stiffness = seabed.normal_stiffness,
            .damping = seabed.damping,
            .slopes = seabed.slope_angle != 0.0};
    if (bed.slopes) {
        const double c = std::cos(seabed.slope_angle), s = std::sin(seabed.slope_angle);
        const double cd = std::cos(seabed.slope_direction), sd = std::sin(seabed.slope_direction);
        bed.normal = {-s * cd, -s * sd, c};
        bed.uphill = {c * cd, c * sd, s};
        bed.level = {-sd, cd, 0.0};
    }
    if (seabed.friction_mobilisation > 0.0) {
        bed.friction_axial = seabed.friction_axial;
        bed.friction_lateral = seabed.friction_lateral;
        bed.mobilisation = seabed.friction_mobilisation;
    }
    return bed;
}

}  // namespace hawser::worker
