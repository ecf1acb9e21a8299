#pragma once
// What the functions of the pen have in common: the painter, and checks of their arguments.

#include <cstdint>

#include <fettle/property/painter.h>

#include <lua/lua_api.h>
#include <lua/tree_names.h>
#include <values/values.h>

namespace fettle::script {

/// The global `pen`.
struct PenBox {
    Tag tag;
    bool on_screen = false;  // inside pen.screen(...)
};

/// The painter of the picture that is being drawn. Throws if none is. Charges the call to the
/// budget of the game.
property::Painter& painter(lua_State* L);
bool& on_screen(lua_State* L);
/// Lets pen:circle(...) work like pen.circle(...).
void drop_self(lua_State* L);

// `what` is the name of the function for messages, as in "pen.circle".
property::Color color_or(lua_State* L, int index, const char* what, property::Color otherwise);
double number_or(lua_State* L, int index, const char* what, double otherwise);
void check_finite(double value, const char* what);
/// Width in pixels.
float width_or(lua_State* L, int index, const char* what, double otherwise);
/// Fill, border and width of the border, at `index` and after it.
property::Paint paint_at(lua_State* L, int index, const char* what);
Vec2 point_at(lua_State* L, int index, const char* what);
/// `of`: what the number is, as in "radius".
double length_at(lua_State* L, int index, const char* what, const char* of);
double angle_at(lua_State* L, int index, const char* what, double otherwise);

/// Adds the functions that draw figures to the table on top of the stack.
void add_figures(lua_State* L);

}  // namespace fettle::script
