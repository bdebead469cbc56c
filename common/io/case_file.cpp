#include "io/case_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "io/case_echo.hpp"
#include "io/case_tree.hpp"
#include "io/history_file.hpp"
#include "io/key_reader.hpp"
#include "io/weather_tables.hpp"

namespace hawser::io {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> text_of(const fs::path& path) {
    std::error_code status;
    if (!fs::is_regular_file(path, status)) return {};
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) return {};
    return text.str();
}

/// Turns YAML into our own tree: keeps places, refuses repeated keys and merge keys.
class FromYaml {
 public:
    FromYaml(std::string file, Units units, Problems& problems)
        : file_(std::move(file)), units_(units), problems_(problems) {}

    Node node(const YAML::Node& yaml, int depth = 0) {
        Node result;
        result.place = place(yaml.Mark());
        result.units = units_;
        if (depth > 50) {
            error(result.place, "nested too deep");
            return result;
        }
        if (yaml.IsScalar()) {
            result.kind = Node::Kind::scalar;
            result.text = yaml.Scalar();
        } else if (yaml.IsSequence()) {
            result.kind = Node::Kind::list;
            for (const auto& item : yaml) result.items.push_back(node(item, depth + 1));
        } else if (yaml.IsMap()) {
            result.kind = Node::Kind::map;
            for (const auto& item : yaml) entry(result, item.first, item.second, depth);
        }
        return result;
    }

 private:
    void entry(Node& map, const YAML::Node& key, const YAML::Node& value, int depth) {
        const Place at = place(key.Mark());
        if (!key.IsScalar()) return error(at, "a key must be a word");
        const std::string& name = key.Scalar();
        if (name == "<<") {
            map.partial = true;
            return error(at, "merge key \"<<\" is not supported; use \"like:\"");
        }
        for (const Entry& e : map.entries) {
            if (e.key != name) continue;
            return error(
                at, fmt::format("key \"{}\" given twice, first at line {}", name, e.place.line));
        }
        Entry added{name, at, node(value, depth + 1), {}};
        if (added.value.kind == Node::Kind::nothing) added.value.place = at;
        map.entries.push_back(std::move(added));
    }

    Place place(const YAML::Mark& mark) const {
        return {file_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
    }
    void error(const Place& at, const std::string& message) {
        problems_.push_back(problem_at(at, "", message));
    }

    std::string file_;
    Units units_;
    Problems& problems_;
};

Units units_of(const YAML::Node& yaml, const std::string& file, Problems& problems) {
    if (!yaml.IsMap()) return Units::SI;
    for (const auto& item : yaml) {
        if (!item.first.IsScalar() || item.first.Scalar() != "units") continue;
        const std::string word = item.second.IsScalar() ? item.second.Scalar() : "";
        if (word == "SI") return Units::SI;
        if (word == "SI-kN") return Units::SI_kN;
        if (word == "US") return Units::US;
        const YAML::Mark mark = item.second.Mark();
        problems.push_back(
            problem_at({file, mark.line + 1, mark.column + 1}, "units",
                       fmt::format("expected one of SI, SI-kN, US; got \"{}\"", word)));
    }
    return Units::SI;
}

/// A file with everything it is based on and includes.
class Loader {
 public:
    Loader(Problems& problems, std::vector<std::pair<std::string, std::string>>& sources)
        : problems_(problems), sources_(sources) {}

    Node parse(const std::string& text, const std::string& file) {
        try {
            std::vector<YAML::Node> documents = YAML::LoadAll(text);
            if (documents.size() > 1) {
                problems_.push_back(
                    problem_at({file, documents[1].Mark().line + 1, 1}, "",
                               "a second document starts here; a case is one document"));
            }
            if (documents.empty() || documents[0].IsNull()) {
                problems_.push_back(problem_at({file, 1, 1}, "", "the file is empty"));
                unreadable_ = true;
                Node empty;
                empty.kind = Node::Kind::map;
                empty.place = {file, 1, 1};
                return empty;
            }
            const Units units = units_of(documents[0], file, problems_);
            return FromYaml(file, units, problems_).node(documents[0]);
        } catch (const YAML::ParserException& e) {
            problems_.push_back(problem_at({file, e.mark.line + 1, e.mark.column + 1}, "",
                                           reworded(e.msg, text, e.mark.line)));
        } catch (const YAML::Exception& e) {
            problems_.push_back(problem_at({file, 1, 1}, "", e.msg));
        }
        unreadable_ = true;
        Node nothing;
        nothing.kind = Node::Kind::map;
        nothing.place = {file, 1, 1};
        return nothing;
    }

    Node load(const fs::path& path, const std::string& text) {
        stack_.push_back(fs::weakly_canonical(path));
        sources_.emplace_back(path.string(), text);
        Node own = parse(text, path.string());
        Node merged;
        merged.kind = Node::Kind::map;
        merged.place = own.place;
        if (own.kind != Node::Kind::map) {
            problems_.push_back(problem_at(
                own.place, "", fmt::format("expected a map of keys; got {}", found(own))));
            unreadable_ = true;
            own = merged;
        }
        if (const Node* base = own.find("base")) add(*base, "base", path, merged);
        if (const Node* include = own.find("include")) {
            if (include->kind == Node::Kind::list) {
                for (std::size_t i = 0; i < include->items.size(); ++i) {
                    add(include->items[i], fmt::format("include[{}]", i), path, merged);
                }
            } else {
                add(*include, "include", path, merged);
            }
        }
        own.remove("base");
        own.remove("include");
        own.remove("units");
        merge(merged, own);
        merged.place = own.place;
        stack_.pop_back();
        return merged;
    }

    /// A syntax error leaves nothing to check.
    [[nodiscard]] bool unreadable() const { return unreadable_; }

 private:
    void add(const Node& name, const std::string& key, const fs::path& from, Node& merged) {
        if (name.kind != Node::Kind::scalar) {
            problems_.push_back(problem_at(
                name.place, key, fmt::format("expected a file name; got {}", found(name))));
            return;
        }
        const fs::path path = (from.parent_path() / name.text).lexically_normal();
        if (std::find(stack_.begin(), stack_.end(), fs::weakly_canonical(path)) != stack_.end()) {
            problems_.push_back(
                problem_at(name.place, key, fmt::format("\"{}\" leads back to itself", name.text)));
            unreadable_ = true;
            return;
        }
        const std::optional<std::string> text = text_of(path);
        if (!text) {
            problems_.push_back(
                problem_at(name.place, key, fmt::format("cannot read \"{}\"", path.string())));
            unreadable_ = true;
            return;
        }
        merge(merged, load(path, *text));
    }

    static std::string reworded(const std::string& message, const std::string& text, int line) {
        std::istringstream lines(text);
        std::string at;
        for (int i = 0; i <= line && std::getline(lines, at); ++i) {
        }
        const std::size_t start = at.find_first_not_of(' ');
        if (start != std::string::npos && at[start] == '\t') {
            return "a tab is used for indentation; YAML needs spaces";
        }
        if (at.find("${") != std::string::npos) {
            return message + "; inside {...}, ${name} must be in quotes: \"${name}\"";
        }
        return "this is not YAML: " + message;
    }

    Problems& problems_;
    std::vector<std::pair<std::string, std::string>>& sources_;
    std::vector<fs::path> stack_;
    bool unreadable_ = false;
};

/// Is `format` the first key of the file itself (what it includes is merged before it)?
bool starts_with_format(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#' || line[0] == '%' || line.starts_with("---")) continue;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        return line.starts_with("format");
    }
    return false;
}

/// Are the files of a database there? What is in them is another question.
void hydro_files(const Case& value, const Platform& p, Problems& problems) {
    if (!p.hydrodynamics.database) return;
    const Hydrodynamics& hydro = p.hydrodynamics;
    const HydroDatabase& database = *hydro.database;
    const std::string& stem = database.path;
    if (stem.empty()) return;
    const auto missing = [&](const char* key, const std::string& message) {
        problems.push_back({Severity::error, p.key_path + ".hydrodynamics" + key, message, {}});
    };
    const bool by_stem =
        database.format == HydroFormat::wamit || database.format == HydroFormat::hams;
    if (!by_stem) {
        const bool folder = database.format == HydroFormat::nemoh;
        if (folder ? !fs::is_directory(stem) : !fs::is_regular_file(stem))
            missing(".database.path",
                    fmt::format("there is no {} {}", folder ? "folder" : "file", stem));
        return;
    }
    std::vector<std::string> endings{".1", ".hst"};
    const bool haskind = !fs::is_regular_file(stem + ".3") && fs::is_regular_file(stem + ".2");
    if (!value.environment.waves.empty() && !haskind) endings.emplace_back(".3");
    for (const std::string& ending : endings)
        if (!fs::is_regular_file(stem + ending))
            missing(".database.path", fmt::format("there is no file {}{}", stem, ending));
    if (hydro.drift == Drift::none || value.environment.waves.empty()) return;
    const bool full = hydro.drift == Drift::full_qtf;
    for (const char* ending : {".12d", ".11d", ".10d"})
        if (fs::is_regular_file(stem + ending)) return;
    if (!full)
        for (const char* ending : {".8", ".9", ".7"})
            if (fs::is_regular_file(stem + ending)) return;
    missing(".drift",
            full ? fmt::format("there is no file {0}.12d (.11d, .10d) with a difference-frequency "
                               "QTF; newman does with the mean drift of a .8, .9 or .7",
                               stem)
                 : fmt::format("there is no file {}.8 with drift data", stem));
}

/// What the main file defines and nothing uses. Libraries that it includes may hold more.
void unused(const DeclaredCase& declared, const Places& places, const std::string& file,
            Problems& problems) {
    std::set<std::string> types, materials;
    for (const LineKeys& line : declared.lines) {
        for (const SectionKeys& section : line.sections) types.insert(section.type);
    }
    const auto warn = [&](const std::string& path, const char* message) {
        const auto place = places.find(path);
        if (place == places.end() || place->second.file != file) return;
        problems.push_back(problem_at(place->second, path, message, Severity::warning));
    };
    for (const LineTypeKeys& type : declared.line_types) {
        if (type.taper && types.contains(type.name)) {
            types.insert(type.taper->from);
            types.insert(type.taper->to);
        }
    }
    for (const LineTypeKeys& type : declared.line_types) {
        if (type.material) materials.insert(*type.material);
        if (!types.contains(type.name)) {
            warn("line_types." + type.name, "no line uses this line type");
        }
    }
    for (const Material& material : declared.materials) {
        if (!materials.contains(material.name)) {
            warn("materials." + material.name, "no line type uses this material");
        }
    }
}

/// From the merged tree to the Case, and to the resolved text.
CaseFile finish(Node root, const std::string& name, const std::string& file, const fs::path& folder,
                bool overridden, Problems problems) {
    carry_out_likes(root, problems);
    fill_in(root, overridden, problems);
    DeclaredCase declared;
    KeyReader reader(problems);
    reader.set_folder(folder);
    reader.read(case_keys(), root, &declared, "");
    read_weather_tables(declared.environment, folder, file.empty(), problems);
    complete(declared, reader.given(), problems);
    CaseFile result;
    result.value = build(declared, name, folder, problems);
    check(result.value, declared, problems);
    const double duration = result.value.analysis.dynamics.duration;
    if (result.value.platform) read_histories(*result.value.platform, duration, problems);
    for (Platform& p : result.value.further_platforms) read_histories(p, duration, problems);
    if (!file.empty()) {
        for (int k = 0; k < result.value.platform_count(); ++k)
            hydro_files(result.value, result.value.platform_at(k), problems);
        unused(declared, reader.places(), file, problems);
    }
    result.file = file;
    result.places = reader.places();
    locate(problems, result);
    tidy(problems);
    if (has_errors(problems)) throw InputError(std::move(problems));
    result.resolved = echo(declared, reader, folder);
    for (const Problem& p : problems) result.notes.push_back(format(p));
    result.problems = std::move(problems);
    return result;
}

}  // namespace

void locate(Problems& problems, const CaseFile& file) {
    for (Problem& p : problems) {
        if (!p.file.empty() || p.line > 0) continue;
        std::string path = p.path;
        auto place = file.places.find(path);
        while (place == file.places.end() && !path.empty()) {
            const std::size_t cut = path.find_last_of(".[");
            path = cut == std::string::npos ? "" : path.substr(0, cut);
            place = file.places.find(path);
        }
        if (place == file.places.end()) {
            p.file = file.file;
            continue;
        }
        p.file = place->second.file;
        p.line = place->second.line;
        p.column = place->second.column;
    }
}

CaseFile read_case(const fs::path& path, const Overrides& overrides) {
    const std::optional<std::string> text = text_of(path);
    if (!text) throw RunError(ExitCode::io, fmt::format("cannot read the case {}", path.string()));
    Problems problems;
    std::vector<std::pair<std::string, std::string>> sources;
    Loader loader(problems, sources);
    Node root = loader.load(path, *text);
    if (loader.unreadable()) {
        tidy(problems);
        throw InputError(std::move(problems));
    }
    const Node* format = root.find("format");  // of the file itself, or of its base
    if (format != nullptr && format->place.file == root.place.file && !starts_with_format(*text)) {
        problems.push_back(problem_at(root.find("format")->place, "format",
                                      "is not the first key of the case", Severity::warning));
    }
    for (const auto& [key, value] : overrides) {
        Problems unused;
        Node node;
        try {
            node = FromYaml("--set", Units::SI, unused).node(YAML::Load(value));
        } catch (const YAML::Exception&) {
            node.kind = Node::Kind::scalar;
            node.text = value;
        }
        const std::function<void(Node&)> mark = [&mark, origin = "--set " + key](Node& n) {
            n.place = {origin, 0, 0};
            for (Node& item : n.items) mark(item);
            for (Entry& e : n.entries) {
                e.place = n.place;
                mark(e.value);
            }
        };
        mark(node);
        if (key == "units" || key == "include" || key == "base") {
            problems.push_back(problem_at(
                node.place, key,
                fmt::format("belongs to the text of a file and cannot be set from outside{}",
                            key == "units" ? "; write numbers with their unit" : "")));
            continue;
        }
        const Node* waves = root.find("environment");
        if (waves != nullptr) waves = waves->find("waves");
        if (key.starts_with("environment.waves[") && (waves == nullptr || waves->items.empty())) {
            problems.push_back(problem_at(node.place, key, "the case has no waves"));
            continue;
        }
        set_value(root, key, node, problems);
    }
    const std::string name = path.stem().string();
    const fs::path folder = path.parent_path();
    CaseFile first = finish(std::move(root), name, path.string(), folder, !overrides.empty(),
                            std::move(problems));
    // The case that runs is the one that every rank reads from the resolved text.
    CaseFile result = read_resolved_case(name, first.resolved, folder);
    result.notes = std::move(first.notes);
    result.problems = std::move(first.problems);
    result.sources = std::move(sources);
    result.file = std::move(first.file);
    result.places = std::move(first.places);
    return result;
}

CaseFile read_resolved_case(const std::string& name, const std::string& text,
                            const fs::path& folder) {
    Problems problems;
    std::vector<std::pair<std::string, std::string>> sources;
    Loader loader(problems, sources);
    Node root = loader.parse(text, "");
    if (loader.unreadable()) throw InputError(std::move(problems));
    CaseFile result = finish(std::move(root), name, "", folder, false, std::move(problems));
    result.resolved = text;
    return result;
}

}  // namespace hawser::io
