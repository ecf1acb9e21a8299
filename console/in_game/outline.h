#pragma once
// The outline of the selected instance in the picture of the game.

#include <imgui.h>

#include <span>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <look/pen.h>

namespace fettle::console {

/// Draws a line around everything that each instance and its children draw: around figures, else
/// around pictures; an instance that draws nothing gets its `aabb`. `seen`: the visible part of the
/// world. `seconds`: time for the pulsing of the line.
void draw_outlines(ImDrawList& list, const property::Tree& tree,
                   std::span<const property::Handle> instances, const ToPixels& to_pixels,
                   const property::Seen& seen, double seconds);

}  // namespace fettle::console
