#pragma once
// Whether a scene could be loaded, found out without making anything.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// Throws the SceneError that loading the scene below `parent` (null: one that is not known) as
/// `name` ("": as the file says) would throw, as far as the classes tell: its shape, classes,
/// names, values, the texts of formulas, references inside of it. What the owner of a property, or
/// a parent that makes children of its own, would refuse is found by loading alone.
void check_scene(const Tree& tree, const Document& document, Handle parent = {},
                 std::string_view name = {});

}  // namespace fettle::property
