#pragma once
// Paths of instances as texts: splitting, joining, and replacing after a move.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/path.h>
#include <fettle/property/tree.h>

namespace fettle::property {

/// The path of the first `count` names, in the form that the tree writes.
std::string joined_path(const std::vector<Segment>& segments, std::size_t count);
/// The path of the parent, and the last name.
std::pair<std::string, std::string> split_path(const std::string& path);
/// The inverse of `split_path`.
std::string path_below(const std::string& parent, const std::string& name);
/// A name that no instance can have, because it begins with a zero byte. It replaces names in paths
/// that users never see.
std::string impossible_name(std::string_view name);
bool is_impossible(std::string_view name);
/// Whether a reference in a scene begins at the top of the scene (`.`, `.arm`) instead of the root.
bool is_from_top(std::string_view path);
/// Throws Error if there is none.
Handle instance_at(const Tree& tree, const std::string& path);
/// Null if there is none.
Handle instance_or_none(const Tree& tree, const std::string& path);
/// Whether `path` is `top` or a path below it.
bool is_at_or_below(const std::string& path, const std::string& top);

/// A set of paths. Finding those that contain a given path takes a time that does not depend on the
/// size of the set.
class PathSet {
  public:
    explicit PathSet(const std::vector<std::string>& paths);
    std::size_t size() const { return places_.size(); }
    /// Indices of the paths that are `path` or above it.
    std::vector<std::size_t> above(const std::string& path) const;

  private:
    std::unordered_map<std::string, std::size_t> places_;
};

/// The replacement of a path; nullopt: it stays. "": the reference becomes null.
using NewPath = std::function<std::optional<std::string>(const std::string& path)>;
/// Replaces `from`, and paths below it, by `to`.
NewPath moved_path(std::string from, std::string to);
/// A text that occurs in every JSON text with a reference to `path` or below it; it may occur in
/// others.
std::string mention_of(const std::string& path);

}  // namespace fettle::property
