// The global `pen`, with which draw(pen) draws. World units, y up; inside pen.screen(fn) pixels, y
// down.
//   the figures of pen_figures.cpp
//   pen.text(position, text [, height [, color [, "middle" | "left" | "right" [, font [, wrap
//     [, outline]]]]]])
//   pen.screen(function)
//   pen.push([position [, angle [, scale]]])   pen.pop()
//   pen.fade(opacity)   pen.blend(mode)   pen.clip(lower, upper)      until pen.pop(), or the end
//   pen.linear(from, to, colors)   pen.radial(center, radius, colors)     likewise, for fills
//   pen.image(file, center [, width [, height [, angle [, tint [, smooth]]]]])
//     the file is a name, or for a frame of it { name [, columns = n] [, rows = n] [, frame = n] }
//   pen.text_size(text [, height [, font [, wrap]]]) -> width, height
// Colors are values or names; false draws no fill, no border. Without a fill a figure is white
// unless it has a border.

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/media.h>
#include <fettle/property/spelling.h>
#include <fettle/script/runtime.h>

#include <library/pen.h>
#include <library/pen_arguments.h>
#include <limits/budget.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sandbox/sandbox.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

using property::Color;
using property::Painter;

namespace {

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

property::Media& media(lua_State* L, const char* what) {
    if (property::Media* const found = machine_of(L).options.media) return *found;
    throw Error(ErrorKind::rejected,
                std::string(what) + ": this program has neither images nor fonts");
}

/// A message about a font that cannot be read names the line of the script.
std::string font_at(lua_State* L, int index, const char* what) {
    if (lua_isnoneornil(L, index)) return "sans";
    if (lua_type(L, index) == LUA_TSTRING) {
        std::string font = string_at(L, index);
        if (property::Media* const media = machine_of(L).options.media)
            media->load_font([=] { return position(L) + what; }, font);
        return font;
    }
    throw Error(ErrorKind::wrong_type,
                std::string(what) + ": expected a font, got " + short_text(L, index));
}

/// The greatest width of a line; 0 without an argument: no limit.
double wrap_at(lua_State* L, int index, const char* what) {
    return lua_isnoneornil(L, index) ? 0 : length_at(L, index, what, "wrap");
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
    lua_settop(L, 8);
    const Vec2 position = point_at(L, 1, "pen.text");
    const double height =
        lua_isnil(L, 3) ? on_screen(L) ? 16 : 0.5 : length_at(L, 3, "pen.text", "height");
    const Color color = color_or(L, 4, "pen.text", {1, 1, 1, 1});
    const auto align = align_at(L, 5);
    const std::string font = font_at(L, 6, "pen.text");
    const double wrap = wrap_at(L, 7, "pen.text");
    const Color outline = color_or(L, 8, "pen.text", {0, 0, 0, 0});
    push_tostring(L, 2);
    if (property::Media* const media = machine_of(L).options.media)
        media->text(painter(L), position, view_at(L, -1),
                    {.font = font,
                     .size = height,
                     .color = color,
                     .align = align,
                     .wrap = wrap,
                     .outline = outline});
    else
        painter(L).text(position, view_at(L, -1), height, color, align);
    return 0;
}

int text_size(lua_State* L) {
    drop_self(L);
    if (lua_gettop(L) < 1) throw Error(ErrorKind::wrong_type, "pen.text_size: needs a text");
    lua_settop(L, 4);
    const double height =
        lua_isnil(L, 2) ? on_screen(L) ? 16 : 0.5 : length_at(L, 2, "pen.text_size", "height");
    const std::string font = font_at(L, 3, "pen.text_size");
    const double wrap = wrap_at(L, 4, "pen.text_size");
    push_tostring(L, 1);
    const Vec2 size = media(L, "pen.text_size")
                          .text_size(view_at(L, -1), {.font = font, .size = height, .wrap = wrap});
    lua_pushnumber(L, size.x);
    lua_pushnumber(L, size.y);
    return 2;
}

// --- Transforms, pictures

int push(lua_State* L) {
    drop_self(L);
    Painter& to = painter(L);
    constexpr std::size_t most = 1000;
    if (to.pushed() >= most)
        throw Error(ErrorKind::rejected, "pen.push: " + std::to_string(most) +
                                             " transforms are set: is a pen.pop missing?");
    const Vec2 position = lua_isnoneornil(L, 1) ? Vec2(0, 0) : point_at(L, 1, "pen.push");
    const double angle = number_or(L, 2, "pen.push", 0), scale = number_or(L, 3, "pen.push", 1);
    check_finite(angle, "pen.push");
    check_finite(scale, "pen.push");
    // Angles are counter-clockwise as seen, though y points down on the screen.
    const auto turned = property::Transform::placed(position, to.on_screen() ? -angle : angle);
    to.push(turned * property::Transform::scaled({scale, scale}));
    return 0;
}

int pop(lua_State* L) {
    drop_self(L);
    if (painter(L).pushed() <= machine_of(L).pen.base)
        throw Error(ErrorKind::rejected, "pen.pop: there was no pen.push before");
    painter(L).pop();
    return 0;
}

int fade(lua_State* L) {
    drop_self(L);
    const double opacity = check_number(L, 1, "pen.fade");
    check_finite(opacity, "pen.fade");
    painter(L).fade(static_cast<float>(std::clamp(opacity, 0.0, 1.0)));
    return 0;
}

int blend(lua_State* L) {
    drop_self(L);
    const std::string name = lua_type(L, 1) == LUA_TSTRING ? string_at(L, 1) : "";
    Painter& to = painter(L);
    if (name == "normal") return to.blend(property::Blend::normal), 0;
    if (name == "add") return to.blend(property::Blend::add), 0;
    if (name == "multiply") return to.blend(property::Blend::multiply), 0;
    throw Error(ErrorKind::wrong_type,
                "pen.blend: expected \"normal\", \"add\" or \"multiply\", got " + short_text(L, 1));
}

std::vector<Color> colors_at(lua_State* L, int index, const char* what) {
    constexpr lua_Unsigned most = 64;
    if (lua_type(L, index) != LUA_TTABLE || lua_rawlen(L, index) < 2 || lua_rawlen(L, index) > most)
        throw Error(ErrorKind::wrong_type, std::string(what) + ": expected a list of 2 to " +
                                               std::to_string(most) + " colors, got " +
                                               short_text(L, index));
    std::vector<Color> colors;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, index, i);
        colors.push_back(check_color(L, lua_gettop(L), what));
        lua_pop(L, 1);
    }
    return colors;
}

int linear(lua_State* L) {
    drop_self(L);
    Painter& to = painter(L);
    to.gradient({.radial = false,
                 .from = point_at(L, 1, "pen.linear"),
                 .to = point_at(L, 2, "pen.linear"),
                 .colors = colors_at(L, 3, "pen.linear")});
    return 0;
}

int radial(lua_State* L) {
    drop_self(L);
    Painter& to = painter(L);
    const Vec2 center = point_at(L, 1, "pen.radial");
    const double radius = length_at(L, 2, "pen.radial", "radius");
    to.gradient({.radial = true,
                 .from = center,
                 .to = center + Vec2(radius, 0),
                 .colors = colors_at(L, 3, "pen.radial")});
    return 0;
}

int clip(lua_State* L) {
    drop_self(L);
    const Vec2 lower = point_at(L, 1, "pen.clip");
    painter(L).clip(lower, point_at(L, 2, "pen.clip"));
    return 0;
}

struct ImageRequest {
    std::string name;
    property::ImageFrame frame{};
};

std::int64_t count_of(lua_State* L, const char* field, std::int64_t most) {
    lua_getfield(L, 1, field);
    const std::int64_t count = lua_isnil(L, -1) ? 1 : lua_tointeger(L, -1);
    if (count < 1 || count > most)
        throw Error(ErrorKind::out_of_range,
                    std::string("pen.image: ") + field + ": expected a whole number from 1 to " +
                        std::to_string(most) + ", got " + short_text(L, -1));
    lua_pop(L, 1);
    return count;
}

ImageRequest image_at(lua_State* L) {
    if (lua_type(L, 1) == LUA_TSTRING) return {.name = string_at(L, 1)};
    const auto expected = [&](int index) {
        throw Error(ErrorKind::wrong_type,
                    "pen.image: expected the name of a file, got " + short_text(L, index));
    };
    if (lua_type(L, 1) != LUA_TTABLE) expected(1);
    lua_rawgeti(L, 1, 1);
    if (lua_type(L, -1) != LUA_TSTRING) expected(-1);
    ImageRequest request{.name = string_at(L, -1)};
    lua_pop(L, 1);
    const std::vector<std::string> known{"columns", "frame", "rows"};
    for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
        if (lua_isinteger(L, -2) && lua_tointeger(L, -2) == 1) continue;
        const std::string name = lua_type(L, -2) == LUA_TSTRING ? string_at(L, -2) : "";
        if (std::ranges::find(known, name) == known.end())
            throw Error(ErrorKind::unknown_name, "pen.image: a frame has no " + short_text(L, -2) +
                                                     property::suggestion(name, known));
    }
    request.frame = {.columns = count_of(L, "columns", 10'000),
                     .rows = count_of(L, "rows", 10'000),
                     .frame = count_of(L, "frame", 1'000'000'000)};
    return request;
}

int image(lua_State* L) {
    drop_self(L);
    lua_settop(L, 7);
    const ImageRequest request = image_at(L);
    Painter& to = painter(L);
    const Vec2 center = point_at(L, 2, "pen.image");
    const double angle = number_or(L, 5, "pen.image", 0);
    check_finite(angle, "pen.image");
    const Color tint = color_or(L, 6, "pen.image", {1, 1, 1, 1});
    property::Media& from = media(L, "pen.image");
    const bool smooth = lua_isnil(L, 7) ? from.smooth() : lua_toboolean(L, 7) != 0;
    const auto user = [L] { return position(L) + "pen.image"; };
    const property::Picture& picture = from.picture(user, request.name);
    const property::PictureFrame frame = from.frame(user, request.name, request.frame);
    const double pixel = on_screen(L) ? 1.0 : 1.0 / 32, w = frame.size.x, h = frame.size.y;
    // With one length, the picture keeps its proportions.
    const bool has_width = !lua_isnil(L, 3), has_height = !lua_isnil(L, 4);
    const double given_width = has_width ? length_at(L, 3, "pen.image", "width") : 0;
    const double given_height = has_height ? length_at(L, 4, "pen.image", "height") : 0;
    const double width = has_width    ? given_width
                         : has_height ? given_height * w / std::max(h, 1.0)
                                      : w * pixel;
    const double height = has_height  ? given_height
                          : has_width ? given_width * h / std::max(w, 1.0)
                                      : h * pixel;
    to.push(property::Transform::placed(center, to.on_screen() ? -angle : angle));
    // In the box of the uncut frame, that of the part that the file contains.
    const Vec2 unit(width / std::max(w, 1.0), height / std::max(h, 1.0));
    const Vec2 part = unit.times({frame.area.width, frame.area.height});
    Vec2 lower = unit.times(frame.offset) - Vec2(0.5 * width, 0.5 * height);
    if (!to.on_screen()) lower.y = -lower.y - part.y;
    to.picture(picture, frame.area, lower, lower + part, tint, smooth);
    to.pop();
    return 0;
}

int screen(lua_State* L) {
    drop_self(L);
    check_function(L, 1, "pen.screen");
    struct Pixels {
        Painter& painter;
        bool& on;
        std::size_t& base;
        bool before;
        std::size_t base_before;
        Pixels(Painter& p, bool& flag, std::size_t& lowest)
            : painter(p),
              on(flag),
              base(lowest),
              before(std::exchange(flag, true)),
              base_before(lowest) {
            painter.begin_screen();
            base = painter.pushed();
        }
        ~Pixels() {
            while (painter.pushed() > base) painter.pop();
            base = base_before;
            painter.end_screen();
            on = before;
        }
    } pixels(painter(L), on_screen(L), machine_of(L).pen.base);
    lua_settop(L, 1);
    push_registry(L, machine_of(L).pen.reference);
    lua_call(L, 1, 0);
    return 0;
}

int pen_index(lua_State* L) {
    // Names from other libraries differ too much for a suggestion by spelling.
    const std::string name = key_in_message(L, 2);
    constexpr std::array<std::pair<std::string_view, const char*>, 10> others{
        {{"rect", "box"},
         {"rectangle", "box"},
         {"oval", "ellipse"},
         {"sector", "pie"},
         {"lines", "line"},
         {"polyline", "line"},
         {"print", "text"},
         {"printf", "text"},
         {"draw", "image"},
         {"sprite", "image"}}};
    for (const auto& [other, own] : others)
        if (name == other)
            throw Error(ErrorKind::unknown_name,
                        "pen has no " + name + " (did you mean \"" + own + "\"?)");
    return push_method(L, "pen");
}

}  // namespace

void open_pen(lua_State* L, Machine& machine) {
    auto* made = static_cast<PenBox*>(lua_newuserdatauv(L, sizeof(PenBox), 0));
    *made = {.tag = Tag::pen};
    lua_newtable(L);
    add_pure<pen_index>(L, "__index");
    lua_newtable(L);
    add_figures(L);
    add_function<text>(L, "text");
    add_function<screen>(L, "screen");
    add_function<text_size>(L, "text_size");
    add_function<push>(L, "push");
    add_function<pop>(L, "pop");
    add_function<fade>(L, "fade");
    add_function<blend>(L, "blend");
    add_function<clip>(L, "clip");
    add_function<linear>(L, "linear");
    add_function<radial>(L, "radial");
    add_function<image>(L, "image");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "pen");
    lua_setmetatable(L, -2);
    machine.pen.reference = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
