#include "io/result_fields.hpp"

#include <algorithm>
#include <numeric>

namespace hawser::io {
namespace {

std::string load_description(std::string_view name) {
    static const std::vector<std::pair<std::string_view, const char*>> words{
        {"wave1", "First-order wave excitation"},
        {"drift", "Mean and slow wave drift"},
        {"wave2", "Second-order wave force at sum frequencies"},
        {"radiation", "Radiation damping and inertia of the added mass"},
        {"hydrostatic", "Buoyancy and waterplane restoring"},
        {"weight", "Weight"},
        {"members", "Members beyond their drag in current alone: wave loads and viscous drift"},
        {"plates", "Heave plates"},
        {"current", "Drag of members in current alone; current coefficients"},
        {"wind", "Wind"},
        {"damping", "Linear and quadratic damping of the case"},
        {"stiffness", "Linear stiffness of the case"},
        {"forces", "Forces given by hand"},
        {"holding", "What holds or leads the motions that do not follow from the loads"},
        {"lines", "All lines"},
        {"total", "All loads"}};
    for (const auto& [key, text] : words) {
        if (key == name) return std::string(text) + ": force and moment about O, world axes";
    }
    return std::string(name);
}

}  // namespace

bool has_load(const Platform& p, std::string_view name) {
    if (name == "stiffness") return !p.stiffness.isZero(0.0);
    if (name == "forces") return !p.forces.empty();
    if (name == "holding") return p.held() != std::array<bool, 6>{};
    return true;
}

std::string platform_path(const Platform& platform) { return "/platform/" + platform.name + "/"; }

std::vector<SeriesField> result_fields(const Case& input, const std::vector<int>& nodes) {
    std::vector<SeriesField> fields;
    const Output& output = input.output;
    const int platforms = input.platform_count();
    for (int k = 0; k < platforms && output.platform_motions; ++k) {
        const Platform& p = input.platform_at(k);
        const std::string root = platform_path(p);
        const bool moved = p.position != Vec3::Zero();
        const std::string six = "surge, sway, heave, roll, pitch, yaw";
        fields.push_back({root + "position",
                          "m, m, m, deg, deg, deg",
                          (moved ? "Displacement of the reference point from where it is designed "
                                   "to be, and Euler angles: "
                                 : "Position of the reference point and Euler angles: ") +
                              six,
                          {6}});
        fields.push_back({root + "velocity",
                          "m/s, m/s, m/s, deg/s, deg/s, deg/s",
                          "Rates of the position and of the Euler angles: " + six,
                          {6}});
        fields.push_back({root + "acceleration",
                          "m/s2, m/s2, m/s2, deg/s2, deg/s2, deg/s2",
                          "Second derivatives of the position and of the Euler angles: " + six,
                          {6}});
    }
    for (int k = 0; k < platforms && output.platform_loads; ++k) {
        const Platform& p = input.platform_at(k);
        for (const std::string_view name : load_names) {
            if (!has_load(p, name)) continue;
            fields.push_back({platform_path(p) + "loads/" + std::string(name),
                              "N, N, N, N.m, N.m, N.m",
                              load_description(name),
                              {6}});
        }
    }
    if (output.environment && !input.environment.waves.empty()) {
        fields.push_back(
            {"/environment/elevation", "m", "Undisturbed elevation of the sea at the origin", {}});
        if (const auto n = static_cast<int>(input.environment.waves.size()); n > 1)
            fields.push_back({"/environment/elevation_of_trains",
                              "m",
                              "Elevation of each wave train alone at the origin",
                              {n}});
    }
    for (int k = 0; k < platforms && output.environment && !input.environment.waves.empty(); ++k)
        if (const Platform& p = input.platform_at(k); !p.position.head<2>().isZero(0.0))
            fields.push_back(
                {platform_path(p) + "elevation",
                 "m",
                 "Undisturbed elevation of the sea where the platform is designed to be",
                 {}});
    if (output.environment && input.environment.wind) {
        fields.push_back({"/environment/wind_speed",
                          "m/s",
                          platforms > 1
                              ? "Wind speed at the height of the first platform's wind area"
                              : "Wind speed at the height of the platform's wind area",
                          {}});
    }
    add_line_fields(input, nodes, fields);
    return fields;
}

}  // namespace hawser::io
