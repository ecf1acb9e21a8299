#pragma once
// The order of the children of an instance.

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Moves an instance right behind a sibling; to the front if `before` is null. Nothing happens if
/// they have different parents. Throws as `Tree::move` does.
void put_behind(Tree& tree, Handle instance, Handle before);

}  // namespace fettle::property

FETTLE_PROPERTY_END
