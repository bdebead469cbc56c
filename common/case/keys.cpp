#include "case/keys.hpp"

#include <algorithm>

namespace hawser {

bool Table::applies(const Key& key, const void* object) const {
    if (key.condition_key.empty()) return true;
    const Value value = find(key.condition_key)->get(object);
    std::string word;
    if (const auto* text = std::get_if<std::string>(&value)) word = *text;
    if (const auto* flag = std::get_if<bool>(&value)) word = *flag ? "true" : "false";
    const auto& words = key.condition_words;
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace hawser
