#pragma once
// Paths of instances as texts: taken apart, put together, and after something was renamed or moved.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
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
/// Throws Error where there is none.
Handle instance_at(const Tree& tree, const std::string& path);
/// Whether `path` is `top` or leads below it.
bool is_at_or_below(const std::string& path, const std::string& top);

/// The path to write in the place of one, or nothing to leave it as it is. "": no reference.
using NewPath = std::function<std::optional<std::string>(const std::string& path)>;
/// Of what was at `from` or below it, and is at `to` now.
NewPath moved_path(std::string from, std::string to);
/// What every text in JSON holds that names an instance at `path` or below it; others may, too.
std::string mention_of(const std::string& path);

}  // namespace fettle::property
