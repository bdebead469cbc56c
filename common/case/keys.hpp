// The keys of the case file as data. Beside each struct of this folder stands a table of its keys:
// name, kind of value, dimension, default, range and one sentence. The reader, the echo, the
// reference case and the JSON schema all go through these tables, so a key is declared once.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "case/dimension.hpp"
#include "vector.hpp"

namespace hawser {

/// What a key holds.
enum class Form {
    number,   ///< a quantity of one dimension
    integer,  ///< a whole number
    flag,     ///< true or false
    text,
    path,     ///< file name, relative to the file that says it
    choice,   ///< one word of a list
    words,    ///< a list of such words
    numbers,  ///< a list of `fewest` to `most` quantities; with fewest = 1 a number alone will do
    matrix,   ///< list of `columns` wide rows, row-major
    rows,     ///< any number of rows of `fewest` to `most` quantities
    curve,    ///< one quantity, or rows of two: dimensions of the number and of the two columns
    modes,    ///< 6x6 matrix, or a map of its diagonal by surge ... yaw
    place,    ///< arc length, "joint n", or a word of `choices`
    map,      ///< a sub-table
    list,     ///< a list of sub-tables
    named,    ///< a map of names to sub-tables
    open,     ///< a map whose keys the user chooses
    entries,  ///< a list of such maps
};

/// A value on its way between file and struct, SI and radians. Empty: not given (or the key's word,
/// such as `auto`).
using Value =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::string>,
                 std::vector<double>, std::vector<std::vector<double>>>;

struct Table;

/// One element under a key of form map, list or named.
struct Element {
    std::string name;
    const void* object = nullptr;
    std::string shown;  ///< name in the paths of messages: the family of a line
};

struct Key {
    std::string name;
    Form form = Form::number;
    std::string sentence;

    std::vector<Dimension> dimensions;   ///< one, or one per column or matrix entry
    std::size_t fewest = 1, most = 1;    ///< numbers, rows
    std::size_t columns = 0;             ///< matrix
    std::vector<std::string> choices;    ///< choice, words
    std::vector<std::string> not_yet;    ///< words of the format that this version does not act on
    std::string word;                    ///< stands for "not given": auto, static
    std::optional<double> lower, upper;  ///< range [SI]
    bool lower_open = false;             ///< the lower end is excluded
    std::string fallback;                ///< default, as text of the case file
    std::string worked_out;              ///< how the default follows from other keys
    std::string example_text;
    /// The key means something only where this other key of its map has one of these words (a flag:
    /// true or false) ...
    std::string condition_key;
    std::vector<std::string> condition_words;
    bool is_needed = false;       ///< ... and there it is required
    bool is_table_later = false;  ///< a table instead of one number: not in this version
    bool is_required = false, is_later = false, is_hidden = false;
    const Table& (*table)() = nullptr;  ///< map, list, named
    /// Where the dimension follows from another key of the same map: which of `dimensions`.
    std::function<std::size_t(const void*)> dimension_index;

    std::function<void(void*, const Value&)> set;
    std::function<Value(const void*)> get;
    std::function<void*(void*, const std::string&)> open;
    std::function<std::vector<Element>(const void*)> elements;

    /// Dimension of a number in this object.
    [[nodiscard]] const Dimension& dimension(const void* object) const {
        return dimensions[dimension_index ? dimension_index(object) : 0];
    }

    Key& only_with(std::string key, std::vector<std::string> values) {
        condition_key = std::move(key);
        condition_words = std::move(values);
        return *this;
    }
    Key& needed_with(std::string key, std::vector<std::string> values) {
        is_needed = true;
        return only_with(std::move(key), std::move(values));
    }
    Key& required() {
        is_required = true;
        return *this;
    }
    Key& def(std::string text) {
        fallback = std::move(text);
        return *this;
    }
    Key& follows(std::string rule) {
        worked_out = std::move(rule);
        return *this;
    }
    Key& eg(std::string text) {
        example_text = std::move(text);
        return *this;
    }
    Key& or_word(std::string text) {
        word = std::move(text);
        return *this;
    }
    Key& above(double x) {
        lower = x;
        lower_open = true;
        return *this;
    }
    Key& at_least(double x) {
        lower = x;
        return *this;
    }
    Key& at_most(double x) {
        upper = x;
        return *this;
    }
    Key& later_words(std::vector<std::string> words) {
        not_yet = std::move(words);
        return *this;
    }
    Key& table_later() {
        is_table_later = true;
        return *this;
    }
    /// Dealt with before the table is read (include, like, pattern ...): no value of its own.
    Key& hidden() {
        is_hidden = true;
        return *this;
    }
};

/// A rule about which keys go together.
struct KeyRule {
    enum class Count { exactly_one, at_most_one, at_least_one } count;
    std::vector<std::string> keys;
};

struct Table {
    std::string name;
    std::vector<Key> keys;
    std::vector<KeyRule> rules;

    [[nodiscard]] const Key* find(std::string_view key) const {
        for (const Key& k : keys) {
            if (k.name == key) return &k;
        }
        return nullptr;
    }
    /// Does the condition of `key` hold in this object?
    [[nodiscard]] bool applies(const Key& key, const void* object) const;
};

namespace keys_detail {

template <class T>
struct is_optional : std::false_type {};
template <class T>
struct is_optional<std::optional<T>> : std::true_type {};

inline std::vector<std::array<double, 2>> curve_of(const Value& value) {
    std::vector<std::array<double, 2>> curve;
    for (const auto& row : std::get<std::vector<std::vector<double>>>(value)) {
        curve.push_back({row[0], row[1]});
    }
    return curve;
}
inline std::vector<std::vector<double>> rows_of(const std::vector<std::array<double, 2>>& curve) {
    std::vector<std::vector<double>> rows;
    rows.reserve(curve.size());
    for (const auto& [x, y] : curve) rows.push_back({x, y});
    return rows;
}

template <class M>
std::vector<double> flat(const M& m) {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
    }
    return values;
}

template <class M>
M matrix_of(const std::vector<double>& values) {
    M m;
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        for (Eigen::Index j = 0; j < m.cols(); ++j) {
            m(i, j) = values.at(static_cast<std::size_t>(i * m.cols() + j));
        }
    }
    return m;
}

}  // namespace keys_detail

/// Builds the table of struct T. `access` is a pointer to a member of T or any callable that takes
/// a T& and returns a reference to where the value lives; std::optional means "may be absent".
template <class T>
class Keys {
 public:
    explicit Keys(std::string name) { table_.name = std::move(name); }

    template <class A>
    Key& number(std::string name, A access, const Dimension& d, std::string sentence) {
        Key& key = scalar<double>(std::move(name), Form::number, access, std::move(sentence));
        key.dimensions = {d};
        return key;
    }
    template <class A>
    Key& integer(std::string name, A access, std::string sentence) {
        return scalar<std::int64_t>(std::move(name), Form::integer, access, std::move(sentence));
    }
    template <class A>
    Key& flag(std::string name, A access, std::string sentence) {
        return scalar<bool>(std::move(name), Form::flag, access, std::move(sentence));
    }
    template <class A>
    Key& text(std::string name, A access, std::string sentence) {
        return scalar<std::string>(std::move(name), Form::text, access, std::move(sentence));
    }
    template <class A>
    Key& path(std::string name, A access, std::string sentence) {
        return scalar<std::string>(std::move(name), Form::path, access, std::move(sentence));
    }

    /// One of several words, each a value of an enum or a string.
    template <class A, class E>
    Key& choice(std::string name, A access, std::vector<std::pair<std::string, E>> words,
                std::string sentence) {
        Key& key = add(std::move(name), Form::choice, std::move(sentence));
        for (const auto& [word, value] : words) key.choices.push_back(word);
        key.set = [access, words](void* object, const Value& value) {
            for (const auto& [word, meaning] : words) {
                if (word == std::get<std::string>(value)) at(access, object) = meaning;
            }
        };
        key.get = [access, words](const void* object) -> Value {
            auto&& place = at(access, const_cast<void*>(object));
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                if (!place) return {};
                for (const auto& [word, meaning] : words) {
                    if (meaning == *place) return word;
                }
            } else {
                for (const auto& [word, meaning] : words) {
                    if (meaning == place) return word;
                }
            }
            return {};
        };
        return key;
    }
    /// A choice of which this version knows one: nothing is stored.
    Key& only(std::string name, const std::string& word, std::vector<std::string> not_yet,
              std::string sentence) {
        Key& key = add(std::move(name), Form::choice, std::move(sentence));
        key.choices = {word};
        key.not_yet = std::move(not_yet);
        key.fallback = word;
        key.set = [](void*, const Value&) {};
        key.get = [word](const void*) -> Value { return word; };
        return key;
    }
    /// A list of words, each switching on one bool of the struct.
    Key& words(std::string name, std::vector<std::pair<std::string, bool T::*>> flags,
               std::string sentence) {
        Key& key = add(std::move(name), Form::words, std::move(sentence));
        for (const auto& [word, member] : flags) key.choices.push_back(word);
        key.set = [flags](void* object, const Value& value) {
            for (const auto& [word, member] : flags) {
                bool on = false;
                for (const std::string& said : std::get<std::vector<std::string>>(value)) {
                    on = on || said == word;
                }
                static_cast<T*>(object)->*member = on;
            }
        };
        key.get = [flags](const void* object) -> Value {
            std::vector<std::string> said;
            for (const auto& [word, member] : flags) {
                if (static_cast<const T*>(object)->*member) said.push_back(word);
            }
            return said;
        };
        return key;
    }

    /// A vector or matrix of Eigen, given as a list of its entries (a vector) or of its rows.
    template <class A>
    Key& vector(std::string name, A access, std::vector<Dimension> d, std::string sentence) {
        Key& key = eigen(std::move(name), Form::numbers, access, std::move(d), std::move(sentence));
        key.fewest = key.most = 3;
        return key;
    }
    template <class A>
    Key& matrix(std::string name, A access, std::size_t columns, std::vector<Dimension> d,
                std::string sentence) {
        Key& key = eigen(std::move(name), Form::matrix, access, std::move(d), std::move(sentence));
        key.columns = columns;
        return key;
    }
    template <class A>
    Key& modes(std::string name, A access, std::vector<Dimension> d, std::string sentence) {
        Key& key = eigen(std::move(name), Form::modes, access, std::move(d), std::move(sentence));
        key.columns = 6;
        return key;
    }

    /// A list of numbers, or one alone.
    template <class A>
    Key& numbers(std::string name, A access, const Dimension& d, std::size_t fewest,
                 std::size_t most, std::string sentence) {
        Key& key = scalar<std::vector<double>>(std::move(name), Form::numbers, access,
                                               std::move(sentence));
        key.dimensions = {d};
        key.fewest = fewest;
        key.most = most;
        return key;
    }
    /// Rows of two quantities, kept as a Curve.
    template <class A>
    Key& points(std::string name, A access, std::vector<Dimension> d, std::string sentence) {
        Key& key = add(std::move(name), Form::rows, std::move(sentence));
        key.dimensions = std::move(d);
        key.fewest = key.most = 2;
        key.set = [access](void* object, const Value& value) {
            at(access, object) = keys_detail::curve_of(value);
        };
        key.get = [access](const void* object) -> Value {
            const auto& curve = at(access, const_cast<void*>(object));
            if (curve.empty()) return {};
            return keys_detail::rows_of(curve);
        };
        return key;
    }
    /// A number, or a curve instead of it; dimensions of the number and of the curve's columns.
    template <class A, class B>
    Key& curve(std::string name, A number, B curve, std::vector<Dimension> d,
               std::string sentence) {
        Key& key = scalar<double>(std::move(name), Form::curve, number, std::move(sentence));
        key.dimensions = std::move(d);
        key.fewest = key.most = 2;
        key.set = [set = key.set, curve](void* object, const Value& value) {
            if (std::holds_alternative<double>(value)) return set(object, value);
            at(curve, object) = keys_detail::curve_of(value);
        };
        key.get = [get = key.get, curve](const void* object) -> Value {
            const auto& points = at(curve, const_cast<void*>(object));
            if (points.empty()) return get(object);
            return keys_detail::rows_of(points);
        };
        return key;
    }

    /// Any form with hand-written access.
    Key& custom(std::string name, Form form, std::vector<Dimension> d, std::string sentence,
                std::function<void(T&, const Value&)> set, std::function<Value(const T&)> get) {
        Key& key = add(std::move(name), form, std::move(sentence));
        key.dimensions = std::move(d);
        key.set = [set](void* object, const Value& v) { set(*static_cast<T*>(object), v); };
        key.get = [get](const void* object) { return get(*static_cast<const T*>(object)); };
        return key;
    }

    /// A sub-table kept in a member (emplaced if it is an std::optional).
    template <class A>
    Key& map(std::string name, A access, const Table& (*table)(), std::string sentence) {
        Key& key = add(std::move(name), Form::map, std::move(sentence));
        key.table = table;
        key.open = [access](void* object, const std::string&) -> void* {
            auto&& place = at(access, object);
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                return &place.emplace();
            } else {
                return &place;
            }
        };
        key.elements = [access](const void* object) -> std::vector<Element> {
            auto&& place = at(access, const_cast<void*>(object));
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                if (!place) return {};
                return {{"", &*place, ""}};
            } else {
                return {{"", &place, ""}};
            }
        };
        return key;
    }
    /// A sub-table of the file whose values live in this same struct.
    Key& group(std::string name, const Table& (*table)(), std::string sentence) {
        return map(
            std::move(name), [](T& object) -> T& { return object; }, table, std::move(sentence));
    }
    template <class A>
    Key& list(std::string name, A access, const Table& (*table)(), std::string sentence) {
        Key& key = add(std::move(name), Form::list, std::move(sentence));
        key.table = table;
        key.open = [access](void* object, const std::string&) -> void* {
            return &at(access, object).emplace_back();
        };
        key.elements = [access](const void* object) {
            std::vector<Element> all;
            for (const auto& e : at(access, const_cast<void*>(object))) all.push_back({"", &e, ""});
            return all;
        };
        return key;
    }
    /// A map of names; the elements have a member `name`.
    template <class A>
    Key& named(std::string name, A access, const Table& (*table)(), std::string sentence) {
        Key& key = list(std::move(name), access, table, std::move(sentence));
        key.form = Form::named;
        key.open = [access](void* object, const std::string& element) -> void* {
            auto& added = at(access, object).emplace_back();
            added.name = element;
            return &added;
        };
        key.elements = [access](const void* object) {
            std::vector<Element> all;
            for (const auto& e : at(access, const_cast<void*>(object))) {
                if constexpr (requires { e.family; }) {
                    all.push_back({e.name, &e, e.family});
                } else {
                    all.push_back({e.name, &e, e.name});
                }
            }
            return all;
        };
        return key;
    }

    /// A key of the format that this version does not act on: refused.
    Key& later(std::string name, std::string sentence) {
        Key& key = add(std::move(name), Form::open, std::move(sentence));
        key.is_later = true;
        return key;
    }
    /// A key without a place in the struct.
    Key& plain(std::string name, Form form, std::string sentence) {
        return add(std::move(name), form, std::move(sentence)).hidden();
    }

    Keys& rule(KeyRule::Count count, std::vector<std::string> keys) {
        table_.rules.push_back({count, std::move(keys)});
        return *this;
    }
    [[nodiscard]] Table done() { return std::move(table_); }

 private:
    template <class A>
    static decltype(auto) at(A access, void* object) {
        return std::invoke(access, *static_cast<T*>(object));
    }

    Key& add(std::string name, Form form, std::string sentence) {
        Key key;
        key.name = std::move(name);
        key.form = form;
        key.sentence = std::move(sentence);
        table_.keys.push_back(std::move(key));
        return table_.keys.back();
    }

    template <class V, class A>
    Key& scalar(std::string name, Form form, A access, std::string sentence) {
        Key& key = add(std::move(name), form, std::move(sentence));
        key.set = [access](void* object, const Value& value) {
            auto&& place = at(access, object);
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                place = static_cast<typename P::value_type>(std::get<V>(value));
            } else {
                place = static_cast<P>(std::get<V>(value));
            }
        };
        key.get = [access](const void* object) -> Value {
            auto&& place = at(access, const_cast<void*>(object));
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                if (!place) return {};
                return static_cast<V>(*place);
            } else if constexpr (std::is_same_v<P, std::vector<double>>) {
                if (place.empty()) return {};
                return place;
            } else {
                return static_cast<V>(place);
            }
        };
        return key;
    }

    template <class A>
    Key& eigen(std::string name, Form form, A access, std::vector<Dimension> d,
               std::string sentence) {
        Key& key = add(std::move(name), form, std::move(sentence));
        key.dimensions = std::move(d);
        key.set = [access](void* object, const Value& value) {
            auto&& place = at(access, object);
            using P = std::remove_cvref_t<decltype(place)>;
            const auto& v = std::get<std::vector<double>>(value);
            if constexpr (keys_detail::is_optional<P>::value) {
                place = keys_detail::matrix_of<typename P::value_type>(v);
            } else {
                place = keys_detail::matrix_of<P>(v);
            }
        };
        key.get = [access](const void* object) -> Value {
            auto&& place = at(access, const_cast<void*>(object));
            using P = std::remove_cvref_t<decltype(place)>;
            if constexpr (keys_detail::is_optional<P>::value) {
                if (!place) return {};
                return keys_detail::flat(*place);
            } else {
                return keys_detail::flat(place);
            }
        };
        return key;
    }

    Table table_;
};

}  // namespace hawser
