// The case as it is declared: the keys of the file in structs, families expanded, before line types
// are worked out and names become indices. `complete` fills in every default that follows from
// other keys; `build` makes the Case of it. SI and radians.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/keys.hpp"
#include "case/problem.hpp"

namespace hawser {

struct Material {
    std::string name;
    double E = 0.0, density = 0.0;  ///< [Pa], [kg/m3]
    std::optional<double> yield;    ///< [Pa]
};

/// A layer round a line: coating, marine growth.
struct Layer {
    double thickness = 0.0, density = 0.0;  ///< [m], [kg/m3]
};

enum class ChainLink { studless, studlink };
enum class DragReference { nominal, outer, volume };

/// Properties run along the section from one type's to the other's.
struct TaperKeys {
    std::string from, to;
};

struct LineTypeKeys {
    std::string name;
    std::string category;
    std::optional<double> nominal_diameter;
    ChainLink link = ChainLink::studless;
    std::optional<double> outer_diameter, wall_thickness, inner_diameter;  ///< pipe [m]
    std::optional<std::string> material;
    double contents_density = 0.0;
    std::optional<Layer> coating, marine_growth;
    std::optional<double> mass, density, volume_diameter, EA, EI;
    std::optional<Viscoelastic> viscoelastic;
    std::optional<double> damping_ratio, axial_damping;
    double bending_damping = 0.0;
    double drag_normal = 0.0, drag_axial = 0.0;
    std::optional<DragReference> drag_reference;
    double added_mass_normal = 1.0, added_mass_axial = 0.0;
    Curve EA_curve, EI_curve;
    std::optional<double> breaking_load, yield;
    double concentration = 1.0, thickness_factor = 1.0;  ///< of stresses, `stress`
    std::optional<TaperKeys> taper;
};

struct PolarKeys {
    double radius = 0.0;
    std::optional<double> azimuth;
    double z = 0.0;
};

struct AnchorKeys {
    std::optional<double> radius, azimuth;
    std::optional<std::vector<double>> position;  ///< x, y and perhaps z
};

/// Harmonic motion in one direction.
struct HarmonicKeys {
    double amplitude = 0.0, period = 1.0, phase = 0.0;
};

struct MotionKeys {
    std::optional<HarmonicKeys> surge, sway, heave;
};

struct EndKeys {
    std::optional<std::string> platform;
    std::optional<Vec3> position;
    std::optional<PolarKeys> polar;
    std::optional<AnchorKeys> anchor;
    std::optional<double> wellhead_z;
    std::optional<Vec3> fixed;
    std::optional<MotionKeys> motion;
    std::optional<bool> free;
    std::optional<std::string> line;  ///< tied to this other line
    std::optional<double> arc;        ///< and where
    Joint joint = Joint::ball;
    std::optional<double> rotational_stiffness;
    Curve rotational_curve;
    std::optional<double> direction;  ///< from vertical down, in the plane of the azimuth [rad]
};

struct SectionKeys {
    std::string type;
    double length = 0.0;
    std::optional<int> elements;
    std::optional<double> element_length;
    double growth = 1.0;
};

struct AttachmentKeys {
    std::optional<double> arc_length;
    std::optional<int> joint;  ///< between sections n and n + 1, counted from 1
    double mass = 0.0, volume = 0.0, drag_area = 0.0, Ca = 0.0;
};

enum class ConstraintKind {
    ball_joint,
    flex_joint,
    clamp,
    tensioner,
    guide,
    slider,
    pull_tube,
    winch
};
enum class TensionerLaw { linear, gas, table };

/// What holds a line between its ends; a list of heights makes several of it.
struct ConstraintKeys {
    std::optional<ConstraintKind> type;  ///< empty: not understood
    std::optional<std::string> platform, name, names;
    std::optional<std::string> line;  ///< tied to this other line
    std::optional<double> arc, line_arc;
    std::vector<double> z;
    std::optional<Vec3> position, axis;
    double gap = 0.0, length = 0.0;
    std::optional<double> stiffness;
    double damping = 0.0;
    double friction = 0.0;  ///< [N] of a tensioner, else [-]
    double mobilisation = 0.01;
    std::optional<TensionerLaw> law;
    std::optional<double> nominal_tension, exponent, gas_column;
    Curve pull;
    std::vector<double> stroke;  ///< two, or none
    std::vector<Vec3> cylinders, path;
    std::optional<double> rotational_stiffness;
    Curve rotational_curve;
    std::optional<double> direction;
    Curve paid_out;
};

struct FailKeys {
    std::optional<std::string> line;
    double time = 0.0;
    std::optional<double> arc_length;
    std::optional<int> joint;
    bool end_b = false;
};

struct LineKeys {
    std::string name;
    std::string family;
    std::optional<double> azimuth;
    EndKeys end_a, end_b;
    std::vector<SectionKeys> sections;
    std::vector<AttachmentKeys> attachments;
    std::vector<ConstraintKeys> constraints;
    std::optional<double> time_step;
    std::optional<LineModel> model;
    std::optional<double> sheltered_above;
    double internal_pressure = 0.0;
    std::optional<double> pretension, hang_off_angle;
    std::optional<std::string> adjust;
    std::optional<FailKeys> fail;
};

/// How a family makes several lines of one description.
struct PatternKeys {
    std::string names;
    int groups = 1;
    double group_spacing = 0.0;
    int per_group = 1;
    double spacing = 0.0, first_group = 0.0;
};

struct PositionsKeys {
    std::string names;
    std::vector<std::vector<double>> xy;
};

struct PlateKeys {
    std::string name;
    std::vector<double> z;
    std::optional<Vec3> position;
    Vec3 normal = Vec3::UnitZ();
    double area = 0.0, Cd = 0.0, added_mass = 0.0;
};

struct PlatformKeys : Platform {
    std::vector<PlateKeys> plate_groups;
    std::optional<Vec3> gyration;
};

struct DeclaredCase {
    std::string title, description;
    Environment environment;
    std::optional<PlatformKeys> platform;  ///< the only one ...
    std::vector<PlatformKeys> platforms;   ///< ... or each by its name
    std::vector<Material> materials;
    std::vector<LineTypeKeys> line_types;
    std::vector<LineKeys> lines;
    Analysis analysis;
    Output output;

    /// Names of the platforms, in the order of Case::platform_at.
    [[nodiscard]] std::vector<std::string> platform_names() const;
    /// Index of the platform of this name; -1: there is none.
    [[nodiscard]] int find_platform(const std::string& name) const;
    /// Where platform k is built to be [m]; the origin where there is no such platform.
    [[nodiscard]] Vec3 design_of(int k) const;
    /// The platform whose axis a line's radii and heights count from: that of end A, else that of
    /// end B, else that of the first constraint on one; -1: none.
    [[nodiscard]] int platform_of(const LineKeys& line) const;
};

/// Paths of the keys that the file gives: "platform.members[0].inertia".
using Given = std::set<std::string, std::less<>>;

/// The one table that leads to all others.
const Table& case_keys();
const Table& environment_keys();
const Table& platform_keys();
/// The same without `name`: keys of one of several, which stand under its name.
const Table& named_platform_keys();
const Table& material_keys();
const Table& line_type_keys();
const Table& line_keys();
const Table& constraint_keys();
const Table& analysis_keys();
const Table& output_keys();
/// Words of `line_model` and of a family's `model`.
const std::vector<std::pair<std::string, LineModel>>& line_model_words();
/// Keys that describe a family rather than its lines.
const Table& pattern_keys();
const Table& positions_keys();

/// Fills in every default that follows from other keys; what it chose for the user becomes a note.
void complete(DeclaredCase& declared, const Given& given, Problems& problems);

/// The Case; reports names that lead nowhere. Paths of files are taken from `folder`.
Case build(const DeclaredCase& declared, const std::string& name,
           const std::filesystem::path& folder, Problems& problems);

/// What can be known from the text alone (README.md of this folder): geometry, physical sense.
/// Numbers that could not be read are NaN and pass unnoticed here. `declared` is what `value` was
/// built of: it knows where in the file things stand.
void check(const Case& value, const DeclaredCase& declared, Problems& problems);

/// `word` if it is close to a known name: "; did you mean ...?", else the list of known names.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace hawser
