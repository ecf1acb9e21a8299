#pragma once
// Between C++ and Lua: an exception of ours becomes an error of Lua, with the script's position,
// before it could cross a frame of Lua. Lua's own errors are exceptions too in its C++ build; they
// pass through untouched, and destructors run.

#include <exception>
#include <string>

#include "lua_api.h"

namespace fettle::script {

/// "main.lua:12: " of the innermost script function running, or "".
std::string position(lua_State* L);
/// Raises `message` with its position in front.
[[noreturn]] void raise(lua_State* L, const std::string& message);
[[noreturn]] void raise_text(lua_State* L, const char* message);
/// The same with what the exception tells people.
[[noreturn]] void raise_exception(lua_State* L, const std::exception& error);

/// Gives what `body` returns.
template <class Body>
auto guard(lua_State* L, const Body& body) {
    try {
        return body();
    } catch (const std::exception& error) {
        raise_exception(L, error);
    }
}

template <int (*function)(lua_State*)>
int guarded(lua_State* L) {
    return guard(L, [L] { return function(L); });
}

/// Adds `function` under `name` to the table on top.
template <int (*function)(lua_State*)>
void add_function(lua_State* L, const char* name) {
    lua_pushcfunction(L, guarded<function>);
    lua_setfield(L, -2, name);
}

/// The table on top is the metatable of a kind of values: errors call them by that name, and
/// scripts see it instead of the table.
inline void name_metatable(lua_State* L, const char* name) {
    for (const char* field : {"__name", "__metatable"}) {
        lua_pushstring(L, name);
        lua_setfield(L, -2, field);
    }
}

}  // namespace fettle::script
