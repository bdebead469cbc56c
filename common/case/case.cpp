// Keys of the top level of a case file.
#include "case/case.hpp"

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
        k.named("materials", &DeclaredCase::materials, material_keys,
                "Materials of pipes, by name");
        k.named("line_types", &DeclaredCase::line_types, line_type_keys,
                "Kinds of line section, by name");
        k.named("lines", &DeclaredCase::lines, line_keys, "Families of lines, by name");
        k.map("analysis", &DeclaredCase::analysis, analysis_keys, "How it is computed").required();
        k.map("output", &DeclaredCase::output, output_keys, "What is recorded");
        k.later("platforms", "Several platforms");
        k.rule(KeyRule::Count::at_least_one, {"platform", "lines"});
        return k.done();
    }();
    return table;
}

}  // namespace hawser
