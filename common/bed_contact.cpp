#include "bed_contact.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

double resting_penetration(double weight, const Seabed& seabed) {
    if (weight <= 0.0) return 0.0;
    const double pen = std::sqrt(2.0 * bed_smoothing * weight / seabed.normal_stiffness);
    return pen <= bed_smoothing ? pen : weight / seabed.normal_stiffness + 0.5 * bed_smoothing;
}

double resting_height(const LineType& type, const Environment& environment) {
    const double slope = std::cos(environment.seabed.slope_angle);
    const Water& water = environment.water;
    const double weight = (type.mass - water.density * type.displaced_area) * water.gravity;
    const double pen = resting_penetration(weight * slope, environment.seabed);
    return std::max(0.5 * type.outer_diameter - pen, 0.0) / slope;
}

}  // namespace hawser
