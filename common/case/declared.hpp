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
};

/// A layer round a line: coating, marine growth.
struct Layer {
    double thickness = 0.0, density = 0.0;  ///< [m], [kg/m3]
};

enum class ChainLink { studless, studlink };
enum class DragReference { nominal, outer, volume };

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
    std::optional<double> breaking_load;
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
    Joint joint = Joint::ball;
    std::optional<double> rotational_stiffness;
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

struct LineKeys {
    std::string name;
    std::string family;
    std::optional<double> azimuth;
    EndKeys end_a, end_b;
    std::vector<SectionKeys> sections;
    std::vector<AttachmentKeys> attachments;
    std::optional<double> time_step;
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
    std::optional<PlatformKeys> platform;
    std::vector<Material> materials;
    std::vector<LineTypeKeys> line_types;
    std::vector<LineKeys> lines;
    Analysis analysis;
    Output output;
};

/// Paths of the keys that the file gives: "platform.members[0].inertia".
using Given = std::set<std::string, std::less<>>;

/// The one table that leads to all others.
const Table& case_keys();
const Table& environment_keys();
const Table& platform_keys();
const Table& material_keys();
const Table& line_type_keys();
const Table& line_keys();
const Table& analysis_keys();
const Table& output_keys();
/// Keys that describe a family rather than its lines.
const Table& pattern_keys();
const Table& positions_keys();

/// Fills in every default that follows from other keys; what it chose for the user becomes a note.
void complete(DeclaredCase& declared, const Given& given, Problems& problems);

/// The Case; reports names that lead nowhere. Paths of files are taken from `folder`.
Case build(const DeclaredCase& declared, const std::string& name,
           const std::filesystem::path& folder, Problems& problems);

/// What can be known from the text alone (README.md of this folder): geometry, physical sense.
/// Numbers that could not be read are NaN and pass unnoticed here.
void check(const Case& value, Problems& problems);

/// `word` if it is close to a known name: "; did you mean ...?", else the list of known names.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace hawser
