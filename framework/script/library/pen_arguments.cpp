#include <library/pen_arguments.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <library/pen.h>
#include <limits/limiters.h>
#include <lua/machine.h>
#include <lua/stack.h>

namespace fettle::script {

using property::Color;
using property::Paint;
using property::Painter;

namespace {

// Instructions that are charged to an untrusted game for a figure.
constexpr std::uint64_t figure_charge = 1000;

void check_not_below_0(double value, const char* what, const char* of) {
    if (value < 0)
        throw Error(ErrorKind::out_of_range, std::string(what) + ": " +
                                                 property::number_text(value) + " is not a " + of +
                                                 ", which is 0 or more");
}

}  // namespace

Painter& painter(lua_State* L) {
    machine_of(L).limiters.budget.charge_quietly(figure_charge);
    if (Painter* found = machine_of(L).pen.painter) return *found;
    throw Error(ErrorKind::rejected, "pen: draws only while draw(pen) is called");
}

bool& on_screen(lua_State* L) {
    push_registry(L, machine_of(L).pen.reference);
    bool& on = box_at<PenBox>(L, -1, Tag::pen)->on_screen;
    lua_pop(L, 1);  // the registry keeps the box alive
    return on;
}

void drop_self(lua_State* L) {
    if (box_at<PenBox>(L, 1, Tag::pen)) lua_remove(L, 1);
}

Color color_or(lua_State* L, int index, const char* what, Color otherwise) {
    if (lua_isnoneornil(L, index)) return otherwise;
    if (lua_isboolean(L, index) && !lua_toboolean(L, index)) return {0, 0, 0, 0};
    return check_color(L, index, what);
}

double number_or(lua_State* L, int index, const char* what, double otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : check_number(L, index, what);
}

void check_finite(double value, const char* what) {
    if (!std::isfinite(value))
        throw Error(ErrorKind::not_finite,
                    std::string(what) + ": " + property::number_text(value) + " cannot be drawn");
}

float width_or(lua_State* L, int index, const char* what, double otherwise) {
    const double value = number_or(L, index, what, otherwise);
    check_finite(value, what);
    check_not_below_0(value, what, "width in pixels");
    return static_cast<float>(std::min(value, 1e4));
}

Paint paint_at(lua_State* L, int index, const char* what) {
    Paint paint;
    const bool border = !lua_isnoneornil(L, index + 1);
    paint.fill = color_or(L, index, what, border ? Color{0, 0, 0, 0} : Color{1, 1, 1, 1});
    paint.border = color_or(L, index + 1, what, {0, 0, 0, 0});
    paint.border_width = width_or(L, index + 2, what, 1.5);
    return paint;
}

Vec2 point_at(lua_State* L, int index, const char* what) {
    Vec2 v = check_vec(L, index, what);
    check_finite(v.x, what);
    check_finite(v.y, what);
    return v;
}

double length_at(lua_State* L, int index, const char* what, const char* of) {
    const double value = check_number(L, index, what);
    check_finite(value, what);
    check_not_below_0(value, what, of);
    return value;
}

double angle_at(lua_State* L, int index, const char* what, double otherwise) {
    const double angle = number_or(L, index, what, otherwise);
    check_finite(angle, what);
    return angle;
}

}  // namespace fettle::script
