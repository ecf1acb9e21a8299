#include <values/instance_paths.h>

#include <fettle/property/error.h>

#include <json/document.h>

namespace fettle::property {

std::string joined_path(const std::vector<Segment>& segments, std::size_t count) {
    std::string path;
    for (std::size_t i = 0; i < count; ++i)
        path += path_suffix(std::get<std::string>(segments[i].key));
    if (path.starts_with('.')) return path.substr(1);
    return "game" + path;
}

std::pair<std::string, std::string> split_path(const std::string& path) {
    std::vector<Segment> segments = parse_path(path);
    if (segments.empty()) throw Error(ErrorKind::bad_path, "game is the root of everything");
    const std::string name = std::get<std::string>(segments.back().key);
    const std::string suffix = path_suffix(name);
    if (segments.size() == 1) return {"game", name};
    return {path.substr(0, path.size() - suffix.size()), name};
}

std::string path_below(const std::string& parent, const std::string& name) {
    const std::string suffix = path_suffix(name);
    if (parent != "game") return parent + suffix;
    return suffix.starts_with('.') ? suffix.substr(1) : "game" + suffix;
}

std::string impossible_name(std::string_view name) {
    return '\0' + std::string(name);
}

bool is_impossible(std::string_view name) {
    return name.starts_with('\0');
}

bool is_from_top(std::string_view path) {
    return path.starts_with('.') || path.starts_with('[');
}

Handle instance_at(const Tree& tree, const std::string& path) {
    const Place place = resolve(tree, path);
    if (place.property != nullptr)
        throw Error(ErrorKind::unknown_name, path + " is a property now, not an instance");
    return place.instance;
}

Handle instance_or_none(const Tree& tree, const std::string& path) {
    Handle at = tree.root();
    for (const Segment& segment : parse_path(path)) {
        if (segment.is_index()) return {};
        at = tree.child(at, std::get<std::string>(segment.key));
        if (!at) return {};
    }
    return at;
}

bool is_at_or_below(const std::string& path, const std::string& top) {
    return path.starts_with(top) &&
           (path.size() == top.size() || path[top.size()] == '.' || path[top.size()] == '[');
}

PathSet::PathSet(const std::vector<std::string>& paths) {
    for (std::size_t i = 0; i < paths.size(); ++i) places_.emplace(paths[i], i);
}

std::vector<std::size_t> PathSet::above(const std::string& path) const {
    std::vector<std::size_t> found;
    for (std::size_t end = 1; end <= path.size(); ++end) {
        if (end < path.size() && path[end] != '.' && path[end] != '[') continue;
        if (const auto it = places_.find(path.substr(0, end)); it != places_.end())
            found.push_back(it->second);
    }
    return found;
}

NewPath moved_path(std::string from, std::string to) {
    return [from = std::move(from),
            to = std::move(to)](const std::string& path) -> std::optional<std::string> {
        if (!is_at_or_below(path, from)) return std::nullopt;
        return to + path.substr(from.size());
    };
}

std::string mention_of(const std::string& path) {
    std::string quoted;
    append_quoted(quoted, path);
    quoted.pop_back();  // the paths of instances below it continue here
    return quoted;
}

}  // namespace fettle::property
