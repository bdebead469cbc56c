#include "io/case_echo.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "io/json.hpp"

namespace hawser::io {
namespace {

const Dimension& dimension_of(const Key& key, std::size_t i) {
    return key.dimensions[std::min(i, key.dimensions.size() - 1)];
}

std::string row(const Key& key, const std::vector<double>& values, std::size_t first,
                std::size_t count) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t column = key.form == Form::rows    ? i
                                   : key.form == Form::curve ? i + 1
                                                             : first + i;
        const Dimension& d = dimension_of(key, column);
        items.push_back(print_quantity(values[first + i], d));
    }
    return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string matrix(const Key& key, const std::vector<double>& values) {
    const std::size_t n = key.columns;
    if (key.form == Form::modes) {
        static constexpr std::array names{"surge", "sway", "heave", "roll", "pitch", "yaw"};
        bool diagonal = true, zero = true;
        std::vector<std::string> items;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                if (values[i * n + j] == 0.0) continue;
                zero = false;
                diagonal = diagonal && i == j;
                items.push_back(
                    fmt::format("{}: {}", names[i],
                                print_quantity(values[i * n + j], dimension_of(key, i * n + j))));
            }
        }
        if (zero) return {};
        if (diagonal) return fmt::format("{{{}}}", fmt::join(items, ", "));
    }
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < n; ++i) rows.push_back(row(key, values, i * n, n));
    return fmt::format("[{}]", fmt::join(rows, ", "));
}

/// Text of a value, empty if there is nothing to write.
std::string print(const Key& key, const void* object) {
    const Value value = key.get(object);
    if (const auto* x = std::get_if<double>(&value)) {
        return print_quantity(*x, key.dimension(object));
    }
    if (const auto* n = std::get_if<std::int64_t>(&value)) return std::to_string(*n);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&value)) {
        return key.form == Form::choice || key.form == Form::place ? *text : yaml_text(*text);
    }
    if (const auto* words = std::get_if<std::vector<std::string>>(&value)) {
        return fmt::format("[{}]", fmt::join(*words, ", "));
    }
    if (const auto* values = std::get_if<std::vector<double>>(&value)) {
        if (key.columns > 0) return matrix(key, *values);
        return row(key, *values, 0, values->size());
    }
    if (const auto* rows = std::get_if<std::vector<std::vector<double>>>(&value)) {
        std::vector<std::string> items;
        for (const auto& r : *rows) items.push_back(row(key, r, 0, r.size()));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
    return key.is_required ? key.word : std::string();
}

class Writer {
 public:
    Writer(const KeyReader& reader, std::filesystem::path folder)
        : reader_(reader), folder_(std::move(folder)) {}

    std::string table(const Table& table, const void* object, int indent, const std::string& path) {
        std::string text;
        for (const Key& key : table.keys) {
            if (key.is_later || key.is_hidden || !table.applies(key, object)) continue;
            const std::string own = path.empty() ? key.name : path + "." + key.name;
            text += key.table != nullptr ? children(key, object, indent, own)
                                         : line(key, object, indent, own);
        }
        return text;
    }

 private:
    std::string line(const Key& key, const void* object, int indent, const std::string& path) {
        const std::string value = print(key, object);
        if (value.empty()) return {};
        return fmt::format("{:{}}{}: {}{}\n", "", indent, key.name, value, origin(key, path));
    }

    std::string origin(const Key& key, const std::string& path) const {
        if (!reader_.given().contains(path)) {
            return key.worked_out.empty() ? "  # default" : "  # auto";
        }
        const Place& place = reader_.places().find(path)->second;
        if (place.file.empty()) return {};
        if (place.line == 0) return "  # --set";
        const std::filesystem::path file(place.file);
        const std::filesystem::path shown =
            folder_.empty() ? file : file.lexically_relative(folder_);
        return fmt::format("  # {}:{}", shown.string(), place.line);
    }

    std::string children(const Key& key, const void* object, int indent, const std::string& path) {
        const Table& inner = key.table();
        const std::vector<Element> elements = key.elements(object);
        if (key.form == Form::map) {
            if (elements.empty()) return {};
            const std::string text = table(inner, elements[0].object, indent + 2, path);
            if (text.empty()) return {};
            return fmt::format("{:{}}{}:\n{}", "", indent, key.name, text);
        }
        if (elements.empty()) {
            const bool said = key.form == Form::list && reader_.given().contains(path);
            return said ? fmt::format("{:{}}{}: []\n", "", indent, key.name) : std::string();
        }
        std::string text = fmt::format("{:{}}{}:\n", "", indent, key.name);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (key.form == Form::list) {
                std::string item =
                    table(inner, elements[i].object, indent + 4, fmt::format("{}[{}]", path, i));
                item[static_cast<std::size_t>(indent) + 2] = '-';
                text += item;
            } else {
                text += fmt::format(
                    "{:{}}{}:\n{}", "", indent + 2, yaml_text(elements[i].name),
                    table(inner, elements[i].object, indent + 4, path + "." + elements[i].shown));
            }
        }
        return text;
    }

    const KeyReader& reader_;
    std::filesystem::path folder_;
};

}  // namespace

std::string yaml_text(const std::string& text) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/' ||
               c == '.' || c == '-' || c == ' ';
    };
    const bool word = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0;
    static constexpr std::array special{"true", "false", "null", "yes", "no",
                                        "on",   "off",   "y",    "n"};
    if (word && text.back() != ' ' && std::all_of(text.begin(), text.end(), plain) &&
        std::find(special.begin(), special.end(), text) == special.end()) {
        return text;
    }
    return json_text(text);  // JSON's quotes are YAML's too
}

std::string echo(const DeclaredCase& declared, const KeyReader& reader,
                 const std::filesystem::path& folder) {
    return "# Resolved case: every default filled in, families written out one line each.\n" +
           Writer(reader, folder).table(case_keys(), &declared, 0, "");
}

}  // namespace hawser::io
