#pragma once
// Functions for texts and tables on Lua's stack.

#include <string>
#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

inline void push_registry(lua_State* L, int reference) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, reference);
}

inline void push_text(lua_State* L, std::string_view text) {
    lua_pushlstring(L, text.data(), text.size());
}

/// The value at `index`, which must be a text; it may contain zero bytes. Valid as long as the Lua
/// value.
inline std::string_view view_at(lua_State* L, int index) {
    std::size_t size = 0;
    const char* chars = lua_tolstring(L, index, &size);
    return {chars, size};
}

inline std::string string_at(lua_State* L, int index) {
    return std::string(view_at(L, index));
}

// Sets a field of the table at the top of the stack.
inline void put(lua_State* L, const char* field, std::string_view text) {
    push_text(L, text);
    lua_setfield(L, -2, field);
}
inline void put(lua_State* L, const char* field, bool flag) {
    lua_pushboolean(L, flag ? 1 : 0);
    lua_setfield(L, -2, field);
}
inline void put(lua_State* L, const char* field, lua_Integer number) {
    lua_pushinteger(L, number);
    lua_setfield(L, -2, field);
}

/// Pushes a weak table, which does not keep its keys ("k") or its values ("v") alive.
inline void push_weak_table(lua_State* L, const char* mode) {
    lua_newtable(L);
    lua_newtable(L);
    lua_pushstring(L, mode);
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
}

}  // namespace fettle::script
