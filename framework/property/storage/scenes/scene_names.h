#pragma once
// Which instances a text names, and the same text with other paths in their place.

#include <string>

#include <fettle/property/tree.h>

#include <json/document.h>
#include <scenes/instance_paths.h>

namespace fettle::property {

/// Of every reference in a scene. Throws SceneError for a text that is none.
std::string scene_with_paths(const Tree& tree, const std::string& scene, const NewPath& path);

/// Of every reference in a value of that type; of one that says its own types, as the journal
/// holds it, without one.
std::string value_with_paths(const std::string& value, const NewPath& path, Type type = Type::nil,
                             Type element = Type::nil);

}  // namespace fettle::property
