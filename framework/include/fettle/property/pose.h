#pragma once
// Where an instance is in the world: each instance above it with a pose or a `position` maps the
// coordinates below it.

#include <optional>

#include <fettle/property/export.h>
#include <fettle/property/transform.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The map from the coordinates below `instance` to those of the world; nothing if neither it nor
/// an instance above has a place. A class with a function `Lifecycle::pose` has its place in the
/// world, whatever its parent is, as bodies have. Other instances have one by a property
/// `position`, which is relative to their parent, with `angle` and `scale` if there are
/// such numbers. `on_screen`: the coordinates are those of a screen, with y down; angles are still
/// counter-clockwise as seen. `alpha`: position of the moment between the last two steps, 0 to 1;
/// with 1, all values are those of the tree (between_steps.h). Values in error count with their
/// last valid value.
std::optional<Transform> place_below(const Tree& tree, Handle instance, bool on_screen,
                                     double alpha);

}  // namespace fettle::property

FETTLE_PROPERTY_END
