// Parameters ${name} and families of lines: the text-level part of a case that makes several out of
// one.
#include <fmt/format.h>

#include <numbers>
#include <set>

#include "case/declared.hpp"
#include "io/case_tree.hpp"
#include "io/key_reader.hpp"

namespace hawser::io {
namespace {

using Names = std::map<std::string, Node>;

class Filling {
 public:
    Filling(Node& root, Problems& problems) : root_(root), problems_(problems) {}

    void run(bool overridden) {
        Names parameters = take_parameters();
        for (Entry& e : root_.entries) {
            if (e.key == "lines" && e.value.kind == Node::Kind::map) {
                lines(e.value, parameters);
            } else {
                substitute(e.value, parameters, e.key);
            }
        }
        for (const auto& [name, node] : parameters) {
            if (used_.contains(name) || overridden) continue;
            problems_.push_back(problem_at(node.place, "parameters." + name,
                                           "nothing uses this parameter", Severity::warning));
        }
    }

 private:
    Names take_parameters() {
        Names parameters;
        if (const Node* given = root_.find("parameters")) {
            if (given->kind != Node::Kind::map) {
                problems_.push_back(
                    problem_at(given->place, "parameters",
                               fmt::format("expected a map of names; got {}", found(*given))));
            }
            for (const Entry& e : given->entries) {
                if (e.value.kind == Node::Kind::scalar) {
                    parameters[e.key] = e.value;
                } else {
                    problems_.push_back(
                        problem_at(e.place, "parameters." + e.key,
                                   fmt::format("expected one value; got {}", found(e.value))));
                }
            }
            root_.remove("parameters");
        }
        return parameters;
    }

    void substitute(Node& node, const Names& names, const std::string& path) {
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            substitute(node.items[i], names, fmt::format("{}[{}]", path, i));
        }
        for (Entry& e : node.entries) substitute(e.value, names, path + "." + e.key);
        if (node.kind != Node::Kind::scalar) return;
        for (std::size_t at = node.text.find("${"); at != std::string::npos;
             at = node.text.find("${", at)) {
            const std::size_t end = node.text.find('}', at);
            if (end == std::string::npos) {
                problems_.push_back(problem_at(node.place, path, "\"${\" without \"}\""));
                return;
            }
            const std::string name = node.text.substr(at + 2, end - at - 2);
            const auto value = names.find(name);
            if (value == names.end()) {
                std::vector<std::string> known;
                for (const auto& [word, unused] : names) known.push_back(word);
                problems_.push_back(problem_at(
                    node.place, path,
                    fmt::format("unknown parameter \"{}\"{}", name, suggestion(name, known))));
                return;
            }
            used_.insert(name);
            if (at == 0 && end + 1 == node.text.size()) node.units = value->second.units;
            node.text.replace(at, end + 1 - at, value->second.text);
            at += value->second.text.size();
        }
    }

    void lines(Node& map, const Names& parameters) {
        std::vector<Entry> expanded;
        for (Entry& family : map.entries) {
            const std::string path = "lines." + family.key;
            if (family.value.kind != Node::Kind::map) {
                expanded.push_back(family);
                continue;
            }
            const std::size_t ways = (family.value.find("each") != nullptr ? 1U : 0U) +
                                     (family.value.find("pattern") != nullptr ? 1U : 0U) +
                                     (family.value.find("positions") != nullptr ? 1U : 0U);
            if (ways > 1) {
                problems_.push_back(problem_at(
                    family.place, path, "give only one of \"pattern\", \"positions\", \"each\""));
            }
            if (family.value.find("each") != nullptr) {
                each(family, parameters, path, expanded);
                continue;
            }
            substitute(family.value, parameters, path);
            if (const Node* top = family.value.find("top_z");
                top != nullptr && family.value.find("positions") == nullptr) {
                problems_.push_back(problem_at(top->place, path + ".top_z", "only with positions"));
            }
            if (family.value.find("pattern") != nullptr) {
                pattern(family, path, expanded);
            } else if (family.value.find("positions") != nullptr) {
                positions(family, path, expanded);
            } else {
                expanded.push_back(family);
                expanded.back().shown = family.key;
            }
        }
        std::map<std::string, Place> names;
        for (const Entry& line : expanded) {
            if (!names.emplace(line.key, line.place).second) {
                problems_.push_back(
                    problem_at(line.place, "lines." + line.shown,
                               fmt::format("two lines are named \"{}\"", line.key)));
            }
        }
        map.entries = std::move(expanded);
    }

    /// One line of a family: the family's keys without those that describe the family.
    Entry line_of(const Entry& family, const std::string& name) const {
        Entry line{name, family.place, family.value, family.key};
        for (const char* key : {"pattern", "positions", "each", "top_z"}) line.value.remove(key);
        if (line.value.find("family") == nullptr) {
            line.value.put("family", scalar(family.key, family.place));
        }
        return line;
    }

    static Node scalar(const std::string& text, const Place& place) {
        Node node;
        node.kind = Node::Kind::scalar;
        node.text = text;
        node.place = place;
        return node;
    }

    static std::string numbered(std::string name, int n) {
        if (const std::size_t at = name.find("{n}"); at != std::string::npos) {
            name.replace(at, 3, std::to_string(n));
        }
        return name;
    }

    bool has_number(const std::string& names, const Place& place, const std::string& path) {
        if (names.find("{n}") != std::string::npos) return true;
        problems_.push_back(problem_at(
            place, path + ".names", "several lines need \"{n}\" in their names, e.g. \"ml{n}\""));
        return false;
    }

    void pattern(const Entry& family, const std::string& path, std::vector<Entry>& out) {
        const Node& node = *family.value.find("pattern");
        PatternKeys p;
        KeyReader reader(problems_);
        const std::size_t before = problems_.size();
        reader.read(pattern_keys(), node, &p, path + ".pattern");
        const int count = p.groups * p.per_group;
        if (problems_.size() != before ||
            (count > 1 && !has_number(p.names, node.place, path + ".pattern"))) {
            out.push_back(line_of(family, family.key));
            out.back().value.put("azimuth", scalar("0 deg", node.place));
            return;
        }
        int n = 0;
        for (int i = 0; i < p.groups; ++i) {
            for (int j = 0; j < p.per_group; ++j) {
                const double azimuth =
                    p.first_group + i * p.group_spacing + (j - (p.per_group - 1) / 2.0) * p.spacing;
                Entry line = line_of(family, numbered(p.names, ++n));
                line.value.put("azimuth",
                               scalar(print_quantity(azimuth, dimension::angle), node.place));
                out.push_back(std::move(line));
            }
        }
    }

    void positions(const Entry& family, const std::string& path, std::vector<Entry>& out) {
        const Node& node = *family.value.find("positions");
        PositionsKeys p;
        KeyReader reader(problems_);
        const std::size_t before = problems_.size();
        reader.read(positions_keys(), node, &p, path + ".positions");
        const Node* top = family.value.find("top_z");
        const Node* end = family.value.find("end_a");
        const bool free = end != nullptr && end->find("free") != nullptr;
        if (top == nullptr) {
            problems_.push_back(problem_at(node.place, path, "positions need \"top_z\""));
        }
        if (problems_.size() != before || end == nullptr || end->kind != Node::Kind::map ||
            (p.xy.size() > 1 && !has_number(p.names, node.place, path + ".positions"))) {
            out.push_back(line_of(family, family.key));
            return;
        }
        int n = 0;
        for (const std::vector<double>& xy : p.xy) {
            Entry line = line_of(family, numbered(p.names, ++n));
            Node place;
            place.kind = Node::Kind::list;
            place.place = node.place;
            for (const double x : xy) {
                place.items.push_back(scalar(print_quantity(x, dimension::length), node.place));
            }
            place.items.push_back(*top);
            const bool moves = end->find("platform") != nullptr;
            line.value.find("end_a")->put(moves || free ? "position" : "fixed", place);
            out.push_back(std::move(line));
        }
    }

    void each(const Entry& family, const Names& parameters, const std::string& path,
              std::vector<Entry>& out) {
        const Node& list = *family.value.find("each");
        if (list.kind != Node::Kind::list || list.items.empty()) {
            problems_.push_back(problem_at(
                list.place, path + ".each",
                fmt::format("expected a list of maps, one line each; got {}", found(list))));
        }
        for (std::size_t i = 0; i < list.items.size(); ++i) {
            Node entry = list.items[i];
            const std::string where = fmt::format("{}.each[{}]", path, i);
            substitute(entry, parameters, where);
            const Node* name = entry.find("name");
            if (name == nullptr || name->kind != Node::Kind::scalar) {
                problems_.push_back(
                    problem_at(entry.place, where, "required key \"name\" is missing"));
                continue;
            }
            Names names = parameters;
            for (const Entry& e : entry.entries) {
                if (e.value.kind == Node::Kind::scalar) names[e.key] = e.value;
            }
            Entry line = line_of(family, name->text);
            substitute(line.value, names, path);
            out.push_back(std::move(line));
        }
    }

    Node& root_;
    Problems& problems_;
    std::set<std::string> used_;
};

}  // namespace

void fill_in(Node& root, bool overridden, Problems& problems) {
    Filling(root, problems).run(overridden);
}

}  // namespace hawser::io
