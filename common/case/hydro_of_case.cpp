#include "case/hydro_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "environment/wave_components.hpp"
#include "status.hpp"

namespace hawser {

namespace {
constexpr double turn = 2.0 * M_PI, degree = M_PI / 180.0;
constexpr double rounding = 1e-6;  // [rad]

/// Mass of water displaced at the design draft [kg].
double displaced_mass(const Case& input, const Platform& p, double volume) {
    for (const Member& m : p.members) {
        const double top = std::max(m.from.z(), m.to.z()), low = std::min(m.from.z(), m.to.z());
        const double length = (m.to - m.from).norm();
        const double wet = top <= 0.0 ? 1.0 : low >= 0.0 ? 0.0 : -low / (top - low);
        volume += m.displaced_area * length * wet;
    }
    return input.environment.water.density * volume;
}

template <class Value>
bool covers(const WaveTable<Value>& table, double heading) {
    if (table.full_circle) return true;
    const double first = table.headings.front().heading, last = table.headings.back().heading;
    const double b = heading - turn * std::floor((heading - first + rounding) / turn);
    return b <= last + rounding;
}

template <class Value>
void check_waves(const Case& input, const WaveTable<Value>& table, double yaw,
                 const std::string& what, Problems& problems) {
    const Environment& e = input.environment;
    double energy = 0.0, outside = 0.0;
    for (std::size_t i = 0; i < e.waves.size(); ++i) {
        const std::string path = fmt::format("environment.waves[{}]", i);
        bool told = false;
        for (const WaveComponent& c :
             wave_components(e.waves[i], e.seabed.depth, e.water.gravity)) {
            const double a2 = c.amplitude * c.amplitude;
            energy += a2;
            if (c.omega < table.frequencies.front() * (1 - 1e-5) ||
                c.omega > table.frequencies.back() * (1 + 1e-5))
                outside += a2;
            if (told || covers(table, c.heading - yaw)) continue;
            told = true;
            problems.push_back(
                {Severity::error,
                 path + ".heading",
                 fmt::format(
                     "waves meet the platform from a heading of {:.4g} deg, outside the "
                     "{:.4g} to {:.4g} deg of the database's {}; headings are never "
                     "extrapolated: compute more of them, or state the symmetry of the hull",
                     std::remainder(c.heading - yaw, turn) / degree,
                     table.headings.front().heading / degree,
                     table.headings.back().heading / degree, what),
                 {}});
        }
    }
    if (outside > 0.01 * energy)
        problems.push_back(
            {Severity::error,
             "environment.waves",
             fmt::format("{:.1f} % of the waves' energy lies outside the frequencies of the "
                         "database's {}, {:.3g} to {:.3g} rad/s; expected at most 1 %",
                         100 * outside / energy, what, table.frequencies.front(),
                         table.frequencies.back()),
             {}});
}
}  // namespace

void check_displacement(const Case& input, const Platform& p, double volume, Problems& problems) {
    const double water = displaced_mass(input, p, volume);
    const auto add = [&](Severity severity, const char* path, std::string message) {
        problems.push_back({severity, path, std::move(message), {}});
    };
    if (p.displacement && std::abs(*p.displacement / water - 1.0) > 0.005)
        add(Severity::error, "platform.displacement",
            fmt::format("{:.0f} t given, but database and members displace {:.0f} t ({:+.2f} %; "
                        "0.5 % is allowed)",
                        *p.displacement / 1e3, water / 1e3,
                        100.0 * (*p.displacement / water - 1.0)));
    if (p.mass && input.lines.empty() && std::abs(*p.mass / water - 1.0) > 0.005)
        add(Severity::warning, "platform.mass",
            fmt::format("{:.0f} t, but {:.0f} t of water are displaced at the design draft: the "
                        "platform will rise or sink; `auto` keeps the draft",
                        *p.mass / 1e3, water / 1e3));
    if (!p.mass && water == 0.0)
        add(Severity::error, "platform.mass",
            "auto needs buoyancy: a database or members that displace water");
}

void check_coverage(const Case& input, const Platform& p, const HydroData& data,
                    Problems& problems) {
    const Environment& e = input.environment;
    const std::string database = "platform.hydrodynamics.database";
    const auto warning = [&](const std::string& path, std::string message) {
        problems.push_back({Severity::warning, path, std::move(message), {}});
    };
    if (data.depth > 0.0) {
        // The waves see the bed where k h < pi, roughly.
        const double seen = M_PI * e.water.gravity / std::pow(data.frequencies.front(), 2);
        const double file = std::min(data.depth, seen), here = std::min(e.seabed.depth, seen);
        if (std::abs(file / here - 1.0) > 0.05)
            warning(database,
                    fmt::format("computed for {} of water; the case has {:.6g} m",
                                std::isinf(data.depth) ? std::string("infinite depth")
                                                       : fmt::format("{:.6g} m", data.depth),
                                e.seabed.depth));
    }
    if (e.waves.empty()) return;
    if (data.excitation.empty()) {
        problems.push_back(
            {Severity::error, database, "holds no excitation, and the case has waves", {}});
        return;
    }
    try {
        check_waves(input, data.excitation, p.initial.angles.z(), "excitation", problems);
        if (p.hydrodynamics.drift == Drift::none) return;
        if (data.mean_drift.empty())
            problems.push_back({Severity::error,
                                "platform.hydrodynamics.drift",
                                "the database holds no mean drift",
                                {}});
        else
            check_waves(input, data.mean_drift, p.initial.angles.z(), "mean drift", problems);
    } catch (const RunError&) {
        // waves that cannot be made are told by whoever makes them
    }
}

}  // namespace hawser
