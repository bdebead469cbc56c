// The case: line types and lines (case keys `line_types`, `materials`, `lines`), families expanded:
// one Line per line. SI and radians. Arc length is unstretched and measured from end A.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/environment.hpp"
#include "frames.hpp"

namespace hawser {

/// Two-modulus rope, a standard linear solid: R:35, R:36.
struct Viscoelastic {
    double EA_dynamic = 0.0, EA_static = 0.0;  ///< [N]
    double relaxation_time = 0.0;              ///< decay of tension at constant strain [s]

    bool operator==(const Viscoelastic&) const = default;
};

/// Mechanical properties per unit unstretched length of one section, worked out from its line type.
struct LineType {
    std::string name;
    std::string category;         ///< chain, wire, rope, pipe, general
    double mass = 0.0;            ///< structure, coating and contents [kg/m]
    double displaced_area = 0.0;  ///< pi/4 (volume diameter)^2 [m2]
    double outer_diameter = 0.0;  ///< nominal (chain, rope) or outer (pipe) diameter: contact [m]
    double EA = 0.0;              ///< [N]; EA_dynamic where there is a viscoelastic law
    double EI = 0.0;              ///< [N.m2]
    std::optional<Viscoelastic> viscoelastic;
    std::optional<double> damping_ratio;  ///< of critical in the line's first axial mode, R:5
    std::optional<double> axial_damping;  ///< EA_damp [N.s], instead of damping_ratio
    double bending_damping = 0.0;         ///< [N.m2.s]
    double drag_diameter = 0.0;           ///< both drag coefficients refer to it [m]
    double drag_normal = 0.0, drag_axial = 0.0;
    double added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< on displaced_area
    std::optional<double> breaking_load;                     ///< [N]; only for checks

    bool operator==(const LineType&) const = default;
};

struct Section {
    int type = 0;         ///< index into Case::line_types
    double length = 0.0;  ///< unstretched [m]
    int elements = 0;
    double growth = 1.0;  ///< ratio of neighbouring elements, from end A

    bool operator==(const Section&) const = default;
};

enum class EndKind { platform, anchor, fixed, free };
/// `spring`: the end is free and held by a spring-damper; no key of the case file makes one yet.
enum class Joint { ball, clamped, flex, spring };

/// Prescribed harmonic motion of a `fixed` end: offset_i = ramp(t) amplitude_i sin(2 pi t/period_i
/// + phase_i).
struct EndMotion {
    Vec3 amplitude = Vec3::Zero();  ///< surge, sway, heave [m]
    Vec3 period = Vec3::Ones();     ///< [s]
    Vec3 phase = Vec3::Zero();      ///< [rad]

    bool operator==(const EndMotion&) const = default;
};

struct LineEnd {
    EndKind kind = EndKind::free;
    Vec3 position = Vec3::Zero();  ///< platform: platform axes; anchor, fixed: world [m]
    Joint joint = Joint::ball;
    double rotational_stiffness = 0.0;                    ///< flex joint [N.m/rad]
    double spring_stiffness = 0.0, spring_damping = 0.0;  ///< spring [N/m, N.s/m]
    double spring_length = 0.0;                           ///< unstressed [m]
    std::optional<Vec3> direction;    ///< flex, clamped: unit axis along increasing arc length
                                      ///< (same axes as position); empty: the static tangent
    std::optional<EndMotion> motion;  ///< fixed ends

    bool operator==(const LineEnd&) const = default;
};

/// Point mass, clump or buoy on a line.
struct Attachment {
    double arc_length = 0.0;  ///< [m]; snapped to a node of the mesh by the rod
    double mass = 0.0;        ///< [kg]
    double volume = 0.0;      ///< [m3]
    double drag_area = 0.0;   ///< Cd A [m2]
    double Ca = 0.0;          ///< on rho volume

    bool operator==(const Attachment&) const = default;
};

enum class ConstraintType { guide, slider, tensioner };

/// What holds a line between its ends. The place is a point and an axis that move with the
/// platform, or stand on the earth.
struct LineConstraint {
    ConstraintType type = ConstraintType::guide;
    std::string name;
    bool on_platform = true;
    Vec3 position = Vec3::Zero();             ///< platform axes, or world [m]
    Vec3 axis = Vec3::UnitZ();                ///< unit, same axes
    std::optional<double> arc_length;         ///< material point held; empty: what passes the place
    double stiffness = 0.0, damping = 0.0;    ///< [N/m, N.s/m]
    double gap = 0.0;                         ///< guide: radial [m]
    double friction = 0.0;                    ///< guide: Coulomb coefficient along the axis
    double mobilisation = 0.01;               ///< guide: slide that mobilises the friction [m]
    double nominal_tension = 0.0;             ///< tensioner: at stroke 0 [N]
    double exponent = 0.0, gas_column = 0.0;  ///< tensioner: gas law n [-], L [m]; n = 0: linear
    double stroke_min = -1e9, stroke_max = 1e9;  ///< tensioner [m]

    bool operator==(const LineConstraint&) const = default;
};

struct Line {
    std::string name, family;
    LineEnd end_a, end_b;
    std::vector<Section> sections;  ///< from end A
    std::vector<Attachment> attachments;
    std::vector<LineConstraint> constraints;
    std::optional<double> time_step;  ///< upper bound of this line's rod step [s]
    double azimuth = 0.0;             ///< of the pattern, platform towards anchor [rad]

    [[nodiscard]] double length() const {
        double sum = 0.0;
        for (const Section& s : sections) sum += s.length;
        return sum;
    }

    bool operator==(const Line&) const = default;
};

}  // namespace hawser
