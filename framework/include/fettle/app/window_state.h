#pragma once
// The window of a game: its title, size and mode. Seen in the tree as `view.window`. The window
// follows these values; a headless run has them without a window.

#include <cstdint>
#include <string>

#include <fettle/app/export.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::app {

struct View;

/// Form of the mouse pointer. The names of the enumerators are those of `view.window.cursor`.
enum class Cursor : std::uint8_t {
    arrow,
    hand,
    text,
    cross,
    move,
    size_horizontal,
    size_vertical,
    wait,
    help,
    not_allowed
};

struct WindowState {
    std::string title = "Fettle";
    property::Vec2 size{1280, 800};  // px, while it is not fullscreen
    bool fullscreen = false;
    bool resizable = true;
    bool vsync = true;  // frames wait for the screen
    bool cursor_visible = true;
    Cursor cursor = Cursor::arrow;
    bool grab_mouse = false;  // the pointer stays in the window
    std::string icon{};       // an image file of the game; empty: that of the system
};

/// Adds the window of the view to the tree, below `view`. The view must outlive all use by the
/// tree.
void define_window(property::Tree& tree, property::Handle view_instance, View& view);

}  // namespace fettle::app

FETTLE_APP_END
