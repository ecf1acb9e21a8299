#pragma once
// Between C++ and Lua: an exception of ours becomes an error of Lua, with the script's position,
// before it could cross a frame of Lua. Lua's own errors are exceptions too in its C++ build; they
// pass through untouched, and destructors run.

#include <exception>
#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// "main.lua:12: " of the innermost script function running, or "".
std::string position(lua_State* L);
/// Where the function on top of the stack was defined: "main.lua:3: ".
std::string definition(lua_State* L);
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

/// Throws while a formula runs or a function is asked something (`property::Inquiry`), naming that
/// and the function that was called.
void require_changeable(lua_State* L);
/// The same, for formulas alone.
void require_no_formula(lua_State* L);

/// The function of Lua's own library in upvalue 1, as if a script had called it directly: its
/// errors tell the script's line, and which argument is wrong.
inline int call_original(lua_State* L) {
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Adds `function` to the table on top, with the one of that name of Lua's own `library` as its
/// upvalue.
template <int (*function)(lua_State*)>
void wrap_pure(lua_State* L, const char* library, const char* name) {
    lua_getglobal(L, library);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
    lua_pushcclosure(L, guarded<function>, 1);
    lua_setfield(L, -2, name);
}

/// A function that changes something. A formula gives a value and changes nothing, so it cannot
/// call it; nor can a function that is asked in the middle of a step or of a search.
template <int (*function)(lua_State*)>
int effect(lua_State* L) {
    require_changeable(L);
    return function(L);
}

/// A function that answers something else whenever it is called: the value of a formula would
/// depend on how often it was asked for.
template <int (*function)(lua_State*)>
int varying(lua_State* L) {
    require_no_formula(L);
    return function(L);
}

template <int (*function)(lua_State*)>
void add_varying(lua_State* L, const char* name) {
    lua_pushcfunction(L, guarded<varying<function>>);
    lua_setfield(L, -2, name);
}

/// What errors call a function, whatever a script calls it.
void note_name(lua_State* L, lua_CFunction function, const std::string& name);
/// Those of the table on top, the environment of scripts, and of its libraries: "scene.save".
void note_names(lua_State* L);

/// Adds `function`, which changes something, under `name` to the table on top.
template <int (*function)(lua_State*)>
void add_function(lua_State* L, const char* name) {
    note_name(L, guarded<effect<function>>, name);
    lua_pushcfunction(L, guarded<effect<function>>);
    lua_setfield(L, -2, name);
}

/// The same for a function that gives a value and changes nothing, or changes it by the tree, which
/// sees to formulas itself: formulas can call it.
template <int (*function)(lua_State*)>
void add_pure(lua_State* L, const char* name) {
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
