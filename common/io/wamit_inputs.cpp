#include "io/wamit_inputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "io/hydro_reading.hpp"

namespace hawser::io {

namespace {
using Verdict = HydroCheck::Verdict;
constexpr double foot = 0.3048;

/// The lines of a file after its title, each the numbers before its first word. WAMIT reads as many
/// as it wants and takes the rest of a line for a remark.
class Lines {
 public:
    explicit Lines(const Path& file) : in_(file) {
        std::string title;
        std::getline(in_, title);
    }

    /// The next line that holds a number; empty at the end.
    std::vector<double> next() {
        std::vector<double> numbers;
        for (std::string text; numbers.empty() && std::getline(in_, text);) {
            ++line_;
            std::istringstream words(text);
            for (std::string word; words >> word;) {
                const std::optional<double> x = fortran_number(word);
                if (!x) break;
                numbers.push_back(*x);
            }
        }
        return numbers;
    }

    /// n numbers, from as many lines as they take; fewer at the end.
    std::vector<double> next(std::size_t n) {
        std::vector<double> all;
        while (all.size() < n) {
            const std::vector<double> some = next();
            if (some.empty()) break;
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }

    [[nodiscard]] int line() const { return line_; }

 private:
    std::ifstream in_;
    int line_ = 1;
};

std::string not_the_same(const char* what, double here, double there, const char* unit) {
    return fmt::format("{} {:.5g} {}, {:+.2g} % of {:.5g}", what, here, unit,
                       100 * (here / there - 1), there);
}

/// Comparisons that end as checks of one file.
class InputChecks {
 public:
    InputChecks(const HydroDatabase& database, const HydroSet& set, const HydroData& data)
        : base_(database), set_(set), data_(data) {}

    std::vector<PlacedCheck> run() {
        if (set_.geometry) geometry(*set_.geometry);
        if (set_.control) control(*set_.control);
        return std::move(list_);
    }

 private:
    void add(const Path& file, int line, Verdict verdict, const char* what, std::string sentence,
             std::optional<double> size = std::nullopt) {
        HydroCheck check;
        check.verdict = verdict;
        check.about = HydroCheck::About::stiffness;
        check.what = what;
        check.sentence = std::move(sentence);
        check.size = size;
        list_.push_back({std::move(check), file.string(), line});
    }

    void geometry(const WamitGeometry& g) {
        if (g.ulen > 0.0) {
            const double e = std::abs(g.ulen / base_.ulen - 1);
            add(g.file, 2, e > 1e-3 ? Verdict::wrong : Verdict::fine, "ULEN",
                e > 1e-3
                    ? fmt::format("ULEN is {:.6g} m{}, which made the numbers of the set; "
                                  "expected ulen: {:.6g} m, got {:.6g} m",
                                  g.ulen, g.in_feet ? " (GRAV is in feet)" : "", g.ulen, base_.ulen)
                    : fmt::format("ULEN of the panels is ulen, {:g} m", g.ulen),
                e);
        }
        if (!g.hull) {
            add(g.file, g.unread_line, Verdict::remark, "panels",
                "the panels are not compared: " + g.unread);
            return;
        }
        hull(g, *g.hull);
    }

    /// Panels lie inside a curved hull: a coarse mesh lacks a few per cent of its volume.
    void hull(const WamitGeometry& g, const PanelHydrostatics& h) {
        if (!(h.volume() > 0.0) || h.gap() > 0.02) {
            add(g.file, 4, Verdict::doubtful, "panels",
                fmt::format("the volume inside the panels is {:.5g}, {:.5g} and {:.5g} m3 by x, y "
                            "and z: {}",
                            h.volumes.x(), h.volumes.y(), h.volumes.z(),
                            h.volumes.maxCoeff() < 0.0
                                ? "they face into the hull"
                                : "the surface has holes, or some panels face the other way"),
                h.gap());
            return;
        }
        if (base_.displaced_volume)
            compare(g, "volume", h.volume(), *base_.displaced_volume, *base_.displaced_volume,
                    "m3");
        const bool pierces = h.area() > 1e-3 * std::pow(h.volume(), 2.0 / 3);
        if (pierces && std::abs(h.waterline) > 1e-3 * h.draft)
            add(g.file, 4, Verdict::remark, "panels",
                fmt::format("the waterline of the panels is at {:.4g} m of their axes, about which "
                            "the moments of the files are; reference_point says where they stand",
                            h.waterline));
        Vec3 centre = h.centre_of_buoyancy + base_.reference_point;
        centre.z() =
            h.centre_of_buoyancy.z() + (pierces ? 0.0 : h.waterline + base_.reference_point.z());
        if (base_.centre_of_buoyancy)
            compare(g, "centre of buoyancy z", centre.z(), data_.centre_of_buoyancy.z(), h.draft,
                    "m");
        if (set_.stiffness && pierces) stiffness(g, h);
    }

    /// C of the .hst about the files' origin against rho g of the waterplane, V and z_B.
    void stiffness(const WamitGeometry& g, const PanelHydrostatics& h) {
        const Mat6& C = *set_.stiffness;
        const double rho_g = data_.density * data_.gravity;
        compare(g, "waterplane", h.area(), C(2, 2) / rho_g, h.area(), "m2");
        // About the origin of the files, which is that of the panels.
        const double z_B = h.centre_of_buoyancy.z() + h.waterline;
        for (const int i : {1, 2}) {
            const double buoyancy = rho_g * (h.waterplane(i, i) + h.volume() * z_B);
            const double scale =
                rho_g * (h.waterplane(i, i) + h.volume() * std::max(std::abs(z_B), h.draft));
            const double left = C(2 + i, 2 + i) - buoyancy, weight = data_.weight_stiffness(3, 3);
            const double e = std::abs(left - weight) / scale;
            const char* name = i == 1 ? "C44" : "C55";
            if (e < 0.02) {
                add(g.file, 4, Verdict::fine, name,
                    fmt::format("{} is that of the panels{} within {:.2g} % of its parts", name,
                                base_.includes_weight ? " and the weight" : "", 100 * e),
                    e);
                continue;
            }
            add(g.file, 4, e > 0.1 ? Verdict::wrong : Verdict::doubtful, name,
                fmt::format("{} of the .hst is {:.4g} N.m/rad, buoyancy and waterplane of the "
                            "panels make {:.4g}: that leaves {:.4g} for the weight, -m g z_G; {}",
                            name, C(2 + i, 2 + i), buoyancy, left,
                            base_.includes_weight
                                ? fmt::format("included_mass and included_z make {:.4g}", weight)
                                : std::string("expected includes_weight: true with included_mass "
                                              "and included_z, or another .hst")),
                e);
        }
    }

    void compare(const WamitGeometry& g, const char* what, double here, double there, double scale,
                 const char* unit) {
        const double e = std::abs(here - there) / scale;
        add(g.file, 4,
            e > 0.1    ? Verdict::wrong
            : e > 0.03 ? Verdict::doubtful
                       : Verdict::fine,
            what,
            e > 0.03 ? fmt::format("{} of the panels is {:.6g} {}, of the set {:.6g} {}: they are "
                                   "not of one hull, or ulen, rho or the draft differ",
                                   what, here, unit, there, unit)
                     : fmt::format("{} of the panels is {:.6g} {}, of the set {:.6g}", what, here,
                                   unit, there),
            e);
    }

    void control(const WamitControl& c) {
        for (const int option : {1, 2, 3, 4, 8, 9}) {
            const auto i = static_cast<std::size_t>(option - 1);
            if (i >= c.options.size() || c.options[i] != 0) continue;
            const Path file = base_.path + "." + std::to_string(option);
            if (std::filesystem::exists(file))
                add(c.file, 2, Verdict::doubtful, "IOPTN",
                    fmt::format("did not ask for a .{} (IOPTN({}) is 0), but {} is there: it is of "
                                "another run",
                                option, option, file.filename().string()));
        }
        if (c.form == 0) {
            add(c.file, 0, Verdict::remark, "weight",
                "neither form 1 nor form 2; its mass is not compared");
            return;
        }
        const bool in_feet = set_.geometry && set_.geometry->in_feet;
        if (!in_feet && c.density > 0.0 && std::abs(c.density / data_.density - 1) > 5e-3)
            add(c.file, 3, Verdict::doubtful, "RHO",
                not_the_same("RHO is", c.density, data_.density, "kg/m3, as stated"));
        if (set_.stiffness) weight(c);
    }

    /// Whether the .hst holds a weight, and which.
    void weight(const WamitControl& c) {
        const bool in_feet = set_.geometry && set_.geometry->in_feet;
        const double z_G = c.z_G * (in_feet ? foot : 1.0);
        std::optional<double> mass = in_feet ? std::nullopt : c.mass;
        if (c.form == 1 && data_.displaced_volume > 0.0)
            mass = data_.density * data_.displaced_volume;
        if (!base_.includes_weight) {
            if (z_G == 0.0 || (c.form == 2 && !mass)) return;
            const double arm = std::cbrt(std::max(data_.displaced_volume, 1.0));
            if (std::abs(z_G) < 1e-3 * arm) return;
            add(c.file, c.z_G_line, Verdict::doubtful, "weight",
                fmt::format("put the centre of gravity at {:.5g} m, so the .hst should hold -m g "
                            "z_G{}; expected includes_weight: true, included_mass and included_z",
                            z_G,
                            mass ? fmt::format(" = {:.4g} N.m/rad", -*mass * data_.gravity * z_G)
                                 : std::string()));
            return;
        }
        const double stated = base_.included_mass * base_.included_z;
        if (mass && std::abs(*mass * z_G - stated) > 0.01 * std::abs(stated))
            add(c.file, c.z_G_line, Verdict::doubtful, "weight",
                fmt::format("has a mass of {:.6g} kg at {:.5g} m; included_mass and included_z say "
                            "{:.6g} kg at {:.5g} m",
                            *mass, z_G, base_.included_mass, base_.included_z));
    }

    const HydroDatabase& base_;
    const HydroSet& set_;
    const HydroData& data_;
    std::vector<PlacedCheck> list_;
};

}  // namespace

std::optional<WamitGeometry> read_wamit_geometry(const Path& file) {
    if (!std::filesystem::exists(file)) return std::nullopt;
    WamitGeometry g;
    g.file = file;
    Lines lines(file);
    const auto unread = [&](std::string why) {
        g.unread = std::move(why);
        g.unread_line = lines.line();
        return g;
    };
    const std::vector<double> units = lines.next();
    if (units.size() < 2) return unread("expected ULEN and GRAV");
    g.in_feet = std::abs(units[1] - 32.17) < 0.3;
    const double length = g.in_feet ? foot : 1.0;
    g.ulen = units[0] * length;
    g.gravity = units[1] * length;
    const std::vector<double> planes = lines.next();
    if (planes.size() < 2) return unread("expected ISX and ISY");
    g.yz = planes[0] != 0.0;
    g.xz = planes[1] != 0.0;
    const std::vector<double> count = lines.next();
    if (count.size() > 1 || (count.size() == 1 && count[0] < 1.0))
        return unread("the geometry is one of higher order");
    if (count.empty()) return unread("expected NPAN");
    std::vector<Panel> panels;
    for (double n = 0; n < count[0]; ++n) {
        const std::vector<double> x = lines.next(12);
        if (x.size() != 12)
            return unread(fmt::format("expected {:g} panels of 12 numbers; panel {:g} has {}",
                                      count[0], n + 1, x.size()));
        Panel& panel = panels.emplace_back();
        for (std::size_t i = 0; i < 4; ++i)
            panel[i] = length * Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    }
    g.hull = panel_hydrostatics(panels, g.yz, g.xz);
    return g;
}

std::optional<WamitControl> read_wamit_control(const Path& file) {
    if (!std::filesystem::exists(file)) return std::nullopt;
    WamitControl c;
    c.file = file;
    Lines lines(file);
    for (const double x : lines.next()) c.options.push_back(static_cast<int>(x));
    const std::vector<double> third = lines.next();
    const int third_line = lines.line();
    const std::vector<double> fourth = lines.next();
    const int fourth_line = lines.line();
    const std::vector<double> fifth = lines.next();
    if (third.empty() || fourth.size() < 3 || fifth.empty()) return c;
    if (fifth.size() >= 3) {
        c.form = 1;
        c.z_G = third[0];
        c.z_G_line = third_line;
        return c;
    }
    c.form = 2;
    c.density = third[0];
    c.z_G = fourth[2];
    c.z_G_line = fourth_line;
    if (fifth[0] == 1.0)
        if (const std::vector<double> M = lines.next(36); M.size() == 36) c.mass = M[14];
    return c;
}

std::vector<PlacedCheck> check_wamit_inputs(const HydroDatabase& database, const HydroSet& set,
                                            const HydroData& data) {
    return InputChecks(database, set, data).run();
}

}  // namespace hawser::io
