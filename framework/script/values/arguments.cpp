// Checks of the arguments of functions.

#include <algorithm>
#include <cmath>

#include <fettle/property/spelling.h>

#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/synonyms.h>
#include <sources/call_form.h>
#include <values/members.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

int push_method(lua_State* L, const std::string& noun, std::vector<std::string> fields) {
    luaL_getmetafield(L, 1, "methods");
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) != LUA_TNIL) return 1;
    lua_pop(L, 1);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) fields.push_back(string_at(L, -2));
    std::sort(fields.begin(), fields.end());  // Lua has no fixed order
    const std::string name = key_in_message(L, 2);
    throw Error(ErrorKind::unknown_name,
                noun + " has no " + name + hint_at(property_synonyms(name), name, fields));
}

void refuse_type(lua_State* L, int index, std::string_view needed) {
    throw Error(ErrorKind::wrong_type, std::string(needed) + ", not " + describe_type(L, index));
}

void refuse_argument(lua_State* L, int index, const std::string& method, std::string_view needed) {
    // Functions in tables, such as scene.load, are called with a dot.
    const bool in_table = method.find('.') != std::string::npos;
    throw Error(ErrorKind::wrong_type, method + ": needs " + std::string(needed) + ", not " +
                                           describe_type(L, index) +
                                           (in_table ? "" : colon_hint(L, 0)));
}

std::string check_text(lua_State* L, int index, std::string_view needed) {
    if (lua_type(L, index) != LUA_TSTRING) refuse_type(L, index, needed);
    return string_at(L, index);
}

Handle check_instance(lua_State* L, int index, const char* what) {
    const auto* box = instance_at(L, index);
    if (!box) refuse_argument(L, index, what, "an instance");
    machine_of(L).tree.require(box->handle);
    return box->handle;
}

Vec2 check_vec(lua_State* L, int index, const char* what) {
    const auto* box = vec_at(L, index);
    if (!box) refuse_argument(L, index, what, "a vec");
    return {box->x, box->y};
}

property::Color check_color(lua_State* L, int index, const char* what) {
    if (const auto* box = color_at(L, index)) return box->color;
    if (lua_type(L, index) == LUA_TSTRING) {
        property::Color color;
        if (property::parse_color(string_at(L, index), color)) return color;
        throw Error(ErrorKind::wrong_type,
                    std::string(what) + ": \"" + string_at(L, index) + "\" is not a color" +
                        property::suggestion(string_at(L, index), property::color_names()));
    }
    refuse_type(L, index, std::string(what) + ": needs a color");
}

double check_seconds(lua_State* L, const char* what) {
    if (lua_type(L, 1) != LUA_TNUMBER)
        refuse_type(L, 1,
                    std::string(what) + ": needs a time in seconds" +
                        (lua_type(L, 2) == LUA_TNUMBER ? " before the rest" : ""));
    const double seconds = lua_tonumber(L, 1);
    if (!(seconds >= 0) || std::isinf(seconds))
        throw Error(ErrorKind::out_of_range, std::string(what) + ": " +
                                                 property::number_text(seconds) +
                                                 " s; a time is finite and not negative");
    return seconds;
}

void check_function(lua_State* L, int index, const char* what) {
    const std::string needed = std::string(what) + ": needs a function";
    if (lua_isnoneornil(L, index))
        throw Error(ErrorKind::wrong_type,
                    needed + ", not nil (its name without brackets, or function() ... end)");
    if (lua_type(L, index) != LUA_TFUNCTION) refuse_type(L, index, needed);
}

double check_number(lua_State* L, int index, const char* what) {
    if (lua_type(L, index) != LUA_TNUMBER)
        refuse_type(L, index, std::string(what) + ": needs a number");
    return lua_tonumber(L, index);
}

}  // namespace fettle::script
