#pragma once
// The view: the visible part of the world, and its scale. In the tree as `view`.

#include <array>
#include <string>

#include <fettle/app/export.h>
#include <fettle/app/window_state.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Overlays on the picture; `view.show`.
struct Show {
    bool aabbs = false;
    bool contacts = false;
    bool joints = false;
    bool centers = false;
    bool velocities = false;
    bool names = false;
    bool islands = false;
    bool grid = false;
    bool timings = false;
    bool overlay(property::Overlay overlay) const;
};

/// World units are metres with y up; screen units are pixels from the top left corner with y down.
struct View {
    property::Vec2 center{0, 0};  // m, in the middle of the screen
    double height = 20;           // m, visible from bottom to top
    property::Color background{0.105f, 0.122f, 0.153f, 1};
    property::Vec2 screen{1280, 800};  // px
    WindowState window{};
    Show show{};

    double zoom() const { return screen.y() / height; }   // px/m
    double width() const { return screen.x() / zoom(); }  // m
    property::Vec2 lower() const { return center - 0.5 * property::Vec2(width(), height); }
    property::Vec2 upper() const { return center + 0.5 * property::Vec2(width(), height); }

    property::Vec2 to_screen(const property::Vec2& world) const;
    property::Vec2 to_world(const property::Vec2& pixels) const;
};

/// Adds the view to the tree as `view`, with `view.show` and `view.window`. It must outlive all use
/// by the tree.
property::Handle define_view(property::Tree& tree, View& view);

}  // namespace fettle::app

FETTLE_APP_END
