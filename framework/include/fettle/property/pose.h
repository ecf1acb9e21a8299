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
/// counter-clockwise as seen. For `alpha`, see `Lifecycle::pose`. Values in error count with their
/// last valid value.
std::optional<Transform> place_below(const Tree& tree, Handle instance, bool on_screen,
                                     double alpha);

/// The map of an instance with these values. `angle`: rad, counter-clockwise as seen.
Transform local_pose(const Vec2& position, double angle, double scale, bool on_screen);

}  // namespace fettle::property

FETTLE_PROPERTY_END
