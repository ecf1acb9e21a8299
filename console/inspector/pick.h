#pragma once
// What lies under a point of the game.

#include <fettle/property/tree.h>

namespace fettle::console {

/// Asks every instance that has a method `at` (a physics world has one) for what is at the point,
/// in world units; the first answer counts. A null handle when nothing is there. Throws
/// property::Error when asking went wrong.
property::Handle pick(property::Tree& tree, property::Vec2 point);

}  // namespace fettle::console
