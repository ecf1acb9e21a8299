#pragma once
// The line around the selected instance in the game's picture.

#include <imgui.h>

#include <functional>

#include <fettle/property/tree.h>

namespace fettle::console {

using ToPixels = std::function<property::Vec2(property::Vec2 world)>;

/// Goes round what the instance and its children draw, where the picture shows it; round the `aabb`
/// of what draws nothing. `seconds` lets it pulse.
void draw_outline(ImDrawList& list, const property::Tree& tree, property::Handle instance,
                  const ToPixels& to_pixels, double seconds);

}  // namespace fettle::console
