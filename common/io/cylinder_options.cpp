#include "io/cylinder_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/option_numbers.hpp"

namespace hawser::io {
namespace {

using Problems = std::vector<std::string>;

/// One number, `least` or more (or more than it, if `open`).
double read(const char* name, const std::string& text, const char* what, double least, bool open,
            Problems& problems) {
    const std::optional<double> value = number_of(text);
    if (!value || (open ? *value <= least : *value < least)) {
        problems.push_back(fmt::format("{}: expected {}; got \"{}\"", name, what, text));
        return 1.0;
    }
    return *value;
}

/// FROM:TO:STEP, a list with commas, or one number; ascending.
std::vector<double> read_list(const char* name, const std::string& text, const char* example,
                              Problems& problems) {
    const auto refuse = [&](const char* why) {
        problems.push_back(fmt::format("{} {}: {}, e.g. {}", name, text, why, example));
        return std::vector<double>{1.0};
    };
    constexpr double most = 10000;
    if (text.find(':') == std::string::npos) {
        const auto list = numbers_of(text, ',');
        if (!list) return refuse("expected FROM:TO:STEP or a list of numbers");
        for (std::size_t i = 1; i < list->size(); ++i)
            if ((*list)[i] <= (*list)[i - 1]) return refuse("expected ascending numbers");
        return *list;
    }
    const auto range = numbers_of(text, ':');
    if (!range || range->size() != 3) return refuse("expected FROM:TO:STEP or a list of numbers");
    const double from = (*range)[0], to = (*range)[1], step = (*range)[2];
    if (step <= 0.0 || to < from) return refuse("expected TO above FROM and STEP above zero");
    const double steps = std::floor((to - from) / step + 1e-9);
    if (steps > most) return refuse("expected at most 10000 values");
    std::vector<double> out;
    for (int i = 0; i <= static_cast<int>(steps); ++i) out.push_back(from + i * step);
    return out;
}

std::optional<hydro::FreeHull> read_free_hull(const CylinderOptions& o, double& fraction,
                                              Problems& problems) {
    const std::pair<const char*, const std::string&> others[] = {
        {"--cog", o.cog},
        {"--gyration", o.gyration},
        {"--heave-added-mass", o.heave_added_mass},
        {"--heave-damping", o.heave_damping}};
    if (o.mass.empty()) {
        for (const auto& [name, text] : others)
            if (!text.empty())
                problems.push_back(
                    fmt::format("{}: needs --mass; without it the hull is fixed", name));
        return std::nullopt;
    }
    hydro::FreeHull free;
    free.mass = read("--mass", o.mass, "a mass in kg, above zero", 0.0, true, problems);
    if (o.cog.empty())
        problems.emplace_back("--cog: expected with --mass, z of the centre of gravity in m");
    else
        free.cog = read("--cog", o.cog, "z of the centre of gravity in m", -1e9, false, problems);
    if (o.gyration.empty())
        problems.emplace_back("--gyration: expected with --mass, the radius about it in m");
    else
        free.gyration =
            read("--gyration", o.gyration, "a radius in m, above zero", 0.0, true, problems);
    if (!o.heave_added_mass.empty())
        free.heave_added_mass = read("--heave-added-mass", o.heave_added_mass,
                                     "a mass in kg, not negative", 0.0, false, problems);
    if (!o.heave_damping.empty())
        fraction = read("--heave-damping", o.heave_damping, "a fraction of critical, not negative",
                        0.0, false, problems);
    return free;
}

}  // namespace

hydro::CylinderRequest cylinder_request(const CylinderOptions& o, Problems& problems) {
    hydro::CylinderRequest request;
    bool hull_read = !o.parts.empty() && !o.depth.empty();
    if (o.depth.empty())
        problems.emplace_back("--depth: expected, the water depth in m");
    else
        request.hull.depth =
            read("--depth", o.depth, "a depth in m, above zero", 0.0, true, problems);
    if (o.parts.empty()) problems.emplace_back("--part: expected RADIUS,TOP,BOTTOM, e.g. 20,0,-70");
    for (const std::string& text : o.parts) {
        const auto part = numbers_of(text, ',');
        if (part && part->size() == 3) {
            request.hull.parts.push_back({(*part)[0], (*part)[1], (*part)[2]});
        } else {
            hull_read = false;
            problems.push_back(
                fmt::format("--part {}: expected RADIUS,TOP,BOTTOM, e.g. 20,0,-70", text));
        }
    }
    if (hull_read)
        for (const std::string& problem : hydro::problems_of(request.hull))
            problems.push_back("--" + problem);
    if (o.frequencies.empty())
        problems.emplace_back("--frequencies: expected in rad/s, e.g. 0.02:2.5:0.02");
    else
        request.frequencies = read_list("--frequencies", o.frequencies, "0.02:2.5:0.02", problems);
    if (!request.frequencies.empty() && request.frequencies.front() <= 0.0)
        problems.push_back(
            fmt::format("--frequencies {}: expected above zero; the limits of zero and infinite "
                        "frequency are always written",
                        o.frequencies));
    request.headings = read_list("--headings", o.headings, "0:90:15", problems);
    for (double& heading : request.headings) heading *= M_PI / 180.0;
    request.water.density =
        read("--rho", o.rho, "a density in kg/m3, above zero", 0.0, true, problems);
    request.water.gravity =
        read("--g", o.g, "an acceleration in m/s2, above zero", 0.0, true, problems);
    if (!o.tolerance.empty())
        request.tolerance =
            read("--tolerance", o.tolerance, "a relative error above zero", 0.0, true, problems);
    request.free = read_free_hull(o, request.heave_damping_fraction, problems);
    if (o.out.empty())
        problems.emplace_back("--out: expected, where to write: STEM.1, STEM.3 and so on");
    return request;
}

}  // namespace hawser::io
