// The global `pen`, with which draw(pen) draws. World units, y up; inside pen.screen(fn) pixels, y
// down.
//   pen.circle(center, radius [, fill [, border [, width]]])
//   pen.box(center, width, height [, fill [, border [, width [, angle]]]])
//   pen.polygon(vertices [, fill [, border [, width]]])
//   pen.line(from, to [, color [, width]])
//   pen.point(position [, color [, size]])
//   pen.text(position, text [, height [, color [, "middle" | "left" | "right"]]])
//   pen.screen(function)
// Colors are values or names; false draws no fill, no border. Without a fill a figure is white
// unless it has a border.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <library/pen.h>
#include <library/sandbox.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

using property::Color;
using property::Paint;
using property::Painter;

namespace {

struct PenBox {
    Tag tag;
    bool on_screen = false;  // inside pen.screen(...)
};

Painter& painter(lua_State* L) {
    if (Painter* found = machine_of(L).pen.painter) return *found;
    throw Error(ErrorKind::rejected, "pen: draws only while draw(pen) is called");
}

bool& on_screen(lua_State* L) {
    push_registry(L, machine_of(L).pen.reference);
    bool& on = box_at<PenBox>(L, -1, Tag::pen)->on_screen;
    lua_pop(L, 1);  // the registry keeps the box alive
    return on;
}

// pen:circle(...) works like pen.circle(...).
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

void check_not_below_0(double value, const char* what, const char* of) {
    if (value < 0)
        throw Error(ErrorKind::out_of_range, std::string(what) + ": " +
                                                 property::number_text(value) + " is no " + of +
                                                 ", which is 0 or more");
}

/// Width in pixels.
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
    check_finite(v.x(), what);
    check_finite(v.y(), what);
    return v;
}

double length_at(lua_State* L, int index, const char* what, const char* of) {
    const double value = check_number(L, index, what);
    check_finite(value, what);
    check_not_below_0(value, what, of);
    return value;
}

int circle(lua_State* L) {
    drop_self(L);
    painter(L).circle(point_at(L, 1, "pen.circle"), length_at(L, 2, "pen.circle", "radius"),
                      paint_at(L, 3, "pen.circle"));
    return 0;
}

int box(lua_State* L) {
    drop_self(L);
    const Vec2 center = point_at(L, 1, "pen.box");
    const double w = length_at(L, 2, "pen.box", "width") / 2;
    const double h = length_at(L, 3, "pen.box", "height") / 2;
    const double angle = number_or(L, 7, "pen.box", 0);
    check_finite(angle, "pen.box");
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<Vec2> corners;
    for (const Vec2& corner : {Vec2(-w, -h), Vec2(w, -h), Vec2(w, h), Vec2(-w, h)})
        corners.push_back(center +
                          Vec2(c * corner.x() - s * corner.y(), s * corner.x() + c * corner.y()));
    painter(L).polygon(corners, 0, paint_at(L, 4, "pen.box"));
    return 0;
}

int polygon(lua_State* L) {
    drop_self(L);
    const Value value = to_value(L, 1);
    if (!value.is(Type::list) || value.list().size() < 3)
        throw Error(ErrorKind::wrong_type, "pen.polygon: needs a list of three or more vec");
    std::vector<Vec2> vertices;
    for (const Value& each : value.list()) {
        if (!each.is(Type::vec2))
            throw Error(ErrorKind::wrong_type, "pen.polygon: needs a list of vec");
        check_finite(each.vec2().x(), "pen.polygon");
        check_finite(each.vec2().y(), "pen.polygon");
        vertices.push_back(each.vec2());
    }
    painter(L).polygon(vertices, 0, paint_at(L, 2, "pen.polygon"));
    return 0;
}

int line(lua_State* L) {
    drop_self(L);
    painter(L).line(point_at(L, 1, "pen.line"), point_at(L, 2, "pen.line"),
                    color_or(L, 3, "pen.line", {1, 1, 1, 1}), width_or(L, 4, "pen.line", 1.5));
    return 0;
}

int point(lua_State* L) {
    drop_self(L);
    painter(L).point(point_at(L, 1, "pen.point"), color_or(L, 2, "pen.point", {1, 1, 1, 1}),
                     width_or(L, 3, "pen.point", 4));
    return 0;
}

property::TextAlign align_at(lua_State* L, int index) {
    if (lua_isnoneornil(L, index)) return property::TextAlign::middle;
    const std::string name = lua_type(L, index) == LUA_TSTRING ? string_at(L, index) : "";
    if (name == "middle") return property::TextAlign::middle;
    if (name == "left") return property::TextAlign::left;
    if (name == "right") return property::TextAlign::right;
    throw Error(
        ErrorKind::wrong_type,
        "pen.text: expected \"middle\", \"left\" or \"right\", got " + short_text(L, index));
}

int text(lua_State* L) {
    drop_self(L);
    if (lua_gettop(L) < 2)
        throw Error(ErrorKind::wrong_type, "pen.text: needs a position and a text");
    if (lua_type(L, 1) == LUA_TSTRING) {  // both orders are accepted, since they are unambiguous
        lua_pushvalue(L, 1);
        lua_remove(L, 1);
        lua_insert(L, 2);
    }
    lua_settop(L, 5);
    const Vec2 position = point_at(L, 1, "pen.text");
    const double height =
        lua_isnil(L, 3) ? on_screen(L) ? 16 : 0.5 : length_at(L, 3, "pen.text", "height");
    const Color color = color_or(L, 4, "pen.text", {1, 1, 1, 1});
    const auto align = align_at(L, 5);
    push_tostring(L, 2);
    painter(L).text(position, view_at(L, -1), height, color, align);
    return 0;
}

int screen(lua_State* L) {
    drop_self(L);
    check_function(L, 1, "pen.screen");
    struct Pixels {
        Painter& painter;
        bool& on;
        bool before;
        Pixels(Painter& p, bool& flag) : painter(p), on(flag), before(std::exchange(flag, true)) {
            painter.begin_screen();
        }
        ~Pixels() {
            painter.end_screen();
            on = before;
        }
    } pixels(painter(L), on_screen(L));
    lua_settop(L, 1);
    push_registry(L, machine_of(L).pen.reference);
    lua_call(L, 1, 0);
    return 0;
}

int pen_index(lua_State* L) {
    // Names from other libraries differ too much for a suggestion by spelling.
    const std::string name = key_in_message(L, 2);
    if (name == "rect" || name == "rectangle")
        throw Error(ErrorKind::unknown_name, "pen has no " + name + " (did you mean \"box\"?)");
    return push_method(L, "pen");
}

}  // namespace

void open_pen(lua_State* L, Machine& machine) {
    auto* made = static_cast<PenBox*>(lua_newuserdatauv(L, sizeof(PenBox), 0));
    *made = {.tag = Tag::pen};
    lua_newtable(L);
    add_pure<pen_index>(L, "__index");
    lua_newtable(L);
    add_function<circle>(L, "circle");
    add_function<box>(L, "box");
    add_function<polygon>(L, "polygon");
    add_function<line>(L, "line");
    add_function<point>(L, "point");
    add_function<text>(L, "text");
    add_function<screen>(L, "screen");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "pen");
    lua_setmetatable(L, -2);
    machine.pen.reference = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
