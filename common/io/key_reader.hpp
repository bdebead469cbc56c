// Reads a tree of text into structs by the tables of keys (case/keys.hpp).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "case/declared.hpp"
#include "io/case_tree.hpp"

namespace hawser::io {

class KeyReader {
 public:
    explicit KeyReader(Problems& problems) : problems_(problems) {}

    /// Paths of files are rewritten relative to this folder.
    void set_folder(std::filesystem::path folder) { folder_ = std::move(folder); }

    /// Reads the map `node` into `object`, which the table was made for. A number that is wrong or
    /// missing becomes NaN, so that what depends on it can be told from what is right.
    void read(const Table& table, const Node& node, void* object, const std::string& path);

    [[nodiscard]] const Given& given() const { return given_; }
    [[nodiscard]] const Places& places() const { return places_; }

 private:
    void entry(const Table& table, const Entry& entry, void* object, const std::string& path);
    void value(const Key& key, const Node& node, void* object, const std::string& path);
    void children(const Key& key, const Node& node, void* object, const std::string& path);
    void missing(const Table& table, const Node& node, void* object, const std::string& path);
    void defaults(const Table& table, void* object, const Place& place, bool required);
    void rules(const Table& table, const Node& node, const std::string& path);
    void conditions(const Table& table, const Node& node, void* object, const std::string& path);
    Value scalar(const Key& key, const Node& node, const void* object, const std::string& path);
    Value rows(const Key& key, const Node& node, const std::string& path);
    double number(const Key& key, const Dimension& dimension, const Node& node,
                  const std::string& path);
    std::string word(const Key& key, const Node& node, const std::string& path);
    std::string relative(const Node& node) const;
    std::vector<double> row(const Key& key, const Node& node, const std::string& path);
    std::vector<double> matrix(const Key& key, const Node& node, const std::string& path);
    void error(const Place& place, const std::string& path, const std::string& message);

    Problems& problems_;
    Given given_;
    Places places_;
    Given failed_;  ///< paths with errors
    std::filesystem::path folder_;
};

}  // namespace hawser::io
