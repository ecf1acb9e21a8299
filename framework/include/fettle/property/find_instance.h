#pragma once
// The search for an instance by its path.

#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// The instance at the path, "world.ball". Throws Error(unknown_name) with the nearest name if
/// there is none, Error(wrong_type) if the path leads to a property, and Error(bad_path).
Handle find_instance(const Tree& tree, std::string_view path);

}  // namespace fettle::property

FETTLE_PROPERTY_END
