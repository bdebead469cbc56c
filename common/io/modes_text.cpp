#include "io/modes_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "io/json.hpp"
#include "io/text_table.hpp"
#include "motion_names.hpp"

namespace hawser::io {
namespace {

const char* name_of(RodMode::Kind kind) {
    static constexpr std::array names = {"axial", "in-plane", "out-of-plane"};
    return names.at(static_cast<std::size_t>(kind));
}

std::string name_of(const CoupledMode& mode) {
    return motion_names[static_cast<std::size_t>(mode.motion)];
}

/// Of a mode without period: held by nothing, or pushed further the further it goes.
std::string why_none(const CoupledMode& mode) {
    if (mode.held) return "held";
    return mode.omega_squared < 0.0 ? "unstable" : "not held";
}
std::string why_none(const RodMode& mode) {
    return mode.omega_squared < -RodMode::nothing ? "unstable" : "not held";
}

/// Six parts with rotations in degrees per metre or per degree of the main motion.
std::array<double, 6> parts(const CoupledMode& mode, const Vec6& shape) {
    std::array<double, 6> out{};
    for (std::size_t i = 0; i < 6; ++i) {
        const double size = shape[static_cast<Eigen::Index>(i)];
        const double degrees = 180.0 / M_PI;
        const bool turns = mode.motion >= 3;
        out[i] = i < 3 ? (turns ? size / degrees : size) : (turns ? size : size * degrees);
    }
    return out;
}

std::string coupled_text(const ModesReport& report) {
    const bool several = report.platforms.size() > 1;
    std::string names;
    for (const std::string& name : report.platforms) names += (names.empty() ? "" : ", ") + name;
    std::string out = title(several ? "Platforms " + names + " with their lines"
                                    : "Platform " + names + " with its lines");
    TextTable table;
    if (several) table.column("of");
    table.column("mode");
    table.column("period", "s");
    table.column("share", "%");
    for (std::size_t i = 0; i < 6; ++i) table.column(motion_names[i], i < 3 ? "m" : "deg");
    table.column("stiffness", "% lines");
    table.column("inertia", "% lines");
    for (const CoupledMode& mode : report.coupled) {
        std::vector<std::string> cells;
        if (several) cells.push_back(report.platforms.at(static_cast<std::size_t>(mode.platform)));
        const std::vector<std::string> values{
            name_of(mode), mode.period() ? number(*mode.period(), 2) : why_none(mode),
            number(100.0 * mode.share, 1)};
        cells.insert(cells.end(), values.begin(), values.end());
        for (const double part : parts(mode, mode.shape)) cells.push_back(number(part, 3));
        cells.push_back(number(100.0 * mode.line_stiffness, 1));
        cells.push_back(number(100.0 * mode.line_inertia, 2));
        table.row(cells);
        for (std::size_t k = 0; several && k < mode.all.size(); ++k) {  // the others' part
            if (static_cast<int>(k) == mode.platform) continue;
            std::vector<std::string> other{"", "  with " + report.platforms.at(k), "", ""};
            for (const double part : parts(mode, mode.all[k])) other.push_back(number(part, 3));
            other.insert(other.end(), 2, "");
            table.row(other);
        }
    }
    return out + table.text() +
           "undamped, about the equilibrium. share: part of the platform's kinetic energy that is "
           "in the motion the mode is\nnamed after; of that motion 1 m or 1 deg. lines: their part "
           "of the stiffness and of the inertia;\nguides with a gap count as closed\n";
}

std::string line_text(const Case& input, const LineModes& line) {
    std::string out =
        title("Line " + input.lines[static_cast<std::size_t>(line.line)].name + ", ends held");
    TextTable table;
    table.column("mode");
    table.column("period", "s");
    table.column("frequency", "Hz");
    table.column("kind");
    table.column("axial", "%");
    table.column("in plane", "%");
    table.column("out of", "%");
    table.column("largest at", "m");
    int n = 0;
    for (const RodMode& mode : line.modes) {
        const std::optional<double> period = mode.period();
        std::size_t widest = 0;
        for (std::size_t i = 0; i < mode.shape.size(); ++i)
            if (mode.shape[i].norm() > mode.shape[widest].norm() + 1e-9) widest = i;
        table.row({std::to_string(++n), period ? number(*period, 3) : why_none(mode),
                   period ? digits(1.0 / *period, 4) : "-", name_of(mode.kind),
                   number(100.0 * mode.axial, 1), number(100.0 * mode.in_plane, 1),
                   number(100.0 * mode.out_of_plane, 1), number(line.arc_length.at(widest), 0)});
    }
    return out + table.text();
}

/// What an end moves with: the platform's name, else nothing.
std::string end_of(const Case& input, const LineEnd& end) {
    return end.kind == EndKind::platform ? input.platform_at(end.platform).name : "";
}

}  // namespace

std::string modes_text(const Case& input, const ModesReport& report) {
    std::string out =
        fmt::format("{}: natural modes\n", input.title.empty() ? input.name : input.title);
    if (!report.coupled.empty()) out += coupled_text(report);
    for (const LineModes& line : report.lines) out += line_text(input, line);
    if (!report.lines.empty())
        out +=
            "\nundamped, about the static solution, with the added mass of still water and the "
            "dynamic stiffness of ropes,\nguides with a gap closed; plane: the vertical one "
            "through both "
            "ends\n";
    return out;
}

std::string modes_json(const Case& input, const ModesReport& report) {
    Json out = Json::object();
    out.put("case", input.name).put("units", "SI");
    if (!report.coupled.empty()) {
        Json modes = Json::array();
        const bool several = report.platforms.size() > 1;
        const auto six = [](const Vec6& v) {
            Json shape = Json::object();
            for (std::size_t i = 0; i < 6; ++i)
                shape.put(motion_names[i], v[static_cast<Eigen::Index>(i)]);
            return shape;
        };
        for (const CoupledMode& mode : report.coupled) {
            Json one = Json::object(), shape = six(mode.shape);
            one.put("name", name_of(mode));
            if (several) {
                one.put("platform", report.platforms.at(static_cast<std::size_t>(mode.platform)));
                shape = Json::object();
                for (std::size_t k = 0; k < mode.all.size(); ++k)
                    shape.put(report.platforms.at(k), six(mode.all[k]));
            }
            if (mode.period())
                one.put("period", *mode.period());
            else
                one.put("without_period", why_none(mode));
            one.put("shape", std::move(shape))
                .put("share", mode.share)
                .put("line_stiffness", mode.line_stiffness)
                .put("line_inertia", mode.line_inertia)
                .put("converged", mode.converged);
            modes.add(std::move(one));
        }
        if (several) {
            Json names = Json::array();
            for (const std::string& name : report.platforms) names.add(name);
            out.put("platforms", std::move(names));
        } else {
            out.put("platform", report.platforms.front());
        }
        out.put("coupled", std::move(modes));
    }
    Json lines = Json::array();
    const auto point = [](const Vec3& x) {
        Json three = Json::array();
        three.add(x.x()).add(x.y()).add(x.z());
        return three;
    };
    Json hulls = Json::array();
    for (std::size_t k = 0; k < report.rest.size(); ++k) {
        const Platform& its = input.platform_at(static_cast<int>(k));
        Json members = Json::array(), plates = Json::array(), one = Json::object();
        for (const Member& m : its.members)
            members.add(Json::object()
                            .put("from", point(m.from))
                            .put("to", point(m.to))
                            .put("diameter", m.diameter));
        for (const Plate& p : its.plates)
            plates.add(Json::object().put("position", point(p.position)).put("area", p.area));
        one.put("name", report.platforms[k])
            .put("position", point(report.rest[k].position))
            .put("angles", point(report.rest[k].angles))
            .put("members", std::move(members))
            .put("plates", std::move(plates));
        hulls.add(std::move(one));
    }
    if (!hulls.empty()) out.put("hulls", std::move(hulls));
    out.put("seabed_depth", input.environment.seabed.depth);
    const auto points = [&point](const std::vector<Vec3>& at) {
        Json list = Json::array();
        for (const Vec3& x : at) list.add(point(x));
        return list;
    };
    for (const LineModes& line : report.lines) {
        Json modes = Json::array(), arc = Json::array();
        for (const RodMode& mode : line.modes) {
            Json one = Json::object();
            if (mode.period())
                one.put("period", *mode.period());
            else
                one.put("without_period", why_none(mode));
            one.put("kind", name_of(mode.kind))
                .put("axial", mode.axial)
                .put("in_plane", mode.in_plane)
                .put("out_of_plane", mode.out_of_plane)
                .put("shape", points(mode.shape));
            modes.add(std::move(one));
        }
        for (const double s : line.arc_length) arc.add(s);
        Json one = Json::object();
        const Line& its = input.lines[static_cast<std::size_t>(line.line)];
        one.put("name", its.name)
            .put("end_a", end_of(input, its.end_a))
            .put("end_b", end_of(input, its.end_b))
            .put("plane", point(plane_of(its, line.position.front(), line.position.back())))
            .put("arc_length", std::move(arc))
            .put("position", points(line.position))
            .put("modes", std::move(modes));
        lines.add(std::move(one));
    }
    out.put("lines", std::move(lines));
    return out.text() + "\n";
}

std::string modes_csv(const Case& input, const ModesReport& report) {
    std::string out = "of,mode,period [s],kind,axial,in_plane,out_of_plane\n";
    for (const CoupledMode& mode : report.coupled)
        out += fmt::format("{},{},{},coupled,,,\n",
                           report.platforms.at(static_cast<std::size_t>(mode.platform)),
                           name_of(mode), mode.period() ? fmt::format("{}", *mode.period()) : "");
    for (const LineModes& line : report.lines) {
        int n = 0;
        for (const RodMode& mode : line.modes)
            out += fmt::format("{},{},{},{},{},{},{}\n",
                               input.lines[static_cast<std::size_t>(line.line)].name, ++n,
                               mode.period() ? fmt::format("{}", *mode.period()) : "",
                               name_of(mode.kind), mode.axial, mode.in_plane, mode.out_of_plane);
    }
    return out;
}

}  // namespace hawser::io
