#include "io/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/quantity.hpp"

namespace hawser::io {

std::string json_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        switch (c) {
            case '"':
                quoted += "\\\"";
                break;
            case '\\':
                quoted += "\\\\";
                break;
            case '\n':
                quoted += "\\n";
                break;
            case '\t':
                quoted += "\\t";
                break;
            default:
                if (static_cast<unsigned char>(c) < 0x20) {
                    quoted += fmt::format("\\u{:04x}", static_cast<int>(c));
                } else {
                    quoted += c;
                }
        }
    }
    return quoted + "\"";
}

Json::Json(double value)
    : kind_(Kind::plain), text_(std::isfinite(value) ? print_number(value) : "null") {}

Json::Json(const std::string& text) : kind_(Kind::plain), text_(json_text(text)) {}

Json& Json::put(const std::string& key, Json value) {
    members_.emplace_back(key, std::move(value));
    return *this;
}

Json& Json::add(Json value) {
    members_.emplace_back(std::string(), std::move(value));
    return *this;
}

std::string Json::text(int indent) const {
    if (kind_ == Kind::plain) return text_;
    const bool array = kind_ == Kind::array;
    const char* open = array ? "[" : "{";
    const char* close = array ? "]" : "}";
    const bool flat = std::all_of(members_.begin(), members_.end(),
                                  [](const auto& m) { return m.second.kind_ == Kind::plain; });
    if (flat) {
        std::string line = open;
        for (const auto& [key, value] : members_) {
            if (line.size() > 1) line += ", ";
            if (!array) line += json_text(key) + ": ";
            line += value.text();
        }
        line += close;
        if (line.size() + static_cast<std::size_t>(indent) < 96) return line;
    }
    std::string text = open;
    const char* separator = "\n";
    for (const auto& [key, value] : members_) {
        text += fmt::format("{}{:{}}", separator, "", indent + 2);
        if (!array) text += json_text(key) + ": ";
        text += value.text(indent + 2);
        separator = ",\n";
    }
    return text + fmt::format("\n{:{}}{}", "", indent, close);
}

}  // namespace hawser::io
