#pragma once
// Converts C++ exceptions to Lua errors with the script's position, before they cross a frame of
// Lua. Lua's own errors are also exceptions in its C++ build; they pass unchanged, and destructors
// run.

#include <exception>
#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// "main.lua:12: ", the position in the innermost running script function; "" if there is none.
std::string position(lua_State* L);
/// "main.lua:3: ", the place where the function at the top of the stack is defined.
std::string definition(lua_State* L);
/// Raises `message` after the script's position.
[[noreturn]] void raise(lua_State* L, const std::string& message);
[[noreturn]] void raise_text(lua_State* L, const char* message);
/// The same with the text of an exception.
[[noreturn]] void raise_exception(lua_State* L, const std::exception& error);

/// Returns the result of `body`; raises its exceptions as Lua errors.
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

/// Throws while a formula or a question runs (`property::Inquiry`). The message names it and the
/// called function.
void require_changeable(lua_State* L);
/// The same only for formulas.
void require_no_formula(lua_State* L);

/// Calls the function of Lua's library in upvalue 1 as if a script had called it directly, so that
/// its errors contain the script's line and the wrong argument.
inline int call_original(lua_State* L) {
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Adds `function` to the table at the top of the stack. Its upvalue is the function of that name
/// in Lua's own `library`.
template <int (*function)(lua_State*)>
void wrap_pure(lua_State* L, const char* library, const char* name) {
    lua_getglobal(L, library);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
    lua_pushcclosure(L, guarded<function>, 1);
    lua_setfield(L, -2, name);
}

/// A function that changes something. It cannot be called in a formula, which must change nothing,
/// or in a question in the middle of a step or of a search.
template <int (*function)(lua_State*)>
int effect(lua_State* L) {
    require_changeable(L);
    return function(L);
}

/// A function whose result differs from call to call. It cannot be called in a formula, whose value
/// would then depend on the number of evaluations.
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

/// Stores the name of a function for error messages.
void note_name(lua_State* L, lua_CFunction function, const std::string& name);
/// Stores the names of the functions in the table at the top of the stack, which is the environment
/// of scripts, and in its libraries: "scene.save".
void note_names(lua_State* L);

/// Adds `function`, which changes something, to the table at the top of the stack.
template <int (*function)(lua_State*)>
void add_function(lua_State* L, const char* name) {
    note_name(L, guarded<effect<function>>, name);
    lua_pushcfunction(L, guarded<effect<function>>);
    lua_setfield(L, -2, name);
}

/// The same for a function that formulas may call: it changes nothing, or only through the tree,
/// which checks for formulas itself.
template <int (*function)(lua_State*)>
void add_pure(lua_State* L, const char* name) {
    lua_pushcfunction(L, guarded<function>);
    lua_setfield(L, -2, name);
}

/// Names the metatable at the top of the stack: error messages use this name, and scripts get it
/// instead of the metatable.
inline void name_metatable(lua_State* L, const char* name) {
    for (const char* field : {"__name", "__metatable"}) {
        lua_pushstring(L, name);
        lua_setfield(L, -2, field);
    }
}

}  // namespace fettle::script
