#include "io/case_schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "case/declared.hpp"
#include "io/json.hpp"
#include "io/quantity.hpp"

namespace hawser::io {
namespace {

constexpr const char* number_pattern =
    "[-+]?((0|[1-9][0-9]*)(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]+)?";
constexpr const char* unit_pattern = "[A-Za-z_]+(\\^?-?[1-4])?([./][A-Za-z_]+(\\^?-?[1-4])?)*";
constexpr const char* parameter_pattern = "\\$\\{[A-Za-z_][A-Za-z0-9_]*\\}";

Json pattern(const std::string& inside) {
    return Json::object().put("type", "string").put("pattern", "^" + inside + "$");
}

Json any_of(std::vector<Json> choices) {
    Json list = Json::array();
    for (Json& choice : choices) list.add(std::move(choice));
    return Json::object().put("anyOf", std::move(list));
}

Json names(const std::vector<std::string>& words) {
    Json list = Json::array();
    for (const std::string& word : words) list.add(word);
    return list;
}

std::string definition_name(const Dimension& d) {
    std::string name(d.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

class Schema {
 public:
    std::string run() {
        count_uses(case_keys());
        Json properties = loose(case_keys());
        Json needed = strict(case_keys());
        Json whole = Json::object();
        whole.put("$schema", "http://json-schema.org/draft-07/schema#");
        whole.put("title", "Case file of hawser");
        Json definitions = Json::object();
        definitions.put("parameter", pattern(parameter_pattern));
        for (auto& [name, json] : definitions_) definitions.put(name, std::move(json));
        whole.put("definitions", std::move(definitions));
        Json all = Json::array();
        all.add(std::move(properties));
        Json fragment = any_of({Json::object().put("required", names({"base"})),
                                Json::object().put("required", names({"include"}))});
        all.add(Json::object()
                    .put("if", std::move(fragment))
                    .put("then", Json::object())
                    .put("else", std::move(needed)));
        whole.put("allOf", std::move(all));
        return whole.text() + "\n";
    }

 private:
    /// How often each table stands in the format: what stands twice is defined once.
    void count_uses(const Table& table) {
        for (const Key& key : table.keys)
            if (key.table != nullptr && !key.is_later && ++uses_[&key.table()] == 1)
                count_uses(key.table());
    }

    /// A sub-table, or the reference to it.
    Json table(const Table& table) {
        if (uses_[&table] < 2) return loose(table);
        auto at = shared_.find(&table);
        if (at == shared_.end()) {
            std::string name = "keys_of_" + table.name;
            while (definitions_.contains(name)) name += "_";  // another table of the same name
            at = shared_.emplace(&table, name).first;
            definitions_.emplace(name, Json::object());  // the name is taken
            definitions_.insert_or_assign(name, loose(table));
        }
        return reference(at->second);
    }

    static Json reference(const std::string& name) {
        return Json::object().put("$ref", "#/definitions/" + name);
    }

    Json quantity(const Dimension& d) {
        const std::string name = definition_name(d);
        if (!definitions_.contains(name)) {
            const std::string number = number_pattern;
            std::vector<Json> ways;
            if (d.unit_required) {
                ways.push_back(Json::object().put("const", 0));
                ways.push_back(pattern(fmt::format("{} ?{}", number, unit_pattern)));
            } else {
                ways.push_back(Json::object().put("type", "number"));
                ways.push_back(
                    pattern(d.unit.empty() ? number : fmt::format("{}( ?{})?", number, units(d))));
            }
            ways.push_back(reference("parameter"));
            definitions_.emplace(name, any_of(std::move(ways)));
        }
        return reference(name);
    }

    /// Units of a dimension that has names of its own; else any compound.
    static std::string units(const Dimension& d) {
        std::string names;
        for (const char* word :
             {"m",   "mm",  "cm",   "km", "ft",       "in",  "nmi",  "s",    "ms",   "min", "h",
              "kg",  "t",   "te",   "lb", "kip_mass", "N",   "kN",   "MN",   "tf",   "lbf", "kip",
              "deg", "rad", "knot", "kn", "Hz",       "m/s", "ft/s", "km/h", "rad/s"}) {
            if (parse_unit(word)->exponents != d.exponents) continue;
            if (!names.empty()) names += "|";
            names += word;
        }
        const bool by_name = d == dimension::length || d == dimension::time ||
                             d == dimension::mass || d == dimension::force ||
                             d == dimension::angle || d == dimension::speed ||
                             d == dimension::frequency;
        return by_name ? fmt::format("({})", names) : unit_pattern;
    }

    Json limited(const Key& key, Json schema) {
        const bool pure = key.form == Form::integer ||
                          (!key.dimensions.empty() && key.dimensions[0] == dimension::number);
        if (!pure || (!key.lower && !key.upper)) return schema;
        Json all = Json::array();
        all.add(std::move(schema));
        Json range = Json::object();
        if (key.lower) range.put(key.lower_open ? "exclusiveMinimum" : "minimum", *key.lower);
        if (key.upper) range.put("maximum", *key.upper);
        all.add(std::move(range));
        return Json::object().put("allOf", std::move(all));
    }

    const Dimension& dimension_of(const Key& key, std::size_t i) {
        return key.dimensions[std::min(i, key.dimensions.size() - 1)];
    }

    Json row(const Key& key) {
        Json items = Json::array();
        for (std::size_t i = 0; i < std::min<std::size_t>(key.most, 3); ++i) {
            items.add(quantity(dimension_of(key, i)));
        }
        Json list = Json::object();
        list.put("type", "array");
        if (key.most > 3) {
            list.put("items", quantity(dimension_of(key, 0)));
        } else {
            list.put("items", std::move(items));
        }
        list.put("minItems", static_cast<int>(key.fewest));
        list.put("maxItems", static_cast<int>(key.most));
        return list;
    }

    Json matrix(const Key& key) {
        Json rows = Json::array();
        const std::size_t n = key.columns;
        const int size = static_cast<int>(n);
        for (std::size_t i = 0; i < n; ++i) {
            Json items = Json::array();
            for (std::size_t j = 0; j < n; ++j) items.add(quantity(dimension_of(key, i * n + j)));
            rows.add(Json::object()
                         .put("type", "array")
                         .put("items", std::move(items))
                         .put("minItems", size)
                         .put("maxItems", size));
        }
        return Json::object()
            .put("type", "array")
            .put("items", std::move(rows))
            .put("minItems", size)
            .put("maxItems", size);
    }

    Json words(const Key& key) {
        Json list = names(key.choices);
        return Json::object()
            .put("type", "array")
            .put("items", Json::object().put("enum", std::move(list)));
    }

    Json value(const Key& key) {
        switch (key.form) {
            case Form::number: {
                Json number = limited(key, quantity(key.dimensions.front()));
                for (std::size_t i = 1; i < key.dimensions.size(); ++i) {
                    number = any_of({std::move(number), quantity(key.dimensions[i])});
                }
                if (key.word.empty()) return number;
                return any_of({Json::object().put("const", key.word), std::move(number)});
            }
            case Form::integer:
                return any_of({limited(key, Json::object().put("type", "integer")),
                               pattern("(0|-?[1-9][0-9]*)"), reference("parameter")});
            case Form::flag: {
                Json both = Json::array();
                both.add(true).add(false).add("true").add("false");
                return any_of(
                    {Json::object().put("enum", std::move(both)), reference("parameter")});
            }
            case Form::choice: {
                if (key.choices.front() == "1") return Json::object().put("const", 1);
                return any_of(
                    {Json::object().put("enum", names(key.choices)), reference("parameter")});
            }
            case Form::words:
                if (key.choices.empty()) {  // include
                    return any_of({Json::object().put("type", "string"),
                                   Json::object()
                                       .put("type", "array")
                                       .put("items", Json::object().put("type", "string"))});
                }
                return words(key);
            case Form::numbers:
                if (key.fewest > 1) return limited_items(key);
                return any_of({limited(key, quantity(key.dimensions.front())), limited_items(key)});
            case Form::rows:
                return Json::object().put("type", "array").put("items", row(key));
            case Form::curve: {
                Key columns = key;
                columns.dimensions.erase(columns.dimensions.begin());
                Json number = limited(key, quantity(key.dimensions.front()));
                Json curve = Json::object().put("type", "array").put("items", row(columns));
                if (key.word.empty()) return any_of({std::move(number), std::move(curve)});
                return any_of(
                    {Json::object().put("const", key.word), std::move(number), std::move(curve)});
            }
            case Form::matrix:
                return matrix(key);
            case Form::modes: {
                Json diagonal = Json::object();
                static constexpr std::array modes{"surge", "sway", "heave", "roll", "pitch", "yaw"};
                for (std::size_t i = 0; i < 6; ++i) {
                    diagonal.put(modes[i], quantity(dimension_of(key, i * 7)));
                }
                return any_of({Json::object()
                                   .put("type", "object")
                                   .put("properties", std::move(diagonal))
                                   .put("additionalProperties", false),
                               matrix(key)});
            }
            case Form::place:
                if (!key.choices.empty()) {
                    return any_of({Json::object().put("enum", names(key.choices)),
                                   pattern("joint [1-9][0-9]*"), quantity(key.dimensions.front())});
                }
                return any_of({pattern("joint [1-9][0-9]*"), quantity(key.dimensions.front())});
            case Form::map:
                return table(key.table());
            case Form::list:
                return Json::object().put("type", "array").put("items", table(key.table()));
            case Form::named:
                return Json::object()
                    .put("type", "object")
                    .put("additionalProperties", table(key.table()));
            case Form::open:
                return Json::object().put("type", "object");
            case Form::entries:
                return Json::object()
                    .put("type", "array")
                    .put("items",
                         Json::object().put("type", "object").put("required", names({"name"})))
                    .put("minItems", 1);
            case Form::text:
            case Form::path:
                break;
        }
        return Json::object().put("type", names({"string", "number", "boolean"}));
    }

    Json limited_items(const Key& key) { return row(key); }

    /// Which keys there may be, and what they may hold.
    Json loose(const Table& table) {
        Json properties = Json::object();
        for (const Key& key : table.keys) {
            if (key.is_later) continue;
            std::string sentence = key.sentence;
            if (!key.worked_out.empty()) sentence += ". Default: " + key.worked_out;
            Json property = Json::object();
            property.put("description", sentence);
            if (!key.fallback.empty()) property.put("default", key.fallback);
            if (!key.example_text.empty()) property.put("examples", names({key.example_text}));
            Json all = Json::array();
            all.add(value(key));
            property.put("allOf", std::move(all));
            properties.put(key.name, std::move(property));
        }
        Json object = Json::object();
        object.put("type", "object");
        object.put("properties", std::move(properties));
        object.put("additionalProperties", false);
        Json all = Json::array();
        for (const KeyRule& rule : table.rules) {
            if (rule.count == KeyRule::Count::at_least_one) continue;
            for (std::size_t i = 0; i < rule.keys.size(); ++i) {
                for (std::size_t j = i + 1; j < rule.keys.size(); ++j) {
                    all.add(Json::object().put(
                        "not",
                        Json::object().put("required", names({rule.keys[i], rule.keys[j]}))));
                }
            }
        }
        for (const Key& key : table.keys) {
            if (key.condition_key.empty()) continue;
            const Key& other = *table.find(key.condition_key);
            Json holds = condition(key, other);
            Json no = Json::object().put("not", Json::object().put("required", names({key.name})));
            all.add(Json::object()
                        .put("if", std::move(holds))
                        .put("then", Json::object())
                        .put("else", std::move(no)));
        }
        if (!all.empty()) object.put("allOf", std::move(all));
        return object;
    }

    /// Is the condition of `key` met, as far as the file shows? Parameters count as met.
    static Json condition(const Key& key, const Key& other) {
        Json values = Json::array();
        for (const std::string& word : key.condition_words) {
            if (other.form == Form::flag) {
                values.add(word == "true").add(word);
            } else {
                values.add(word);
            }
        }
        Json property = Json::object().put("enum", std::move(values));
        if (other.form == Form::choice) {
            property = any_of({std::move(property), reference("parameter")});
        }
        Json holds = Json::object();
        holds.put("properties", Json::object().put(other.name, std::move(property)));
        // Without the other key its default decides; a required one may come from elsewhere.
        const auto& words = key.condition_words;
        const bool met = other.fallback.empty() ||
                         std::find(words.begin(), words.end(), other.fallback) != words.end();
        if (!met) holds.put("required", names({other.name}));
        return holds;
    }

    /// What a complete file must have, for the parts where that differs from `loose`.
    Json strict(const Table& table) {
        Json required = Json::array();
        Json properties = Json::object();
        Json all = Json::array();
        for (const Key& key : table.keys) {
            if (key.is_later || key.is_hidden) continue;
            if (key.is_required) required.add(key.name);
            if (key.is_needed) {
                const Key& other = *table.find(key.condition_key);
                Json holds = condition(key, other);
                if (other.is_required || other.fallback.empty()) {
                    holds.put("required", names({other.name}));
                }
                all.add(Json::object()
                            .put("if", std::move(holds))
                            .put("then", Json::object().put("required", names({key.name}))));
            }
            if (key.table == nullptr) continue;
            Json inner = strict(key.table());
            if (inner.empty()) continue;
            if (key.form == Form::list) {
                inner = Json::object().put("items", std::move(inner));
            } else if (key.form == Form::named) {
                // What like and taper name brings the rest.
                std::vector<Json> ways;
                for (const char* source : {"like", "taper"}) {
                    if (key.table().find(source) == nullptr) continue;
                    ways.push_back(Json::object().put("required", names({source})));
                }
                ways.push_back(std::move(inner));
                inner = Json::object().put("additionalProperties", any_of(std::move(ways)));
            }
            properties.put(key.name, std::move(inner));
        }
        for (const KeyRule& rule : table.rules) {
            if (rule.count == KeyRule::Count::at_most_one) continue;
            std::vector<Json> ways;
            for (const std::string& key : rule.keys) {
                ways.push_back(Json::object().put("required", names({key})));
            }
            all.add(any_of(std::move(ways)));
        }
        Json object = Json::object();
        if (!required.empty()) object.put("required", std::move(required));
        if (!properties.empty()) object.put("properties", std::move(properties));
        if (!all.empty()) object.put("allOf", std::move(all));
        return object;
    }

    std::map<std::string, Json> definitions_;
    std::map<const Table*, int> uses_;
    std::map<const Table*, std::string> shared_;  ///< under which definition
};

}  // namespace

std::string case_schema() { return Schema().run(); }

}  // namespace hawser::io
