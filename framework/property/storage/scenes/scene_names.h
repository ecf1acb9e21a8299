#pragma once
// Replacement of paths in the references of a text.

#include <string>

#include <fettle/property/tree.h>

#include <json/document.h>
#include <values/instance_paths.h>

namespace fettle::property {

/// Replaces paths in every reference of a scene. Throws SceneError for a text that is not a scene.
std::string scene_with_paths(const Tree& tree, const std::string& scene, const NewPath& path);

/// Replaces paths in every reference of a value of that type. Type::nil: the value contains its own
/// type, as in the journal.
std::string value_with_paths(const std::string& value, const NewPath& path, Type type = Type::nil,
                             Type element = Type::nil);

}  // namespace fettle::property
