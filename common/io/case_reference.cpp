// The reference case: every key with its sentence, kind, default and range.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "case/declared.hpp"
#include "io/case_schema.hpp"
#include "io/quantity.hpp"

namespace hawser::io {
namespace {

std::string kind(const Key& key) {
    switch (key.form) {
        case Form::integer:
            return "whole number";
        case Form::flag:
            return "true or false";
        case Form::text:
            return "text";
        case Form::path:
            return "file name";
        case Form::choice:
            return fmt::format("{}", fmt::join(key.choices, " | "));
        case Form::words:
            return key.choices.empty() ? "list of file names"
                                       : fmt::format("list of {}", fmt::join(key.choices, ", "));
        case Form::matrix:
            return "matrix";
        case Form::modes:
            return "map of surge ... yaw, or 6 rows of 6";
        case Form::place:
            return key.choices.empty()
                       ? "length, or joint n"
                       : fmt::format("length, joint n, {}", fmt::join(key.choices, ", "));
        case Form::map:
            return {};
        case Form::list:
            return "list";
        case Form::named:
            return "map of names";
        case Form::open:
            return "map";
        case Form::entries:
            return "list of maps";
        default:
            break;
    }
    const Dimension& d = key.dimensions.front();
    std::string text = std::string(d.name);
    if (key.form == Form::numbers) text = "list of " + text;
    if (key.form == Form::rows) text = "rows of numbers";
    if (!d.unit.empty() && key.form != Form::rows) text += fmt::format(" [{}]", d.unit);
    if (key.form == Form::curve) text += ", or rows of numbers";
    if (key.dimension_index) {
        for (std::size_t i = 1; i < key.dimensions.size(); ++i) {
            text += fmt::format(", or {} [{}]", key.dimensions[i].name, key.dimensions[i].unit);
        }
    }
    return text;
}

std::string range(const Key& key) {
    if (!key.lower && !key.upper) return {};
    const Dimension d = key.dimensions.empty() ? dimension::number : key.dimensions.front();
    std::string text;
    if (key.lower) {
        text =
            fmt::format("{} {}", key.lower_open ? "above" : "from", print_quantity(*key.lower, d));
    }
    if (key.upper) {
        text += fmt::format("{}{} {}", text.empty() ? "" : " ", key.lower ? "to" : "at most",
                            print_quantity(*key.upper, d));
    }
    return text;
}

class Reference {
 public:
    std::string run() {
        std::string text =
            "# yaml-language-server: $schema=case.schema.json\n"
            "#\n"
            "# Every key of a case file: what it means, its kind [unit of a plain number], range\n"
            "# and default. Written by `hawser schema --reference`; not a case to run.\n"
            "# \"##\" explains the key below it; keys behind \"#\" are optional or stand instead "
            "of "
            "others.\n";
        return text + table(case_keys(), 0, false);
    }

 private:
    std::string table(const Table& table, int indent, bool commented) {
        std::string text;
        for (const Key& key : table.keys) {
            if (!key.is_later) text += entry(table, key, indent, commented);
        }
        return text;
    }

    static bool instead(const Table& table, const Key& key) {
        for (const KeyRule& rule : table.rules) {
            if (rule.count == KeyRule::Count::at_least_one) continue;
            const auto at = std::find(rule.keys.begin(), rule.keys.end(), key.name);
            if (at != rule.keys.end() && at != rule.keys.begin()) return true;
        }
        return false;
    }

    /// Does the condition of a key hold for the other key's value in the reference?
    static bool applies(const Table& table, const Key& key) {
        if (key.condition_key.empty()) return true;
        const auto& words = key.condition_words;
        const std::string value = plain_value(*table.find(key.condition_key));
        return std::find(words.begin(), words.end(), value) != words.end();
    }

    static std::string plain_value(const Key& key) {
        if (!key.example_text.empty()) return key.example_text;
        if (!key.fallback.empty()) return key.fallback;
        return key.choices.empty() ? std::string() : key.choices.front();
    }

    std::string entry(const Table& table, const Key& key, int indent, bool commented) {
        const bool optional =
            instead(table, key) || key.is_hidden || !applies(table, key) ||
            (key.table == nullptr && key.fallback.empty() && !key.is_required && !key.is_needed);
        const bool off = commented || optional;
        std::string text = comment(key, indent);
        const std::string start = fmt::format("{:{}}{}", "", indent, off ? "# " : "");
        if (key.table == nullptr) {
            std::string value = plain_value(key);
            if (value.empty() && key.form == Form::text) value = "\"\"";
            if (value.empty() && key.form == Form::words) value = "[file.yml]";
            if (value.empty() && key.form == Form::entries) value = "[{name: line1}]";
            if (value.empty() && key.form == Form::open) value = "{}";
            if (value.empty() && key.form == Form::integer) value = "1";
            if (value.empty() && key.columns > 0) value = zeros(key.columns);
            if (value.empty() && !key.dimensions.empty()) {
                value = std::string(key.dimensions.front().example);
            }
            const bool quote =
                value.find_first_of("*{") != std::string::npos && key.form == Form::text;
            return text +
                   fmt::format("{}{}: {}\n", start, key.name, quote ? "\"" + value + "\"" : value);
        }
        std::string inner;
        if (key.form == Form::map) {
            inner = this->table(key.table(), indent + 2, off);
        } else if (key.form == Form::list) {
            inner = item(this->table(key.table(), indent + 4, off),
                         static_cast<std::size_t>(indent) + 2);
        } else if (const Key* same = shown_before(table, key)) {
            inner =
                fmt::format("{:{}}## every key of \"{}\" above but its name\n{:{}}# name: {{}}\n",
                            "", indent + 2, same->name, "", indent + 2);
        } else {
            inner = fmt::format("{:{}}{}{}:\n", "", indent + 2, off ? "# " : "", "name") +
                    this->table(key.table(), indent + 4, off);
        }
        const bool empty = !off && key.form == Form::map && all_comments(inner);
        return text + fmt::format("{}{}{}:\n", start, empty ? "# " : "", key.name) + inner;
    }

    /// A key before this one that holds a thing of the same kind.
    static const Key* shown_before(const Table& table, const Key& key) {
        for (const Key& other : table.keys) {
            if (&other == &key) break;
            if (other.table != nullptr && other.table().name == key.table().name) return &other;
        }
        return nullptr;
    }

    static bool all_comments(const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            if (line[line.find_first_not_of(' ')] != '#') return false;
        }
        return true;
    }

    static std::string zeros(std::size_t n) {
        const std::string row = fmt::format("[{}]", fmt::join(std::vector<int>(n, 0), ", "));
        return fmt::format("[{}]", fmt::join(std::vector<std::string>(n, row), ", "));
    }

    /// Puts the dash of a list's element before its first key.
    static std::string item(const std::string& text, std::size_t column) {
        std::istringstream lines(text);
        std::string line, result;
        bool done = false;
        while (std::getline(lines, line)) {
            const std::size_t start = line.find_first_not_of(' ');
            if (!done && start != std::string::npos &&
                (line[start] != '#' || line.compare(start, 3, "# -") == 0)) {
                line[column] = '-';
                done = true;
            }
            result += line + "\n";
        }
        return result;
    }

    static std::string comment(const Key& key, int indent) {
        std::vector<std::string> facts;
        if (const std::string k = kind(key); !k.empty()) facts.push_back(k);
        if (const std::string r = range(key); !r.empty()) facts.push_back(r);
        if (!key.condition_key.empty()) {
            facts.push_back(fmt::format("{} {}: {}", key.is_needed ? "required with" : "only with",
                                        key.condition_key, fmt::join(key.condition_words, ", ")));
        }
        if (key.is_required) facts.push_back("required");
        if (!key.word.empty()) facts.push_back(fmt::format("or the word {}", key.word));
        if (!key.worked_out.empty()) facts.push_back("default: " + key.worked_out);
        if (!key.fallback.empty()) facts.push_back("default: " + key.fallback);
        std::string text = key.sentence;
        if (!facts.empty()) text += fmt::format(" ({})", fmt::join(facts, "; "));
        return wrapped(text, indent);
    }

    /// `# ` lines of at most 100 columns.
    static std::string wrapped(const std::string& text, int indent) {
        const std::string start = fmt::format("{:{}}##", "", indent);
        std::istringstream words(text);
        std::string word, line = start, result;
        while (words >> word) {
            if (line.size() + 1 + word.size() > 100) {
                result += line + "\n";
                line = start;
            }
            line += " " + word;
        }
        return result + line + "\n";
    }
};

}  // namespace

std::string reference_case() { return Reference().run(); }

}  // namespace hawser::io
