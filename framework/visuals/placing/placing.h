#pragma once
// Where an instance is drawn. Each instance above it with a pose or a `position` maps the
// coordinates below it: it scales, turns and moves them, in this order.

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::visuals {

/// The map from the coordinates below `instance` to those of the world or, on the screen, of its
/// layer. `on_screen`: y is down, and angles are still counter-clockwise as seen.
property::Transform placed_below(const property::Tree& tree, property::Handle instance,
                                 bool on_screen, double alpha);

/// `angle`: counter-clockwise as seen.
property::Transform local_pose(const property::Vec2& position, double angle, double scale,
                               bool on_screen);

}  // namespace fettle::visuals
