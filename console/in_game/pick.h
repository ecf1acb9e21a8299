#pragma once
// Finds the instance under a point of the game.

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <look/pen.h>

namespace fettle::console {

/// Calls the method `at` of every instance that has one (physics worlds) with the point in world
/// units, and returns the first result. A null handle if there is nothing. Throws property::Error
/// if a call fails.
property::Handle pick(property::Tree& tree, property::Vec2 point);

/// The foremost widget at a pixel of the window: the first result of a method `widget_at`. A null
/// handle if there is none. Throws property::Error if a call fails.
property::Handle pick_widget(property::Tree& tree, property::Vec2 pixel);

/// The topmost instance with a picture that is opaque at a pixel of the window: a sprite, a text, a
/// layer of tiles. Light that is added covers nothing, and what covers the whole window is a
/// background. A null handle if there is none.
property::Handle pick_picture(const property::Tree& tree, property::Vec2 pixel,
                              const ToPixels& to_pixels, const property::Seen& seen);

}  // namespace fettle::console
