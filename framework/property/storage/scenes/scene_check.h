#pragma once
// Checks whether a scene can be loaded, without making anything.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// Throws the SceneError that loading the scene would throw, as far as the classes show: structure,
/// classes, names, values, texts of formulas, references inside the scene. `parent` may be null
/// (unknown); `name` "" means the name in the file. An error from a setter, or from a parent that
/// makes its own children, is found only by loading. Returns one line for each key that is probably
/// a mistake.
std::vector<std::string> check_scene(const Tree& tree, const Document& document, Handle parent = {},
                                     std::string_view name = {});

}  // namespace fettle::property
