#include <fettle/app/window_state.h>

#include <cmath>
#include <stdexcept>

#include <fettle/app/view.h>

namespace fettle::app {

namespace {

using property::Native;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

/// Outside of fullscreen the screen has the size of the window at once, with and without a window.
void resize_window(View& view, const Vec2& size) {
    if (std::floor(size.x) != size.x || std::floor(size.y) != size.y)
        throw std::invalid_argument("pixels are whole numbers");
    view.window.size = size;
    if (!view.window.fullscreen) view.screen = size;
}

template <class Base>
Property window_switch(View& view, const char* name, bool usual, const char* doc, Base base) {
    return {.name = name,
            .type = Type::boolean,
            .default_value = usual,
            .doc = doc,
            .binding = column(view, Native::boolean, 0, base),
            .transient = true};
}

}  // namespace

void define_window(property::Tree& tree, property::Handle view_instance, View& view) {
    const property::Class& window_class = tree.define(
        {.name = "GameWindow",
         .doc = "The window of the game. It is not part of saved games, and going back in time "
                "leaves it as it is.",
         .creatable = false,
         .snapshots = property::Snapshots::never,
         .properties = {
             {.name = "title",
              .type = Type::text,
              .default_value = view.window.title,
              .doc = "Title of the window; at the start that of game.json.",
              .binding = property::accessor(
                  view, [](View& v, property::Row) { return v.window.title; },
                  [](View& v, property::Row, const Value& title) {
                      v.window.title = title.text();
                  }),
              .transient = true},
             {.name = "icon",
              .type = Type::text,
              .default_value = view.window.icon,
              .doc = "An image file in the game's folder (PNG, JPEG, BMP, TGA) that the system "
                     "shows for the window; at the start that of game.json. Empty: that of the "
                     "system, or the last one.",
              .binding = property::accessor(
                  view, [](View& v, property::Row) { return v.window.icon; },
                  [](View& v, property::Row, const Value& icon) { v.window.icon = icon.text(); }),
              .transient = true},
             {.name = "size",
              .type = Type::vec2,
              .default_value = view.window.size,
              .unit = "px",
              .range = {1, 16384},
              .doc =
                  "Size of the window while it is not fullscreen. view.screen is what is seen now.",
              .binding = property::accessor(
                  view, [](View& v, property::Row) { return v.window.size; },
                  [](View& v, property::Row, const Value& size) { resize_window(v, size.vec2()); }),
              .transient = true,
              .simulated = true},
             window_switch(
                 view, "fullscreen", false,
                 "Whether the game fills the screen. F11 and Alt+Enter change it, and the "
                 "next run remembers it.",
                 [](View& v) { return &v.window.fullscreen; }),
             window_switch(view, "resizable", true,
                           "Whether the player can change the size of the window.",
                           [](View& v) { return &v.window.resizable; }),
             window_switch(
                 view, "vsync", true,
                 "Whether frames wait for the screen. false: they are drawn as fast as possible.",
                 [](View& v) { return &v.window.vsync; }),
             window_switch(view, "cursor_visible", true,
                           "Whether the pointer of the mouse is seen over the window.",
                           [](View& v) { return &v.window.cursor_visible; }),
             {.name = "cursor",
              .type = Type::text,
              .default_value = "arrow",
              .doc = "Form of the pointer of the mouse over the window.",
              .binding =
                  column(view, Native::enumeration, 0,
                         [](View& v) { return reinterpret_cast<std::uint8_t*>(&v.window.cursor); }),
              .transient = true,
              .enumerators = {"arrow", "hand", "text", "cross", "move", "size_horizontal",
                              "size_vertical", "wait", "help", "not_allowed"}},
             window_switch(view, "grab_mouse", false,
                           "Whether the pointer of the mouse is kept inside the window while the "
                           "window has the keyboard.",
                           [](View& v) { return &v.window.grab_mouse; })}});
    tree.create(window_class, view_instance, "window");
}

}  // namespace fettle::app
