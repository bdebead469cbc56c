// Keys of the top level of a case file; platforms by their names.
#include "case/case.hpp"

#include <algorithm>

#include "case/declared.hpp"

namespace hawser {

const Table& case_keys() {
    static const Table table = [] {
        Keys<DeclaredCase> k("case");
        Key& format = k.only("format", "1", {}, "Version of this format, the first key of a file");
        format.fallback.clear();
        format.required();
        k.text("title", &DeclaredCase::title, "Title, copied to the results").def("");
        k.text("description", &DeclaredCase::description, "Longer text, copied to the results")
            .def("");
        Key& units = k.plain("units", Form::choice,
                             "What plain numbers of this file mean: kg m s N Pa, t m s kN kPa, or "
                             "kip ft s");
        units.choices = {"SI", "SI-kN", "US"};
        units.fallback = "SI";
        k.plain("include", Form::words, "Files merged first, relative to this file");
        k.plain("base", Form::path, "A case to start from; this file then only changes it")
            .eg("truss_spar.yml");
        k.plain("parameters", Form::open, "Named values, used as ${name}");
        k.plain("defaults", Form::open, "Keys for every element of line_types or of lines");
        k.map("environment", &DeclaredCase::environment, environment_keys,
              "Water, seabed, waves, current, wind")
            .required();
        k.map("platform", &DeclaredCase::platform, platform_keys, "The floating platform");
        k.named("platforms", &DeclaredCase::platforms, named_platform_keys,
                "Several platforms instead of one, by name; they act on each other by lines alone: "
                "no radiation from one to the other, no shielding");
        k.named("materials", &DeclaredCase::materials, material_keys,
                "Materials of pipes, by name");
        k.named("line_types", &DeclaredCase::line_types, line_type_keys,
                "Kinds of line section, by name");
        k.named("lines", &DeclaredCase::lines, line_keys, "Families of lines, by name");
        k.map("analysis", &DeclaredCase::analysis, analysis_keys, "How it is computed").required();
        k.map("output", &DeclaredCase::output, output_keys, "What is recorded");
        k.rule(KeyRule::Count::at_least_one, {"platform", "platforms", "lines"});
        k.rule(KeyRule::Count::at_most_one, {"platform", "platforms"});
        return k.done();
    }();
    return table;
}

std::vector<std::string> DeclaredCase::platform_names() const {
    std::vector<std::string> names;
    if (platform) names.push_back(platform->name);
    for (const PlatformKeys& p : platforms) names.push_back(p.name);
    return names;
}

int DeclaredCase::find_platform(const std::string& name) const {
    const std::vector<std::string> names = platform_names();
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

Vec3 DeclaredCase::design_of(int k) const {
    if (platform && k == 0) return platform->position;
    const auto i = static_cast<std::size_t>(k);
    return k >= 0 && i < platforms.size() ? platforms[i].position : Vec3::Zero().eval();
}

int DeclaredCase::platform_of(const LineKeys& line) const {
    for (const EndKeys* end : {&line.end_a, &line.end_b})
        if (end->platform) return find_platform(*end->platform);
    for (const ConstraintKeys& c : line.constraints)
        if (c.platform && *c.platform != "seabed") return find_platform(*c.platform);
    return -1;
}

}  // namespace hawser
