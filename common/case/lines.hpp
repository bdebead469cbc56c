// The case: line types and lines (case keys `line_types`, `materials`, `lines`), families expanded:
// one Line per line. SI and radians. Arc length is unstretched and measured from end A.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/analysis.hpp"
#include "case/environment.hpp"
#include "frames.hpp"

namespace hawser {

/// A curve through points (x, y) of ascending x, straight between them.
using Curve = std::vector<std::array<double, 2>>;

/// standard_linear_solid: R:35, R:36. dual_stiffness: static stiffness up to the static tension of
/// the run's start, dynamic stiffness about it.
enum class RopeLaw { standard_linear_solid, dual_stiffness };

/// Two-modulus rope.
struct Viscoelastic {
    double EA_dynamic = 0.0, EA_static = 0.0;  ///< [N]
    double relaxation_time = 0.0;              ///< decay of tension at constant strain [s]
    RopeLaw model = RopeLaw::standard_linear_solid;

    bool operator==(const Viscoelastic&) const = default;
};

/// The wall of a pipe, for stresses (R:38).
struct PipeWall {
    double outer_diameter = 0.0, inner_diameter = 0.0;  ///< of the steel [m]
    double contents_density = 0.0;                      ///< [kg/m3], for the pressure inside
    double concentration = 1.0;                         ///< factor on bending and axial stress
    double thickness_factor = 1.0;     ///< of the wall left for stresses (corrosion)
    std::optional<double> yield = {};  ///< [Pa]

    bool operator==(const PipeWall&) const = default;
};

/// Mechanical properties per unit unstretched length of one section, worked out from its line type.
struct LineType {
    std::string name;
    std::string category;         ///< chain, wire, rope, pipe, general
    double mass = 0.0;            ///< structure, coating and contents [kg/m]
    double displaced_area = 0.0;  ///< pi/4 (volume diameter)^2 [m2]
    double outer_diameter = 0.0;  ///< nominal (chain, rope) or outer (pipe) diameter: contact [m]
    double EA = 0.0;              ///< [N]; EA_dynamic where there is a viscoelastic law
    Curve EA_curve;               ///< strain [-], tension [N]; empty: EA alone
    double EI = 0.0;              ///< [N.m2]
    std::optional<Viscoelastic> viscoelastic = {};
    std::optional<double> damping_ratio = {};  ///< of critical in the line's first axial mode, R:5
    std::optional<double> axial_damping = {};  ///< EA_damp [N.s], instead of damping_ratio
    double bending_damping = 0.0;              ///< [N.m2.s]
    double drag_diameter = 0.0;                ///< both drag coefficients refer to it [m]
    double drag_normal = 0.0, drag_axial = 0.0;
    double added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< on displaced_area
    /// Of chain (both legs of a link), rope and wire (nominal): carries the tension [m2]; 0:
    /// unknown, or a pipe's wall
    double section_area = 0.0;
    std::optional<double> breaking_load = {};  ///< [N]; only for utilisation
    std::optional<PipeWall> wall = {};         ///< pipes

    bool operator==(const LineType&) const = default;
};

struct Section {
    int type = 0;         ///< index into Case::line_types
    double length = 0.0;  ///< unstretched [m]
    int elements = 0;
    double growth = 1.0;   ///< ratio of neighbouring elements, from end A
    int type_at_end = -1;  ///< taper: properties run linearly to this type's; -1: uniform

    bool operator==(const Section&) const = default;
};

/// `line`: tied to a point of another line, by a constraint of the line (LineConstraint::is_end).
enum class EndKind { platform, anchor, fixed, free, line };
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
    int platform = 0;              ///< of the kind platform: which (Case::platform_at)
    Vec3 position = Vec3::Zero();  ///< platform: platform axes; anchor, fixed: world [m]
    Joint joint = Joint::ball;
    double rotational_stiffness = 0.0;  ///< flex joint [N.m/rad]
    Curve rotational_curve =
        {};  ///< flex joint: angle [rad], moment [N.m], instead of the stiffness
    double spring_stiffness = 0.0, spring_damping = 0.0;  ///< spring [N/m, N.s/m]
    double spring_length = 0.0;                           ///< unstressed [m]
    std::optional<Vec3> direction = {};    ///< flex, clamped: unit axis along increasing arc length
                                           ///< (same axes as position); empty: the static tangent
    std::optional<EndMotion> motion = {};  ///< fixed ends

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

enum class ConstraintType {
    ball_joint,  ///< a point of the rod held at a point of the platform or the earth
    flex_joint,  ///< the same, and a moment law on its tangent
    clamp,       ///< the same, and its tangent held
    tensioner,   ///< ram tensioner: pull of one or more cylinders
    guide,       ///< contact with a radial gap, the rod slides through
    slider,      ///< held across an axis, free along it
    pull_tube,   ///< a guide along a path of points
};

/// What holds a line between its ends. The place is a point and an axis that move with the
/// platform, stand on the earth, or belong to another line. A guide with a length is declared once
/// and becomes two constraints here, `<name>.upper` and `<name>.lower`.
struct LineConstraint {
    ConstraintType type = ConstraintType::guide;
    std::string name;
    bool on_platform = true;
    int platform = 0;        ///< on_platform: which (Case::platform_at)
    int other_line = -1;     ///< slider, ball joint: index of the line that it ties to; -1: none
    double other_arc = 0.0;  ///< ball joint: place on that line, arc length from its end A [m]
    bool is_end = false;     ///< ties an end of the line (EndKind::line)
    Vec3 position = Vec3::Zero();             ///< platform axes, or world [m]
    Vec3 axis = Vec3::UnitZ();                ///< unit, same axes
    std::optional<double> arc_length = {};    ///< material point held; empty: what passes the place
    double stiffness = 0.0, damping = 0.0;    ///< [N/m, N.s/m]
    double gap = 0.0;                         ///< guide, pull tube, slider: radial [m]
    double friction = 0.0;                    ///< guide, pull tube: Coulomb coefficient along axis
    double mobilisation = 0.01;               ///< slide that mobilises friction [m]
    double rotational_stiffness = 0.0;        ///< flex joint [N.m/rad]
    Curve rotational_curve = {};              ///< flex joint: angle [rad], moment [N.m]
    std::optional<Vec3> direction = {};       ///< flex joint, clamp: axis; empty: static tangent
    double nominal_tension = 0.0;             ///< tensioner: at stroke 0 [N]
    double exponent = 0.0, gas_column = 0.0;  ///< tensioner: gas law n [-], L [m]; n = 0: linear
    Curve pull = {};                          ///< tensioner: stroke [m], tension [N], table law
    double friction_force = 0.0;              ///< tensioner: Coulomb friction of the rams [N]
    std::vector<Vec3> cylinders =
        {};  ///< tensioner: their points on the platform; empty: one on axis
    double stroke_min = -1e9, stroke_max = 1e9;  ///< tensioner [m]
    std::vector<Vec3> path = {};                 ///< pull tube: its points, same axes

    bool operator==(const LineConstraint&) const = default;
};

/// Statics meets these, at the design position in still water, by the one quantity to adjust.
struct StaticTarget {
    enum class Adjust { none, anchor_radius, section_length };
    Adjust adjust = Adjust::none;
    int section = 0;                            ///< whose length is adjusted
    std::optional<double> pretension = {};      ///< effective tension at end A [N]
    std::optional<double> hang_off_angle = {};  ///< declination at end A [rad]
    /// neither: the nominal tension of the line's tensioner at stroke 0

    bool operator==(const StaticTarget&) const = default;
};

/// A line parts.
struct LineFailure {
    double time = 0.0;        ///< [s]
    double arc_length = 0.0;  ///< from end A [m]; snapped to a node

    bool operator==(const LineFailure&) const = default;
};

/// Line paid out (or, negative, taken in) at end A against time.
struct Winch {
    Curve paid_out = {};  ///< time [s], length [m]

    bool operator==(const Winch&) const = default;
};

struct Line {
    std::string name, family;
    LineEnd end_a, end_b;
    std::vector<Section> sections;  ///< from end A
    std::vector<Attachment> attachments;
    std::vector<LineConstraint> constraints;
    std::optional<double> time_step = {};  ///< upper bound of this line's rod step [s]
    double azimuth = 0.0;                  ///< of the pattern, platform towards anchor [rad]
    Vec3 radii_from = Vec3::Zero();        ///< axis of its platform as designed: anchor radii [m]
    std::optional<LineModel> model = {};   ///< instead of analysis.dynamics.line_model
    std::optional<double> sheltered_above = {};  ///< height on the platform above which the water
                                                 ///< moves with it [m]
    double internal_pressure = 0.0;              ///< at end A [Pa], beside the head of the contents
    StaticTarget target;
    std::optional<LineFailure> fail = {};
    std::optional<Winch> winch = {};

    [[nodiscard]] double length() const {
        double sum = 0.0;
        for (const Section& s : sections) sum += s.length;
        return sum;
    }

    bool operator==(const Line&) const = default;
};

}  // namespace hawser
