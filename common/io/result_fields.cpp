#include "io/result_fields.hpp"

#include <algorithm>
#include <numeric>

namespace hawser::io {
namespace {

struct EndResultKeys {
    EndResult result;
    const char* name;
    const char* units;
    const char* description;  // "... of the line at end A"
    bool vector;
};

constexpr std::array<EndResultKeys, 5> end_result_keys{{
    {EndResult::effective_tension, "effective_tension", "N", "Effective tension", false},
    {EndResult::declination, "declination", "deg",
     "Angle from vertical down of the tangent from end A to end B", false},
    {EndResult::azimuth, "azimuth", "deg",
     "Angle from +x, counter-clockwise from above, of the tangent from end A to end B", false},
    {EndResult::force, "force", "N", "Force of the line on what holds it, world axes", true},
    {EndResult::moment, "moment", "N.m", "Moment of the line on what holds it, world axes", true},
}};

const EndResultKeys& keys_of(EndResult result) {
    return end_result_keys[static_cast<std::size_t>(result)];
}

bool asks(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string load_description(std::string_view name) {
    static const std::vector<std::pair<std::string_view, const char*>> words{
        {"wave1", "First-order wave excitation"},
        {"drift", "Mean and slow wave drift"},
        {"radiation", "Radiation damping and inertia of the added mass"},
        {"hydrostatic", "Buoyancy and waterplane restoring"},
        {"weight", "Weight"},
        {"members", "Members beyond their drag in current alone: wave loads and viscous drift"},
        {"plates", "Heave plates"},
        {"current", "Drag of members in current alone"},
        {"wind", "Wind"},
        {"damping", "Linear and quadratic damping of the case"},
        {"lines", "All lines"},
        {"total", "All loads"}};
    for (const auto& [key, text] : words) {
        if (key == name) return std::string(text) + ": force and moment about O, world axes";
    }
    return std::string(name);
}

}  // namespace

std::string end_path(bool end_a, EndResult result) {
    return std::string("/lines/") + (end_a ? "end_a/" : "end_b/") + keys_of(result).name;
}

bool matches(std::string_view glob, std::string_view name) {
    if (glob.empty()) return name.empty();
    if (glob.front() == '*') {
        for (std::size_t k = 0; k <= name.size(); ++k) {
            if (matches(glob.substr(1), name.substr(k))) return true;
        }
        return false;
    }
    return !name.empty() && (glob.front() == '?' || glob.front() == name.front()) &&
           matches(glob.substr(1), name.substr(1));
}

bool is_recorded(const Output& output, const std::string& line, bool end_a, EndResult result) {
    return std::any_of(output.lines.begin(), output.lines.end(), [&](const LineOutput& entry) {
        return (end_a ? entry.end_a : entry.end_b) && asks(entry.results, keys_of(result).name) &&
               matches(entry.select, line);
    });
}

std::string platform_path(const Case& input) {
    return "/platform/" + (input.platform ? input.platform->name : std::string("platform")) + "/";
}

std::vector<SeriesField> result_fields(const Case& input, const std::vector<int>& nodes) {
    std::vector<SeriesField> fields;
    const Output& output = input.output;
    if (input.platform && output.platform_motions) {
        const std::string root = platform_path(input);
        const std::string six = "surge, sway, heave, roll, pitch, yaw";
        fields.push_back({root + "position",
                          "m, m, m, deg, deg, deg",
                          "Position of the reference point and Euler angles: " + six,
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
    if (input.platform && output.platform_loads) {
        for (const std::string_view name : load_names) {
            fields.push_back({platform_path(input) + "loads/" + std::string(name),
                              "N, N, N, N.m, N.m, N.m",
                              load_description(name),
                              {6}});
        }
    }
    if (output.environment && !input.environment.waves.empty()) {
        fields.push_back(
            {"/environment/elevation", "m", "Undisturbed elevation of the sea at the origin", {}});
    }
    if (output.environment && input.environment.wind) {
        fields.push_back({"/environment/wind_speed",
                          "m/s",
                          "Wind speed at the height of the platform's wind area",
                          {}});
    }
    const int n_lines = static_cast<int>(input.lines.size());
    for (const bool end_a : {true, false}) {
        for (const EndResult result : end_results) {
            if (std::none_of(input.lines.begin(), input.lines.end(), [&](const Line& line) {
                    return is_recorded(output, line.name, end_a, result);
                }))
                continue;
            const EndResultKeys& keys = keys_of(result);
            fields.push_back(
                {end_path(end_a, result), keys.units,
                 std::string(keys.description) + ", at end " + (end_a ? "A" : "B"),
                 keys.vector ? std::vector<int>{n_lines, 3} : std::vector<int>{n_lines}});
        }
    }
    if (output.snapshots && n_lines > 0) {
        const int all = std::accumulate(nodes.begin(), nodes.end(), 0);
        fields.push_back({"/lines/nodes/position",
                          "m",
                          "Positions of the nodes of all lines, world axes",
                          {all, 3},
                          Clock::snapshot,
                          true});
    }
    return fields;
}

}  // namespace hawser::io
