#pragma once
// Which instances a text names, and the same text with other paths in their place.

#include <functional>
#include <optional>
#include <string>

#include <fettle/property/tree.h>

#include "document.h"

namespace fettle::property {

/// The path to write in the place of one, or nothing to leave it as it is.
using NewPath = std::function<std::optional<std::string>(const std::string& path)>;

/// Of every reference in a scene. Throws SceneError for a text that is none.
std::string scene_with_paths(const Tree& tree, const std::string& scene, const NewPath& path);

/// Of every reference in a value of that type; of one that says its own types, as the journal
/// holds it, without one.
std::string value_with_paths(const std::string& value, const NewPath& path, Type type = Type::nil,
                             Type element = Type::nil);

/// Whether `path` is `top` or leads below it.
bool is_at_or_below(const std::string& path, const std::string& top);

}  // namespace fettle::property
