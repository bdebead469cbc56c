// Writing JSON: values in the order they were added.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::io {

class Json {
 public:
    Json() : Json(object()) {}
    Json(bool value) : kind_(Kind::plain), text_(value ? "true" : "false") {}
    Json(int value) : kind_(Kind::plain), text_(std::to_string(value)) {}
    Json(double value);
    Json(const char* text) : Json(std::string(text)) {}
    Json(const std::string& text);
    static Json object() { return Json(Kind::object); }
    static Json array() { return Json(Kind::array); }

    /// Adds to an object.
    Json& put(const std::string& key, Json value);
    /// Adds to an array.
    Json& add(Json value);
    [[nodiscard]] bool empty() const { return members_.empty(); }

    /// With two spaces of indentation per level; short arrays of plain values on one line.
    [[nodiscard]] std::string text(int indent = 0) const;

 private:
    enum class Kind { plain, object, array };
    explicit Json(Kind kind) : kind_(kind) {}

    Kind kind_;
    std::string text_;
    std::vector<std::pair<std::string, Json>> members_;
};

/// A text with its quotes and escapes.
std::string json_text(const std::string& text);

}  // namespace hawser::io
