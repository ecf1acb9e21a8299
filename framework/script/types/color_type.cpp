// The type of colors: color("tomato"), color("#ff8800"), color(r, g, b, a).

#include <fettle/property/literal_hint.h>
#include <fettle/property/spelling.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/short_text.h>
#include <values/store_type.h>
#include <values/values.h>

namespace fettle::script {

using property::Color;

namespace {

float* channel(Color& color, const char* key) {
    if (key[0] == '\0' || key[1] != '\0') return nullptr;
    switch (key[0]) {
        case 'r':
            return &color.r;
        case 'g':
            return &color.g;
        case 'b':
            return &color.b;
        case 'a':
            return &color.a;
        default:
            return nullptr;
    }
}

const char* key_at(lua_State* L) {
    return lua_type(L, 2) == LUA_TSTRING ? lua_tolstring(L, 2, nullptr) : "";
}

int color_lerp(lua_State* L) {
    const Color a = check_color(L, 1, "lerp"), b = check_color(L, 2, "lerp");
    const auto t = static_cast<float>(check_number(L, 3, "lerp"));
    push_color(L, {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t,
                   a.a + (b.a - a.a) * t});
    return 1;
}

int color_index(lua_State* L) {
    auto* box = static_cast<ColorBox*>(lua_touserdata(L, 1));
    const char* key = key_at(L);
    if (const float* value = channel(box->color, key)) {
        lua_pushnumber(L, static_cast<double>(*value));
        return 1;
    }
    if (std::string_view(key) == "lerp") {
        lua_pushcfunction(L, guarded<color_lerp>);
        return 1;
    }
    throw Error(ErrorKind::unknown_name,
                "a color has r, g, b, a and :lerp(), not " + key_in_message(L, 2));
}

/// `meant`: how the color is probably written instead.
float checked_channel(double value, const char* name, const std::string& meant = {}) {
    if (!(value >= 0 && value <= 1))
        throw Error(ErrorKind::out_of_range, std::string("color.") + name + ": " +
                                                 property::number_text(value) +
                                                 " is not between 0 and 1" + meant);
    return static_cast<float>(value);
}

/// The color of three or four numbers from `index` on.
Color check_channels(lua_State* L, int index, int count) {
    property::List given;
    given.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) given.emplace_back(check_number(L, index + i, "color"));
    Color color;
    float* const channels[] = {&color.r, &color.g, &color.b, &color.a};
    const char* const names[] = {"r", "g", "b", "a"};
    for (std::size_t i = 0; i < given.size(); ++i) {
        const double value = given[i].number();
        const std::string meant =
            value > 1 ? property::literal_hint(property::Type::color, Value(given)) : "";
        *channels[i] = checked_channel(value, names[i], meant);
    }
    return color;
}

int color_newindex(lua_State* L) {
    auto* box = static_cast<ColorBox*>(lua_touserdata(L, 1));
    const char* key = key_at(L);
    float* value = channel(box->color, key);
    if (!value)
        throw Error(
            ErrorKind::unknown_name,
            "a color has r, g, b and a, nothing else can be assigned: " + key_in_message(L, 2));
    if (box->has_origin) {
        Machine& machine = machine_of(L);
        origin_write(machine, box->origin, key,
                     Value(static_cast<double>(check_number(L, 3, "color"))));
        const Value now = origin_read(machine, box->origin);
        if (now.is(Type::color)) box->color = now.color();
        return 0;
    }
    const float number = checked_channel(check_number(L, 3, "color"), key);
    const bool stored = refresh_stored(L);
    *value = number;
    if (stored) write_stored(L);
    return 0;
}

int color_equal(lua_State* L) {
    const auto *a = color_at(L, 1), *b = color_at(L, 2);
    lua_pushboolean(L, a && b && a->color == b->color);
    return 1;
}

int color_tostring(lua_State* L) {
    const std::string text = property::value_text(check_color(L, 1, "tostring"));
    push_text(L, text);
    return 1;
}

int color_make(lua_State* L) {
    const int given = lua_gettop(L);
    if (given == 1 && lua_type(L, 1) == LUA_TSTRING) {
        const std::string name = string_at(L, 1);
        Color color;
        if (!property::parse_color(name, color))
            throw Error(ErrorKind::wrong_type,
                        "color: \"" + name + "\" is neither a color's name nor #rgb or #rrggbb" +
                            property::suggestion(name, property::color_names()));
        push_color(L, color);
        return 1;
    }
    if (given == 1 && color_at(L, 1)) {
        push_color(L, check_color(L, 1, "color"));
        return 1;
    }
    if (given < 3)
        throw Error(
            ErrorKind::wrong_type,
            "color: needs a name, \"#rrggbb\" or red, green, blue and opacity, each 0 to 1");
    push_color(L, check_channels(L, 1, given > 3 ? 4 : 3));
    return 1;
}

}  // namespace

void open_color(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<color_index>(L, "__index");
    add_pure<color_newindex>(L, "__newindex");
    add_pure<color_equal>(L, "__eq");
    add_pure<color_tostring>(L, "__tostring");
    name_metatable(L, "color");
    machine.boxes.color = luaL_ref(L, LUA_REGISTRYINDEX);
    add_pure<color_make>(L, "color");
}

}  // namespace fettle::script
