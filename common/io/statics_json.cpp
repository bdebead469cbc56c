// The static solution for scripts: JSON and CSV. SI, angles in degrees.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/statics_text.hpp"
#include "line_weight.hpp"
#include "motion_names.hpp"

namespace hawser::io {
namespace {

constexpr double degrees = 180.0 / M_PI;

template <class Values>
Json list(const Values& values) {
    Json out = Json::array();
    for (const auto& value : values) out.add(value);
    return out;
}

Json matrix(const Mat6& K) {
    Json rows = Json::array();
    for (int i = 0; i < 6; ++i) {
        Json row = Json::array();
        for (int k = 0; k < 6; ++k) row.add(K(i, k));
        rows.add(std::move(row));
    }
    return rows;
}

Json platform_json(const PlatformAtRest& p, const Vec3& design) {
    Json position = Json::object(), periods = Json::object();
    for (std::size_t i = 0; i < 6; ++i) {
        const auto k = static_cast<int>(i % 3);
        position.put(motion_names[i],
                     i < 3 ? p.position.position[k] - design[k] : degrees * p.position.angles[k]);
        if (p.periods[i]) periods.put(motion_names[i], *p.periods[i]);
    }
    const Stability& s = p.stability;
    Json out = Json::object();
    out.put("name", p.name)
        .put("position", std::move(position))
        .put("mass", p.mass)
        .put("mass_is_auto", p.mass_is_auto)
        .put("acting_buoyancy", p.acting_buoyancy)
        .put("vertical_line_load", p.vertical_line_load)
        .put("line_load", list(std::vector<double>(p.line_load.data(), p.line_load.data() + 6)))
        .put("hull_GM_roll", s.hull_GM_roll)
        .put("hull_GM_pitch", s.hull_GM_pitch)
        .put("GM_roll", s.GM_roll)
        .put("GM_pitch", s.GM_pitch)
        .put("stable", s.stable())
        .put("unstable", list(s.unstable))
        .put("unheld", list(s.unheld))
        .put("periods", std::move(periods))
        .put("added_mass_frequency", p.added_mass_frequency)
        .put("stiffness", matrix(p.stiffness))
        .put("line_stiffness", matrix(p.line_stiffness));
    return out;
}

Json line_json(const Case& input, const Line& line, const LineAtRest& r) {
    Json constraints = Json::array();
    for (std::size_t c = 0; c < line.constraints.size(); ++c) {
        const ConstraintAtRest& q = r.constraints[c];
        Json one = Json::object();
        one.put("name", line.constraints[c].name)
            .put("magnitude", q.magnitude)
            .put("opening", q.opening)
            .put("force", list(std::array<double, 3>{q.force.x(), q.force.y(), q.force.z()}));
        constraints.add(std::move(one));
    }
    Json out = Json::object();
    out.put("name", line.name)
        .put("family", line.family)
        .put("length", line.length())
        .put("submerged_weight", submerged_weight(line, input))
        .put("tension_a", r.tension_a)
        .put("tension_b", r.tension_b)
        .put("declination_a", degrees * r.declination_a)
        .put("declination_b", degrees * r.declination_b)
        .put("azimuth_a", degrees * r.azimuth_a)
        .put("azimuth_b", degrees * r.azimuth_b)
        .put("grounded", r.grounded);
    if (!std::isnan(r.touchdown)) out.put("touchdown", r.touchdown);
    out.put("lowest_tension", r.lowest_tension).put("lowest_at", r.lowest_at);
    for (const auto& [name, extreme] : {std::pair("greatest_tension", &r.tension),
                                        {"von_mises_stress", &r.von_mises},
                                        {"bending_stress", &r.bending},
                                        {"curvature", &r.curvature},
                                        {"yield_utilisation", &r.yield},
                                        {"load_utilisation", &r.breaking_load}}) {
        if (std::isnan(extreme->value)) continue;
        Json one = Json::object();
        one.put("value", extreme->value).put("at", extreme->at);
        out.put(name, std::move(one));
    }
    out.put("constraints", std::move(constraints));
    return out;
}

Json curve_json(const Case& input, const OffsetCurve& curve) {
    Json points = Json::array(), names = Json::array();
    const auto name = [&](int i) { return input.lines[static_cast<std::size_t>(i)].name; };
    for (const int i : curve.lines) names.add(name(i));
    const FreeMotions& f = curve.free;
    Json free = Json::array();
    for (const auto& [is_free, motion] : {std::pair(f.transverse, "transverse"),
                                          {f.heave, "heave"},
                                          {f.roll, "roll"},
                                          {f.pitch, "pitch"},
                                          {f.yaw, "yaw"}})
        if (is_free) free.add(std::string(motion));
    for (const OffsetPoint& p : curve.points) {
        Json one = Json::object();
        Json position = Json::object();
        for (std::size_t i = 0; i < 6; ++i)
            position.put(motion_names[i], i < 3 ? p.pose.position[static_cast<int>(i)]
                                                : degrees * p.pose.angles[static_cast<int>(i) - 3]);
        one.put("offset", p.offset)
            .put("position", std::move(position))
            .put("across", p.across)
            .put("restoring", p.restoring)
            .put("transverse", p.transverse)
            .put("yaw_moment", p.yaw_moment)
            .put("slope", p.slope)
            .put("least_tension", p.least)
            .put("least_line", name(p.least_line))
            .put("greatest_tension", p.greatest)
            .put("greatest_line", name(p.greatest_line));
        points.add(std::move(one));
    }
    Json out = Json::object();
    if (input.platform_count() > 1) out.put("platform", input.platform_at(curve.platform).name);
    out.put("heading", degrees * curve.heading)
        .put("lines", std::move(names))
        .put("free", std::move(free))
        .put("points", std::move(points))
        .put("complete", curve.ends.empty());
    if (!curve.ends.empty()) out.put("ends", curve.ends);
    return out;
}

}  // namespace

Json statics_json(const Case& input, const StaticsReport& report) {
    Json out = Json::object();
    out.put("case", input.name).put("units", "SI, angles in degrees");
    const auto platform = [&](std::size_t k) {
        return platform_json(report.platforms[k], input.platform_at(static_cast<int>(k)).position);
    };
    if (report.platforms.size() == 1) out.put("platform", platform(0));
    if (report.platforms.size() > 1) {
        Json all = Json::array();
        for (std::size_t k = 0; k < report.platforms.size(); ++k) all.add(platform(k));
        out.put("platforms", std::move(all));
        Json rows = Json::array();
        for (Eigen::Index i = 0; i < report.stiffness.rows(); ++i) {
            Json row = Json::array();
            for (Eigen::Index k = 0; k < report.stiffness.cols(); ++k)
                row.add(report.stiffness(i, k));
            rows.add(std::move(row));
        }
        out.put("stiffness", std::move(rows));
    }
    Json lines = Json::array();
    for (std::size_t i = 0; i < input.lines.size(); ++i)
        lines.add(line_json(input, input.lines[i], report.lines[i]));
    out.put("lines", std::move(lines));
    if (report.curve) out.put("restoring", curve_json(input, *report.curve));
    out.put("warnings", list(report.warnings));
    return out;
}

std::string statics_csv(const Case& input, const StaticsReport& report) {
    const auto name = [&](int i) { return input.lines[static_cast<std::size_t>(i)].name; };
    if (report.curve) {
        std::string out =
            "offset [m],restoring [N],transverse [N],yaw_moment [N.m],slope [N/m],"
            "least_tension [N],least_line,greatest_tension [N],greatest_line,across [m],heave [m],"
            "roll [deg],pitch [deg],yaw [deg]\n";
        for (const OffsetPoint& p : report.curve->points) {
            const Vec3 turned = degrees * p.pose.angles;
            out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", p.offset, p.restoring,
                               p.transverse, p.yaw_moment, p.slope, p.least, name(p.least_line),
                               p.greatest, name(p.greatest_line), p.across, p.pose.position.z(),
                               turned.x(), turned.y(), turned.z());
        }
        return out;
    }
    std::string out =
        "line,family,length [m],submerged_weight [N],tension_a [N],tension_b [N],declination_a "
        "[deg],declination_b [deg],azimuth_a [deg],azimuth_b [deg],grounded [m],touchdown [m],"
        "lowest_tension [N],lowest_at [m]\n";
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const Line& line = input.lines[i];
        const LineAtRest& r = report.lines[i];
        out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", line.name, line.family,
                           line.length(), submerged_weight(line, input), r.tension_a, r.tension_b,
                           degrees * r.declination_a, degrees * r.declination_b,
                           degrees * r.azimuth_a, degrees * r.azimuth_b, r.grounded,
                           std::isnan(r.touchdown) ? "" : fmt::format("{}", r.touchdown),
                           r.lowest_tension, r.lowest_at);
    }
    return out;
}

}  // namespace hawser::io
