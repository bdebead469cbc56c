// From the declared case to the Case: names become indices, angles become vectors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bed_contact.hpp"
#include "case/build_constraints.hpp"
#include "case/declared.hpp"
#include "case/line_type_rules.hpp"

namespace hawser {
namespace {

class Build {
 public:
    Build(const DeclaredCase& declared, Problems& problems)
        : declared_(declared), problems_(problems) {}

    Case run(const std::string& name, const std::filesystem::path& folder) {
        value_.name = name;
        value_.title = declared_.title;
        value_.description = declared_.description;
        value_.environment = declared_.environment;
        value_.analysis = declared_.analysis;
        value_.output = declared_.output;
        if (declared_.platform) value_.platform = platform(*declared_.platform, folder);
        for (const PlatformKeys& keys : declared_.platforms) {
            if (value_.platform)
                value_.further_platforms.push_back(platform(keys, folder));
            else
                value_.platform = platform(keys, folder);
        }
        for (const LineTypeKeys& type : declared_.line_types) {
            value_.line_types.push_back(line_type(type));
        }
        for (const LineTypeKeys& type : declared_.line_types) taper(type);
        for (const LineKeys& line : declared_.lines) this->line(line);
        return std::move(value_);
    }

 private:
    void error(const std::string& path, const std::string& message) {
        problems_.push_back({Severity::error, path, message, {}});
    }

    Platform platform(const PlatformKeys& keys, const std::filesystem::path& folder) {
        Platform p = keys;
        if (keys.gyration) p.radii_of_gyration = *keys.gyration;
        for (std::size_t i = 0; i < keys.plate_groups.size(); ++i) {
            const PlateKeys& group = keys.plate_groups[i];
            Plate plate{.name = group.name,
                        .area = group.area,
                        .Cd = group.Cd,
                        .added_mass = group.added_mass};
            if (group.normal.norm() == 0.0) {
                error(fmt::format("{}.plates[{}].normal", keys.key_path, i),
                      "the normal has no length");
            }
            plate.normal = group.normal.normalized();
            std::vector<Vec3> places;
            if (group.position) places.push_back(*group.position);
            for (const double z : group.z) places.emplace_back(0.0, 0.0, z);
            for (const Vec3& place : places) {
                plate.position = place;
                p.plates.push_back(plate);
            }
        }
        if (p.hydrodynamics.database) {
            std::string& path = p.hydrodynamics.database->path;
            path = (folder / path).lexically_normal().string();
        }
        const auto found = [&](std::string& path) {
            if (!path.empty()) path = (folder / path).lexically_normal().string();
        };
        for (AppliedForce& f : p.forces) found(f.path);
        if (p.prescribed) found(p.prescribed->path);
        return p;
    }

    void taper(const LineTypeKeys& type) {
        if (!type.taper) return;
        const std::string path = "line_types." + type.name + ".taper";
        for (const auto& [name, key] :
             {std::pair{type.taper->from, ".from"}, {type.taper->to, ".to"}}) {
            const int i = type_index(name, path + key);
            if (i < 0) continue;
            const LineTypeKeys& end = declared_.line_types[static_cast<std::size_t>(i)];
            if (end.taper) error(path + key, fmt::format("\"{}\" is tapered itself", name));
            if (end.viscoelastic || !end.EA_curve.empty()) {
                error(path + key, fmt::format("\"{}\" has no single EA: a taper between such types "
                                              "is not available in this version",
                                              name));
            }
        }
    }

    void line(const LineKeys& keys) {
        const std::string path = "lines." + keys.family;
        Line line;
        line.name = keys.name;
        line.family = keys.family;
        line.azimuth = keys.azimuth.value_or(0.0);
        line.time_step = keys.time_step;
        line.radii_from = declared_.design_of(declared_.platform_of(keys));
        line.end_a = end(keys.end_a, keys, line.radii_from, path + ".end_a");
        line.end_b = end(keys.end_b, keys, line.radii_from, path + ".end_b");
        if (keys.end_b.wellhead_z) line.end_b.position.head<2>() = place_of(line.end_a).head<2>();
        if (keys.end_a.wellhead_z) error(path + ".end_a", "a wellhead is for end B");
        if (line.end_b.kind == EndKind::platform && line.end_b.joint != Joint::ball) {
            error(
                path + ".end_b.joint",
                "end B turns freely on a platform in this version; expected ball, or end A there");
        }
        for (std::size_t i = 0; i < keys.sections.size(); ++i)
            section(keys.sections[i], i, path, line);
        lay_on_bed(line);
        line.model = keys.model;
        line.sheltered_above = keys.sheltered_above;
        line.internal_pressure = keys.internal_pressure;
        line_constraints(keys, declared_, line, problems_);
        tied_end(keys.end_a, false, keys, declared_, line, problems_);
        tied_end(keys.end_b, true, keys, declared_, line, problems_);
        line_target(keys, line, problems_);
        line_failure(keys, declared_, line, problems_);
        if (keys.end_a.free == true) free_end_a(keys, path);
        for (std::size_t i = 0; i < keys.attachments.size(); ++i) {
            attachment(keys.attachments[i], fmt::format("{}.attachments[{}]", path, i), line);
        }
        value_.lines.push_back(std::move(line));
    }

    /// An anchor holds a line where it lies at rest, its axis above the bed.
    void lay_on_bed(Line& line) const {
        const auto lay = [&](LineEnd& end, int type) {
            if (end.kind == EndKind::anchor && type >= 0)
                end.position.z() += resting_height(
                    value_.line_types[static_cast<std::size_t>(type)], value_.environment);
        };
        if (line.sections.empty()) return;
        const Section& last = line.sections.back();
        lay(line.end_a, line.sections.front().type);
        lay(line.end_b, last.type_at_end < 0 ? last.type : last.type_at_end);
    }

    /// A free end A is held by what stands among the constraints.
    void free_end_a(const LineKeys& keys, const std::string& path) {
        using Kind = ConstraintKind;
        if (keys.end_b.free == true) return error(path, "both ends are free: one must be held");
        const auto holds = [](const ConstraintKeys& c) {
            return !c.type || c.type == Kind::tensioner || c.type == Kind::ball_joint ||
                   c.type == Kind::flex_joint || c.type == Kind::clamp;
        };
        if (std::none_of(keys.constraints.begin(), keys.constraints.end(), holds)) {
            error(path + ".end_a.free",
                  "a free end A needs something that holds the line up: a tensioner among its "
                  "constraints");
        } else if (!keys.end_a.position) {
            error(path + ".end_a",
                  "a free end A needs \"position\", where it is at the design position (or "
                  "positions and top_z of the family)");
        }
    }

    /// Height of the seabed [m].
    double bed(double x, double y) const { return declared_.environment.seabed.height(x, y); }

    int type_index(const std::string& name, const std::string& path) {
        std::vector<std::string> known;
        for (std::size_t k = 0; k < declared_.line_types.size(); ++k) {
            known.push_back(declared_.line_types[k].name);
            if (known.back() == name) return static_cast<int>(k);
        }
        if (!name.empty()) {
            error(path, fmt::format("unknown line type \"{}\"{}", name, suggestion(name, known)));
        }
        return -1;
    }

    void section(const SectionKeys& keys, std::size_t i, const std::string& path, Line& line) {
        int type = type_index(keys.type, fmt::format("{}.sections[{}].type", path, i)), end = -1;
        if (type >= 0) {
            const LineTypeKeys& declared = declared_.line_types[static_cast<std::size_t>(type)];
            if (declared.taper) {
                const std::string taper = "line_types." + declared.name + ".taper";
                type = type_index(declared.taper->from, taper + ".from");
                end = type_index(declared.taper->to, taper + ".to");
                if (end < 0) type = -1;
            }
        }
        line.sections.push_back({.type = type,
                                 .length = keys.length,
                                 .elements = keys.elements.value_or(0),
                                 .growth = keys.growth,
                                 .type_at_end = end});
    }

    void attachment(const AttachmentKeys& keys, const std::string& path, Line& line) {
        Attachment a{.arc_length = keys.arc_length.value_or(NAN),
                     .mass = keys.mass,
                     .volume = keys.volume,
                     .drag_area = keys.drag_area,
                     .Ca = keys.Ca};
        if (keys.joint) {
            const int last = static_cast<int>(line.sections.size()) - 1;
            if (*keys.joint < 1 || *keys.joint > last) {
                error(path + ".at", last < 1 ? "a line of one section has no joints"
                                             : fmt::format("expected joint 1 to {}; got joint {}",
                                                           last, *keys.joint));
            }
            a.arc_length = 0.0;
            for (int i = 0; i < std::min(*keys.joint, last + 1); ++i) {
                a.arc_length += line.sections[static_cast<std::size_t>(i)].length;
            }
        } else if (a.arc_length > line.length()) {
            error(path + ".at",
                  fmt::format("beyond the end of the line at {:.6g} m", line.length()));
        }
        line.attachments.push_back(a);
    }

    /// World place of an end at the design position.
    Vec3 place_of(const LineEnd& end) const {
        if (end.kind != EndKind::platform) return end.position;
        return declared_.design_of(end.platform) + end.position;
    }

    /// @param from  axis from which radii on the seabed count, and places of a free end
    LineEnd end(const EndKeys& keys, const LineKeys& line, const Vec3& from,
                const std::string& path) {
        LineEnd e;
        if (keys.platform) {
            e.kind = EndKind::platform;
            const std::vector<std::string> known = declared_.platform_names();
            const int found = declared_.find_platform(*keys.platform);
            if (known.empty()) {
                error(path + ".platform", "the case has no platform");
            } else if (found < 0) {
                error(path + ".platform", fmt::format("unknown platform \"{}\"{}", *keys.platform,
                                                      suggestion(*keys.platform, known)));
            }
            e.platform = std::max(found, 0);
            if (keys.polar) {
                e.position =
                    on_circle(keys.polar->radius, keys.polar->azimuth.value_or(NAN), keys.polar->z);
            } else if (keys.position) {
                e.position = *keys.position;
            } else {
                error(path, "expected \"position\" or \"polar\": where on the platform?");
                e.position.setConstant(NAN);
            }
        } else if (keys.anchor) {
            e.kind = EndKind::anchor;
            const AnchorKeys& anchor = *keys.anchor;
            if (anchor.radius) {
                e.position = from + on_circle(*anchor.radius, anchor.azimuth.value_or(NAN), 0.0);
                e.position.z() = bed(e.position.x(), e.position.y());
            } else if (anchor.position) {
                const double z = bed((*anchor.position)[0], (*anchor.position)[1]);
                e.position = {(*anchor.position)[0], (*anchor.position)[1], z};
                if (anchor.position->size() > 2 && (*anchor.position)[2] != z && !std::isnan(z)) {
                    error(path + ".anchor.position",
                          fmt::format("an anchor lies on the seabed, z = {:.6g} m; leave z out, or "
                                      "use \"fixed\"",
                                      z));
                }
            }
        } else if (keys.wellhead_z) {
            e.kind = EndKind::fixed;
            e.position = {0.0, 0.0, *keys.wellhead_z};
        } else if (keys.fixed) {
            e.kind = EndKind::fixed;
            e.position = *keys.fixed;
        } else if (keys.line) {
            e.kind = EndKind::line;
            if (!keys.arc) error(path, "required key \"arc\" is missing: where on that line?");
            if (keys.joint != Joint::ball) {
                error(path + ".joint", "an end on another line turns freely in this version");
            }
        } else if (keys.free && !*keys.free) {
            error(path + ".free", "expected true, or another kind of end");
        }
        if (keys.free == true && keys.position) e.position = from + *keys.position;
        const bool placed = keys.polar || (keys.position && keys.free != true);
        if (placed && !keys.platform) {
            error(path, "\"position\" and \"polar\" are places on a platform: name it");
        }
        if (keys.arc && !keys.line) error(path + ".arc", "a place on another line: name it");
        if (keys.motion) {
            if (!keys.fixed) error(path + ".motion", "only a fixed end has a motion of its own");
            e.motion = motion(*keys.motion);
        }
        joint(keys, line, path, e);
        return e;
    }

    void joint(const EndKeys& keys, const LineKeys& line, const std::string& path, LineEnd& e) {
        e.joint = keys.joint;
        if (e.kind == EndKind::free && keys.joint != Joint::ball) {
            error(path + ".joint", "a free end has no joint");
        }
        if (keys.joint == Joint::flex) {
            e.rotational_curve = keys.rotational_curve;
            check_curve(e.rotational_curve, path + ".rotational_stiffness", problems_);
            e.rotational_stiffness = first_slope(e.rotational_curve, keys.rotational_stiffness);
        }
        if (keys.direction) e.direction = direction_down(*keys.direction, line.azimuth);
    }

    static EndMotion motion(const MotionKeys& keys) {
        EndMotion m;
        const std::array<const std::optional<HarmonicKeys>*, 3> modes{&keys.surge, &keys.sway,
                                                                      &keys.heave};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            if (!*modes[i]) continue;
            m.amplitude[k] = (*modes[i])->amplitude;
            m.period[k] = (*modes[i])->period;
            m.phase[k] = (*modes[i])->phase;
        }
        return m;
    }

    static Vec3 on_circle(double radius, double azimuth, double z) {
        return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
    }

    const DeclaredCase& declared_;
    Problems& problems_;
    Case value_;
};

}  // namespace

Case build(const DeclaredCase& declared, const std::string& name,
           const std::filesystem::path& folder, Problems& problems) {
    return Build(declared, problems).run(name, folder);
}

}  // namespace hawser
