// Elastic catenary of a line with sections, joints and a flat sea bed: the guess of the rods'
// statics, and a closed form to test them against. No bending, no current.
#pragma once

#include <vector>

#include "vector.hpp"

namespace hawser::worker {

/// A stretch of uniform line between two nodes.
struct CatenaryElement {
    double length = 0.0;      ///< unstretched [m]
    double EA = 0.0;          ///< [N]
    double weight_wet = 0.0;  ///< submerged weight per unstretched length [N/m]
    double weight_dry = 0.0;  ///< weight above the water line z = 0 [N/m]
    double point_weight =
        0.0;  ///< submerged weight of what hangs on the node at the element's upper end [N]
    double point_buoyancy = 0.0;  ///< its buoyancy [N], which fades over its height about z = 0,
    double point_height = 1.0;    ///< as that of a point mass does [m]
    /// Part of its buoyancy that is lost at a height z, 0 ... 1.
    [[nodiscard]] double dry_part(double z) const {
        const double part = 0.5 + z / point_height;
        return part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
    }
    /// Weight less buoyancy of what hangs there at a height z [N].
    [[nodiscard]] double hanging_at(double z) const {
        return point_weight + dry_part(z) * point_buoyancy;
    }
};

struct CatenaryNode {
    Vec3 position = Vec3::Zero();  ///< [m]
    Vec3 tangent = Vec3::Zero();   ///< unit, towards end A
    double tension = 0.0;          ///< [N]
};

struct Catenary {
    bool found = false;
    std::vector<CatenaryNode> nodes;  ///< from end B to end A, elements + 1
    double horizontal = 0.0;          ///< horizontal tension [N]
    double vertical_a =
        0.0;                ///< vertical tension at end A, positive when the line hangs from A [N]
    double grounded = 0.0;  ///< unstretched length on the bed at end B [m]
    double vertical_b = 0.0;        ///< vertical tension at end B [N]
    Mat3 stiffness = Mat3::Zero();  ///< d(pull of the line at end A)/d(its position) [N/m]
};

/// Line from end B at `b` to end A at `a`, elements given from B to A. If `on_bed`, end B lies on
/// the bed and part of the line may lie there. Unknowns are the horizontal tension H and the
/// vertical tension at B (or the grounded length); both are found by nested bisection on monotonic
/// functions.
/// @param friction  of the bed along the line: the tension falls from touchdown towards B by
/// friction times the weight that lies, down to zero [-]
Catenary solve_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                        bool on_bed, double friction = 0.0);
/// The same into a line that is overwritten; with nodes reserved no memory is taken.
void solve_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                    bool on_bed, double friction, Catenary& line);

/// The same by Newton's iteration from the horizontal and vertical tension at end A of a
/// neighbouring solution, to 1e-10 of the length; with the stiffness, in closed form. Where the
/// iteration fails it is solve_catenary that answers.
/// @param line  is overwritten; with nodes reserved no memory is taken
void follow_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                     bool on_bed, double horizontal, double vertical_a, Catenary& line);

/// Line that hangs straight down from `a` with its other end free.
Catenary hang_freely(const std::vector<CatenaryElement>& elements, const Vec3& a);

}  // namespace hawser::worker
