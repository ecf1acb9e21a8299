// Makes the environment of games and the console, which contains only allowed names.

#include <calls/errors.h>
#include <fettle/property/error.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/other_languages.h>
#include <sandbox/sandbox.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// Copies these fields of the global library `from` into a new table.
void copy_library(lua_State* L, const char* from, std::initializer_list<const char*> names) {
    lua_getglobal(L, from);
    lua_newtable(L);
    for (const char* name : names) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    lua_remove(L, -2);
}

// Adds the allowed functions to the environment at the top of the stack.
void allow(lua_State* L) {
    for (const char* name : {"assert", "error", "next", "rawequal", "rawget", "rawlen", "rawset",
                             "select", "tonumber", "type"}) {
        lua_getglobal(L, name);
        lua_setfield(L, -2, name);
    }
    for (const char* name : {"assert", "error"}) {
        lua_getglobal(L, name);
        machine_of(L).errors.raise_unchanged.push_back(lua_tocfunction(L, -1));
        lua_pop(L, 1);
    }
    lua_pushstring(L, LUA_VERSION);
    lua_setfield(L, -2, "_VERSION");
    lua_pushvalue(L, -1);
    lua_setfield(L, -2, "_G");
    const struct {
        const char* library;
        std::initializer_list<const char*> names;
    } libraries[] = {
        {"math",
         {"abs",  "acos", "asin", "atan", "ceil",       "cos",  "deg",        "exp",  "floor",
          "fmod", "huge", "log",  "max",  "maxinteger", "min",  "mininteger", "modf", "pi",
          "rad",  "sin",  "sqrt", "tan",  "tointeger",  "type", "ult"}},
        {"string",
         {"byte", "char", "len", "lower", "pack", "packsize", "rep", "reverse", "sub", "unpack",
          "upper"}},
        {"table", {"pack"}},
        {"coroutine", {"isyieldable", "running", "status", "yield"}},
        {"utf8", {"char", "charpattern", "codepoint", "codes", "len", "offset"}},
        {"os", {"clock", "date", "difftime", "time"}},
    };
    for (const auto& [library, names] : libraries) {
        copy_library(L, library, names);
        lua_setfield(L, -2, library);
    }
}

/// The `__index` of `string`, where texts look up their methods: an unknown name is not nil.
int unknown_of_text(lua_State* L) {
    if (lua_type(L, 2) == LUA_TNUMBER)
        throw property::Error(property::ErrorKind::unknown_name,
                              "a text has no elements; text:sub(1, 1) is its first letter");
    if (lua_type(L, 2) == LUA_TSTRING)
        if (const std::string hint = hint_for_text_method(view_at(L, 2)); !hint.empty())
            throw property::Error(property::ErrorKind::unknown_name,
                                  "a text has no " + string_at(L, 2) + hint);
    return push_method(L, "a text");
}

void refuse_unknown_of_text(lua_State* L) {
    lua_getfield(L, -1, "string");
    lua_createtable(L, 0, 3);
    lua_pushvalue(L, -2);
    lua_setfield(L, -2, "methods");
    lua_pushliteral(L, "string");
    lua_setfield(L, -2, "__metatable");
    lua_pushcfunction(L, guarded<unknown_of_text>);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
    lua_pop(L, 1);
}

// All texts share one metatable, which scripts must not get.
void protect_texts(lua_State* L) {
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_getfield(L, -3, "string");
    lua_setfield(L, -2, "__index");
    lua_pushliteral(L, "text");
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 2);
}

}  // namespace

void open_sandbox(lua_State* L) {
    lua_newtable(L);
    allow(L);
    open_base(L);
    open_table_guards(L);
    open_strings(L);
    open_patterns(L);
    protect_texts(L);
    refuse_unknown_of_text(L);
}

}  // namespace fettle::script
