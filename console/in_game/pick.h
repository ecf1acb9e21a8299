#pragma once
// Finds the instance under a point of the game.

#include <fettle/property/tree.h>

namespace fettle::console {

/// Calls the method `at` of every instance that has one (physics worlds) with the point in world
/// units, and returns the first result. A null handle if there is nothing. Throws property::Error
/// if a call fails.
property::Handle pick(property::Tree& tree, property::Vec2 point);

}  // namespace fettle::console
