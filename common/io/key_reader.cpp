#include "io/key_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hawser::io {
namespace {

constexpr std::array mode_names{"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// The text of a default as a node: a scalar, or a flow list of such texts.
Node node_of(std::string_view text, const Place& place) {
    Node node;
    node.place = place;
    if (text.empty() || text.front() != '[') {
        node.kind = Node::Kind::scalar;
        node.text = text;
        return node;
    }
    node.kind = Node::Kind::list;
    text = text.substr(1, text.size() - 2);
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        node.items.push_back(node_of(text.substr(0, comma), place));
        text.remove_prefix(std::min(comma + 2, text.size()));
    }
    return node;
}

std::string range_of(const Key& key, const Dimension& d) {
    const auto show = [&d](double x) { return print_quantity(x, d); };
    if (key.lower && key.upper) {
        return fmt::format("{} {} to {}", key.lower_open ? "above" : "from", show(*key.lower),
                           show(*key.upper));
    }
    if (key.lower) {
        return fmt::format("{} {}", key.lower_open ? "above" : "at least", show(*key.lower));
    }
    return "at most " + show(*key.upper);
}

bool in_range(const Key& key, double x) {
    if (key.lower && (key.lower_open ? x <= *key.lower : x < *key.lower)) return false;
    return !(key.upper && x > *key.upper);
}

const Dimension& dimension_of(const Key& key, std::size_t i) {
    return key.dimensions[std::min(i, key.dimensions.size() - 1)];
}

}  // namespace

void KeyReader::error(const Place& place, const std::string& path, const std::string& message) {
    problems_.push_back(problem_at(place, path, message));
    failed_.insert(path);
}

void KeyReader::read(const Table& table, const Node& node, void* object, const std::string& path) {
    places_.emplace(path, node.place);
    if (node.kind != Node::Kind::map) {
        error(node.place, path, fmt::format("expected a map of keys; got {}", found(node)));
        missing(table, Node{}, object, "");
        return;
    }
    // Words first: what a number means may depend on them.
    const auto is_word = [&table](const Entry& e) {
        const Key* key = table.find(e.key);
        return key != nullptr && key->form == Form::choice;
    };
    for (const bool words : {true, false}) {
        for (const Entry& e : node.entries) {
            if (is_word(e) == words) entry(table, e, object, path);
        }
    }
    missing(table, node, object, path);
    rules(table, node, path);
    conditions(table, node, object, path);
}

void KeyReader::entry(const Table& table, const Entry& e, void* object, const std::string& path) {
    const std::string own = path.empty() ? e.key : path + "." + e.key;
    const Key* key = table.find(e.key);
    if (key == nullptr) {
        std::vector<std::string> known;
        for (const Key& k : table.keys) {
            if (!k.is_later) known.push_back(k.name);
        }
        error(e.place, own, fmt::format("unknown key \"{}\"{}", e.key, suggestion(e.key, known)));
        return;
    }
    if (key->is_later) {
        error(e.place, own, fmt::format("\"{}\": not available in this version", e.key));
        return;
    }
    given_.insert(own);
    places_[own] = e.place;
    if (key->is_hidden) return;
    if (key->table != nullptr) {
        children(*key, e.value, object, own);
    } else {
        value(*key, e.value, object, own);
    }
}

void KeyReader::children(const Key& key, const Node& node, void* object, const std::string& path) {
    const Table& table = key.table();
    if (key.form == Form::map) {
        read(table, node, key.open(object, {}), path);
        return;
    }
    const bool list = key.form == Form::list;
    if (node.kind != (list ? Node::Kind::list : Node::Kind::map)) {
        error(node.place, path,
              fmt::format("expected a {}; got {}", list ? "list" : "map of names", found(node)));
        return;
    }
    if (key.is_required && node.items.empty() && node.entries.empty()) {
        error(node.place, path, "expected at least one element");
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        read(table, node.items[i], key.open(object, {}), fmt::format("{}[{}]", path, i));
    }
    for (const Entry& e : node.entries) {
        const std::string& shown = e.shown.empty() ? e.key : e.shown;
        places_.emplace(path + "." + shown, e.place);
        read(table, e.value, key.open(object, e.key), path + "." + shown);
    }
}

void KeyReader::value(const Key& key, const Node& node, void* object, const std::string& path) {
    if (node.kind == Node::Kind::scalar && node.text.find("${") != std::string::npos) {
        failed_.insert(path);  // an unknown parameter, reported already
        if (key.form == Form::number || key.form == Form::curve) key.set(object, NAN);
        return;
    }
    if (!key.word.empty() && node.kind == Node::Kind::scalar && node.text == key.word) return;
    Value v;
    switch (key.form) {
        case Form::numbers:
            v = row(key, node, path);
            break;
        case Form::rows: {
            v = rows(key, node, path);
            break;
        }
        case Form::curve: {
            if (node.kind != Node::Kind::list) {
                v = number(key, key.dimensions.front(), node, path);
                break;
            }
            Key columns = key;
            columns.form = Form::rows;
            columns.dimensions.erase(columns.dimensions.begin());
            columns.lower.reset();
            columns.upper.reset();
            v = rows(columns, node, path);
            break;
        }
        case Form::matrix:
        case Form::modes:
            v = matrix(key, node, path);
            break;
        case Form::words: {
            std::vector<std::string> words;
            if (node.kind != Node::Kind::list) {
                error(node.place, path,
                      fmt::format("expected a list of words, e.g. {}; got {}",
                                  key.fallback.empty() ? "[...]" : key.fallback, found(node)));
            }
            for (std::size_t i = 0; i < node.items.size(); ++i) {
                words.push_back(word(key, node.items[i], fmt::format("{}[{}]", path, i)));
            }
            v = std::move(words);
            break;
        }
        default:
            v = scalar(key, node, object, path);
    }
    if (!std::holds_alternative<std::monostate>(v)) key.set(object, v);
}

/// Keys that mean something only beside a certain word of another key.
void KeyReader::conditions(const Table& table, const Node& node, void* object,
                           const std::string& path) {
    for (const Key& key : table.keys) {
        if (key.condition_key.empty()) continue;
        const std::string other = path.empty() ? key.condition_key : path + "." + key.condition_key;
        const Key& decider = *table.find(key.condition_key);
        const bool due =
            decider.is_required || (decider.is_needed && table.applies(decider, object));
        const bool unknown =
            failed_.contains(other) || (due && node.find(key.condition_key) == nullptr);
        if (unknown) continue;  // reported already; what follows from it would be noise
        const Node* given = node.find(key.name);
        const bool applies = table.applies(key, object);
        const std::string words = fmt::format("{}", fmt::join(key.condition_words, " or "));
        if (given != nullptr && !applies) {
            error(places_[path.empty() ? key.name : path + "." + key.name],
                  path.empty() ? key.name : path + "." + key.name,
                  fmt::format("means something only with {}: {}", key.condition_key, words));
        } else if (given == nullptr && applies && key.is_needed) {
            error(node.place, path,
                  fmt::format("required key \"{}\" is missing (with {}: {})", key.name,
                              key.condition_key, words));
            if (key.form == Form::number || key.form == Form::curve) key.set(object, NAN);
        }
    }
}

Value KeyReader::rows(const Key& key, const Node& node, const std::string& path) {
    std::vector<std::vector<double>> rows;
    if (node.kind != Node::Kind::list) {
        error(
            node.place, path,
            fmt::format("expected a list of rows, e.g. {}; got {}", key.example_text, found(node)));
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        rows.push_back(row(key, node.items[i], fmt::format("{}[{}]", path, i)));
    }
    return rows;
}

Value KeyReader::scalar(const Key& key, const Node& node, const void* object,
                        const std::string& path) {
    if (node.kind != Node::Kind::scalar && key.form != Form::number && key.form != Form::choice) {
        error(node.place, path, fmt::format("expected one value; got {}", found(node)));
        return {};
    }
    switch (key.form) {
        case Form::number:
            return number(key, key.dimension(object), node, path);
        case Form::place:
            if (std::find(key.choices.begin(), key.choices.end(), node.text) != key.choices.end()) {
                return node.text;
            }
            if (node.text.starts_with("joint ")) {
                int n = 0;
                const char* end = node.text.data() + node.text.size();
                const auto [stop, status] = std::from_chars(node.text.data() + 6, end, n);
                if (status == std::errc{} && stop == end && n >= 1) return node.text;
                error(node.place, path,
                      fmt::format("expected an arc length or \"joint 1\"; got {}", found(node)));
                return {};
            }
            return number(key, key.dimensions.front(), node, path);
        case Form::integer: {
            std::int64_t n = 0;
            const char* end = node.text.data() + node.text.size();
            const auto [stop, status] = std::from_chars(node.text.data(), end, n);
            const std::size_t sign = node.text.starts_with("-") ? 1 : 0;
            const bool zeros = node.text.size() > sign + 1 && node.text[sign] == '0';
            if (status != std::errc{} || stop != end || zeros) {
                error(node.place, path,
                      fmt::format("expected a whole number{}; got {}",
                                  zeros ? " without leading zeros" : "", found(node)));
                return {};
            }
            if (!in_range(key, static_cast<double>(n))) {
                error(node.place, path,
                      fmt::format("expected a value {}; got {}", range_of(key, dimension::number),
                                  n));
                return {};
            }
            return n;
        }
        case Form::flag:
            if (node.text == "true") return true;
            if (node.text != "false") {
                error(node.place, path, fmt::format("expected true or false; got {}", found(node)));
                return {};
            }
            return false;
        case Form::choice: {
            const std::string chosen = word(key, node, path);
            if (chosen.empty()) return {};
            return chosen;
        }
        case Form::path:
            return relative(node);
        default:
            return node.text;
    }
}

double KeyReader::number(const Key& key, const Dimension& dimension, const Node& node,
                         const std::string& path) {
    if (node.kind == Node::Kind::list && key.is_table_later) {
        error(node.place, path, "a table: not available in this version; give one number");
        return NAN;
    }
    if (node.kind != Node::Kind::scalar) {
        error(node.place, path,
              fmt::format("expected {}, e.g. \"{}\"; got {}", with_article(dimension.name),
                          dimension.example, found(node)));
        return NAN;
    }
    const Quantity q = parse_quantity(node.text, dimension, node.units);
    if (!q.value) {
        std::string hint;
        if (!key.word.empty()) hint = fmt::format(" (or the word \"{}\")", key.word);
        error(node.place, path, q.error + hint);
        return NAN;
    }
    if (!in_range(key, *q.value)) {
        error(node.place, path,
              fmt::format("expected a value {}; got \"{}\"", range_of(key, dimension), node.text));
        return NAN;
    }
    return *q.value;
}

std::string KeyReader::word(const Key& key, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::scalar) {
        error(node.place, path,
              fmt::format("expected one of {}; got {}", fmt::join(key.choices, ", "), found(node)));
        return {};
    }
    const std::string& text = node.text;
    if (std::find(key.choices.begin(), key.choices.end(), text) != key.choices.end()) return text;
    if (std::find(key.not_yet.begin(), key.not_yet.end(), text) != key.not_yet.end()) {
        error(node.place, path,
              fmt::format("\"{}\": not available in this version; available: {}", text,
                          fmt::join(key.choices, ", ")));
        return {};
    }
    error(node.place, path,
          fmt::format("expected one of {}; got \"{}\"", fmt::join(key.choices, ", "), text));
    return {};
}

std::string KeyReader::relative(const Node& node) const {
    const std::filesystem::path path(node.text);
    if (path.is_absolute() || node.place.file.empty()) return path.lexically_normal().string();
    const std::filesystem::path from = std::filesystem::path(node.place.file).parent_path();
    if (from == folder_) return path.lexically_normal().string();
    // From the current folder, for a path given with --set.
    const std::filesystem::path here = std::filesystem::current_path();
    return (here / from / path)
        .lexically_normal()
        .lexically_relative((here / folder_).lexically_normal())
        .string();
}

std::vector<double> KeyReader::row(const Key& key, const Node& node, const std::string& path) {
    const std::size_t whole = key.fewest;
    if (node.kind == Node::Kind::scalar && key.form == Form::numbers && key.fewest == 1) {
        return {number(key, dimension_of(key, 0), node, path)};
    }
    if (node.kind != Node::Kind::list || node.items.size() < key.fewest ||
        node.items.size() > key.most) {
        const std::string count = key.fewest == key.most
                                      ? std::to_string(whole)
                                      : fmt::format("{} to {}", key.fewest, key.most);
        const std::string got =
            node.kind == Node::Kind::list
                ? fmt::format("{} number{}", node.items.size(), node.items.size() == 1 ? "" : "s")
                : found(node);
        error(node.place, path, fmt::format("expected a list of {} numbers; got {}", count, got));
        return std::vector<double>(whole, NAN);
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        values.push_back(
            number(key, dimension_of(key, i), node.items[i], fmt::format("{}[{}]", path, i)));
    }
    return values;
}

std::vector<double> KeyReader::matrix(const Key& key, const Node& node, const std::string& path) {
    const std::size_t n = key.columns;
    std::vector<double> values(n * n, 0.0);
    if (key.form == Form::modes && node.kind == Node::Kind::map) {
        for (const Entry& e : node.entries) {
            const auto mode = std::find(mode_names.begin(), mode_names.end(), e.key);
            if (mode == mode_names.end()) {
                error(e.place, path + "." + e.key,
                      fmt::format("unknown key \"{}\"{}", e.key,
                                  suggestion(e.key, {mode_names.begin(), mode_names.end()})));
                continue;
            }
            const auto i = static_cast<std::size_t>(mode - mode_names.begin());
            values[i * n + i] =
                number(key, dimension_of(key, i * n + i), e.value, path + "." + e.key);
        }
        return values;
    }
    bool square = node.kind == Node::Kind::list && node.items.size() == n;
    for (const Node& r : node.items) {
        square = square && r.kind == Node::Kind::list && r.items.size() == n;
    }
    if (!square) {
        error(node.place, path,
              fmt::format("expected {}{} rows of {} numbers; got {}",
                          key.form == Form::modes ? "a map of surge ... yaw, or " : "", n, n,
                          node.kind == Node::Kind::list ? "other rows" : found(node)));
        return std::vector<double>(n * n, NAN);
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            values[i * n + j] = number(key, dimension_of(key, i * n + j), node.items[i].items[j],
                                       fmt::format("{}[{}][{}]", path, i, j));
        }
    }
    return values;
}

void KeyReader::missing(const Table& table, const Node& node, void* object,
                        const std::string& path) {
    const bool silent = node.kind != Node::Kind::map || node.partial;
    for (const Key& key : table.keys) {
        if (key.is_later || key.is_hidden || node.find(key.name) != nullptr) continue;
        if (key.is_required && !silent) {
            error(node.place, path, fmt::format("required key \"{}\" is missing", key.name));
        }
        if (key.form == Form::map) {
            for (const Element& e : key.elements(object)) {
                defaults(key.table(), const_cast<void*>(e.object), node.place, key.is_required);
            }
        } else if (!key.fallback.empty()) {
            value(key, node_of(key.fallback, node.place), object, key.name);
        } else if ((key.form == Form::number || key.form == Form::curve) && key.is_required) {
            key.set(object, NAN);
        }
    }
}

/// Defaults of a sub-table that the file leaves out but the struct always has. If it should have
/// been there, the numbers that it must hold become NaN.
void KeyReader::defaults(const Table& table, void* object, const Place& place, bool required) {
    for (const Key& key : table.keys) {
        if (key.is_later || key.is_hidden) continue;
        if (key.form == Form::map) {
            for (const Element& e : key.elements(object)) {
                defaults(key.table(), const_cast<void*>(e.object), place,
                         required && key.is_required);
            }
        } else if (!key.fallback.empty()) {
            value(key, node_of(key.fallback, place), object, key.name);
        } else if (required && key.is_required && key.form == Form::number) {
            key.set(object, NAN);
        }
    }
}

void KeyReader::rules(const Table& table, const Node& node, const std::string& path) {
    for (const KeyRule& rule : table.rules) {
        std::vector<std::string> present;
        for (const std::string& key : rule.keys) {
            if (node.find(key) != nullptr) present.push_back(key);
        }
        const std::string all = fmt::format("\"{}\"", fmt::join(rule.keys, "\", \""));
        if (present.empty() && rule.count != KeyRule::Count::at_most_one) {
            error(node.place, path, fmt::format("expected one of {}", all));
        } else if (present.size() > 1 && rule.count != KeyRule::Count::at_least_one) {
            error(node.find(present[1])->place, path,
                  fmt::format("give only one of \"{}\"", fmt::join(present, "\", \"")));
        }
    }
}

}  // namespace hawser::io
