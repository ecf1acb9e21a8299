#pragma once
// Paths of instances as texts: taken apart, put together, and after something was renamed or moved.

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

/// The path of the first `count` names, as the tree writes it.
std::string joined_path(const std::vector<Segment>& segments, std::size_t count);
/// The parent's path of a path of an instance, and its last name.
std::pair<std::string, std::string> split_path(const std::string& path);
/// The other way round.
std::string path_below(const std::string& parent, const std::string& name);
/// A name that no instance can have, since names hold no zero byte: it stands for one in paths that
/// are not for users.
std::string impossible_name(std::string_view name);
bool is_impossible(std::string_view name);
/// Whether a reference in a scene leads from the top of the scene (`.`, `.arm`) and not from the
/// root.
bool is_from_top(std::string_view path);
/// Throws Error where there is none.
Handle instance_at(const Tree& tree, const std::string& path);
/// Null where there is none.
Handle instance_or_none(const Tree& tree, const std::string& path);
/// Whether `path` is `top` or leads below it.
bool is_at_or_below(const std::string& path, const std::string& top);

/// Paths, by which those at or below one of them are found in a time that does not grow with their
/// number.
class PathSet {
  public:
    explicit PathSet(const std::vector<std::string>& paths);
    std::size_t size() const { return places_.size(); }
    /// Places in the list of those that are `path` or lead to something above it.
    std::vector<std::size_t> above(const std::string& path) const;

  private:
    std::unordered_map<std::string, std::size_t> places_;
};

/// The path to write in the place of one, or nothing to leave it as it is. "": no reference.
using NewPath = std::function<std::optional<std::string>(const std::string& path)>;
/// Of what was at `from` or below it, and is at `to` now.
NewPath moved_path(std::string from, std::string to);
/// What every text in JSON holds that names an instance at `path` or below it; others may, too.
std::string mention_of(const std::string& path);

}  // namespace fettle::property
