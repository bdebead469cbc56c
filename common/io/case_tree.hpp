// The case file as a tree of text with places, before any key is read: files are merged, values
// set, `like` and `defaults` carried out, parameters filled in, families expanded.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "case/problem.hpp"
#include "io/quantity.hpp"

namespace hawser::io {

struct Place {
    std::string file;
    int line = 0, column = 0;  ///< from 1; 0: not in a file
};

/// Where each key stands.
using Places = std::map<std::string, Place, std::less<>>;

struct Entry;

struct Node {
    enum class Kind { nothing, scalar, list, map };
    Kind kind = Kind::nothing;
    Place place;
    Units units = Units::SI;  ///< of the file it stands in
    std::string text;
    bool partial = false;  ///< something in this map has been refused: what is missing is not said
    std::vector<Node> items;
    std::vector<Entry> entries;

    [[nodiscard]] const Node* find(std::string_view key) const;
    [[nodiscard]] Node* find(std::string_view key);
    void remove(std::string_view key);
    /// Adds or replaces.
    void put(const std::string& key, Node value);
};

struct Entry {
    std::string key;
    Place place;
    Node value;
    std::string shown;  ///< in paths instead of the key: the family of an expanded line
};

/// "a map", "a list", the text in quotes: what was found, for messages.
std::string found(const Node& node);

/// `from` over `into`: maps key by key, everything else replaced; nothing (null) removes the key.
void merge(Node& into, const Node& from);

/// Sets the value at a dotted path, environment.waves[0].Hs; maps on the way are made. Nothing
/// (null) removes the key.
void set_value(Node& root, const std::string& path, const Node& value, Problems& problems);

/// Carries out `defaults` and `like` for line_types and lines; both keys are gone afterwards.
void carry_out_likes(Node& root, Problems& problems);

/// Replaces ${name} and expands families into one entry per line. `parameters` is gone afterwards.
/// A parameter that nothing uses is a warning, unless keys have been overridden.
void fill_in(Node& root, bool overridden, Problems& problems);

/// A problem at a node.
Problem problem_at(const Place& place, const std::string& path, const std::string& message,
                   Severity severity = Severity::error);

}  // namespace hawser::io
