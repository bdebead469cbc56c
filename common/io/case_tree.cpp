#include "io/case_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "case/declared.hpp"

namespace hawser::io {

const Node* Node::find(std::string_view key) const {
    for (const Entry& e : entries) {
        if (e.key == key) return &e.value;
    }
    return nullptr;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

void Node::remove(std::string_view key) {
    std::erase_if(entries, [key](const Entry& e) { return e.key == key; });
}

void Node::put(const std::string& key, Node value) {
    if (Node* old = find(key)) {
        *old = std::move(value);
        return;
    }
    const Place at = value.place;
    entries.push_back({key, at, std::move(value), {}});
}

std::string found(const Node& node) {
    switch (node.kind) {
        case Node::Kind::nothing:
            return "nothing";
        case Node::Kind::scalar:
            return fmt::format("\"{}\"", node.text);
        case Node::Kind::list:
            return "a list";
        case Node::Kind::map:
            break;
    }
    return "a map";
}

Problem problem_at(const Place& place, const std::string& path, const std::string& message,
                   Severity severity) {
    return {severity, path, message, place.file, place.line, place.column};
}

void merge(Node& into, const Node& from) {
    if (into.kind != Node::Kind::map || from.kind != Node::Kind::map) {
        into = from;
        return;
    }
    for (const Entry& e : from.entries) {
        const auto old = std::find_if(into.entries.begin(), into.entries.end(),
                                      [&e](const Entry& other) { return other.key == e.key; });
        if (old == into.entries.end()) {
            into.entries.push_back(e);
            continue;
        }
        if (e.value.kind == Node::Kind::nothing) {
            into.entries.erase(old);
            continue;
        }
        if (e.value.kind != Node::Kind::map) old->place = e.place;
        merge(old->value, e.value);
    }
}

void set_value(Node& root, const std::string& path, const Node& value, Problems& problems) {
    const auto refuse = [&](const std::string& why) {
        problems.push_back(problem_at(value.place, path, why));
    };
    Node* node = &root;
    std::size_t i = 0;
    while (i < path.size()) {
        const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
        const std::string key = path.substr(i, end - i);
        if (key.empty()) return refuse("expected a path such as environment.waves[0].Hs");
        if (node->kind == Node::Kind::nothing) node->kind = Node::Kind::map;
        if (node->kind != Node::Kind::map) {
            return refuse(fmt::format("there is no \"{}\" in {}", key, found(*node)));
        }
        const bool removes = value.kind == Node::Kind::nothing;
        if (node->find(key) == nullptr) {
            if (removes) return refuse("there is nothing to remove");
            Node made;
            made.place = value.place;
            node->put(key, made);
        }
        if (removes && end == path.size()) return node->remove(key);
        node = node->find(key);
        i = end;
        while (i < path.size() && path[i] == '[') {
            std::size_t index = 0;
            const char* last = path.data() + path.size();
            const auto [stop, status] = std::from_chars(path.data() + i + 1, last, index);
            if (status != std::errc{} || stop == last || *stop != ']') {
                return refuse("expected a path such as environment.waves[0].Hs");
            }
            if (node->kind != Node::Kind::list || index >= node->items.size()) {
                return refuse(fmt::format("there is no element [{}]: {} has {}", index, key,
                                          node->items.size()));
            }
            node = &node->items[index];
            i = static_cast<std::size_t>(stop - path.data()) + 1;
            if (removes && i == path.size())
                return refuse("an element of a list cannot be removed");
        }
        if (i < path.size()) {
            if (path[i] != '.' || i + 1 == path.size()) {
                return refuse("expected a path such as environment.waves[0].Hs");
            }
            ++i;
        }
    }
    *node = value;
}

namespace {

/// Resolves `like` of one entry of a map of names.
class Likes {
 public:
    Likes(Node& map, const Node* defaults, const std::string& path, Problems& problems)
        : map_(map), defaults_(defaults), path_(path), problems_(problems) {}

    void run() {
        Node resolved = map_;
        for (Entry& e : resolved.entries) {
            if (e.value.kind != Node::Kind::map) continue;
            std::vector<std::string> chain;
            e.value = whole(e.key, chain);
        }
        map_ = std::move(resolved);
    }

 private:
    Node whole(const std::string& name, std::vector<std::string>& chain) {
        const Node& own = *map_.find(name);
        const Node* like = own.kind == Node::Kind::map ? own.find("like") : nullptr;
        // What a tapered type leaves out it takes from the type at its beginning.
        const Node* taper = own.kind == Node::Kind::map ? own.find("taper") : nullptr;
        for (const Entry& e : own.entries) {
            const bool written = taper != nullptr && !e.place.file.empty();
            if (!written || e.key == "taper" || e.key == "like") continue;
            problems_.push_back(problem_at(e.place, path_ + "." + name + "." + e.key,
                                           "does not act: a tapered type is what its two ends are",
                                           Severity::warning));
        }
        if (like == nullptr && taper != nullptr && own.find("category") == nullptr) {
            like = taper->find("from");
        }
        Node result;
        result.kind = Node::Kind::map;
        result.place = own.place;
        if (defaults_ != nullptr && defaults_->kind == Node::Kind::map) result = *defaults_;
        if (like != nullptr) {
            const std::string path = path_ + "." + name + ".like";
            chain.push_back(name);
            if (like->kind != Node::Kind::scalar) {
                problems_.push_back(problem_at(
                    like->place, path, fmt::format("expected a name; got {}", found(*like))));
            } else if (std::find(chain.begin(), chain.end(), like->text) != chain.end()) {
                problems_.push_back(problem_at(
                    like->place, path, fmt::format("\"{}\" leads back to itself", like->text)));
            } else if (map_.find(like->text) == nullptr) {
                std::vector<std::string> known;
                for (const Entry& e : map_.entries) {
                    if (e.key != name) known.push_back(e.key);
                }
                problems_.push_back(problem_at(like->place, path,
                                               fmt::format("unknown name \"{}\"{}", like->text,
                                                           suggestion(like->text, known))));
            } else {
                result = whole(like->text, chain);
                result.remove("taper");  // a type's own
            }
        }
        const bool partial = like != nullptr && result.entries.empty();
        merge(result, own);
        result.place = own.place;
        result.partial = partial || own.partial;
        result.remove("like");
        return result;
    }

    Node& map_;
    const Node* defaults_;
    std::string path_;
    Problems& problems_;
};

}  // namespace

void carry_out_likes(Node& root, Problems& problems) {
    Node defaults;
    if (const Node* given = root.find("defaults")) {
        defaults = *given;
        if (defaults.kind != Node::Kind::map) {
            problems.push_back(problem_at(defaults.place, "defaults",
                                          fmt::format("expected a map; got {}", found(defaults))));
        }
        for (const Entry& e : defaults.entries) {
            if (e.key == "line_types" || e.key == "lines") continue;
            problems.push_back(problem_at(e.place, "defaults." + e.key,
                                          "there are defaults for line_types and lines only"));
        }
        root.remove("defaults");
    }
    for (const char* name : {"line_types", "lines"}) {
        Node* map = root.find(name);
        if (map != nullptr && map->kind == Node::Kind::map) {
            Likes(*map, defaults.find(name), name, problems).run();
        }
    }
}

}  // namespace hawser::io
